// SPDX-License-Identifier: Apache-2.0
// Rules that compare figures of a row exactly, for threads, fasteners, bearings, guides, sections and materials.
// Figures are in declared units; what only usually holds is in relation.h.
#include <cmath>
#include <numbers>

#include "catalogue/lint_row.h"
#include "scalar/elementary.h"

namespace millwright::catalogue {
namespace {

/// Tensile stress area of an ISO metric thread, ISO 898-1: pi/4 ((d2 + d3)/2)^2, in mm2.
double stress_area(double diameter, double pitch) {
  return std::numbers::pi / 4 * scalar::square(diameter - 0.938194 * pitch);
}

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
}

void lint_support_bearing(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::support_bearings, name); };
  row.at_most("bore", of("bore"), of("screw_diameter"));
}

void lint_guide(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::linear_guides, name); };
  constexpr Column distance = of("rating_distance");
  row.demand("rating-distance",
             distance,
             !(row(distance) != 50 && std::abs(row(distance) - 100) > 1e-9),
             "load ratings are stated for 50 or 100 km");
  row.at_most("block-width", of("rail_width"), of("block_width"));
  row.at_most("rail-height", of("rail_height"), of("assembly_height"));
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

void lint_material(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::materials, name); };
  constexpr Column modulus = of("elastic_modulus"), shear = of("shear_modulus"), poisson = of("poisson_ratio"),
                   yield = of("yield_strength");
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
