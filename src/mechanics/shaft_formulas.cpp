// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/shaft.h"

namespace millwright::mechanics {

void define_shaft(FormulaList& list) {
  define(
      list,
      {.name = "shaft.required_diameter_bending",
       .handbook_id = "SHAFT-DIAM-BENDING",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter for a bending moment",
       .source = "khurmi_gupta2005, 14.5",
       .validity = "solid round shaft, steady rotation"},
      [](const auto&... x) { return shaft::required_diameter_bending(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("allowable_bending_stress", "σ_b", "Pa", "allowable bending stress").falling());

  define(
      list,
      {.name = "shaft.required_diameter_maximum_shear",
       .handbook_id = "SHAFT-DIAM-MAX-SHEAR",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter for bending and torsion by the largest shear stress",
       .source = "khurmi_gupta2005, 14.9, 14.11; sularso_suga, chapter 1",
       .validity = "solid round shaft, steady rotation"},
      [](const auto&... x) { return shaft::required_diameter_maximum_shear(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("bending_factor", "K_m", "1", "bending shock factor").at_least(1).typical(1, 3).rising(),
      quantity("torsion_factor", "K_t", "1", "torsion shock factor").at_least(1).typical(1, 3).rising(),
      quantity("allowable_shear_stress", "τ_a", "Pa", "allowable shear stress").falling());

  define(
      list,
      {.name = "shaft.required_diameter_von_mises",
       .handbook_id = "SHAFT-DIAM-VONMISES",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter for bending and torsion by the distortion energy",
       .source = "khurmi_gupta2005, chapter 14",
       .validity = "solid round shaft, steady rotation"},
      [](const auto&... x) { return shaft::required_diameter_von_mises(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("bending_factor", "K_m", "1", "bending shock factor").at_least(1).typical(1, 3).rising(),
      quantity("torsion_factor", "K_t", "1", "torsion shock factor").at_least(1).typical(1, 3).rising(),
      quantity("allowable_stress", "σ_a", "Pa", "allowable normal stress").falling());

  define(
      list,
      {.name = "shaft.required_diameter_torsion",
       .handbook_id = "SHAFT-DIAM-SULARSO-TORSION",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter for torsion with bending not yet known, allowed for by a factor of 1.2 to 2.3",
       .source = "sularso_suga, chapter 1",
       .validity = "solid round shaft, steady rotation"},
      [](const auto&... x) { return shaft::required_diameter_torsion(x...); },
      quantity("torque", "T", "N.m", "design torque").rising(),
      quantity("torsion_factor", "K_t", "1", "torsion shock factor").at_least(1).typical(1, 3).rising(),
      quantity("bending_allowance", "C_b", "1", "bending allowance factor").at_least(1).typical(1.2, 2.3).rising(),
      quantity("allowable_shear_stress", "τ_a", "Pa", "allowable shear stress").falling());

  define(
      list,
      {.name = "shaft.required_diameter_twist",
       .handbook_id = "SHAFT-TWIST-LIMIT-DIAM",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter for a permitted twist",
       .source = "khurmi_gupta2005, chapter 14",
       .validity = "solid round shaft, steady rotation"},
      [](const auto&... x) { return shaft::required_diameter_twist(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(2e9, 9e10).falling(),
      quantity("permitted_twist", "θ", "rad", "permitted twist").typical(1e-4, 0.05).falling());

  define(
      list,
      {.name = "shaft.torque_of_power",
       .symbol = "T",
       .unit = "N.m",
       .title = "Torque of a shaft from its power",
       .source = "sularso_suga, chapter 1; mini_mill, eq. 18"},
      [](const auto&... x) { return shaft::torque_of_power(x...); },
      quantity("power", "P", "W", "power").rising(),
      quantity("angular_speed", "ω", "rad/s", "angular speed").falling());

  define(
      list,
      {.name = "shaft.twist",
       .symbol = "θ",
       .unit = "rad",
       .title = "Twist of a solid round shaft",
       .source = "sularso_suga, chapter 1; mini_mill, eq. 19",
       .validity = "linear elastic"},
      [](const auto&... x) { return shaft::twist(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("length", "L", "m", "length").rising(),
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(2e9, 9e10).falling(),
      quantity("diameter", "d", "m", "diameter").falling());

  define(
      list,
      {.name = "shaft.bending_constant",
       .symbol = "c",
       .unit = "Pa",
       .title = "Bending moment that a solid round shaft bears per cube of its diameter",
       .source = "torch_table, eq. 14"},
      [](const auto&... x) { return shaft::bending_constant(x...); },
      quantity("bending_stress", "σ_b", "Pa", "bending stress").rising());

  define(
      list,
      {.name = "shaft.diameter_cubed",
       .symbol = "d³",
       .unit = "m^3",
       .title = "Cube of the diameter of a shaft in bending",
       .source = "torch_table, eq. 14"},
      [](const auto&... x) { return shaft::diameter_cubed(x...); },
      quantity("moment", "M", "N.m", "bending moment").rising(),
      quantity("bending_constant", "c", "Pa", "moment per cube of the diameter").falling());

  define(
      list,
      {.name = "shaft.diameter_of_cube",
       .symbol = "d",
       .unit = "m",
       .title = "Diameter from its cube",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return shaft::diameter_of_cube(x...); },
      quantity("diameter_cubed", "q", "m^3", "diameter cubed").typical(1e-10, 1e-4).rising());
}

}  // namespace millwright::mechanics
