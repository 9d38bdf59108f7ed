// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "mechanics/formula_definition.h"
#include "mechanics/power_screw.h"

namespace millwright::mechanics {

void define_power_screw(FormulaList& list) {
  define(
      list,
      {.name = "power_screw.lead",
       .handbook_id = "SCREW-LEAD",
       .symbol = "l",
       .unit = "m",
       .title = "Lead",
       .source = "khurmi_gupta2005, section 17.2"},
      [](const auto&... x) { return power_screw::lead(x...); },
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).rising(),
      count("starts", "z_s", "number of starts").typical(1, 8).rising());

  define(
      list,
      {.name = "power_screw.mean_diameter",
       .handbook_id = "SCREW-MEAN-DIAM",
       .symbol = "d_m",
       .unit = "m",
       .title = "Mean diameter of a thread",
       .source = "din103; iso724",
       .validity = "pitch < major_diameter / 2"},
      [](const auto&... x) { return power_screw::mean_diameter(x...); },
      choice<power_screw::ThreadForm>("form", "form", "thread form", {"square", "trapezoidal", "acme", "metric60"}),
      quantity("major_diameter", "d", "m", "major (outside) diameter").typical(0.006, 0.06).rising(),
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).falling())
      .valid_when("pitch < major_diameter / 2", [](power_screw::ThreadForm, double major_diameter, double pitch) {
        return 2.0 * pitch < major_diameter;
      });

  define(
      list,
      {.name = "power_screw.core_diameter",
       .handbook_id = "SCREW-CORE-DIAM",
       .symbol = "d_c",
       .unit = "m",
       .title = "Core diameter of a thread",
       .source = "din103; asme_b1_5; iso724",
       .validity = "pitch < major_diameter / 2"},
      [](const auto&... x) { return power_screw::core_diameter(x...); },
      choice<power_screw::ThreadForm>("form", "form", "thread form", {"square", "trapezoidal", "acme", "metric60"}),
      quantity("major_diameter", "d", "m", "major (outside) diameter").typical(0.006, 0.06).rising(),
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).falling())
      .valid_when("pitch < major_diameter / 2", [](power_screw::ThreadForm, double major_diameter, double pitch) {
        return 2.0 * pitch < major_diameter;
      });

  define(
      list,
      {.name = "power_screw.lead_angle",
       .handbook_id = "SCREW-LEAD-ANGLE",
       .symbol = "λ",
       .unit = "rad",
       .title = "Lead angle",
       .source = "khurmi_gupta2005, section 17.4"},
      [](const auto&... x) { return power_screw::lead_angle(x...); },
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).falling());

  define(
      list,
      {.name = "power_screw.effective_friction",
       .handbook_id = "SCREW-MU-EFF",
       .symbol = "μ_e",
       .unit = "1",
       .title = "Effective friction coefficient of a thread",
       .source = "khurmi_gupta2005, section 17.12; bhandari, eq. 6.9"},
      [](const auto&... x) { return power_screw::effective_friction(x...); },
      quantity("friction", "μ", "1", "friction coefficient").typical(0.03, 0.3).rising(),
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55).rising());

  define(
      list,
      {.name = "power_screw.exact_effective_friction",
       .handbook_id = "SCREW-MU-EFF-EXACT",
       .symbol = "μ_e",
       .unit = "1",
       .title = "Effective friction coefficient at any lead angle",
       .source = "shigley, section 8-2"},
      [](const auto&... x) { return power_screw::exact_effective_friction(x...); },
      quantity("friction", "μ", "1", "friction coefficient").typical(0.03, 0.3).rising(),
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55).rising(),
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).falling());

  define(
      list,
      {.name = "power_screw.exact_friction_ratio",
       .symbol = "r",
       .unit = "1",
       .title = "Exact over approximate effective friction of a thread",
       .source = "khurmi_gupta2005, section 17.12; shigley, section 8-2",
       .validity = "the approximation is for lead angles below 20 degrees; square threads need none"},
      [](const auto&... x) { return power_screw::exact_friction_ratio(x...); },
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55).falling(),
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).falling())
      .valid_when("lead angle < 20 degrees", [](double flank_angle, double lead_angle) {
        return flank_angle == 0.0 || lead_angle < std::numbers::pi / 9.0;
      });

  define(
      list,
      {.name = "power_screw.raising_torque",
       .handbook_id = "SCREW-TORQUE-RAISE",
       .symbol = "T_R",
       .unit = "N.m",
       .title = "Torque to raise the load",
       .source = "khurmi_gupta2005, section 17.4; bhandari, eq. 6.2; shigley, eq. 8-1",
       .validity = "friction * tan(lead angle) < 1; lead angle < 40 degrees"},
      [](const auto&... x) { return power_screw::raising_torque(x...); },
      quantity("force", "W", "N", "axial load opposing the motion").rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).rising(),
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).rising())
      .valid_when("friction * tan(lead angle) < 1",
                  [](double, double mean_diameter, double lead, double friction) {
                    return friction * lead < std::numbers::pi * mean_diameter;
                  })
      .valid_when("lead angle < 40 degrees", [](double, double mean_diameter, double lead, double) {
        return lead < 0.8390996 * std::numbers::pi * mean_diameter;
      });

  define(
      list,
      {.name = "power_screw.lowering_torque",
       .handbook_id = "SCREW-TORQUE-LOWER",
       .symbol = "T_L",
       .unit = "N.m",
       .title = "Torque to lower the load",
       .source = "khurmi_gupta2005, section 17.5; bhandari, eq. 6.3",
       .validity = "lead angle < 45 degrees"},
      [](const auto&... x) { return power_screw::lowering_torque(x...); },
      quantity("force", "W", "N", "axial load assisting the motion"),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).falling(),
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).rising())
      .valid_when("lead angle < 45 degrees", [](double, double mean_diameter, double lead, double) {
        return lead < std::numbers::pi * mean_diameter;
      });

  define(
      list,
      {.name = "power_screw.collar_torque",
       .handbook_id = "SCREW-COLLAR-TORQUE",
       .symbol = "T_C",
       .unit = "N.m",
       .title = "Collar torque, uniform wear",
       .source = "khurmi_gupta2005, section 17.4; bhandari, eq. 6.5",
       .validity = "inner_radius < outer_radius"},
      [](const auto&... x) { return power_screw::collar_torque(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("collar_friction", "μ_c", "1", "friction coefficient of the collar").typical(0.03, 0.3).rising(),
      quantity("outer_radius", "R_o", "m", "outer radius of the collar").typical(0.005, 0.04).rising(),
      quantity("inner_radius", "R_i", "m", "inner radius of the collar").typical(0.002, 0.03).rising())
      .valid_when("inner_radius < outer_radius",
                  [](double, double, double outer_radius, double inner_radius) { return inner_radius < outer_radius; });

  define(
      list,
      {.name = "power_screw.collar_torque_uniform_pressure",
       .handbook_id = "SCREW-COLLAR-TORQUE-UP",
       .symbol = "T_C",
       .unit = "N.m",
       .title = "Collar torque, uniform pressure",
       .source = "khurmi_gupta2005, section 17.4",
       .validity = "inner_radius < outer_radius"},
      [](const auto&... x) { return power_screw::collar_torque_uniform_pressure(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("collar_friction", "μ_c", "1", "friction coefficient of the collar").typical(0.03, 0.3).rising(),
      quantity("outer_radius", "R_o", "m", "outer radius of the collar").typical(0.005, 0.04).rising(),
      quantity("inner_radius", "R_i", "m", "inner radius of the collar").typical(0.002, 0.03).rising())
      .valid_when("inner_radius < outer_radius",
                  [](double, double, double outer_radius, double inner_radius) { return inner_radius < outer_radius; });

  define(
      list,
      {.name = "power_screw.efficiency",
       .handbook_id = "SCREW-EFFICIENCY",
       .symbol = "η",
       .unit = "1",
       .title = "Efficiency of a screw, collar included",
       .source = "khurmi_gupta2005, section 17.6"},
      [](const auto&... x) { return power_screw::efficiency(x...); },
      quantity("force", "W", "N", "axial load"),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025),
      quantity("torque", "T", "N.m", "total torque while raising, collar included").falling());

  define(
      list,
      {.name = "power_screw.thread_efficiency",
       .handbook_id = "SCREW-EFFICIENCY-THREAD",
       .symbol = "η",
       .unit = "1",
       .title = "Efficiency of the thread",
       .source = "khurmi_gupta2005, section 17.6",
       .validity = "friction * tan(lead_angle) < 1"},
      [](const auto&... x) { return power_screw::thread_efficiency(x...); },
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6),
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).falling())
      .valid_when("friction * tan(lead_angle) < 1",
                  [](double lead_angle, double friction) { return friction * std::tan(lead_angle) < 1.0; });

  define(
      list,
      {.name = "power_screw.greatest_thread_efficiency",
       .handbook_id = "SCREW-EFFICIENCY-MAX",
       .symbol = "η_max",
       .unit = "1",
       .title = "Largest efficiency of any lead angle",
       .source = "khurmi_gupta2005, section 17.7"},
      [](const auto&... x) { return power_screw::greatest_thread_efficiency(x...); },
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).falling());

  define(
      list,
      {.name = "power_screw.reverse_efficiency",
       .handbook_id = "SCREW-EFFICIENCY-REVERSE",
       .symbol = "η_r",
       .unit = "1",
       .title = "Efficiency of the thread while the load drives",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::reverse_efficiency(x...); },
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6),
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).falling());

  define(
      list,
      {.name = "power_screw.self_locking_ratio",
       .handbook_id = "SCREW-SELF-LOCK",
       .symbol = "u",
       .unit = "1",
       .title = "Self-locking ratio",
       .source = "khurmi_gupta2005, section 17.9"},
      [](const auto&... x) { return power_screw::self_locking_ratio(x...); },
      quantity("lead_angle", "λ", "rad", "lead angle").between(0, 1.5).typical(0.02, 0.6).rising(),
      quantity("friction", "μ_e", "1", "effective friction coefficient, the lowest credible")
          .typical(0.03, 0.3)
          .falling());

  define(
      list,
      {.name = "power_screw.antibacklash_drag_torque",
       .handbook_id = "SCREW-ANTIBACKLASH-DRAG",
       .symbol = "T_d",
       .unit = "N.m",
       .title = "Drag of a spring-loaded split nut",
       .source = "millwright_derivations",
       .validity = "friction * tan(lead angle) < 1; lead angle < 40 degrees"},
      [](const auto&... x) { return power_screw::antibacklash_drag_torque(x...); },
      quantity("spring_force", "F_s", "N", "axial spring force between the nut halves").rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025),
      quantity("friction", "μ_e", "1", "effective friction coefficient").typical(0.03, 0.3).rising())
      .valid_when("friction * tan(lead angle) < 1",
                  [](double, double mean_diameter, double lead, double friction) {
                    return friction * lead < std::numbers::pi * mean_diameter;
                  })
      .valid_when("lead angle < 40 degrees", [](double, double mean_diameter, double lead, double) {
        return lead < 0.8390996 * std::numbers::pi * mean_diameter;
      });

  define(
      list,
      {.name = "power_screw.torsional_windup",
       .handbook_id = "SCREW-TORSION-WINDUP",
       .symbol = "θ",
       .unit = "rad",
       .title = "Twist of a screw",
       .source = "sularso_suga, chapter 1"},
      [](const auto&... x) { return power_screw::torsional_windup(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("length", "L", "m", "length").typical(0.1, 2).rising(),
      quantity("shear_modulus", "G", "Pa", "shear modulus").typical(20000000000.0, 90000000000.0).falling(),
      quantity("diameter", "d", "m", "diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.windup_error",
       .handbook_id = "SCREW-WINDUP-ERROR",
       .symbol = "Δx",
       .unit = "m",
       .title = "Position error by twist",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::windup_error(x...); },
      quantity("windup", "θ", "rad", "twist").typical(1e-05, 0.1).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).rising());

  define(
      list,
      {.name = "power_screw.axial_stiffness_of_torsion",
       .handbook_id = "SCREW-TORSION-AS-AXIAL-STIFFNESS",
       .symbol = "k_ax",
       .unit = "N/m",
       .title = "Axial equivalent of a torsional stiffness",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::axial_stiffness_of_torsion(x...); },
      quantity("torsional_stiffness", "k_θ", "N.m/rad", "torsional stiffness").rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).falling());

  define(
      list,
      {.name = "power_screw.axial_stiffness_one_end_fixed",
       .handbook_id = "SCREW-STIFFNESS-ONE-END",
       .symbol = "k",
       .unit = "N/m",
       .title = "Axial stiffness, one end fixed",
       .source = "thk_catalogue, axial rigidity"},
      [](const auto&... x) { return power_screw::axial_stiffness_one_end_fixed(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("distance", "x", "m", "distance from the fixed bearing to the nut").falling());

  define(
      list,
      {.name = "power_screw.axial_stiffness_both_ends_fixed",
       .handbook_id = "SCREW-STIFFNESS-BOTH-ENDS",
       .symbol = "k",
       .unit = "N/m",
       .title = "Axial stiffness, both ends fixed",
       .source = "thk_catalogue, axial rigidity",
       .validity = "distance < length"},
      [](const auto&... x) { return power_screw::axial_stiffness_both_ends_fixed(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "distance of the bearings").typical(0.1, 2),
      quantity("distance", "x", "m", "distance from one bearing to the nut"))
      .valid_when("distance < length",
                  [](double, double, double length, double distance) { return distance < length; });

  define(
      list,
      {.name = "power_screw.thermal_growth",
       .handbook_id = "SCREW-THERMAL-GROWTH",
       .symbol = "ΔL",
       .unit = "m",
       .title = "Thermal growth",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::thermal_growth(x...); },
      quantity("thermal_expansion", "α", "1/K", "coefficient of thermal expansion").rising(),
      quantity("length", "L", "m", "length").typical(0.1, 2).rising(),
      quantity("temperature_rise", "ΔT", "K", "rise of temperature").rising());

  define(
      list,
      {.name = "power_screw.inertia",
       .handbook_id = "SCREW-INERTIA",
       .symbol = "J",
       .unit = "kg.m^2",
       .title = "Moment of inertia of a screw",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::inertia(x...); },
      quantity("density", "ρ", "kg/m^3", "density").typical(1000, 9000).rising(),
      quantity("diameter", "d", "m", "diameter of the equivalent cylinder").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "length").typical(0.1, 2).rising());

  define(
      list,
      {.name = "power_screw.angular_speed",
       .handbook_id = "SCREW-SPEED",
       .symbol = "ω",
       .unit = "rad/s",
       .title = "Speed of a screw",
       .source = "khurmi_gupta2005, chapter 17"},
      [](const auto&... x) { return power_screw::angular_speed(x...); },
      quantity("speed", "v", "m/s", "speed of the nut").typical(0.01, 2).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).falling());

  define(
      list,
      {.name = "power_screw.power",
       .handbook_id = "SCREW-POWER",
       .symbol = "P",
       .unit = "W",
       .title = "Power at the screw",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::power(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("angular_speed", "ω", "rad/s", "angular speed").rising());
}

}  // namespace millwright::mechanics
