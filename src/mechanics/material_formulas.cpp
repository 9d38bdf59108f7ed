// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/material.h"

namespace millwright::mechanics {

void define_material(FormulaList& list) {
  define(
      list,
      {.name = "material.shear_modulus",
       .handbook_id = "MAT-SHEAR-MODULUS",
       .symbol = "G",
       .unit = "Pa",
       .title = "Shear modulus",
       .source = "shigley, section 3-8"},
      [](const auto&... x) { return material::shear_modulus(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("poisson_ratio", "ν", "1", "Poisson ratio").between(0, 0.5).typical(0.2, 0.45).falling());

  define(
      list,
      {.name = "material.von_mises_stress",
       .handbook_id = "MAT-VONMISES",
       .symbol = "σ_v",
       .unit = "Pa",
       .title = "Von Mises stress",
       .source = "shigley, section 5-5"},
      [](const auto&... x) { return material::von_mises_stress(x...); },
      quantity("normal_stress", "σ", "Pa", "normal stress").rising(),
      quantity("shear_stress", "τ", "Pa", "shear stress").rising());

  define(
      list,
      {.name = "material.maximum_shear_stress",
       .handbook_id = "MAT-MAX-SHEAR",
       .symbol = "τ_max",
       .unit = "Pa",
       .title = "Maximum shear stress",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return material::maximum_shear_stress(x...); },
      quantity("normal_stress", "σ", "Pa", "normal stress").rising(),
      quantity("shear_stress", "τ", "Pa", "shear stress").rising());

  define(
      list,
      {.name = "material.maximum_principal_stress",
       .handbook_id = "MAT-MAX-PRINCIPAL",
       .symbol = "σ_1",
       .unit = "Pa",
       .title = "Maximum principal stress",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return material::maximum_principal_stress(x...); },
      quantity("normal_stress", "σ", "Pa", "normal stress").rising(),
      quantity("shear_stress", "τ", "Pa", "shear stress").rising());

  define(
      list,
      {.name = "material.allowable_stress",
       .handbook_id = "MAT-ALLOW-YIELD",
       .symbol = "σ_a",
       .unit = "Pa",
       .title = "Allowable stress from the yield strength",
       .source = "khurmi_gupta2005, chapter 4"},
      [](const auto&... x) { return material::allowable_stress(x...); },
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).rising(),
      quantity("safety_factor", "SF", "1", "safety factor").typical(1, 6).falling());

  define(
      list,
      {.name = "material.sularso_allowable_shear_stress",
       .handbook_id = "MAT-ALLOW-SULARSO",
       .symbol = "τ_a",
       .unit = "Pa",
       .title = "Allowable shear stress of shafts",
       .source = "sularso_suga, chapter 1; mini_mill, eq. 1",
       .validity = "material factor 5.6 to 6.0, notch factor 1.3 to 3.0"},
      [](const auto&... x) { return material::sularso_allowable_shear_stress(x...); },
      quantity("tensile_strength", "σ_B", "Pa", "tensile strength").typical(200000000.0, 2000000000.0).rising(),
      quantity("material_factor", "Sf_1", "1", "material factor").between(5.6, 6.0).typical(5.6, 6.0).falling(),
      quantity("notch_factor", "Sf_2", "1", "notch and size factor").between(1.3, 3.0).typical(1.3, 3.0).falling());

  define(
      list,
      {.name = "material.von_mises_shear_yield",
       .handbook_id = "MAT-SHEAR-YIELD-VONMISES",
       .symbol = "τ_y",
       .unit = "Pa",
       .title = "Shear yield strength after von Mises",
       .source = "shigley, section 5-5; torch_table, eq. 23"},
      [](const auto&... x) { return material::von_mises_shear_yield(x...); },
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).rising());

  define(
      list,
      {.name = "material.tresca_shear_yield",
       .handbook_id = "MAT-SHEAR-YIELD-TRESCA",
       .symbol = "τ_y",
       .unit = "Pa",
       .title = "Shear yield strength after Tresca",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return material::tresca_shear_yield(x...); },
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).rising());

  define(
      list,
      {.name = "material.yield_safety",
       .handbook_id = "MAT-YIELD-SAFETY",
       .symbol = "n",
       .unit = "1",
       .title = "Safety against yield",
       .source = "khurmi_gupta2005, chapter 4"},
      [](const auto&... x) { return material::yield_safety(x...); },
      quantity("largest_stress", "σ_max", "Pa", "largest equivalent stress").typical(1000000.0, 600000000.0).falling(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).rising());

  define(
      list,
      {.name = "material.endurance_limit",
       .handbook_id = "MAT-ENDURANCE",
       .symbol = "S_e",
       .unit = "Pa",
       .title = "Endurance limit of steel",
       .source = "shigley, section 6-7"},
      [](const auto&... x) { return material::endurance_limit(x...); },
      quantity("tensile_strength", "σ_u", "Pa", "tensile strength").typical(200000000.0, 2000000000.0).rising(),
      quantity("modifying_factor", "k_marin", "1", "product of surface, size, load and reliability factors")
          .typical(0.2, 1)
          .rising());

  define(
      list,
      {.name = "material.surface_factor",
       .handbook_id = "MAT-SURFACE-FACTOR",
       .symbol = "k_a",
       .unit = "1",
       .title = "Surface factor",
       .source = "shigley, table 6-2"},
      [](const auto&... x) { return material::surface_factor(x...); },
      quantity("tensile_strength", "σ_u", "Pa", "tensile strength").typical(200000000.0, 2000000000.0).falling(),
      quantity("coefficient", "a", "1", "coefficient for the strength in MPa").typical(1.5, 300),
      quantity("exponent", "b", "1", "exponent").between(-2, 0).typical(-1, -0.05));

  define(
      list,
      {.name = "material.size_factor",
       .handbook_id = "MAT-SIZE-FACTOR",
       .symbol = "k_b",
       .unit = "1",
       .title = "Size factor",
       .source = "shigley, eq. 6-20"},
      [](const auto&... x) { return material::size_factor(x...); },
      quantity("diameter", "d", "m", "diameter").between(2.79e-3, 51e-3).typical(0.00279, 0.051).falling());

  define(
      list,
      {.name = "material.fatigue_notch_factor",
       .handbook_id = "MAT-NOTCH-FACTOR",
       .symbol = "K_f",
       .unit = "1",
       .title = "Fatigue notch factor",
       .source = "shigley, eq. 6-32"},
      [](const auto&... x) { return material::fatigue_notch_factor(x...); },
      quantity("notch_sensitivity", "q", "1", "notch sensitivity").between(0, 1).rising(),
      quantity("stress_concentration", "K_t", "1", "theoretical stress concentration factor")
          .at_least(1)
          .typical(1, 4)
          .rising());

  define(
      list,
      {.name = "material.goodman_safety",
       .handbook_id = "MAT-GOODMAN-SAFETY",
       .symbol = "n",
       .unit = "1",
       .title = "Safety against fatigue after Goodman",
       .source = "shigley, section 6-12"},
      [](const auto&... x) { return material::goodman_safety(x...); },
      quantity("stress_amplitude", "σ_a", "Pa", "stress amplitude").typical(1000000.0, 300000000.0).falling(),
      quantity("mean_stress", "σ_m", "Pa", "mean stress, tension positive").typical(1000000.0, 300000000.0).falling(),
      quantity("endurance_limit", "S_e", "Pa", "corrected endurance limit").typical(50000000.0, 600000000.0).rising(),
      quantity("tensile_strength", "σ_u", "Pa", "tensile strength").typical(200000000.0, 2000000000.0).rising());
}

}  // namespace millwright::mechanics
