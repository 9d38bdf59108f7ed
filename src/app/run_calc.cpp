// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/calc_arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "report/json.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

using mechanics::Formula;
using scalar::Traced;
using scalar::Unit;

const Formula* find_formula(const std::string& name, text::Diagnostics& diagnostics) {
  if (const Formula* formula = mechanics::find_formula(name)) return formula;
  std::vector<std::string> names;
  std::string by_last_name;
  for (const Formula& formula : mechanics::formulas()) {
    names.push_back(formula.name());
    names.push_back(formula.handbook_id());
    // "raising_torque" alone is nearly right.
    if (formula.name().substr(formula.name().find('.') + 1) == name)
      by_last_name += (by_last_name.empty() ? "did you mean '" : "' or '") + formula.name();
  }
  diagnostics.error("there is no formula " + text::in_quotes(name),
                    by_last_name.empty() ? text::did_you_mean(name, names, "'millwright formulas WORD' finds formulas")
                                         : by_last_name + "'?");
  return nullptr;
}

/// The unit that a formula's result has in SI: its own, or for "any" that of its arguments.
Unit si_unit_of(const Formula& formula, const CalcArguments& arguments) {
  if (formula.unit() != "any") return Unit::of(formula.unit());
  for (const report::CalculationInput& input : arguments.inputs)
    if (!input.values.empty()) return Unit::of(input.unit);
  return {};
}

Unit shown_unit(const Formula& formula, const CalcArguments& arguments) {
  if (!formula.display_unit().empty()) return Unit::of(formula.display_unit());
  if (formula.unit() == "any" && !arguments.units.empty()) {
    const Unit& given = arguments.units.front();
    // Between two temperatures lies a difference, which has no zero of its own.
    const bool difference =
        formula.name() == "arithmetic.difference" && given.dimension() == scalar::dimension::temperature;
    return difference ? Unit::of("K") : given;
  }
  return si_unit_of(formula, arguments);
}

std::vector<mechanics::ArgumentValue<Traced>> traced(const Formula& formula, const CalcArguments& arguments) {
  std::vector<mechanics::ArgumentValue<Traced>> values;
  for (std::size_t i = 0; i < arguments.values.size(); ++i) {
    const mechanics::Argument& argument = formula.arguments()[i];
    if (const int* choice = std::get_if<int>(&arguments.values[i])) {
      values.emplace_back(*choice);
    } else if (const auto* list = std::get_if<std::vector<double>>(&arguments.values[i])) {
      std::vector<Traced> leaves;
      for (std::size_t k = 0; k < list->size(); ++k)
        leaves.push_back(Traced::leaf(fmt::format("{}[{}]", argument.symbol, k + 1), (*list)[k], arguments.units[i]));
      values.emplace_back(std::move(leaves));
    } else {
      values.emplace_back(Traced::leaf(argument.symbol, std::get<double>(arguments.values[i]), arguments.units[i]));
    }
  }
  return values;
}

/// Counts that are none. (The formula takes them as any number, and a search may do so: here somebody wrote it.)
void warn_of_fractions(const Formula& formula, const CalcArguments& arguments, std::vector<std::string>& warnings) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < arguments.values.size(); ++i) {
    const auto* value = std::get_if<double>(&arguments.values[i]);
    if (value == nullptr || !formula.arguments()[i].whole) continue;
    if (std::abs(*value - std::round(*value)) > rounding * std::max(1.0, std::abs(*value)))
      warnings.push_back(
          fmt::format("{} = {} is not a whole number", formula.arguments()[i].name, scalar::format_number(*value, 10)));
  }
}

std::optional<report::Calculation> calculate(const Formula& formula,
                                             const Options& options,
                                             text::Diagnostics& diagnostics) {
  auto arguments = read_calc_arguments(formula, options.words, diagnostics);
  if (!arguments) return std::nullopt;
  report::Calculation calculation;
  calculation.formula = &formula;
  calculation.si_unit = si_unit_of(formula, *arguments);
  calculation.unit = shown_unit(formula, *arguments);
  if (!options.unit.empty()) {
    std::string reason;
    const auto unit = Unit::parse(options.unit, reason);
    // SI has one unit for revolutions and cycles per second; what is given says which is meant.
    if (!unit || !unit->fits(formula.unit() == "any" ? calculation.unit : calculation.si_unit, reason)) {
      diagnostics.error("--unit: " + reason, fmt::format("the result is in {}", calculation.unit.name()));
      return std::nullopt;
    }
    calculation.unit = *unit;
  }
  calculation.warnings = formula.violations(arguments->values);
  warn_of_fractions(formula, *arguments, calculation.warnings);
  const Traced result = formula.evaluate<Traced>(traced(formula, *arguments));
  calculation.value = result.value;
  if (std::isinf(result.value)) calculation.warnings.push_back("the result is infinite, or too large for a number");
  calculation.derivation = scalar::derivation(result, formula.symbol(), calculation.unit);
  calculation.inputs = std::move(arguments->inputs);
  return calculation;
}

}  // namespace

int run_calc(const Options& options) {
  text::Diagnostics diagnostics;
  std::optional<report::Calculation> calculation;
  if (const Formula* formula = find_formula(options.subject, diagnostics))
    calculation = calculate(*formula, options, diagnostics);
  if (calculation && std::isnan(calculation->value)) {
    std::string why;
    for (const std::string& warning : calculation->warnings) why += (why.empty() ? "" : "; ") + warning;
    diagnostics.error(calculation->formula->name() + " has no value for these arguments", why);
  }
  outputs_are_writable(options, diagnostics);
  // Else they stand below the result.
  if (calculation && options.quiet)
    for (const std::string& warning : calculation->warnings)
      diagnostics.warning({}, calculation->formula->name() + ": " + warning);
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  const std::string text = report::calculation_text(*calculation, output_style(options));
  return deliver(options, text, report::calculation_json(*calculation)) ? exit_done : exit_bad_input;
}

}  // namespace millwright::app
