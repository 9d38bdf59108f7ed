// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "mechanics/actuation.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_actuation(FormulaList& list) {
  define(
      list,
      {.name = "actuation.stacked_mass",
       .handbook_id = "ACT-STACK-MASS",
       .symbol = "m_k",
       .unit = "kg",
       .title = "Mass that an axis moves",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::stacked_mass(x...); },
      list_of(
          "own_masses", "m_own", "kg", "own moving masses, first entry = the axis itself, then every axis it carries"),
      quantity("payload", "m_payload", "kg", "tool or workpiece").rising());

  define(
      list,
      {.name = "actuation.gravity_force",
       .handbook_id = "ACT-GRAVITY-FORCE",
       .symbol = "F_g",
       .unit = "N",
       .title = "Force of gravity along an inclined axis after the counterbalance, at standard gravity",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::gravity_force(x...); },
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("inclination", "ψ", "rad", "inclination of the axis (pi/2 = vertical)")
          .between(0, 1.5707963267948966)
          .typical(0.01, 1.55),
      quantity("counterbalance_force", "F_cb", "N", "counterbalance force along the axis").falling());

  define(
      list,
      {.name = "actuation.axial_force",
       .handbook_id = "ACT-AXIAL-FORCE",
       .symbol = "F",
       .unit = "N",
       .title = "Force the drive has to exert in one phase of the motion",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::axial_force(x...); },
      quantity("mass", "m", "kg", "moved mass"),
      quantity("acceleration", "a", "m/s^2", "signed acceleration").any_sign().typical(-5, 5),
      quantity("gravity_force", "F_g", "N", "signed gravity force to be lifted (positive opposes +v)")
          .any_sign()
          .typical(-300, 300)
          .rising(),
      quantity("friction_force", "F_f", "N", "friction force magnitude"),
      quantity("direction", "s_v", "1", "direction of motion -1|0|+1").between(-1, 1).typical(-1, 1),
      quantity("process_force", "F_c", "N", "signed process force opposing +v").any_sign().typical(-300, 300).rising());

  define(
      list,
      {.name = "actuation.screw_axis_inertia",
       .handbook_id = "ACT-INERTIA-SCREW",
       .symbol = "J_tot",
       .unit = "kg.m^2",
       .title = "All inertia at the motor of a screw axis, moved mass included",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::screw_axis_inertia(x...); },
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor").rising(),
      quantity("motor_side_inertia", "J_c", "kg.m^2", "coupling and motor-side parts").rising(),
      quantity("output_side_inertia", "J_s", "kg.m^2", "screw and output-side parts").rising(),
      quantity("mass", "m", "kg", "moved mass").rising(),
      quantity("lead", "l", "m", "lead").rising(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10).falling());

  define(
      list,
      {.name = "actuation.belt_axis_inertia",
       .handbook_id = "ACT-INERTIA-BELT",
       .symbol = "J_tot",
       .unit = "kg.m^2",
       .title = "All inertia at the motor of a belt axis, moved mass included",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::belt_axis_inertia(x...); },
      quantity("rotor_inertia", "J_M", "kg.m^2", "rotor").rising(),
      quantity("motor_side_inertia", "J_c", "kg.m^2", "motor-side parts").rising(),
      quantity("pulley_inertia", "J_p", "kg.m^2", "all pulleys referred to the drive pulley").rising(),
      quantity("mass", "m", "kg", "carriage + belt mass").rising(),
      quantity("pitch_radius", "r", "m", "pitch radius").rising(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10).falling());

  define(
      list,
      {.name = "actuation.screw_motor_torque",
       .handbook_id = "ACT-TORQUE-SCREW",
       .symbol = "T",
       .unit = "N.m",
       .title = "Motor torque of a screw axis",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::screw_motor_torque(x...); },
      quantity("force", "F", "N", "signed axial force along the motion (positive = opposes the motion)")
          .any_sign()
          .typical(-300, 300),
      quantity("lead", "l", "m", "lead"),
      quantity("efficiency", "η", "1", "forward efficiency").between(0, 1).typical(0.3, 1),
      quantity("reverse_efficiency", "η_r", "1", "reverse efficiency (negative = self-locking)")
          .between(-std::numeric_limits<double>::infinity(), 1)
          .typical(-0.8, 0.9),
      quantity("rotating_inertia", "J_rot", "kg.m^2", "rotating inertia at the motor (without moved mass)"),
      quantity("angular_acceleration", "α", "rad/s^2", "signed motor acceleration along the motion")
          .any_sign()
          .typical(-2000, 2000)
          .rising(),
      quantity("drag_torque", "T_drag", "N.m", "load-independent drag (preload, bearings, seals) at the motor")
          .rising(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10),
      quantity("reducer_efficiency", "η_g", "1", "reducer efficiency").between(0, 1).typical(0.7, 1));

  define(
      list,
      {.name = "actuation.belt_motor_torque",
       .handbook_id = "ACT-TORQUE-BELT",
       .symbol = "T",
       .unit = "N.m",
       .title = "Motor torque of a belt axis",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::belt_motor_torque(x...); },
      quantity("force", "F", "N", "signed carriage force along the motion").any_sign().typical(-300, 300).rising(),
      quantity("pitch_radius", "r", "m", "pitch radius"),
      quantity("efficiency", "η", "1", "belt efficiency").between(0, 1).typical(0.3, 1),
      quantity("rotating_inertia", "J_rot", "kg.m^2", "rotating inertia at the motor"),
      quantity("angular_acceleration", "α", "rad/s^2", "signed motor acceleration")
          .any_sign()
          .typical(-2000, 2000)
          .rising(),
      quantity("drag_torque", "T_drag", "N.m", "drag at the motor").rising(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10));

  define(
      list,
      {.name = "actuation.backdriving_torque",
       .handbook_id = "ACT-BACKDRIVE-TORQUE",
       .symbol = "T_b",
       .unit = "N.m",
       .title = "Torque with which gravity drives the unpowered motor",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::backdriving_torque(x...); },
      quantity("gravity_force", "F_g", "N", "gravity force along the axis").any_sign().typical(1, 300).rising(),
      quantity("lead", "l", "m", "lead"),
      quantity("reverse_efficiency", "η_r", "1", "reverse efficiency (<=0 means self-locking)")
          .between(-std::numeric_limits<double>::infinity(), 1)
          .typical(-0.8, 0.9),
      quantity("friction_force", "F_f", "N", "guide friction").falling(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10));

  define(
      list,
      {.name = "actuation.torque_utilisation",
       .handbook_id = "ACT-TORQUE-MARGIN",
       .symbol = "u",
       .unit = "1",
       .title = "Required torque over the permitted share of the available torque at the same speed",
       .source = "oriental_motor_sizing; sander, eq. 22",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::torque_utilisation(x...); },
      quantity("required_torque", "T_req", "N.m", "required motor torque at a speed").rising(),
      quantity("available_torque", "T_avail", "N.m", "available torque at the same speed").falling(),
      quantity("permitted_fraction", "k_T", "1", "permitted fraction").between(0, 1).typical(0.4, 1).falling());

  define(
      list,
      {.name = "actuation.power",
       .handbook_id = "ACT-POWER",
       .symbol = "P",
       .unit = "W",
       .title = "Mechanical power of a shaft",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::power(x...); },
      quantity("torque", "T", "N.m", "motor torque").rising(),
      quantity("angular_speed", "ω", "rad/s", "motor speed").rising());

  define(
      list,
      {.name = "actuation.cycle_energy",
       .handbook_id = "ACT-CYCLE-ENERGY",
       .symbol = "E",
       .unit = "J",
       .title = "Work of the motor shaft over a cycle",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::cycle_energy(x...); },
      list_of("torques", "T", "N.m", "mean torques per phase").any_sign().typical(-2, 2),
      list_of("angular_speeds", "ω", "rad/s", "mean speeds per phase").any_sign().typical(-60, 60).as_long_as(0),
      list_of("durations", "t", "s", "durations").as_long_as(0));

  define(
      list,
      {.name = "actuation.kinetic_energy",
       .handbook_id = "ACT-KINETIC-ENERGY",
       .symbol = "E",
       .unit = "J",
       .title = "Kinetic energy of an axis, referred to the motor",
       .source = "sander, 4.2",
       .validity = "rigid axis; elastic parts count in the stiffness chain"},
      [](const auto&... x) { return actuation::kinetic_energy(x...); },
      quantity("inertia", "J", "kg.m^2", "total inertia at the motor").rising(),
      quantity("angular_speed", "ω", "rad/s", "motor speed").rising());
}

}  // namespace millwright::mechanics
