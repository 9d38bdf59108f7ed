// SPDX-License-Identifier: Apache-2.0
#include "mechanics/coupling.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_coupling(FormulaList& list) {
  define(
      list,
      {.name = "coupling.required_torque",
       .handbook_id = "TRANS-COUPLING-TORQUE",
       .symbol = "T_c",
       .unit = "N.m",
       .title = "Torque a coupling has to be rated for",
       .source = "ktr_couplings"},
      [](const auto&... x) { return coupling::required_torque(x...); },
      quantity("peak_torque", "T_peak", "N.m", "peak torque of the motor").rising(),
      quantity("motor_inertia", "J_M", "kg.m^2", "inertia of the motor").falling(),
      quantity("load_inertia", "J_L", "kg.m^2", "inertia of the load").rising(),
      quantity("shock_factor", "K_s", "1", "shock factor").typical(1, 3).rising());

  define(
      list,
      {.name = "coupling.windup",
       .handbook_id = "TRANS-COUPLING-WINDUP",
       .symbol = "θ",
       .unit = "rad",
       .title = "Twist of a coupling",
       .source = "millwright_derivations"},
      [](const auto&... x) { return coupling::windup(x...); },
      quantity("torque", "T", "N.m", "transmitted torque").rising(),
      quantity("torsional_stiffness", "C_T", "N.m/rad", "torsional stiffness").falling());

  define(
      list,
      {.name = "coupling.series_stiffness",
       .handbook_id = "TRANS-TORSION-SERIES",
       .symbol = "C",
       .unit = "N.m/rad",
       .title = "Torsional stiffness in series",
       .source = "millwright_derivations"},
      [](const auto&... x) { return coupling::series_stiffness(x...); },
      list_of("torsional_stiffnesses", "C", "N.m/rad", "torsional stiffness of each element, at the same shaft")
          .typical(10, 100000.0));

  define(
      list,
      {.name = "coupling.shaft_torsional_stiffness",
       .handbook_id = "TRANS-SHAFT-TORSION-STIFFNESS",
       .symbol = "C",
       .unit = "N.m/rad",
       .title = "Torsional stiffness of a shaft",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return coupling::shaft_torsional_stiffness(x...); },
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(20000000000.0, 90000000000.0).rising(),
      quantity("diameter", "d", "m", "diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "length").typical(0.1, 2).falling());

  define(
      list,
      {.name = "coupling.resonant_frequency",
       .handbook_id = "TRANS-COUPLING-RESONANCE",
       .symbol = "f",
       .unit = "Hz",
       .title = "Two-mass torsional resonance",
       .source = "millwright_derivations"},
      [](const auto&... x) { return coupling::resonant_frequency(x...); },
      quantity("torsional_stiffness", "C_T", "N.m/rad", "torsional stiffness").rising(),
      quantity("motor_inertia", "J_M", "kg.m^2", "inertia of the motor").falling(),
      quantity("load_inertia", "J_L", "kg.m^2", "inertia of the load").falling());
}

}  // namespace millwright::mechanics
