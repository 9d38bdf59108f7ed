// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "mechanics/formula.h"
#include "scalar/unit.h"

/// Random arguments for any registered formula, drawn from the everyday range that it states.
namespace formula_samples {

using millwright::mechanics::Argument;
using millwright::mechanics::ArgumentKind;
using millwright::mechanics::ArgumentValue;
using millwright::mechanics::Formula;
using Arguments = std::vector<ArgumentValue<double>>;

/// Same numbers on every platform, other numbers for every formula.
class Random {
 public:
  explicit Random(std::string_view seed) {
    std::uint64_t hash = 1469598103934665603u;
    for (char c : seed) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    engine_.seed(hash);
  }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1.0p-53);
  }
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

inline double draw(const Argument& argument, Random& random) {
  const double low = argument.typical_lower, high = argument.typical_upper;
  double x = low > 0.0 ? std::exp(random.uniform(std::log(low), std::log(high))) : random.uniform(low, high);
  if (argument.whole) x = std::round(x);
  if (low > 0.0 && argument.lower < -high && random.whole(0, 2) == 0) x = -x;
  return x;
}

inline ArgumentValue<double> draw_value(const Argument& argument, const Arguments& before, Random& random) {
  if (argument.kind == ArgumentKind::number) return draw(argument, random);
  if (argument.kind == ArgumentKind::choice) return random.whole(0, static_cast<int>(argument.choices.size()) - 1);
  auto length = static_cast<std::size_t>(random.whole(1, 4));
  if (argument.same_length_as >= 0)
    length = std::get<std::vector<double>>(before[static_cast<std::size_t>(argument.same_length_as)]).size();
  std::vector<double> list(length);
  for (double& x : list) x = draw(argument, random);
  return list;
}

/// Arguments at which the formula holds by its own statement. Throws when none are found: a formula whose conditions
/// hardly ever hold in its everyday range states one of the two wrongly.
inline Arguments draw_arguments(const Formula& formula, Random& random) {
  for (int attempt = 0; attempt < 5000; ++attempt) {
    Arguments values;
    for (const Argument& argument : formula.arguments()) values.push_back(draw_value(argument, values, random));
    if (formula.violations(values).empty() && std::isfinite(formula.evaluate<double>(values))) return values;
  }
  throw std::runtime_error(formula.name() + ": no valid arguments found in the everyday range");
}

/// Where a number stands among the arguments: argument, and element if that is a list.
using Place = std::pair<std::size_t, std::size_t>;

inline std::vector<Place> number_places(const Arguments& values) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::holds_alternative<double>(values[i])) places.emplace_back(i, 0);
    if (const auto* list = std::get_if<std::vector<double>>(&values[i]))
      for (std::size_t k = 0; k < list->size(); ++k) places.emplace_back(i, k);
  }
  return places;
}

template <class T>
T& at(std::vector<ArgumentValue<T>>& values, Place place) {
  if (T* number = std::get_if<T>(&values[place.first])) return *number;
  return std::get<std::vector<T>>(values[place.first])[place.second];
}

inline double number_at(const Arguments& values, Place place) {
  if (const double* number = std::get_if<double>(&values[place.first])) return *number;
  return std::get<std::vector<double>>(values[place.first])[place.second];
}

inline Arguments with(Arguments values, Place place, double x) {
  at(values, place) = x;
  return values;
}

/// The same arguments on another scalar; `convert(x, place)` makes the number.
template <class T, class Convert>
std::vector<ArgumentValue<T>> on_scalar(const Arguments& values, Convert convert) {
  std::vector<ArgumentValue<T>> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const double* number = std::get_if<double>(&values[i])) {
      result.emplace_back(std::in_place_index<0>, convert(*number, Place{i, 0}));
    } else if (const auto* list = std::get_if<std::vector<double>>(&values[i])) {
      std::vector<T> converted;
      for (std::size_t k = 0; k < list->size(); ++k) converted.push_back(convert((*list)[k], Place{i, k}));
      result.emplace_back(std::in_place_index<1>, std::move(converted));
    } else {
      result.emplace_back(std::in_place_index<2>, std::get<int>(values[i]));
    }
  }
  return result;
}

/// The unit of an argument or result; quantities of any unit are tried in metres.
inline millwright::scalar::Unit unit_of(const std::string& unit) {
  return millwright::scalar::Unit::of(unit == "any" ? "m" : unit);
}

}  // namespace formula_samples
