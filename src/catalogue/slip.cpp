// SPDX-License-Identifier: Apache-2.0
#include "catalogue/slip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

struct UnitSlips {
  std::string_view unit;
  std::vector<Slip> slips;
};

/// Factors are exact conversions (oz.in = 7.0616 mN.m, lb.in = 0.112985 N.m, lbf = 4.44822 N, in = 25.4 mm, ...).
/// The factor is what the figure is in the wrong unit, divided by what it is in the right one.
const std::vector<UnitSlips>& by_unit() {
  static const std::vector<UnitSlips> all = {
      {"N.m",
       {{100, 0.12, "N.cm read as N.m"},
        {1000, 0.04, "N.mm read as N.m"},
        {10.1972, 0.05, "kgf.cm read as N.m"},
        {141.612, 0.05, "oz.in read as N.m"},
        {8.85075, 0.03, "lb.in read as N.m"},
        {0.101972, 0.02, "kgf.m read as N.m"}}},
      {"g.cm2",
       {{1e-3, 0.08, "kg.cm2 read as g.cm2"},
        {100, 0.06, "g.mm2 read as g.cm2"},
        {10, 0.04, "kg.mm2 read as g.cm2"},
        {1e-7, 0.04, "kg.m2 read as g.cm2"},
        {0.00546745, 0.03, "oz.in2 read as g.cm2"},
        {4, 0.02, "diameter taken for radius"},
        {16, 0.02, "diameter taken for radius in d^4"}}},
      {"N",
       {{1e-3, 0.1, "kN read as N"},
        {0.101972, 0.1, "kgf read as N"},
        {0.1, 0.02, "daN read as N"},
        {0.224809, 0.05, "lbf read as N"},
        {9.80665, 0.03, "multiplied by g although already in N"}}},
      {"mm",
       {{0.1, 0.05, "cm read as mm"},
        {1e-3, 0.05, "m read as mm"},
        {0.0393701, 0.1, "inch read as mm"},
        {25.4, 0.04, "converted from inch although already in mm"},
        {0.5, 0.06, "radius for diameter"},
        {2, 0.06, "diameter for radius"},
        {3.141593, 0.01, "circumference for diameter"}}},
      {"kg",
       {{1000, 0.15, "g read as kg"},
        {2.20462, 0.06, "lb read as kg"},
        {35.274, 0.03, "oz read as kg"},
        {1e-3, 0.03, "divided by 1000 although already in kg"}}},
      {"kg/m",
       {{1000, 0.1, "g/m read as kg/m"},
        {0.671969, 0.05, "lb/ft read as kg/m"},
        {0.01, 0.03, "kg/cm read as kg/m"},
        {1e-3, 0.05, "kg/mm or t/m read as kg/m"}}},
      {"A",
       {{1000, 0.1, "mA read as A"},
        {1.414214, 0.06, "peak for RMS"},
        {0.707107, 0.06, "RMS for peak, or unipolar for bipolar"},
        {2, 0.05, "parallel winding for series"},
        {0.5, 0.05, "series winding for parallel"}}},
      {"mH",
       {{1000, 0.1, "uH read as mH"},
        {1e-3, 0.06, "H read as mH"},
        {4, 0.05, "series winding for parallel"},
        {0.25, 0.05, "parallel winding for series"}}},
      {"ohm",
       {{1000, 0.05, "mOhm read as ohm"},
        {1e-3, 0.03, "kOhm read as ohm"},
        {4, 0.05, "series winding for parallel"},
        {0.25, 0.05, "parallel winding for series"},
        {2, 0.05, "both phases in series for one"}}},
      {"V", {{1e-3, 0.03, "kV read as V"}, {1000, 0.05, "mV read as V"}}},
      {"W", {{1e-3, 0.1, "kW read as W"}, {0.00134102, 0.03, "hp read as W"}}},
      {"N/um",
       {{1000, 0.12, "N/mm read as N/um"},
        {0.101972, 0.1, "kgf/um read as N/um"},
        {1e-3, 0.03, "kN/um read as N/um"},
        {5.71015, 0.02, "lbf/mil read as N/um"}}},
      {"N.m/rad",
       {{0.0174533, 0.12, "N.m/deg read as N.m/rad"},
        {57.29578, 0.06, "multiplied by 180/pi although already per radian"},
        {1e-3, 0.06, "kN.m/rad read as N.m/rad"}}},
      {"MPa",
       {{1e-3, 0.12, "GPa read as MPa"},
        {1000, 0.04, "kPa read as MPa"},
        {1e6, 0.02, "Pa read as MPa"},
        {145.038, 0.05, "psi read as MPa"},
        {0.145038, 0.05, "ksi read as MPa"},
        {0.101972, 0.06, "kgf/mm2 read as MPa"},
        {10, 0.04, "bar read as MPa"}}},
      {"mm2", {{0.01, 0.15, "cm2 read as mm2"}, {0.0015500, 0.05, "in2 read as mm2"}, {1e-6, 0.02, "m2 read as mm2"}}},
      {"mm3", {{1e-3, 0.15, "cm3 read as mm3"}, {6.10237e-5, 0.05, "in3 read as mm3"}}},
      {"mm4", {{1e-4, 0.15, "cm4 read as mm4"}, {2.40251e-6, 0.05, "in4 read as mm4"}}},
      {"kg/m3", {{1e-3, 0.15, "g/cm3 read as kg/m3"}, {0.0624280, 0.03, "lb/ft3 read as kg/m3"}}},
      {"rpm", {{0.0166667, 0.05, "1/s read as rpm"}, {0.104720, 0.05, "rad/s read as rpm"}}},
      {"um", {{1e-3, 0.12, "mm read as um"}, {25.4, 0.02, "mil for um"}, {1000, 0.03, "nm read as um"}}},
      {"deg", {{0.0174533, 0.1, "radian read as degree"}}},
      {"m/s", {{60, 0.08, "m/min read as m/s"}, {1000, 0.05, "mm/s read as m/s"}, {3.28084, 0.02, "ft/s read as m/s"}}},
      {"km",
       {{1000, 0.1, "m read as km"},
        {2, 0.2, "a rating for 50 km (C is 1.26 times that for 100 km)"},
        {0.5, 0.2, "a rating for 100 km (C is 0.79 times that for 50 km)"}}},
      {"%", {{0.01, 0.2, "a fraction, not per cent"}}},
      {"1/K", {{1.8, 0.04, "per K taken for per degree Fahrenheit"}, {0.555556, 0.06, "per degree Fahrenheit"}}},
      {"", {{12, 0.04, "the price of a dozen"}, {5, 0.03, "the price of a pack of five"}}},
      {"1/m",
       {{1e-3, 0.06, "price a millimetre"},
        {0.3048, 0.06, "price a foot"},
        {2, 0.04, "price of a piece of 2 m"},
        {3, 0.04, "price of a piece of 3 m"},
        {6, 0.03, "price of a bar of 6 m"}}},
      {"1/kg", {{1e-3, 0.06, "price a gram"}, {0.453592, 0.06, "price a pound"}, {1000, 0.06, "price a tonne"}}},
  };
  return all;
}

