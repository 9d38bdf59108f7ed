// SPDX-License-Identifier: Apache-2.0
#include "scalar/unit.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <unordered_map>

#include "scalar/unit_definition.h"

namespace millwright::scalar {
namespace {

/// Every unit text seen so far. Never freed: units are handles to its entries and may outlive any static.
struct Known {
  std::mutex mutex;  // UDUNITS-2 parses in one thread at a time
  std::unordered_map<std::string, std::unique_ptr<const UnitDefinition>> units;
};
Known& known() {
  static Known& instance = *new Known;
  return instance;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

const UnitDefinition& dimensionless_unit() {
  static const UnitDefinition& instance = *new UnitDefinition;
  return instance;
}

/// The same number with a factor of ten more or less is the same number: 9806650.000000001 is 9806650.
double cleaned(double x) {
  const double whole = std::round(x);
  return std::fabs(x - whole) <= 4e-16 * std::fabs(x) ? whole : x;
}

std::string described(const Unit& unit) {
  const std::string name = unit.name().empty() ? "no unit" : "'" + unit.name() + "'";
  if (unit.kind() == UnitKind::plain) return fmt::format("{} ({})", name, to_string(unit.dimension()));
  return fmt::format("{} ({})", name, to_string(unit.kind()));
}

std::string kind_hint(UnitKind given, UnitKind expected) {
  using enum UnitKind;
  if (expected == angular_speed && given == frequency)
    return "1 Hz = 1 rev/s = 60 rpm = 6.283 rad/s: write rpm or rad/s";
  if (expected == frequency && given == angular_speed) return "60 rpm = 1 Hz: write Hz";
  if (expected == step_rate) return "motor steps per second are written pps";
  if (given == step_rate) return "steps per second depend on the step angle: write rpm, rad/s or Hz";
  if (expected == angle) return "write rad, deg or rev";
  if (given == angle) return "an angle does not count as a plain number here";
  return "";
}

}  // namespace

const char* to_string(UnitKind kind) {
  switch (kind) {
    case UnitKind::plain:
      return "plain";
    case UnitKind::angle:
      return "angle";
    case UnitKind::angular_speed:
      return "angular speed";
    case UnitKind::frequency:
      return "frequency";
    case UnitKind::step_rate:
      return "step rate";
    case UnitKind::temperature:
      return "temperature";
    case UnitKind::currency:
      return "currency";
  }
  return "plain";
}

UnitKind kind_of(const UnitDefinition& unit) {
  if (unit.currency_exponent != 0.0) return UnitKind::currency;
  if (unit.offset != 0.0) return UnitKind::temperature;
  if (unit.dimension == dimension::none && unit.angle == 1.0 && unit.step == 0.0) return UnitKind::angle;
  if (!(unit.dimension == dimension::frequency)) return UnitKind::plain;
  if (unit.angle == 1.0 && unit.step == 0.0) return UnitKind::angular_speed;
  if (unit.angle == 0.0 && unit.step == 1.0) return UnitKind::step_rate;
  return unit.angle == 0.0 && unit.step == 0.0 ? UnitKind::frequency : UnitKind::plain;
}

Unit::Unit() : definition_(&dimensionless_unit()) {}

std::optional<Unit> Unit::parse(std::string_view text, std::string& reason) {
  const std::string key(trimmed(text));
  Known& all = known();
  const std::lock_guard lock(all.mutex);
  if (const auto found = all.units.find(key); found != all.units.end()) return Unit(found->second.get());
  auto definition = unit_expression(key, reason);
  if (!definition) return std::nullopt;
  if (definition->currency_exponent != 0.0 && definition->currency_exponent != 1.0) {
    reason = "a currency may stand only above the line and only once";
    return std::nullopt;
  }
  definition->name = key;
  definition->numerator = cleaned(definition->numerator);
  definition->denominator = cleaned(definition->denominator);
  definition->kind = kind_of(*definition);
  auto owned = std::make_unique<const UnitDefinition>(std::move(*definition));
  return Unit(all.units.emplace(key, std::move(owned)).first->second.get());
}

Unit Unit::of(std::string_view text) {
  std::string reason;
  if (const auto unit = parse(text, reason)) return *unit;
  throw std::logic_error(fmt::format("unit '{}': {}", text, reason));
}

const std::string& Unit::name() const { return definition_->name; }
const Dimension& Unit::dimension() const { return definition_->dimension; }
UnitKind Unit::kind() const { return definition_->kind; }
const std::string& Unit::currency() const { return definition_->currency; }
double Unit::to_si(double value) const {
  return value * definition_->numerator / definition_->denominator + definition_->offset;
}
void Unit::to_si(std::span<double> values) const {
  const double numerator = definition_->numerator, denominator = definition_->denominator, offset = definition_->offset;
  for (double& value : values) value = value * numerator / denominator + offset;
}
double Unit::from_si(double si) const {
  return (si - definition_->offset) * definition_->denominator / definition_->numerator;
}

bool Unit::fits(const Unit& expected, std::string& reason) const {
  const UnitDefinition& a = *definition_;
  const UnitDefinition& b = *expected.definition_;
  if (!(a.dimension == b.dimension)) {
    reason = fmt::format("{} does not fit: {} is wanted", described(*this), described(expected));
    if (a.name == "C" && b.dimension == dimension::temperature) reason += "; the degree Celsius is written degC";
    if (b.dimension == dimension::torque && a.dimension == dimension::mass * dimension::length) {
      reason += "; a torque from kilograms or pounds needs kgf or lbf";
    }
    if (b.dimension == dimension::force && a.dimension == dimension::mass)
      reason += "; a force is written kgf, lbf, ozf";
    return false;
  }
  if (a.currency != b.currency) {
    reason = fmt::format("{} does not fit: {} is wanted; rates of exchange belong to the problem, not to units",
                         described(*this),
                         described(expected));
    return false;
  }
  if (a.offset != 0.0 && b.offset == 0.0) {
    reason = fmt::format("'{}' is a temperature with its own zero, a difference is wanted: write K", a.name);
    return false;
  }
  if (std::fabs(a.angle - b.angle) < 1e-9 && std::fabs(a.step - b.step) < 1e-9) return true;
  reason = fmt::format("{} does not fit: {} is wanted", described(*this), described(expected));
  const std::string hint = kind_hint(a.kind, b.kind);
  reason += hint.empty() ? "; the two count angles or steps differently" : "; " + hint;
  return false;
}

std::optional<double> parse_number(std::string_view text, std::string& reason) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  const bool digits = !text.empty() && text.find_first_of("0123456789") <= 2;
  if (error == std::errc() && read_to == end && digits && std::isfinite(value)) return value;
  if (text.find(',') != std::string_view::npos) {
    reason = fmt::format("'{}' has a comma: write a decimal point and no thousands separator", text);
  } else if (error == std::errc::result_out_of_range) {
    reason = fmt::format("'{}' is too large or too small for a number", text);
  } else {
    reason = fmt::format("'{}' is not a number", text);
  }
  return std::nullopt;
}

std::optional<Quantity> parse_quantity(std::string_view text, const Unit& expected, std::string& reason) {
  text = trimmed(text);
  const std::size_t number_end = std::min(text.find_first_not_of("0123456789.,+-eE"), text.size());
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::string_view unit_text = trimmed(text.substr(std::min(number_end, blank)));
  std::string_view number = text.substr(0, std::min(number_end, blank));
  const bool glued = number_end < blank;
  if (glued && (number.ends_with('e') || number.ends_with('E'))) number.remove_suffix(1);
  const auto value = parse_number(number, reason);
  if (!value) {
    if (number.empty()) reason = fmt::format("'{}' does not start with a number", text);
    return std::nullopt;
  }
  if (glued && !unit_text.starts_with("%") && !unit_text.starts_with("°")) {
    reason =
        fmt::format("a blank is missing between number and unit: write '{} {}'", number, text.substr(number.size()));
    return std::nullopt;
  }
  const auto unit = Unit::parse(unit_text, reason);
  if (!unit) return std::nullopt;
  if (!unit->fits(expected, reason)) {
    if (unit_text.empty())
      reason = fmt::format("a unit is missing: write for example '{} {}'", number, expected.name());
    return std::nullopt;
  }
  const double si = unit->to_si(*value);
  if (!std::isfinite(si)) {
    reason = fmt::format("'{}' is too large for a number", text);
    return std::nullopt;
  }
  return Quantity{si, *unit};
}

}  // namespace millwright::scalar
