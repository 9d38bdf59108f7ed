// SPDX-License-Identifier: Apache-2.0
#include "mechanics/outside_validity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace millwright::mechanics {

FormulaWatch::FormulaWatch() : before_(detail::current_watch) { detail::current_watch = this; }

FormulaWatch::~FormulaWatch() { detail::current_watch = before_; }

std::vector<ArgumentValue<double>> argument_values(std::initializer_list<WatchedArgument> arguments) {
  std::vector<ArgumentValue<double>> values;
  for (const WatchedArgument& argument : arguments) {
    switch (argument.kind) {
      case WatchedArgument::Kind::number:
        values.emplace_back(argument.number);
        break;
      case WatchedArgument::Kind::list:
        values.emplace_back(std::vector<double>(argument.list.begin(), argument.list.end()));
        break;
      case WatchedArgument::Kind::choice:
        values.emplace_back(argument.choice);
        break;
    }
  }
  return values;
}

namespace {

bool is_known(const ArgumentValue<double>& value) {
  if (const double* number = std::get_if<double>(&value)) return !std::isnan(*number);
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    return std::none_of(list->begin(), list->end(), [](double x) { return std::isnan(x); });
  return true;
}

}  // namespace

void ValidityWatch::called(const char* name, std::initializer_list<WatchedArgument> arguments) {
  const Formula* formula = find_formula(name);
  if (formula == nullptr) throw std::logic_error(std::string(name) + " announces itself and is not registered");
  const std::vector<ArgumentValue<double>> values = argument_values(arguments);
  formulas_.insert(formula);
  if (!std::all_of(values.begin(), values.end(), is_known)) return;
  for (BrokenLimit& broken : formula->broken_limits(values)) {
    const auto same = std::find_if(left_.begin(), left_.end(), [&](const LeftRange& left) {
      return left.formula == formula && left.limit.index == broken.index;
    });
    if (same == left_.end())
      left_.push_back({formula, std::move(broken), values});
    else if (broken.excess > same->limit.excess)
      *same = {formula, std::move(broken), values};
  }
}

}  // namespace millwright::mechanics
