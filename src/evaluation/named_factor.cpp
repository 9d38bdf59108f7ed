// SPDX-License-Identifier: Apache-2.0
#include "evaluation/named_factor.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace millwright::evaluation {

namespace {
using machine::PrintedValue;
using scalar::Unit;

/// What calculations of this trade are printed in.
constexpr std::array<std::string_view, 68> usual_units = {
    "m",       "cm",    "mm",     "um",     "m^2",    "cm^2",     "mm^2",     "m^3",     "cm^3",    "mm^3",
    "m^4",     "cm^4",  "mm^4",   "s",      "ms",     "min",      "h",        "kg",      "g",       "t",
    "m/s",     "mm/s",  "m/min",  "mm/min", "rad/s",  "r/min",    "rev/s",    "deg/s",   "N",       "kN",
    "mN",      "kgf",   "gf",     "N.m",    "N.cm",   "N.mm",     "mN.m",     "kgf.m",   "kgf.cm",  "kgf.mm",
    "Pa",      "kPa",   "MPa",    "GPa",    "N/cm^2", "kgf/mm^2", "kgf/cm^2", "W",       "kW",      "mW",
    "kgf.m/s", "rad",   "deg",    "rev",    "1",      "percent",  "kg.m^2",   "kg.cm^2", "kg.mm^2", "g.cm^2",
    "g.mm^2",  "m^3/s", "cm^3/s", "mm^3/s", "N/m",    "N/mm",     "m/s^2",    "mm/s^2"};

const std::vector<Unit>& parsed_units() {
  static const std::vector<Unit> units = [] {
    std::vector<Unit> result;
    for (const std::string_view name : usual_units) {
      std::string reason;
      if (const auto unit = Unit::parse(name, reason)) result.push_back(*unit);
    }
    return result;
  }();
  return units;
}

/// How far the printed number is from `value` (in its own unit), as a share of half its last digit: agrees up to 1.
double misfit(const PrintedValue& printed, double value) {
  return std::fabs(printed.number - value) / printed.half_digit;
}

std::string readable(const Unit& unit) { return unit.name().empty() ? "1" : unit.name(); }

constexpr double just_one = 1.0 + 1e-9;

std::optional<NamedFactor> other_unit(const PrintedValue& printed, const Unit& unit, double line) {
  std::optional<NamedFactor> best;
  double least = just_one;
  for (const Unit& other : parsed_units()) {
    if (!(other.dimension() == unit.dimension())) continue;
    // Degrees and turns are dimensionless, but a plain ratio is not read in them.
    if ((other.kind() == scalar::UnitKind::angle) != (unit.kind() == scalar::UnitKind::angle)) continue;
    const double factor = unit.to_si(1.0) / other.to_si(1.0);
    const double fit = misfit(printed, other.from_si(line));
    if (std::fabs(factor - 1.0) < 1e-9 || fit >= least) continue;
    least = fit;
    best = {factor, fmt::format("{:.6g}: printed {}, is {}", factor, readable(unit), readable(other))};
  }
  return best;
}

struct BareFactor {
  double factor;
  std::string_view name;
  bool (*occurs)(const Unit&);
};

bool has_time(const Unit& unit) { return unit.dimension().second != 0.0; }
bool turns(const Unit& unit) { return has_time(unit) || unit.kind() == scalar::UnitKind::angle; }
bool has_mass(const Unit& unit) { return unit.dimension().kilogram != 0.0; }
bool has_dimension(const Unit& unit) { return !(unit.dimension() == scalar::dimension::none); }

constexpr std::array<BareFactor, 8> bare_factors = {{{60.0, "60: minutes and seconds", has_time},
                                                     {3600.0, "3600: hours and seconds", has_time},
                                                     {2.0 * std::numbers::pi, "2 pi: turns and radians", turns},
                                                     {9.80665, "9.80665: weight and force", has_mass},
                                                     {1e3, "10^3: prefix, or mm and m", has_dimension},
                                                     {1e6, "10^6: prefix, or mm and m", has_dimension},
                                                     {1e9, "10^9: prefix, or mm and m", has_dimension},
                                                     {1e12, "10^12: prefix, or mm and m", has_dimension}}};

std::optional<NamedFactor> bare_factor(const PrintedValue& printed, const Unit& unit, double line) {
  for (const BareFactor& bare : bare_factors) {
    if (!bare.occurs(unit)) continue;
    for (const double factor : {bare.factor, 1.0 / bare.factor}) {
      if (misfit(printed, unit.from_si(line) * factor) <= just_one) return NamedFactor{factor, std::string(bare.name)};
    }
  }
  return std::nullopt;
}
}  // namespace

std::optional<NamedFactor> named_factor(const PrintedValue& printed, const Unit& unit, double line) {
  if (printed.significant_digits < 2 || !std::isfinite(line) || line == 0.0) return std::nullopt;
  if (auto other = other_unit(printed, unit, line)) return other;
  return bare_factor(printed, unit, line);
}

}  // namespace millwright::evaluation
