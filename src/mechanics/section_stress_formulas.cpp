// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/section_stress.h"

namespace millwright::mechanics {

void define_section_stress(FormulaList& list) {
  define(
      list,
      {.name = "section.bending_stress",
       .handbook_id = "STRESS-BENDING",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Bending stress at the extreme fibre",
       .source = "khurmi_gupta2005, chapter 5",
       .validity = "linear elastic, away from where the load enters"},
      [](const auto&... x) { return section::bending_stress(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).falling(),
      quantity("fibre_distance", "c", "m", "distance of the extreme fibre").rising());

  define(
      list,
      {.name = "section.round_torsional_stress",
       .handbook_id = "STRESS-TORSION-ROUND",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Shear stress at the surface of a round bar in torsion",
       .source = "khurmi_gupta2005, chapter 5",
       .validity = "linear elastic, away from where the load enters"},
      [](const auto&... x) { return section::round_torsional_stress(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("diameter", "d", "m", "diameter of a solid round bar").falling());

  define(
      list,
      {.name = "section.thin_tube_torsional_stress",
       .handbook_id = "STRESS-TORSION-THIN-TUBE",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Shear stress in the wall of a closed thin-walled tube in torsion",
       .source = "khurmi_gupta2005, chapter 5",
       .validity = "linear elastic, wall thin"},
      [](const auto&... x) { return section::thin_tube_torsional_stress(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("enclosed_area", "A_m", "m^2", "area enclosed by the wall mid-line").falling(),
      quantity("wall_thickness", "t", "m", "wall").falling());

  define(
      list,
      {.name = "section.twist",
       .handbook_id = "STRUCT-TWIST",
       .symbol = "θ",
       .unit = "rad",
       .title = "Twist of a bar in torsion",
       .source = "khurmi_gupta2005, chapter 5",
       .validity = "linear elastic, free to warp"},
      [](const auto&... x) { return section::twist(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(2e9, 9e10).falling(),
      quantity("torsion_constant", "J", "m^4", "torsion constant").falling());

  define(
      list,
      {.name = "section.diameter_of_square",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter from its square",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return section::diameter_of_square(x...); },
      quantity("diameter_squared", "s", "m^2", "diameter squared").typical(1e-7, 1e-3).rising());

  define(
      list,
      {.name = "section.direct_stress",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Direct stress",
       .source = "khurmi_gupta2005, chapter 4",
       .validity = "force through the centroid"},
      [](const auto&... x) { return section::direct_stress(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("area", "A", "m^2", "area").falling());

  define(
      list,
      {.name = "section.round_direct_stress",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Direct stress in a round bar",
       .source = "khurmi_gupta2005, chapter 4",
       .validity = "force through the centroid"},
      [](const auto&... x) { return section::round_direct_stress(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("diameter", "d", "m", "diameter").falling());

  define(
      list,
      {.name = "section.stress_radicand",
       .symbol = "q",
       .unit = "Pa^2",
       .title = "What stands under the root of the principal stresses",
       .source = "torch_table, eq. 20; khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::stress_radicand(x...); },
      quantity("normal_stress", "σ", "Pa", "normal stress").rising(),
      quantity("shear_stress", "τ", "Pa", "shear stress").rising());

  define(
      list,
      {.name = "section.stress_root",
       .symbol = "√q",
       .unit = "Pa",
       .title = "Root in the principal stresses, twice the maximum shear stress",
       .source = "torch_table, eq. 20; khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::stress_root(x...); },
      quantity("normal_stress", "σ", "Pa", "normal stress").rising(),
      quantity("shear_stress", "τ", "Pa", "shear stress").rising());

  define(
      list,
      {.name = "section.stress_of_radicand",
       .symbol = "√q",
       .unit = "Pa",
       .title = "Root in the principal stresses, from its radicand",
       .source = "torch_table, eq. 20; khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::stress_of_radicand(x...); },
      quantity("radicand", "q", "Pa^2", "square of the normal plus four squares of the shear stress")
          .typical(1e12, 1e18)
          .rising());

  define(
      list,
      {.name = "section.bending_stress_of_modulus",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Bending stress from the section modulus",
       .source = "khurmi_gupta2005, chapter 5",
       .validity = "linear elastic"},
      [](const auto&... x) { return section::bending_stress_of_modulus(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("section_modulus", "Z", "m^3", "section modulus").falling());

  define(
      list,
      {.name = "section.modulus",
       .symbol = "Z",
       .unit = "m^3",
       .title = "Section modulus",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::modulus(x...); },
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("fibre_distance", "c", "m", "distance of the extreme fibre from the neutral axis").falling());
}

}  // namespace millwright::mechanics
