// SPDX-License-Identifier: Apache-2.0
// The mistakes that people make when they copy figures out of data sheets, sown into rows of the shipped catalogues.
// The kinds come from what such tables get wrong (units of the sheet's own country, decimal signs, columns read one
// off, bases of ratings, radius and diameter), not from what lint looks for; some cannot always be seen.
#pragma once

#include <string>
#include <vector>

#include "catalogue/family.h"

namespace seeded {

using millwright::catalogue::Family;

/// A column, as "family.column".
struct Place {
  Family family;
  std::string column;
};

enum class Change {
  factor,      ///< the figure times `factor`
  swap,        ///< two figures of the row: places come in pairs
  whole_file,  ///< the column of every row of the file times `factor`
  drop_digit,  ///< one digit before the decimal point (or the first that counts) is left out
  double_digit,
  move_point,    ///< the decimal point one place to the left or right
  lose_point,    ///< the decimal sign is lost
  turn_digits,   ///< the first two different neighbouring digits change places
  other_row,     ///< the figure of another row of the file, at least twice or half as large
  next_column,   ///< the figures of the two numeric columns that stand side by side change places
  replace_with,  ///< the figure becomes `factor`
};

struct Kind {
  std::string name;
  Change change;
  double factor = 1.0;
  std::vector<Place> places;  ///< empty: every number of every family
  double at_least = 0.0;      ///< share that must be found
};

/// What came of one kind.
struct Outcome {
  int sown = 0;
  int found = 0;   ///< lint reports something about the row that it did not report before
  int blamed = 0;  ///< ... at the figure that was changed, or names its column
};

/// All kinds.
inline const std::vector<Kind>& kinds() {
  using enum Family;
  using enum Change;
  static const std::vector<Kind> all = {
      // Motors
      {"N.cm read as N.m", factor, 100, {{steppers, "holding_torque"}, {couplings, "rated_torque"}}, 0.95},
      {"kgf.cm read as N.m", factor, 10.1972, {{steppers, "holding_torque"}, {couplings, "rated_torque"}}, 0.9},
      {"oz.in read as N.m", factor, 141.612, {{steppers, "holding_torque"}, {couplings, "maximum_torque"}}, 0.95},
      {"uH read as mH", factor, 1000, {{steppers, "phase_inductance"}}, 0.95},
      {"inductance ten times (35 mH for 3.5)", factor, 10, {{steppers, "phase_inductance"}}, 0.9},
      {"kg.cm2 read as g.cm2",
       factor,
       1e-3,
       {{steppers, "rotor_inertia"}, {couplings, "inertia"}, {pulleys, "inertia"}},
       0.95},
      {"g.mm2 read as g.cm2",
       factor,
       100,
       {{steppers, "rotor_inertia"}, {couplings, "inertia"}, {pinions, "inertia"}},
       0.95},
      {"mOhm read as ohm", factor, 1000, {{steppers, "phase_resistance"}}, 0.95},
      {"mA read as A",
       factor,
       1000,
       {{steppers, "rated_current"}, {drivers, "peak_current"}, {power_supplies, "output_current"}},
       0.95},
      {"resistance and inductance swapped",
       swap,
       1,
       {{steppers, "phase_resistance"}, {steppers, "phase_inductance"}},
       0.3},
      {"current of the parallel winding", factor, 2, {{steppers, "rated_current"}}, 0.4},
      {"torque with one phase on", factor, 0.707107, {{steppers, "holding_torque"}}, 0.3},
      // Masses
      {"g read as kg",
       factor,
       1000,
       {{steppers, "mass"},
        {couplings, "mass"},
        {lead_nuts, "mass"},
        {drivers, "mass"},
        {support_bearings, "mass"},
        {linear_guides, "carriage_mass"},
        {ball_screws, "nut_mass"}},
       0.95},
      {"lb read as kg",
       factor,
       2.20462,
       {{steppers, "mass"},
        {couplings, "mass"},
        {linear_guides, "carriage_mass"},
        {ball_screws, "nut_mass"},
        {power_supplies, "mass"}},
       0.5},
      {"g/m read as kg/m",
       factor,
       1000,
       {{belts, "mass_per_length"},
        {ball_screws, "screw_mass_per_length"},
        {linear_guides, "rail_mass_per_length"},
        {extrusions, "mass_per_length"}},
       0.95},
      {"lb/ft read as kg/m",
       factor,
       0.671969,
       {{ball_screws, "screw_mass_per_length"},
        {linear_guides, "rail_mass_per_length"},
        {steel_sections, "mass_per_length"},
        {extrusions, "mass_per_length"}},
       0.9},
      // Loads
      {"kgf read as N",
       factor,
       0.101972,
       {{ball_screws, "dynamic_load_rating"},
        {ball_screws, "static_load_rating"},
        {linear_guides, "static_load_rating"},
        {linear_guides, "dynamic_load_rating"},
        {support_bearings, "dynamic_load_rating"}},
       0.95},
      {"kN read as N",
       factor,
       1e-3,
       {{ball_screws, "dynamic_load_rating"},
        {linear_guides, "static_load_rating"},
        {support_bearings, "dynamic_load_rating"},
        {screws, "proof_load"}},
       0.95},
      {"lbf read as N",
       factor,
       0.224809,
       {{ball_screws, "dynamic_load_rating"}, {linear_guides, "dynamic_load_rating"}, {belts, "allowable_tension"}},
       0.7},
      {"C and C0 swapped",
       swap,
       1,
       {{ball_screws, "dynamic_load_rating"},
        {ball_screws, "static_load_rating"},
        {linear_guides, "dynamic_load_rating"},
        {linear_guides, "static_load_rating"},
        {support_bearings, "dynamic_load_rating"},
        {support_bearings, "static_load_rating"}},
       0.8},
      {"100 km said where the maker rates for 50 km", replace_with, 100, {{linear_guides, "rating_distance"}}, 0.5},
      {"rating for 100 km given for 50 km", factor, 0.793701, {{linear_guides, "dynamic_load_rating"}}, 0.3},
      {"kgf/um read as N/um",
       factor,
       0.101972,
       {{ball_screws, "nut_stiffness"}, {support_bearings, "axial_stiffness"}, {linear_guides, "radial_stiffness"}},
       0.9},
      // Lengths
      {"inch read as mm",
       factor,
       0.0393701,
       {{steppers, "body_length"},
        {steppers, "frame_size"},
        {ball_screws, "nominal_diameter"},
        {lead_screws, "major_diameter"},
        {couplings, "outside_diameter"},
        {pulleys, "bore"},
        {extrusions, "width"},
        {linear_guides, "block_length"}},
       0.95},
      {"cm read as mm",
       factor,
       0.1,
       {{steppers, "body_length"},
        {ball_screws, "maximum_length"},
        {linear_guides, "block_width"},
        {extrusions, "height"},
        {couplings, "length"}},
       0.9},
      {"radius for diameter",
       factor,
       0.5,
       {{ball_screws, "root_diameter"},
        {ball_screws, "nut_outside_diameter"},
        {lead_screws, "pitch_diameter"},
        {couplings, "outside_diameter"},
        {pulleys, "pitch_diameter"},
        {pinions, "outside_diameter"},
        {lead_nuts, "outside_diameter"}},
       0.9},
      {"root and outside diameter swapped",
       swap,
       1,
       {{ball_screws, "outside_diameter"},
        {ball_screws, "root_diameter"},
        {lead_screws, "major_diameter"},
        {lead_screws, "minor_diameter"}},
       0.95},
      {"pitch for lead",
       swap,
       1,
       {{lead_screws, "starts"}, {lead_screws, "lead"}, {ball_screws, "starts"}, {ball_screws, "lead"}},
       0.9},
      {"mm read as um",
       factor,
       1e-3,
       {{ball_screws, "lead_error_per_300mm"}, {lead_screws, "lead_error_per_300mm"}},
       0.95},
      // Sections and materials
      {"cm4 read as mm4",
       factor,
       1e-4,
       {{steel_sections, "second_moment_x"}, {extrusions, "second_moment_y"}, {steel_sections, "torsion_constant"}},
       0.95},
      {"cm3 read as mm3",
       factor,
       1e-3,
       {{steel_sections, "section_modulus_x"}, {extrusions, "section_modulus_y"}},
       0.95},
      {"strong and weak axis swapped",
       swap,
       1,
       {{steel_sections, "second_moment_x"},
        {steel_sections, "second_moment_y"},
        {extrusions, "second_moment_x"},
        {extrusions, "second_moment_y"}},
       0.95},
      {"GPa read as MPa",
       factor,
       1e-3,
       {{materials, "elastic_modulus"}, {extrusions, "elastic_modulus"}, {materials, "shear_modulus"}},
       0.95},
      {"ksi read as MPa",
       factor,
       0.145038,
       {{materials, "yield_strength"},
        {materials, "ultimate_strength"},
        {lead_screws, "yield_strength"},
        {screws, "tensile_strength"}},
       0.8},
      {"g/cm3 read as kg/m3", factor, 1e-3, {{materials, "density"}}, 0.95},
      {"N.m/deg read as N.m/rad", factor, 0.0174533, {{couplings, "torsional_stiffness"}}, 0.7},
      {"kW read as W", factor, 1e-3, {{power_supplies, "power"}}, 0.95},
      // Prices
      {"price of a hundred",
       factor,
       100,
       {{screws, "price"}, {lead_nuts, "price"}, {couplings, "price"}, {pulleys, "price"}},
       0.9},
      {"price in cents",
       factor,
       100,
       {{steppers, "price"}, {drivers, "price"}, {support_bearings, "price"}, {belts, "price_per_length"}},
       0.9},
      {"price a millimetre",
       factor,
       1e-3,
       {{ball_screws, "price_per_length"}, {extrusions, "price_per_length"}, {racks, "price_per_length"}},
       0.95},
      {"price in another currency (rupiah)",
       factor,
       15500,
       {{steppers, "price"}, {linear_guides, "price"}, {ball_screws, "price"}},
       0.95},
      // Whole columns under a wrong header
      {"whole column: N.cm as N.m", whole_file, 100, {{steppers, "holding_torque"}}, 0.95},
      {"whole column: kg.cm2 as g.cm2", whole_file, 1e-3, {{steppers, "rotor_inertia"}}, 0.95},
      {"whole column: kgf as N",
       whole_file,
       0.101972,
       {{ball_screws, "static_load_rating"}, {linear_guides, "static_load_rating"}},
       0.95},
      {"whole column: lb as kg", whole_file, 2.20462, {{steppers, "mass"}}, 0.6},
      // Typing
      {"decimal point moved", move_point, 1, {}, 0.8},
      {"decimal sign lost", lose_point, 1, {}, 0.8},
      {"digit left out", drop_digit, 1, {}, 0.8},
      {"digit typed twice", double_digit, 1, {}, 0.8},
      {"neighbouring columns swapped", next_column, 1, {}, 0.75},
  };
  return all;
}

}  // namespace seeded
