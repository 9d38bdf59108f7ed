// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "mechanics/formula_definition.h"
#include "scalar/unit.h"

namespace millwright::mechanics {

namespace {

/// A value in SI, in an argument's unit: that is SI, but for the zero of temperatures.
std::string text_of(double value, const std::string& unit) {
  std::ostringstream text;
  text << (unit == "degC" ? scalar::Unit::of(unit).from_si(value) : value);
  return text.str();
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \n") - first + 1));
}

const char* kind_name(ArgumentKind kind) {
  switch (kind) {
    case ArgumentKind::number:
      return "a number";
    case ArgumentKind::list:
      return "a list";
    case ArgumentKind::choice:
      return "one of its names";
  }
  return "";
}

/// Limits are numbered: three for each argument (not a number or an empty list, below, above), then the relations.
constexpr std::size_t limits_of_argument = 3;

void check_range(const Argument& argument, std::size_t first, double value, std::vector<BrokenLimit>& broken) {
  if (value >= argument.lower && value <= argument.upper) return;
  if (std::isnan(value)) {
    broken.push_back({first, 0.0, argument.name + " is not a number"});
    return;
  }
  const std::string& unit = argument.unit;
  const std::string suffix = unit.empty() || unit == "1" || unit == "any" ? "" : " " + unit;
  const std::string is = argument.name + " = " + text_of(value, unit) + suffix + " is ";
  if (value < argument.lower)
    broken.push_back({first + 1, argument.lower - value, is + "below " + text_of(argument.lower, unit) + suffix});
  else
    broken.push_back({first + 2, value - argument.upper, is + "above " + text_of(argument.upper, unit) + suffix});
}

/// Everyday range of a unit, for arguments that name none.
std::pair<double, double> typical_range(std::string_view unit) {
  struct Range {
    std::string_view unit;
    double lower, upper;
  };
  static constexpr std::array ranges{
      Range{"m", 1e-3, 1},        Range{"m/s", 1e-2, 2},       Range{"m/s^2", 0.1, 10},      Range{"m/s^3", 10, 1e3},
      Range{"s", 0.05, 10},       Range{"rad", 0.02, 1.2},     Range{"rad/s", 1, 400},       Range{"rad/s^2", 1, 1e4},
      Range{"Hz", 1, 1e4},        Range{"N", 1, 1e4},          Range{"N.m", 0.01, 20},       Range{"N/m", 1e5, 1e9},
      Range{"N.m/rad", 10, 1e5},  Range{"Pa", 1e6, 1e9},       Range{"kg", 0.1, 200},        Range{"kg/m", 5e-3, 10},
      Range{"kg/m^3", 1e3, 1e4},  Range{"kg.m^2", 1e-6, 1e-2}, Range{"m^2", 1e-5, 1e-2},     Range{"m^3", 1e-8, 1e-4},
      Range{"m^4", 1e-12, 1e-6},  Range{"m/N", 1e-9, 1e-5},    Range{"m^2/N", 1e-16, 1e-13}, Range{"m^3/s", 1e-9, 1e-5},
      Range{"1/K", 5e-6, 3e-5},   Range{"K", 1, 100},          Range{"K/W", 0.5, 10},        Range{"W", 0.5, 1e3},
      Range{"J", 0.1, 100},       Range{"V", 5, 80},           Range{"A", 0.5, 8},           Range{"ohm", 0.2, 10},
      Range{"H", 5e-4, 2e-2},     Range{"F", 1e-4, 1e-2},      Range{"Pa.s", 10, 1e3},       Range{"N.m/A", 0.05, 2},
      Range{"s/rad", 1e-5, 1e-3}, Range{"any", 1, 100}};
  for (const Range& range : ranges)
    if (range.unit == unit) return {range.lower, range.upper};
  return {0.1, 5.0};
}

Argument argument_of(const ArgumentText& text) {
  Argument argument;
  argument.name = text.name;
  argument.symbol = text.symbol;
  argument.unit = text.unit;
  argument.meaning = text.meaning;
  argument.kind = text.kind;
  argument.monotone = text.monotone;
  argument.lower = text.lower;
  argument.upper = text.upper;
  std::tie(argument.typical_lower, argument.typical_upper) = text.typical ? *text.typical : typical_range(text.unit);
  argument.whole = text.whole;
  argument.choices.assign(text.choices.begin(), text.choices.end());
  argument.same_length_as = text.same_length_as;
  return argument;
}

}  // namespace

Formula::Formula(const FormulaHeader& header, std::vector<Argument> arguments, const Evaluators& evaluators)
    : header_{.name = std::string(header.name),
              .handbook_id = std::string(header.handbook_id),
              .symbol = std::string(header.symbol),
              .unit = std::string(header.unit),
              .display_unit = std::string(header.display_unit),
              .title = std::string(header.title),
              .source = std::string(header.source),
              .validity = std::string(header.validity)},
      arguments_(std::move(arguments)),
      evaluators_(evaluators) {
  if (header_.name.empty() || header_.unit.empty() || header_.source.empty())
    throw std::logic_error("formula '" + header_.name + "' lacks its name, unit or source");
  for (Argument& argument : arguments_) {
    argument.typical_lower = std::clamp(argument.typical_lower, argument.lower, argument.upper);
    argument.typical_upper = std::clamp(argument.typical_upper, argument.lower, argument.upper);
  }
}

std::string_view Formula::element() const { return std::string_view(name()).substr(0, name().find('.')); }

std::vector<std::string> Formula::source_keys() const {
  std::vector<std::string> keys;
  std::istringstream parts(source());
  for (std::string part; std::getline(parts, part, ';');) keys.push_back(trimmed(part.substr(0, part.find(','))));
  return keys;
}

bool Formula::has_limits() const {
  return !conditions_.empty() || std::any_of(arguments_.begin(), arguments_.end(), [](const Argument& argument) {
    const double usual = argument.whole ? 1.0 : 0.0;
    return argument.kind != ArgumentKind::choice &&
           (std::isfinite(argument.upper) || (std::isfinite(argument.lower) && argument.lower != usual));
  });
}

std::vector<BrokenLimit> Formula::broken_limits(std::span<const ArgumentValue<double>> values) const {
  check_shape(values.size(), [&](std::size_t i) { return values[i].index(); });
  std::vector<BrokenLimit> broken;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Argument& argument = arguments_[i];
    const std::size_t first = limits_of_argument * i;
    if (const double* number = std::get_if<double>(&values[i])) check_range(argument, first, *number, broken);
    if (const auto* list = std::get_if<std::vector<double>>(&values[i])) {
      for (double value : *list) check_range(argument, first, value, broken);
      if (list->empty()) broken.push_back({first, 0.0, argument.name + " is an empty list"});
      const int other = argument.same_length_as;
      if (other >= 0 && std::get<std::vector<double>>(values[static_cast<std::size_t>(other)]).size() != list->size())
        broken.push_back(
            {first,
             0.0,
             argument.name + " and " + arguments_[static_cast<std::size_t>(other)].name + " differ in length"});
    }
  }
  if (!broken.empty()) return broken;  // the relations below may divide by what was just found to be bad
  for (std::size_t i = 0; i < conditions_.size(); ++i)
    if (!conditions_[i].holds(values))
      broken.push_back(
          {limits_of_argument * arguments_.size() + i, 0.0, "it does not hold that " + conditions_[i].text});
  return broken;
}

std::vector<std::string> Formula::violations(std::span<const ArgumentValue<double>> values) const {
  std::vector<std::string> sentences;
  for (BrokenLimit& broken : broken_limits(values)) sentences.push_back(std::move(broken.sentence));
  return sentences;
}

void Formula::add_condition(std::string_view text, Validity::Holds holds) {
  conditions_.push_back({std::string(text), holds});
}

void Formula::fail_count(std::size_t count) const {
  throw std::invalid_argument(name() + " takes " + std::to_string(arguments_.size()) + " arguments, not " +
                              std::to_string(count));
}

void Formula::fail_kind(std::size_t index) const {
  throw std::invalid_argument(name() + ": argument " + arguments_[index].name + " takes " +
                              kind_name(arguments_[index].kind));
}

namespace detail {

Formula& add_formula(FormulaList& list,
                     const FormulaHeader& header,
                     std::span<const ArgumentText* const> texts,
                     const Formula::Evaluators& evaluators) {
  std::vector<Argument> arguments;
  for (const ArgumentText* text : texts) arguments.push_back(argument_of(*text));
  return list.emplace_back(header, std::move(arguments), evaluators);
}

}  // namespace detail

}  // namespace millwright::mechanics
