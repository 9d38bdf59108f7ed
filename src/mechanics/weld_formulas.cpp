// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/weld.h"

namespace millwright::mechanics {

void define_weld(FormulaList& list) {
  define(
      list,
      {.name = "weld.throat",
       .handbook_id = "WELD-THROAT",
       .symbol = "t",
       .unit = "m",
       .title = "Throat of an equal-leg fillet weld",
       .source = "khurmi_gupta2005, chapter 10",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::throat(x...); },
      quantity("leg_length", "s", "m", "leg length of an equal-leg fillet weld").rising());

  define(
      list,
      {.name = "weld.direct_stress",
       .handbook_id = "WELD-DIRECT-STRESS",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Shear stress on the throat when the force is shared evenly",
       .source = "khurmi_gupta2005, chapter 10",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::direct_stress(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("leg_length", "s", "m", "leg length").falling(),
      quantity("weld_length", "l", "m", "total weld length").falling());

  define(
      list,
      {.name = "weld.rectangle_section_modulus",
       .handbook_id = "WELD-RECT-BENDING-Z",
       .symbol = "Z",
       .unit = "m^3",
       .title = "Section modulus of a weld all around a rectangle",
       .source = "khurmi_gupta2005, Table 10.7",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::rectangle_section_modulus(x...); },
      quantity("throat", "t", "m", "throat").rising(),
      quantity("width", "b", "m", "width of the welded rectangle (parallel to the bending axis)").rising(),
      quantity("height", "d", "m", "height").rising());

  define(
      list,
      {.name = "weld.rectangle_polar_moment",
       .handbook_id = "WELD-RECT-TORSION-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Polar moment of a weld all around a rectangle",
       .source = "khurmi_gupta2005, Table 10.7",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::rectangle_polar_moment(x...); },
      quantity("throat", "t", "m", "throat").rising(),
      quantity("width", "b", "m", "width").rising(),
      quantity("height", "d", "m", "height of the welded rectangle").rising());

  define(
      list,
      {.name = "weld.parallel_polar_moment",
       .handbook_id = "WELD-2PAR-TORSION-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Polar moment of two parallel welds",
       .source = "khurmi_gupta2005, chapter 10",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::parallel_polar_moment(x...); },
      quantity("throat", "t", "m", "throat").rising(),
      quantity("weld_length", "l", "m", "length of each of two parallel welds").rising(),
      quantity("weld_distance", "w", "m", "distance between them").rising());

  define(
      list,
      {.name = "weld.combined_stress",
       .handbook_id = "WELD-COMBINED",
       .symbol = "τ_eq",
       .unit = "Pa",
       .title = "Equivalent stress on the throat",
       .source = "shigley, chapter 9",
       .validity = "fillet weld with equal legs, stress even over the throat; safe side"},
      [](const auto&... x) { return weld::combined_stress(x...); },
      quantity("direct_stress", "τ_d", "Pa", "direct stress").rising(),
      quantity("bending_stress", "σ_b", "Pa", "bending stress on the throat").rising(),
      quantity("torsional_stress", "τ_t", "Pa", "torsional stress on the throat").rising());

  define(
      list,
      {.name = "weld.eccentric_stress",
       .handbook_id = "WELD-ECCENTRIC-2PAR",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Shear stress at the worst corner of two parallel welds under an in-plane force square to the welds "
                "and off their centroid",
       .source = "bhandari, example 8.9",
       .validity = "fillet weld with equal legs, stress even over the throat"},
      [](const auto&... x) { return weld::eccentric_stress(x...); },
      quantity("force", "P", "N", "in-plane force parallel to the welds' perpendicular (see text)").rising(),
      quantity("eccentricity", "e", "m", "distance of the force from the weld-group centroid").rising(),
      quantity("throat", "t", "m", "throat").falling(),
      quantity("weld_length", "l", "m", "length of each weld").falling(),
      quantity("weld_distance", "w", "m", "distance between the two welds"));

  define(
      list,
      {.name = "weld.allowable_stress",
       .symbol = "τ_a",
       .unit = "Pa",
       .title = "Allowable stress on the throat from the strength of the electrode",
       .source = "shigley, chapter 9"},
      [](const auto&... x) { return weld::allowable_stress(x...); },
      quantity("electrode_strength", "S_u", "Pa", "tensile strength of the electrode").rising(),
      quantity("fraction", "c", "1", "permitted share").between(0, 1).typical(0.2, 0.6).rising());
}

}  // namespace millwright::mechanics