struct ColumnSlips {
  Family family;
  std::string_view column;
  std::vector<Slip> slips;
};

/// What data sheets state in two ways, so that one is easily taken for the other.
const std::vector<ColumnSlips>& by_column() {
  static const std::vector<ColumnSlips> all = {
      {Family::steppers,
       "holding_torque",
       {{0.707107, 0.1, "torque with one phase on, where two are meant (column phases_on)"},
        {1.414214, 0.03, "torque with two phases on, where one is said"}}},
      {Family::linear_guides,
       "dynamic_load_rating",
       {{0.793701, 0.15, "C for 100 km of travel, where 50 km are said (column rating_distance)"},
        {1.259921, 0.08, "C for 50 km of travel, where 100 km are said (column rating_distance)"}}},
  };
  return all;
}

constexpr std::array<Slip, 8> general = {{{10, 0.14, "decimal point, or a unit ten times smaller"},
                                          {0.1, 0.14, "decimal point, or a unit ten times larger"},
                                          {100, 0.04, "decimal point, or a unit a hundred times smaller"},
                                          {0.01, 0.04, "decimal point, or a unit a hundred times larger"},
                                          {1000, 0.05, "thousands point read as decimal, or a prefix"},
                                          {0.001, 0.05, "decimal point read as thousands, or a prefix"},
                                          {2, 0.02, "counted twice"},
                                          {0.5, 0.02, "counted half"}}};

bool same_factor(double a, double b) { return a < b * 1.001 && b < a * 1.001; }

/// Adds slips to others, the same one once.
void merge(std::span<const Slip> more, std::vector<Slip>& slips) {
  for (const Slip& each : more) {
    const auto there =
        std::find_if(slips.begin(), slips.end(), [&](const Slip& one) { return same_factor(one.factor, each.factor); });
    if (there != slips.end())
      there->weight += each.weight;
    else
      slips.push_back(each);
  }
}

std::vector<Slip> slips_of(Column column) {
  const ColumnDeclaration& declared = declaration(column);
  std::vector<Slip> slips;
  for (const ColumnSlips& each : by_column()) {
    if (each.family == column.family && each.column == declared.name) merge(each.slips, slips);
  }
  for (const UnitSlips& each : by_unit()) {
    if (each.unit == declared.unit) merge(each.slips, slips);
  }
  merge(general, slips);
  return slips;
}

}  // namespace

std::span<const Slip> slips(Column column) {
  static const std::vector<std::vector<std::vector<Slip>>> all = [] {
    std::vector<std::vector<std::vector<Slip>>> of_family(family_count);
    for (const FamilyDeclaration& each : families) {
      for (std::size_t i = 0; i < column_count(each.family); ++i)
        of_family[static_cast<std::size_t>(each.family)].push_back(
            slips_of({each.family, static_cast<std::uint8_t>(i)}));
    }
    return of_family;
  }();
  return all[static_cast<std::size_t>(column.family)][column.index];
}

std::string times(double factor) {
  const bool large = factor >= 1.0;
  return fmt::format(
      "{} times too {}", scalar::format_number(large ? factor : 1.0 / factor, 3), large ? "large" : "small");
}

}  // namespace millwright::catalogue
