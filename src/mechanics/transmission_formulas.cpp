// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/transmission.h"

namespace millwright::mechanics {

void define_transmission(FormulaList& list) {
  define(
      list,
      {.name = "transmission.cylinder_inertia",
       .handbook_id = "TRANS-CYL-INERTIA",
       .symbol = "J",
       .unit = "kg.m^2",
       .title = "Moment of inertia of a cylinder",
       .source = "millwright_derivations; sander, eq. 4.2",
       .validity = "inner_diameter < outer_diameter"},
      [](const auto&... x) { return transmission::cylinder_inertia(x...); },
      quantity("mass", "m", "kg", "mass").rising(),
      quantity("outer_diameter", "D_o", "m", "outer diameter").typical(0.005, 0.2).rising(),
      quantity("inner_diameter", "D_i", "m", "inner diameter, 0 when solid").typical(0.001, 0.1).rising())
      .valid_when("inner_diameter < outer_diameter",
                  [](double, double outer_diameter, double inner_diameter) { return inner_diameter < outer_diameter; });

  define(
      list,
      {.name = "transmission.screw_load_inertia",
       .handbook_id = "TRANS-SCREW-LINEAR-INERTIA",
       .symbol = "J",
       .unit = "kg.m^2",
       .title = "Inertia of a mass moved by a screw",
       .source = "oriental_motor_sizing; sander, eq. 4.2"},
      [](const auto&... x) { return transmission::screw_load_inertia(x...); },
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04).rising());

  define(
      list,
      {.name = "transmission.belt_load_inertia",
       .handbook_id = "TRANS-BELT-LINEAR-INERTIA",
       .symbol = "J",
       .unit = "kg.m^2",
       .title = "Inertia of a mass moved by a belt or rack",
       .source = "oriental_motor_sizing"},
      [](const auto&... x) { return transmission::belt_load_inertia(x...); },
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("pitch_radius", "r", "m", "pitch radius of the pulley or pinion").typical(0.005, 0.1).rising());

  define(
      list,
      {.name = "transmission.reflected_inertia",
       .handbook_id = "TRANS-REFLECTED-INERTIA",
       .symbol = "J_M",
       .unit = "kg.m^2",
       .title = "Inertia reflected to the motor",
       .source = "oriental_motor_sizing"},
      [](const auto&... x) { return transmission::reflected_inertia(x...); },
      quantity("inertia", "J", "kg.m^2", "moment of inertia").rising(),
      quantity("ratio", "i", "1", "motor speed over output speed").typical(0.5, 20).falling());

  define(
      list,
      {.name = "transmission.motor_torque",
       .handbook_id = "TRANS-RATIO-TORQUE",
       .symbol = "T_M",
       .unit = "N.m",
       .title = "Motor torque for an output torque",
       .source = "oriental_motor_sizing"},
      [](const auto&... x) { return transmission::motor_torque(x...); },
      quantity("output_torque", "T_out", "N.m", "torque at the output").rising(),
      quantity("ratio", "i", "1", "motor speed over output speed").typical(0.5, 20).falling(),
      quantity("efficiency", "η", "1", "efficiency").between(0, 1).typical(0.2, 1).falling());

  define(
      list,
      {.name = "transmission.optimal_ratio",
       .handbook_id = "TRANS-OPTIMAL-RATIO",
       .symbol = "i_opt",
       .unit = "1",
       .title = "Ratio for the largest acceleration",
       .source = "millwright_derivations"},
      [](const auto&... x) { return transmission::optimal_ratio(x...); },
      quantity("load_inertia", "J_L", "kg.m^2", "inertia of the load").rising(),
      quantity("motor_inertia", "J_M", "kg.m^2", "inertia of the motor").falling(),
      quantity("load_torque", "T_L", "N.m", "torque of the load").rising(),
      quantity("motor_torque", "T_M", "N.m", "torque of the motor").falling());

  define(
      list,
      {.name = "transmission.linear_backlash",
       .handbook_id = "TRANS-BACKLASH-LINEAR",
       .symbol = "Δx",
       .unit = "m",
       .title = "Linear play by angular play",
       .source = "millwright_derivations"},
      [](const auto&... x) { return transmission::linear_backlash(x...); },
      quantity("angular_backlash", "θ_b", "rad", "angular play at the output shaft").typical(0.0001, 0.01).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04).rising());
}

}  // namespace millwright::mechanics
