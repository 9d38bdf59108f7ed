// SPDX-License-Identifier: Apache-2.0
#include "mechanics/critical_speed.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_critical_speed(FormulaList& list) {
  define(
      list,
      {.name = "critical_speed.critical_speed",
       .handbook_id = "SCREW-CRITICAL-SPEED",
       .symbol = "ω_c",
       .unit = "rad/s",
       .title = "Critical speed of a screw",
       .source = "thk_catalogue, permissible speed"},
      [](const auto&... x) { return critical_speed::critical_speed(x...); },
      quantity("eigenvalue", "λ_e", "1", "first eigenvalue of the shaft with these ends").typical(1.8, 4.8).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "distance of the bearings").typical(0.1, 2).falling(),
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("density", "ρ", "kg/m^3", "density").typical(1000, 9000).falling());
}

}  // namespace millwright::mechanics
