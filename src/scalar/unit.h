// SPDX-License-Identifier: Apache-2.0
//
// Units and quantities as people write them: "20 mm/s", "N·cm", "62.7 N/mm^2".
//
// The names and prefixes come from UDUNITS-2, the grammar and the definitions an engineer expects are ours (unit.cpp,
// unit_names.cpp): `oz.in` is a torque, `rev`, `rpm`, `pps` and `Nm` exist, and nothing that is not a unit parses as
// one.
//
//     unit     = "" | factor { separator factor } [ "/" (factor | group) ]...
//     factor   = ( symbol | "1" | "(" unit ")" ) [ exponent ]
//     exponent = [ "^" ] [ "-" ] digits | "^" decimal | superscript digits       mm2 mm^2 mm² s-1 m^0.5
//     separator = "." "·" "*" "×" "⋅" "-" or a blank
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scalar/dimension.h"

namespace millwright::scalar {

/// What a unit counts, beyond its dimension. 50 Hz, 50 rad/s and 50 pps all have the dimension 1/s.
enum class UnitKind {
  plain,          ///< everything that its dimension describes, temperature differences (K) included
  angle,          ///< rad, deg, rev
  angular_speed,  ///< rad/s, rpm
  frequency,      ///< Hz, 1/s
  step_rate,      ///< pps
  temperature,    ///< a temperature on a scale with its own zero, degC; in SI as K above absolute zero
  currency        ///< USD, EUR/m; currencies do not convert into each other
};
const char* to_string(UnitKind kind);

struct UnitDefinition;

/// A unit. Cheap to copy; the definitions live as long as the program. Safe to use from several threads.
class Unit {
 public:
  /// Dimensionless, "".
  Unit();

  /// Reads a unit expression; empty and "1" are dimensionless. On failure nothing, and why in `reason`, with the
  /// nearest known name where there is one.
  static std::optional<Unit> parse(std::string_view text, std::string& reason);
  /// A unit written in the program. Throws std::logic_error if it is not one.
  static Unit of(std::string_view text);

  /// As it was spelt.
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const Dimension& dimension() const;
  [[nodiscard]] UnitKind kind() const;
  /// The ISO 4217 code of a currency, "" for every other kind.
  [[nodiscard]] const std::string& currency() const;
  [[nodiscard]] double to_si(double value) const;
  /// The same for many numbers, in place.
  void to_si(std::span<double> values) const;
  [[nodiscard]] double from_si(double si) const;
  /// Whether a quantity given in this unit may stand where `expected` is wanted; if not, why and what to write.
  [[nodiscard]] bool fits(const Unit& expected, std::string& reason) const;

  friend bool operator==(const Unit& a, const Unit& b) { return a.name() == b.name(); }

 private:
  explicit Unit(const UnitDefinition* definition) : definition_(definition) {}
  const UnitDefinition* definition_;
};

/// A number in SI with the unit it was given in.
struct Quantity {
  double si = 0.0;
  Unit unit;
};

/// Reads a number, a blank and a unit that fits `expected`; a bare number only where `expected` is dimensionless.
/// On failure nothing, and why in `reason`.
std::optional<Quantity> parse_quantity(std::string_view text, const Unit& expected, std::string& reason);

/// Reads a plain number, complete: no blank, no unit, no decimal comma, no infinity. On failure why in `reason`.
std::optional<double> parse_number(std::string_view text, std::string& reason);

/// `si` in the unit `display` with that many significant digits, no trailing zeros: "308.7 MPa", "20 mm", "0.1".
std::string format(double si, const Unit& display, int significant = 4);
/// A plain number with that many significant digits, without trailing zeros; 1.2e-7 where that is shorter.
std::string format_number(double value, int significant = 4);

/// The unit an engineer would write this value in: 0.02 m in mm, 3e8 Pa in MPa, 1/s as rad/s.
Unit readable_unit(const Dimension& dimension, double si);

}  // namespace millwright::scalar
