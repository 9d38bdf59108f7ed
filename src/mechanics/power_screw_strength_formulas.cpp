// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/power_screw_strength.h"

namespace millwright::mechanics {

void define_power_screw_strength(FormulaList& list) {
  define(
      list,
      {.name = "power_screw.axial_stress",
       .handbook_id = "SCREW-STRESS-AXIAL",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Axial stress in the core",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::axial_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.torsional_stress",
       .handbook_id = "SCREW-STRESS-TORSION",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Torsional stress in the core",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::torsional_stress(x...); },
      quantity("torque", "T", "N.m", "torque through the core").rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.maximum_shear_stress",
       .handbook_id = "SCREW-STRESS-MAX-SHEAR",
       .symbol = "τ_max",
       .unit = "Pa",
       .title = "Maximum shear stress in the core",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::maximum_shear_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.maximum_principal_stress",
       .handbook_id = "SCREW-STRESS-MAX-PRINCIPAL",
       .symbol = "σ_max",
       .unit = "Pa",
       .title = "Maximum principal stress in the core",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return power_screw::maximum_principal_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.von_mises_stress",
       .handbook_id = "SCREW-STRESS-VONMISES",
       .symbol = "σ_v",
       .unit = "Pa",
       .title = "Von Mises stress in the core",
       .source = "shigley, section 5-5"},
      [](const auto&... x) { return power_screw::von_mises_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "power_screw.required_core_diameter",
       .handbook_id = "SCREW-CORE-DIAM-REQUIRED",
       .symbol = "d_c",
       .unit = "m",
       .title = "Core diameter that carries the force",
       .source = "khurmi_gupta2005, section 17.13; torch_table, eq. 15"},
      [](const auto&... x) { return power_screw::required_core_diameter(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("safety_factor", "SF", "1", "safety factor").typical(1, 6).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).falling());

  define(
      list,
      {.name = "power_screw.engaged_turns",
       .handbook_id = "SCREW-THREADS-ENGAGED",
       .symbol = "n",
       .unit = "1",
       .title = "Turns in engagement",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::engaged_turns(x...); },
      quantity("nut_height", "H", "m", "height of the nut").typical(0.008, 0.1).rising(),
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).falling());

  define(
      list,
      {.name = "power_screw.bearing_pressure",
       .handbook_id = "SCREW-BEARING-PRESSURE",
       .symbol = "p_b",
       .unit = "Pa",
       .title = "Bearing pressure of the thread",
       .source = "khurmi_gupta2005, section 17.13; bhandari, section 6.5"},
      [](const auto&... x) { return power_screw::bearing_pressure(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).falling(),
      quantity("thread_depth", "h", "m", "depth of engagement of the threads").typical(0.0005, 0.006).falling(),
      quantity("engaged_turns", "n", "1", "number of turns in engagement").typical(1, 10).falling());

  define(
      list,
      {.name = "power_screw.required_nut_height",
       .handbook_id = "SCREW-NUT-HEIGHT-REQUIRED",
       .symbol = "H",
       .unit = "m",
       .title = "Nut height for an allowable pressure",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::required_nut_height(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).falling(),
      quantity("thread_depth", "h", "m", "depth of engagement of the threads").typical(0.0005, 0.006).falling(),
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).rising(),
      quantity("allowable_pressure", "p_allow", "Pa", "allowable bearing pressure")
          .typical(1000000.0, 20000000.0)
          .falling());

  define(
      list,
      {.name = "power_screw.thread_root_thickness",
       .handbook_id = "SCREW-THREAD-ROOT-THICKNESS",
       .symbol = "t_r",
       .unit = "m",
       .title = "Thread thickness at the root",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::thread_root_thickness(x...); },
      quantity("pitch", "p", "m", "pitch").typical(0.001, 0.012).rising(),
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05));

  define(
      list,
      {.name = "power_screw.thread_shear_stress",
       .handbook_id = "SCREW-THREAD-SHEAR",
       .symbol = "τ",
       .unit = "Pa",
       .title = "Mean shear stress of the thread",
       .source = "khurmi_gupta2005, section 17.13"},
      [](const auto&... x) { return power_screw::thread_shear_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).falling(),
      quantity("root_thickness", "t_r", "m", "thickness of the thread at its root").typical(0.0005, 0.008).falling(),
      quantity("engaged_turns", "n", "1", "number of turns in engagement").typical(1, 10).falling());

  define(
      list,
      {.name = "power_screw.maximum_thread_shear_stress",
       .handbook_id = "SCREW-THREAD-SHEAR-MAX",
       .symbol = "τ_max",
       .unit = "Pa",
       .title = "Largest shear stress of the thread",
       .source = "shigley, section 8-2; fdm_printer, eq. 2.8"},
      [](const auto&... x) { return power_screw::maximum_thread_shear_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).falling(),
      quantity("root_thickness", "t_r", "m", "thickness of the thread at its root").typical(0.0005, 0.008).falling(),
      quantity("engaged_turns", "n", "1", "number of turns in engagement").typical(1, 10).falling());

  define(
      list,
      {.name = "power_screw.thread_bending_stress",
       .handbook_id = "SCREW-THREAD-BENDING",
       .symbol = "σ_b",
       .unit = "Pa",
       .title = "Bending stress of the thread",
       .source = "shigley, eq. 8-11"},
      [](const auto&... x) { return power_screw::thread_bending_stress(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("root_diameter", "d_r", "m", "root diameter").typical(0.004, 0.05).falling(),
      quantity("thread_depth", "h", "m", "depth of engagement of the threads").typical(0.0005, 0.006).rising(),
      quantity("root_thickness", "t_r", "m", "thickness of the thread at its root").typical(0.0005, 0.008).falling(),
      quantity("engaged_turns", "n", "1", "number of turns in engagement").typical(1, 10).falling());

  define(
      list,
      {.name = "power_screw.sliding_speed",
       .handbook_id = "SCREW-SLIDING-SPEED",
       .symbol = "v_s",
       .unit = "m/s",
       .title = "Sliding speed of the thread",
       .source = "millwright_derivations"},
      [](const auto&... x) { return power_screw::sliding_speed(x...); },
      quantity("angular_speed", "ω", "rad/s", "angular speed").rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).rising());

  define(
      list,
      {.name = "power_screw.pressure_velocity",
       .handbook_id = "SCREW-PV",
       .symbol = "PV",
       .unit = "Pa.m/s",
       .title = "Pressure times sliding speed of the nut",
       .source = "thomson_pv"},
      [](const auto&... x) { return power_screw::pressure_velocity(x...); },
      quantity("bearing_pressure", "p_b", "Pa", "pressure between the threads").typical(100000.0, 20000000.0).rising(),
      quantity("sliding_speed", "v_s", "m/s", "sliding speed of the threads").rising());

  define(
      list,
      {.name = "power_screw.nut_wear",
       .handbook_id = "SCREW-NUT-WEAR",
       .symbol = "δ_ax",
       .unit = "m",
       .title = "Axial wear of the nut",
       .source = "tribology_abc"},
      [](const auto&... x) { return power_screw::nut_wear(x...); },
      quantity("wear_rate", "k", "m^2/N", "specific wear rate").rising(),
      quantity("bearing_pressure", "p_b", "Pa", "pressure between the threads").typical(100000.0, 20000000.0).rising(),
      quantity("sliding_distance", "s_slide", "m", "total sliding distance").typical(1, 100000.0).rising(),
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55).rising());

  define(
      list,
      {.name = "power_screw.nut_wear_travel",
       .handbook_id = "SCREW-NUT-WEAR-TRAVEL",
       .symbol = "s_lin",
       .unit = "m",
       .title = "Travel until the nut is worn",
       .source = "tribology_abc; millwright_derivations"},
      [](const auto&... x) { return power_screw::nut_wear_travel(x...); },
      quantity("wear_rate", "k", "m^2/N", "specific wear rate").falling(),
      quantity("bearing_pressure", "p_b", "Pa", "pressure between the threads").typical(100000.0, 20000000.0).falling(),
      quantity("flank_angle", "β", "rad", "half of the thread angle").between(0, 1.5).typical(0, 0.55).falling(),
      quantity("allowable_wear", "δ_allow", "m", "allowable axial wear").typical(1e-05, 0.001).rising(),
      quantity("mean_diameter", "d_m", "m", "mean diameter").typical(0.005, 0.05).falling(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.025).rising());
}

}  // namespace millwright::mechanics
