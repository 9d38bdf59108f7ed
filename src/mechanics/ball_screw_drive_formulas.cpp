// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "mechanics/ball_screw.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_ball_screw_drive(FormulaList& list) {
  define(
      list,
      {.name = "ball_screw.efficiency",
       .handbook_id = "BS-EFFICIENCY",
       .symbol = "η",
       .unit = "1",
       .title = "Efficiency of a ball screw",
       .source = "thk_catalogue, efficiency; iso3408_5",
       .validity = "friction < tan(lead_angle) < 1 / friction; lead angle < 40 degrees"},
      [](const auto&... x) { return ball_screw::efficiency(x...); },
      quantity("friction", "μ", "1", "equivalent rolling friction coefficient").typical(0.002, 0.02).falling(),
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).rising())
      .valid_when("friction < tan(lead_angle) < 1 / friction",
                  [](double friction, double lead_angle) {
                    return friction < std::tan(lead_angle) && friction * std::tan(lead_angle) < 1.0;
                  })
      .valid_when("lead angle < 40 degrees", [](double, double lead_angle) { return lead_angle < 0.698; });

  define(
      list,
      {.name = "ball_screw.reverse_efficiency",
       .handbook_id = "BS-EFFICIENCY-REVERSE",
       .symbol = "η_r",
       .unit = "1",
       .title = "Efficiency of a ball screw while the load drives",
       .source = "thk_catalogue, efficiency; iso3408_5",
       .validity = "lead angle < 40 degrees"},
      [](const auto&... x) { return ball_screw::reverse_efficiency(x...); },
      quantity("friction", "μ", "1", "equivalent rolling friction coefficient").typical(0.002, 0.02).falling(),
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).rising())
      .valid_when("lead angle < 40 degrees", [](double, double lead_angle) { return lead_angle < 0.698; });

  define(
      list,
      {.name = "ball_screw.drive_torque",
       .handbook_id = "BS-DRIVE-TORQUE",
       .symbol = "T",
       .unit = "N.m",
       .title = "Drive torque",
       .source = "thk_catalogue, rotational torque"},
      [](const auto&... x) { return ball_screw::drive_torque(x...); },
      quantity("force", "F", "N", "axial load opposing the motion").rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04).rising(),
      quantity("efficiency", "η", "1", "efficiency").between(0, 1).typical(0.2, 1).falling());

  define(
      list,
      {.name = "ball_screw.backdriving_torque",
       .handbook_id = "BS-BACKDRIVE-TORQUE",
       .symbol = "T_b",
       .unit = "N.m",
       .title = "Torque that holds a driving load",
       .source = "thk_catalogue, rotational torque; khurmi_gupta2005, section 17.5"},
      [](const auto&... x) { return ball_screw::backdriving_torque(x...); },
      quantity("force", "F", "N", "axial load that drives the screw").rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04).rising(),
      quantity("reverse_efficiency", "η_r", "1", "efficiency while the load drives (negative = self-locking)")
          .between(-std::numeric_limits<double>::infinity(), 1)
          .typical(0.1, 1)
          .rising());

  define(
      list,
      {.name = "ball_screw.preload_torque",
       .handbook_id = "BS-PRELOAD-TORQUE",
       .symbol = "T_pr",
       .unit = "N.m",
       .title = "Drag of a preloaded nut",
       .source = "jis_b1192; thk_catalogue, preload torque"},
      [](const auto&... x) { return ball_screw::preload_torque(x...); },
      quantity("preload", "F_pr", "N", "preload").rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04),
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).falling());

  define(
      list,
      {.name = "ball_screw.speed_value",
       .handbook_id = "BS-DN",
       .symbol = "DN",
       .unit = "m.rad/s",
       .display_unit = "mm.rpm",
       .title = "DN value",
       .source = "thk_catalogue, DN value"},
      [](const auto&... x) { return ball_screw::speed_value(x...); },
      quantity("pitch_circle_diameter", "d_pw", "m", "ball pitch circle diameter").typical(0.005, 0.1).rising(),
      quantity("angular_speed", "ω", "rad/s", "angular speed").rising());

  define(
      list,
      {.name = "ball_screw.permissible_speed",
       .handbook_id = "BS-CRITICAL-SPEED-CATALOGUE",
       .symbol = "ω_perm",
       .unit = "rad/s",
       .title = "Permissible speed of the catalogues",
       .source = "thk_catalogue, permissible rotational speed; hsk_ball_screw"},
      [](const auto&... x) { return ball_screw::permissible_speed(x...); },
      quantity("eigenvalue", "λ_e", "1", "first eigenvalue of the shaft with these ends").typical(1.8, 4.8).rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "distance of the bearings").typical(0.1, 2).falling());

  define(
      list,
      {.name = "ball_screw.permissible_buckling_load",
       .handbook_id = "BS-BUCKLING-CATALOGUE",
       .symbol = "P_perm",
       .unit = "N",
       .title = "Permissible buckling load of the catalogues",
       .source = "thk_catalogue, permissible axial load; hsk_ball_screw"},
      [](const auto&... x) { return ball_screw::permissible_buckling_load(x...); },
      quantity("end_fixity", "N_e", "1", "end-fixity coefficient").typical(0.25, 4).rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "unsupported length").typical(0.1, 2).falling());

  define(
      list,
      {.name = "ball_screw.permissible_axial_load",
       .handbook_id = "BS-PERMISSIBLE-AXIAL",
       .symbol = "F_perm",
       .unit = "N",
       .title = "Permissible tension or compression",
       .source = "thk_catalogue, permissible axial load"},
      [](const auto&... x) { return ball_screw::permissible_axial_load(x...); },
      quantity("permissible_stress", "σ_p", "Pa", "permissible stress").typical(50000000.0, 300000000.0).rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).rising());

  define(
      list,
      {.name = "ball_screw.nut_stiffness",
       .handbook_id = "BS-NUT-STIFFNESS",
       .symbol = "k_N",
       .unit = "N/m",
       .title = "Stiffness of a nut without preload",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return ball_screw::nut_stiffness(x...); },
      quantity("catalogue_stiffness", "K_cat", "N/m", "nut stiffness of the catalogue").rising(),
      quantity("force", "F_a", "N", "axial load").rising(),
      quantity("dynamic_load_rating", "C_a", "N", "basic dynamic axial load rating")
          .typical(1000.0, 100000.0)
          .falling());

  define(
      list,
      {.name = "ball_screw.nut_deflection",
       .symbol = "δ_N",
       .unit = "m",
       .title = "Deflection of a nut without preload",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return ball_screw::nut_deflection(x...); },
      quantity("catalogue_stiffness", "K_cat", "N/m", "nut stiffness of the catalogue").falling(),
      quantity("force", "F_a", "N", "axial load").rising(),
      quantity("dynamic_load_rating", "C_a", "N", "basic dynamic axial load rating")
          .typical(1000.0, 100000.0)
          .rising());

  define(
      list,
      {.name = "ball_screw.preloaded_nut_stiffness",
       .handbook_id = "BS-NUT-STIFFNESS-PRELOADED",
       .symbol = "k_N",
       .unit = "N/m",
       .title = "Stiffness of a preloaded nut",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return ball_screw::preloaded_nut_stiffness(x...); },
      quantity("catalogue_stiffness", "K_cat", "N/m", "nut stiffness of the catalogue").rising(),
      quantity("preload", "F_pr", "N", "preload").rising(),
      quantity("dynamic_load_rating", "C_a", "N", "basic dynamic axial load rating")
          .typical(1000.0, 100000.0)
          .falling());

  define(
      list,
      {.name = "ball_screw.bearing_stiffness",
       .handbook_id = "BS-BEARING-STIFFNESS",
       .symbol = "k_B",
       .unit = "N/m",
       .title = "Stiffness of a preloaded bearing pair",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return ball_screw::bearing_stiffness(x...); },
      quantity("bearing_preload", "F_a0", "N", "preload of the bearing").typical(50, 5000.0).rising(),
      quantity("preload_displacement", "δ_a0", "m", "axial displacement by that preload")
          .typical(1e-06, 5e-05)
          .falling());

  define(
      list,
      {.name = "ball_screw.chain_stiffness",
       .handbook_id = "BS-STIFFNESS-CHAIN",
       .symbol = "k",
       .unit = "N/m",
       .title = "Stiffness of a chain in series",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return ball_screw::chain_stiffness(x...); },
      list_of("stiffnesses", "k", "N/m", "stiffness of each element").typical(1000000.0, 1000000000.0));

  define(
      list,
      {.name = "ball_screw.elastic_error",
       .handbook_id = "BS-ELASTIC-ERROR",
       .symbol = "δ",
       .unit = "m",
       .title = "Elastic position error",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::elastic_error(x...); },
      quantity("force", "F", "N", "axial load").rising(),
      quantity("stiffness", "k", "N/m", "stiffness").typical(10000.0, 1000000000.0).falling());

  define(
      list,
      {.name = "ball_screw.lost_motion",
       .handbook_id = "BS-LOST-MOTION",
       .symbol = "Δ",
       .unit = "m",
       .title = "Reversal error",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::lost_motion(x...); },
      quantity("friction_force", "F_f", "N", "friction force in one direction").rising(),
      quantity("stiffness", "k", "N/m", "stiffness").typical(10000.0, 1000000000.0).falling(),
      quantity("backlash", "b", "m", "mechanical play").typical(1e-06, 0.0002).rising());

  define(
      list,
      {.name = "ball_screw.transport_travel_error",
       .handbook_id = "BS-TRAVEL-ERROR-T",
       .symbol = "e_p",
       .unit = "m",
       .title = "Travel error of a transport screw",
       .source = "iso3408_3"},
      [](const auto&... x) { return ball_screw::transport_travel_error(x...); },
      quantity("travel_variation", "v_300p", "m", "permitted travel variation in 300 mm")
          .typical(1e-06, 0.0003)
          .rising(),
      quantity("useful_travel", "l_u", "m", "useful travel").rising());

  define(
      list,
      {.name = "ball_screw.pretension_force",
       .handbook_id = "BS-PRETENSION-FORCE",
       .symbol = "F_t",
       .unit = "N",
       .title = "Pre-tension force of a shaft",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::pretension_force(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).rising(),
      quantity("thermal_expansion", "α", "1/K", "coefficient of thermal expansion").rising(),
      quantity("temperature_rise", "ΔT", "K", "rise of temperature").rising());

  define(
      list,
      {.name = "ball_screw.friction_heat",
       .handbook_id = "BS-FRICTION-HEAT",
       .symbol = "P",
       .unit = "W",
       .title = "Friction heat",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::friction_heat(x...); },
      quantity("friction_torque", "T_f", "N.m", "friction torque").rising(),
      quantity("angular_speed", "ω", "rad/s", "angular speed").rising());
}

}  // namespace millwright::mechanics
