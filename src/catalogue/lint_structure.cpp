// SPDX-License-Identifier: Apache-2.0
// Plausibility rules for threads, fasteners, bearings, guides, sections and materials. Figures are in declared units.
#include <array>
#include <cmath>
#include <numbers>

#include "catalogue/lint_row.h"

namespace millwright::catalogue {
namespace {

constexpr double pi = std::numbers::pi;

double square(double x) { return x * x; }

/// Tensile stress area of an ISO metric thread, ISO 898-1: pi/4 ((d2 + d3)/2)^2, in mm2.
double stress_area(double diameter, double pitch) { return pi / 4 * square(diameter - 0.938194 * pitch); }

void lint_thread(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::threads, name); };
  const double diameter = row(of("nominal_diameter"));
  const double pitch = row(of("pitch"));
  row.below("root-diameter", of("minor_diameter_external"), of("pitch_diameter"));
  row.below("root-diameter", of("pitch_diameter"), of("nominal_diameter"));
  row.agrees("iso-724", of("pitch_diameter"), diameter - 0.649519 * pitch, 0.002, 0.05, "d - 0.6495 P");
  row.agrees("iso-724", of("minor_diameter_external"), diameter - 1.226869 * pitch, 0.003, 0.05, "d - 1.2269 P");
  row.agrees("iso-724", of("minor_diameter_internal"), diameter - 1.082532 * pitch, 0.003, 0.05, "d - 1.0825 P");
  row.agrees("stress-area",
             of("tensile_stress_area"),
             stress_area(diameter, pitch),
             0.02,
             0.1,
             "the stress area of ISO 898-1");
  row.below("clearance-hole", of("nominal_diameter"), of("clearance_hole_diameter"));
  row.below("tap-drill", of("tap_drill_diameter"), of("nominal_diameter"));
}

void lint_fastener(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::screws, name); };
  constexpr Column area = of("tensile_stress_area"), proof = of("proof_strength"), preload = of("maximum_preload");
  row.agrees("stress-area",
             area,
             stress_area(row(of("nominal_diameter")), row(of("pitch"))),
             0.02,
             0.1,
             "the stress area of ISO 898-1");
  row.at_most("strength-order", proof, of("yield_strength"));
  row.below("strength-order", of("yield_strength"), of("tensile_strength"));
  row.agrees("proof-load", of("proof_load"), row(proof) * row(area), 0.02, 0.1, "proof strength x stress area");
  row.agrees("ultimate-load",
             of("ultimate_load"),
             row(of("tensile_strength")) * row(area),
             0.02,
             0.1,
             "tensile strength x stress area");
  row.below("preload", preload, of("proof_load"));
  const double nut_factor = row(of("tightening_torque")) / (row(preload) * row(of("nominal_diameter")) * 1e-3);
  row.within("tightening-torque",
             of("tightening_torque"),
             nut_factor,
             {0.03, 0.1, 0.35, 1},
             "nut factor K = torque / (preload x diameter)");
}

void lint_support_bearing(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::support_bearings, name); };
  constexpr Column bore = of("bore"), dynamic = of("dynamic_load_rating");
  row.at_most("bore", bore, of("screw_diameter"));
  row.within("load-ratings",
             of("static_load_rating"),
             row(of("static_load_rating")) / row(dynamic),
             {0.1, 0.25, 4, 10},
             "C0 / C");
  row.within("axial-load",
             of("permissible_axial_load"),
             row(of("permissible_axial_load")) / row(dynamic),
             {0.03, 0.15, 3, 10},
             "permissible axial load / C");
  row.within("maximum-speed",
             of("maximum_speed"),
             row(bore) * row(of("maximum_speed")),
             {1e3, 5e3, 1e6, 3e6},
             "bore x speed in mm.rpm");
}

void lint_guide(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::linear_guides, name); };
  constexpr Column fixed = of("static_load_rating"), distance = of("rating_distance"),
                   rail = of("rail_mass_per_length");
  row.within("load-ratings", fixed, row(fixed) / row(of("dynamic_load_rating")), {0.4, 0.7, 4, 10}, "C0 / C");
  row.demand("rating-distance",
             distance,
             !(row(distance) != 50 && std::abs(row(distance) - 100) > 1e-9),
             "load ratings are stated for 50 or 100 km");
  row.at_most("block-width", of("rail_width"), of("block_width"));
  row.at_most("rail-height", of("rail_height"), of("assembly_height"));
  const double roll = row(fixed) * row(of("rail_width")) * 1e-3;
  row.within("moment-rating",
             of("roll_moment_rating"),
             row(of("roll_moment_rating")) / roll,
             {0.05, 0.2, 1.0, 5},
             "roll moment / (C0 x rail width)");
  const double pitch = row(fixed) * row(of("block_length")) * 1e-3;
  row.within("moment-rating",
             of("pitch_moment_rating"),
             row(of("pitch_moment_rating")) / pitch,
             {0.01, 0.04, 0.4, 2},
             "pitch moment / (C0 x block length)");
  const double block = row(of("block_length")) * row(of("block_width")) * row(of("assembly_height"));
  row.within("carriage-mass",
             of("carriage_mass"),
             row(of("carriage_mass")) / block * 1e6,
             {0.5, 1.2, 6, 7.85},
             "carriage mass / envelope in kg/dm3");
  const double solid = row(of("rail_width")) * row(of("rail_height")) * 7.85e-3;
  row.within(
      "rail-mass", rail, row(rail) / solid, {0.15, 0.4, 1.1, 3}, "rail mass / solid steel of that width and height");
}

