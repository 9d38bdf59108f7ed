// SPDX-License-Identifier: Apache-2.0
#include "report/calculation.h"

#include <fmt/format.h>

namespace millwright::report {

namespace {

constexpr int shown_digits = 10;

std::string input_text(const CalculationInput& input) {
  if (!input.word.empty()) return input.word;
  std::string out;
  for (const double value : input.values)
    out += (out.empty() ? "" : ", ") + scalar::format(value, scalar::Unit::of(input.unit), 6);
  return out;
}

std::string unit_or_dash(const std::string& unit) { return unit.empty() || unit == "1" ? "-" : unit; }

std::string kind_text(const mechanics::Argument& argument) {
  switch (argument.kind) {
    case mechanics::ArgumentKind::number:
      return argument.whole ? "a whole number: " : "";
    case mechanics::ArgumentKind::list:
      return "a list: ";
    case mechanics::ArgumentKind::choice:
      return fmt::format("one of {}: ", fmt::join(argument.choices, ", "));
  }
  return {};
}

}  // namespace

std::string calculation_text(const Calculation& calculation, const Style& style) {
  const mechanics::Formula& formula = *calculation.formula;
  const std::string value = scalar::format(calculation.value, calculation.unit, shown_digits);
  if (style.brief) return value + "\n";
  std::string out = style.heading(formula.title()) + "\n";
  out += fmt::format("  {}  {}\n\n", formula.name(), style.faint(formula.handbook_id()));
  TextTable inputs({{""}, {""}, {""}, {""}, {"", Align::left, 40}});
  for (const CalculationInput& input : calculation.inputs) {
    const std::string understood = input_text(input);
    inputs.add({input.name,
                input.symbol == input.name ? "" : input.symbol,
                "= " + input.given,
                understood == input.given ? "" : "= " + understood,
                input.meaning});
  }
  out += inputs.str(2, style) + "\n";
  for (const scalar::DerivationLine& line : calculation.derivation)
    out += equation(scalar::to_string(line), 2, style.width);
  if (!calculation.derivation.empty()) out += "\n";
  const std::string si = scalar::format(calculation.value, calculation.si_unit, shown_digits);
  out += style.heading(fmt::format("{} = {}", formula.symbol(), value)) + (si == value ? "" : "  (" + si + ")") + "\n";
  for (const std::string& warning : calculation.warnings)
    out += style.bad("  outside the stated validity: ") + warning + "\n";
  out += fmt::format("  source: {}\n", formula.source());
  return out;
}

std::string formula_text(const mechanics::Formula& formula, const Style& style) {
  if (style.brief) return formula.name() + "\n";
  const std::string result = formula.display_unit().empty() ? formula.unit() : formula.display_unit();
  std::string out = style.heading(formula.name()) + "  " + style.faint(formula.handbook_id()) + "\n";
  out += fmt::format("  {}: {} [{}]\n", formula.title(), formula.symbol(), unit_or_dash(result));
  TextTable arguments({{""}, {""}, {""}, {"", Align::left, 60}});
  for (const mechanics::Argument& argument : formula.arguments())
    arguments.add({argument.name,
                   argument.symbol == argument.name ? "" : argument.symbol,
                   argument.kind == mechanics::ArgumentKind::choice ? "" : "[" + unit_or_dash(argument.unit) + "]",
                   kind_text(argument) + argument.meaning});
  out += arguments.str(4, style);
  if (!formula.validity().empty()) out += "  valid: " + wrapped(formula.validity(), 70, 9) + "\n";
  out += "  source: " + wrapped(formula.source(), 70, 10) + "\n";
  return out;
}

}  // namespace millwright::report
