// SPDX-License-Identifier: Apache-2.0
// Values of conditions as people read and write them.
#include <fmt/format.h>

#include <cmath>

#include "machine/condition.h"
#include "scalar/unit.h"

namespace millwright::machine {

namespace {

scalar::Unit display_unit(const Condition& condition) {
  const scalar::Unit declared = scalar::Unit::of(condition.unit);
  if (condition.unit == "rad") return scalar::Unit::of("deg");
  const bool scaled =
      condition.unit == "s" || condition.unit == "m" || condition.unit == "Pa" || condition.unit == "m/s";
  return scaled ? scalar::readable_unit(declared.dimension(), condition.value) : declared;
}

}  // namespace

std::string shown(const Condition& condition, double value, const std::string& currency, int digits) {
  if (condition.kind == ConditionKind::choice) return condition.present;
  if (condition.unit.empty()) return fmt::format("{:.2f} {}", value, currency);
  return scalar::format(value, display_unit(condition), digits);
}

ShownUnit shown_unit(const Condition& condition, const std::string& currency) {
  if (condition.unit.empty()) return {currency, 1.0};
  const scalar::Unit unit = display_unit(condition);
  const std::string text = scalar::format(1.0, unit);
  const std::size_t blank = text.find(' ');
  return {blank == std::string::npos ? "1" : text.substr(blank + 1), unit.to_si(1.0) - unit.to_si(0.0)};
}

double rounded_looser(const Condition& condition, double value) {
  const bool money = condition.unit.empty();
  const double number = money ? value : display_unit(condition).from_si(value);
  if (!(number > 0.0)) return value;
  const double step = money ? 0.01 : std::pow(10.0, std::floor(std::log10(number)) - 2.0);
  const double steps = number / step;
  const double rounded = (condition.larger_is_looser ? std::ceil(steps - 1e-9) : std::floor(steps + 1e-9)) * step;
  return money ? rounded : display_unit(condition).to_si(rounded);
}

}  // namespace millwright::machine