/// What profiles and steel sections have in common; `density` in kg/mm3.
void lint_section(Family family, const LintRow& row, double density, bool symmetric_x, bool symmetric_y) {
  const auto of = [family](std::string_view name) { return column(family, name); };
  const double height = row(of("height"));
  const double width = row(of("width"));
  const double area = row(of("area"));
  row.within("area", of("area"), area / (height * width), {0.01, 0.03, 1.001, 1.05}, "area / (height x width)");
  row.agrees("section-mass", of("mass_per_length"), area * density * 1e3, 0.05, 0.3, "area x density");
  const double by_height = row(of("second_moment_x"));
  const double by_width = row(of("second_moment_y"));
  row.within("second-moment",
             of("second_moment_x"),
             std::sqrt(by_height / area) / height,
             {0.1, 0.2, 0.45, 0.5},
             "radius of gyration / height");
  row.within("second-moment",
             of("second_moment_y"),
             std::sqrt(by_width / area) / width,
             {0.1, 0.2, 0.45, 0.5},
             "radius of gyration / width");
  row.expect("strong-axis",
             of("second_moment_x"),
             !(height >= width && by_height < 0.999 * by_width),
             "bends easier over the greater dimension: x and y swapped?");
  if (symmetric_x)
    row.agrees("section-modulus",
               of("section_modulus_x"),
               2 * by_height / height,
               0.03,
               0.3,
               "second moment / half the height");
  if (symmetric_y)
    row.agrees(
        "section-modulus", of("section_modulus_y"), 2 * by_width / width, 0.03, 0.3, "second moment / half the width");
}

void lint_material_class(const LintRow& row) {
  struct MaterialClass {
    std::string_view name;
    double modulus_lower, modulus_upper;      // MPa
    double density_lower, density_upper;      // kg/m3
    double expansion_lower, expansion_upper;  // 1/K
  };
  static constexpr std::array<MaterialClass, 5> classes = {{{"steel", 185e3, 220e3, 7600, 8200, 9e-6, 2e-5},
                                                            {"iron", 60e3, 190e3, 6800, 7500, 8e-6, 1.5e-5},
                                                            {"aluminium", 65e3, 80e3, 2500, 2950, 1.8e-5, 2.6e-5},
                                                            {"copper alloy", 85e3, 140e3, 7400, 9000, 1.5e-5, 2.3e-5},
                                                            {"polymer", 100, 20e3, 800, 2300, 1.5e-5, 2.5e-4}}};
  constexpr auto of = [](std::string_view name) { return column(Family::materials, name); };
  for (const MaterialClass& each : classes) {
    if (row.text(of("class")) != each.name) continue;
    row.within("material-class",
               of("elastic_modulus"),
               row(of("elastic_modulus")),
               {each.modulus_lower / 3, each.modulus_lower, each.modulus_upper, each.modulus_upper * 3},
               "the elastic modulus in MPa for its class");
    row.within("material-class",
               of("density"),
               row(of("density")),
               {each.density_lower / 2, each.density_lower, each.density_upper, each.density_upper * 2},
               "the density in kg/m3 for its class");
    row.within("material-class",
               of("thermal_expansion"),
               row(of("thermal_expansion")) * 1e6,
               {each.expansion_lower * 3e5,
                each.expansion_lower * 1e6,
                each.expansion_upper * 1e6,
                each.expansion_upper * 3e6},
               "the thermal expansion in 1e-6/K for its class");
  }
}

void lint_material(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::materials, name); };
  constexpr Column modulus = of("elastic_modulus"), shear = of("shear_modulus"), poisson = of("poisson_ratio"),
                   yield = of("yield_strength");
  lint_material_class(row);
  row.at_most("strength-order", yield, of("ultimate_strength"));
  row.below("strength-order", of("endurance_limit"), of("ultimate_strength"));
  row.agrees("shear-modulus", shear, row(modulus) / (2 * (1 + row(poisson))), 0.05, 0.3, "E / (2 (1 + nu))");
  row.agrees(
      "shear-yield", of("shear_yield_strength"), row(yield) / std::sqrt(3.0), 0.15, 1.0, "yield strength / sqrt(3)");
  row.within(
      "yield-strain", yield, row(yield) / row(modulus), {1e-5, 1e-4, 0.1, 1}, "yield strength / elastic modulus");
}

}  // namespace

void lint_structure(Family family, const LintRow& row) {
  switch (family) {
    case Family::threads:
      return lint_thread(row);
    case Family::screws:
      return lint_fastener(row);
    case Family::support_bearings:
      return lint_support_bearing(row);
    case Family::linear_guides:
      return lint_guide(row);
    case Family::extrusions:
      return lint_section(family, row, 2.7e-6, true, true);
    case Family::steel_sections: {
      const std::string_view kind = row.text(column(family, "kind"));
      const bool angle = kind.find("angle") != kind.npos;
      return lint_section(family, row, 7.85e-6, !angle, !angle && kind.find("channel") == kind.npos);
    }
    case Family::materials:
      return lint_material(row);
    default:
      return;
  }
}

}  // namespace millwright::catalogue
