// SPDX-License-Identifier: Apache-2.0
#include "mechanics/actuation_steps.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_actuation_steps(FormulaList& list) {
  define(
      list,
      {.name = "actuation.weight",
       .symbol = "W",
       .unit = "N",
       .title = "Weight",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::weight(x...); },
      quantity("mass", "m", "kg", "mass").rising(),
      quantity("gravity", "g", "m/s^2", "gravity").typical(9.7, 10).rising());

  define(
      list,
      {.name = "actuation.force_of_acceleration",
       .symbol = "F",
       .unit = "N",
       .title = "Force that accelerates a mass",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::force_of_acceleration(x...); },
      quantity("mass", "m", "kg", "mass").rising(),
      quantity("acceleration", "a", "m/s^2", "acceleration").rising());

  define(
      list,
      {.name = "actuation.lever_torque",
       .symbol = "T",
       .unit = "N.m",
       .title = "Torque, or bending moment, of a force on a lever arm",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::lever_torque(x...); },
      quantity("force", "F", "N", "force").rising(),
      quantity("lever_arm", "r", "m", "lever arm").rising());

  define(
      list,
      {.name = "actuation.friction_torque",
       .symbol = "T_W",
       .unit = "N.m",
       .title = "Torque on a loss-free screw that overcomes the guide friction of a horizontal axis",
       .source = "sander, eq. 18",
       .validity = "horizontal axis, loss-free screw"},
      [](const auto&... x) { return actuation::friction_torque(x...); },
      quantity("friction", "μ", "1", "guide friction coefficient").between(0, 1).typical(0.002, 0.4).rising(),
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("gravity", "g", "m/s^2", "gravity").typical(9.7, 10).rising(),
      quantity("lead", "l", "m", "lead").rising());

  define(
      list,
      {.name = "actuation.geared_load_torque",
       .symbol = "T_L",
       .unit = "N.m",
       .title = "Load torque at the motor through a gear",
       .source = "sander, eq. 19"},
      [](const auto&... x) { return actuation::geared_load_torque(x...); },
      quantity("screw_torque", "T_W", "N.m", "torque at the screw").rising(),
      quantity("gear_ratio", "G", "1", "speed of the screw over speed of the motor").typical(0.1, 1).rising(),
      quantity("efficiency", "η", "1", "efficiency").between(0, 1).typical(0.3, 1).falling());

  define(
      list,
      {.name = "actuation.geared_motor_speed",
       .symbol = "ω",
       .unit = "rad/s",
       .title = "Motor speed of a screw axis behind a gear",
       .source = "sander, eq. 20; mini_mill, eq. 15"},
      [](const auto&... x) { return actuation::geared_motor_speed(x...); },
      quantity("speed", "v", "m/s", "speed of the axis").rising(),
      quantity("lead", "l", "m", "lead").falling(),
      quantity("gear_ratio", "G", "1", "speed of the screw over speed of the motor").typical(0.1, 1).falling());

  define(
      list,
      {.name = "actuation.screw_load_inertia",
       .symbol = "J_W",
       .unit = "kg.m^2",
       .title = "Inertia at the screw of the moved mass and the screw itself",
       .source = "sander, eq. 16"},
      [](const auto&... x) { return actuation::screw_load_inertia(x...); },
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("lead", "l", "m", "lead").rising(),
      quantity("screw_inertia", "J_B", "kg.m^2", "inertia of the screw").rising());

  define(
      list,
      {.name = "actuation.geared_load_inertia",
       .symbol = "J_L",
       .unit = "kg.m^2",
       .title = "Load inertia at the motor through a gear",
       .source = "sander, eq. 17"},
      [](const auto&... x) { return actuation::geared_load_inertia(x...); },
      quantity("gear_ratio", "G", "1", "speed of the screw over speed of the motor").typical(0.1, 1).rising(),
      quantity("screw_side_inertia", "J_W", "kg.m^2", "inertia at the screw").rising(),
      quantity("driven_gear_inertia", "J_2", "kg.m^2", "inertia of the gear on the screw").rising(),
      quantity("driving_gear_inertia", "J_1", "kg.m^2", "inertia of the gear on the motor").rising());

  define(
      list,
      {.name = "actuation.flywheel_effect",
       .symbol = "mD²",
       .unit = "kg.m^2",
       .title = "Mass times sum of the squared diameters, eight times the inertia of a hollow cylinder",
       .source = "sander, eq. 9"},
      [](const auto&... x) { return actuation::flywheel_effect(x...); },
      quantity("mass", "m", "kg", "mass").rising(),
      quantity("outer_diameter", "D_1", "m", "outer diameter").rising(),
      quantity("inner_diameter", "D_2", "m", "inner diameter").rising());

  define(
      list,
      {.name = "actuation.stroke_time",
       .symbol = "t_s",
       .unit = "s",
       .title = "Time of a stroke with equal ramps at both ends",
       .source = "sander, eq. 14; millwright_derivations, definition",
       .validity = "stroke at least speed times ramp time"},
      [](const auto&... x) { return actuation::stroke_time(x...); },
      quantity("distance", "L", "m", "stroke").rising(),
      quantity("speed", "v", "m/s", "speed"),
      quantity("acceleration_time", "t_A", "s", "time of each ramp").rising())
      .valid_when("speed·acceleration_time <= distance", [](double distance, double speed, double acceleration_time) {
        return speed * acceleration_time <= distance;
      });

  define(
      list,
      {.name = "actuation.angular_acceleration",
       .symbol = "α",
       .unit = "rad/s^2",
       .title = "Angular acceleration of an even ramp from standstill",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::angular_acceleration(x...); },
      quantity("angular_speed", "ω", "rad/s", "speed reached").rising(),
      quantity("acceleration_time", "t_A", "s", "time of the ramp").falling());

  define(
      list,
      {.name = "actuation.accelerated_inertia",
       .symbol = "J",
       .unit = "kg.m^2",
       .title = "Inertia the motor torque has to accelerate, the load through the transmission",
       .source = "sander, eq. 23"},
      [](const auto&... x) { return actuation::accelerated_inertia(x...); },
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor inertia").rising(),
      quantity("load_inertia", "J_L", "kg.m^2", "load inertia at the motor").rising(),
      quantity("efficiency", "η", "1", "efficiency of the transmission").between(0, 1).typical(0.3, 1).falling());

  define(
      list,
      {.name = "actuation.inertia_torque",
       .symbol = "T_A",
       .unit = "N.m",
       .title = "Torque that accelerates an inertia",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::inertia_torque(x...); },
      quantity("inertia", "J", "kg.m^2", "inertia").rising(),
      quantity("angular_acceleration", "α", "rad/s^2", "angular acceleration").rising());

  define(
      list,
      {.name = "actuation.mean_square_torque",
       .symbol = "T_rms²",
       .unit = "N^2.m^2",
       .title = "Mean of the squared torque over a cycle",
       .source = "sander, eq. 25"},
      [](const auto&... x) { return actuation::mean_square_torque(x...); },
      list_of("torques", "T", "N.m", "torques of the phases").any_sign().typical(-2, 2),
      list_of("durations", "t", "s", "durations of the phases, pauses included").as_long_as(0));

  define(
      list,
      {.name = "actuation.torque_of_mean_square",
       .symbol = "T_rms",
       .unit = "N.m",
       .title = "Effective torque from the mean of its square",
       .source = "sander, eq. 25"},
      [](const auto&... x) { return actuation::torque_of_mean_square(x...); },
      quantity("mean_square", "q", "N^2.m^2", "mean of the squared torque").typical(1e-7, 10).rising());

  define(
      list,
      {.name = "actuation.electrical_power",
       .symbol = "P",
       .unit = "W",
       .title = "Electrical power of a direct current",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::electrical_power(x...); },
      quantity("voltage", "V", "V", "voltage").typical(10, 60).rising(),
      quantity("current", "I", "A", "current").typical(0.5, 6).rising());

  define(
      list,
      {.name = "actuation.peripheral_speed",
       .symbol = "v",
       .unit = "m/s",
       .title = "Speed at the circumference",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return actuation::peripheral_speed(x...); },
      quantity("angular_speed", "ω", "rad/s", "angular speed").rising(),
      quantity("radius", "r", "m", "radius").rising());
}

}  // namespace millwright::mechanics
