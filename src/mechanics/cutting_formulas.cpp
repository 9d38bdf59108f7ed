// SPDX-License-Identifier: Apache-2.0
#include "mechanics/cutting.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_cutting(FormulaList& list) {
  define(
      list,
      {.name = "cutting.cutting_speed",
       .handbook_id = "CUT-SPEED",
       .symbol = "v_c",
       .unit = "m/s",
       .title = "Speed of the cutting edge",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::cutting_speed(x...); },
      quantity("diameter", "D", "m", "tool diameter").rising(),
      quantity("spindle_speed", "ω_s", "rad/s", "spindle speed").typical(50, 3000).rising());

  define(
      list,
      {.name = "cutting.feed_speed",
       .handbook_id = "CUT-FEED-SPEED",
       .symbol = "v_f",
       .unit = "m/s",
       .title = "Feed speed from the feed per tooth",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::feed_speed(x...); },
      quantity("feed_per_tooth", "f_z", "m", "feed per tooth").typical(1e-5, 2e-4).rising(),
      count("teeth", "z", "teeth").typical(1, 8).rising(),
      quantity("spindle_speed", "ω_s", "rad/s", "spindle speed").typical(50, 3000).rising());

  define(
      list,
      {.name = "cutting.mean_chip_thickness",
       .handbook_id = "CUT-CHIP-THICKNESS",
       .symbol = "h_m",
       .unit = "m",
       .title = "Mean chip thickness in peripheral milling over the arc of engagement",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting; engagement at most the diameter"},
      [](const auto&... x) { return cutting::mean_chip_thickness(x...); },
      quantity("feed_per_tooth", "f_z", "m", "feed per tooth").typical(1e-5, 2e-4).rising(),
      quantity("radial_engagement", "a_e", "m", "radial engagement"),
      quantity("diameter", "D", "m", "tool diameter"),
      quantity("entering_angle", "κ", "rad", "entering angle (pi/2 for an end mill)")
          .between(0, 1.5707963267948966)
          .typical(0.5, 1.5))
      .valid_when("radial_engagement <= diameter", [](double, double radial_engagement, double diameter, double) {
        return radial_engagement <= diameter;
      });

  define(
      list,
      {.name = "cutting.specific_cutting_force",
       .handbook_id = "CUT-SPECIFIC-FORCE",
       .symbol = "k_c",
       .unit = "Pa",
       .title = "Specific cutting force after Kienzle",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::specific_cutting_force(x...); },
      quantity("unit_specific_force", "k_c1.1", "Pa", "specific cutting force at h = 1 mm").typical(1e8, 2e9).rising(),
      quantity("chip_thickness", "h_m", "m", "mean chip thickness").typical(1e-6, 2e-4).falling(),
      quantity("exponent", "m_c", "1", "exponent").typical(0.1, 0.9).rising(),
      quantity("rake_angle", "γ_0", "rad", "effective rake angle").between(-0.5, 0.5).typical(-0.1, 0.3).falling());

  define(
      list,
      {.name = "cutting.removal_rate",
       .handbook_id = "CUT-MRR",
       .symbol = "Q",
       .unit = "m^3/s",
       .title = "Volume removed per time",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::removal_rate(x...); },
      quantity("axial_depth", "a_p", "m", "axial depth").rising(),
      quantity("radial_engagement", "a_e", "m", "radial engagement").rising(),
      quantity("feed_speed", "v_f", "m/s", "feed speed").rising());

  define(
      list,
      {.name = "cutting.cutting_power",
       .handbook_id = "CUT-POWER",
       .symbol = "P_c",
       .unit = "W",
       .title = "Cutting power",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::cutting_power(x...); },
      quantity("specific_cutting_force", "k_c", "Pa", "specific cutting force").rising(),
      quantity("removal_rate", "Q", "m^3/s", "removal rate").rising());

  define(
      list,
      {.name = "cutting.mean_tangential_force",
       .handbook_id = "CUT-TANGENTIAL-FORCE-MEAN",
       .symbol = "F_t",
       .unit = "N",
       .title = "Time mean of the tangential cutting force",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::mean_tangential_force(x...); },
      quantity("cutting_power", "P_c", "W", "cutting power").rising(),
      quantity("cutting_speed", "v_c", "m/s", "cutting speed").falling());

  define(
      list,
      {.name = "cutting.peak_tooth_force",
       .handbook_id = "CUT-TOOTH-FORCE-PEAK",
       .symbol = "F_t,pk",
       .unit = "N",
       .title = "Largest tangential force of one tooth in peripheral milling",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting; engagement at most the diameter"},
      [](const auto&... x) { return cutting::peak_tooth_force(x...); },
      quantity("unit_specific_force", "k_c1.1", "Pa", "specific cutting force").typical(1e8, 2e9).rising(),
      quantity("exponent", "m_c", "1", "exponent").typical(0.1, 0.9),
      quantity("axial_depth", "a_p", "m", "axial depth").rising(),
      quantity("feed_per_tooth", "f_z", "m", "feed per tooth").typical(1e-5, 2e-4).rising(),
      quantity("radial_engagement", "a_e", "m", "radial engagement").rising(),
      quantity("diameter", "D", "m", "tool diameter"))
      .valid_when("radial_engagement <= diameter",
                  [](double, double, double, double, double radial_engagement, double diameter) {
                    return radial_engagement <= diameter;
                  });

  define(
      list,
      {.name = "cutting.spindle_torque",
       .handbook_id = "CUT-SPINDLE-TORQUE",
       .symbol = "M_c",
       .unit = "N.m",
       .title = "Torque at the spindle",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::spindle_torque(x...); },
      quantity("cutting_power", "P_c", "W", "cutting power").rising(),
      quantity("spindle_speed", "ω_s", "rad/s", "spindle speed").typical(50, 3000).falling());

  define(
      list,
      {.name = "cutting.axis_force",
       .handbook_id = "CUT-AXIS-FORCE",
       .symbol = "F_axis",
       .unit = "N",
       .title = "Force on an axis as a share of the tangential force",
       .source = "altintas2012",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::axis_force(x...); },
      quantity("tangential_force", "F_t", "N", "tangential force").rising(),
      quantity("force_ratio", "r_a", "1", "ratio of the axis force to F_t").rising());

  define(
      list,
      {.name = "cutting.drill_thrust",
       .handbook_id = "CUT-DRILL-THRUST",
       .symbol = "F_f",
       .unit = "N",
       .title = "Feed force of a drill",
       .source = "sandvik_milling",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::drill_thrust(x...); },
      quantity("specific_cutting_force", "k_c", "Pa", "specific cutting force").rising(),
      quantity("diameter", "D", "m", "drill diameter").rising(),
      quantity("feed_per_revolution", "f_n", "m", "feed per revolution").rising(),
      quantity("half_point_angle", "κ", "rad", "half point angle").between(0, 1.5707963267948966).typical(0.8, 1.3));

  define(
      list,
      {.name = "cutting.equivalent_chip_thickness",
       .handbook_id = "CUT-GRIND-HEQ",
       .symbol = "h_eq",
       .unit = "m",
       .title = "Equivalent chip thickness in grinding",
       .source = "sander, eq. 4",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::equivalent_chip_thickness(x...); },
      quantity("depth_of_cut", "a", "m", "depth of cut").rising(),
      quantity("feed_speed", "v_w", "m/s", "work (feed) speed").rising(),
      quantity("wheel_speed", "v_s", "m/s", "wheel peripheral speed").typical(1, 60).falling());

  define(
      list,
      {.name = "cutting.grinding_force",
       .handbook_id = "CUT-GRIND-FORCE",
       .symbol = "F_t",
       .unit = "N",
       .title = "Tangential grinding force",
       .source = "sander, eq. 5",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::grinding_force(x...); },
      quantity("specific_tangential_force", "F_1", "N/m", "specific tangential force at h_eq = 1 um").rising(),
      quantity("equivalent_chip_thickness", "h_eq", "m", "equivalent chip thickness").typical(1e-8, 2e-6).rising(),
      quantity("exponent", "f_e", "1", "exponent").typical(0.1, 0.9),
      quantity("active_width", "b", "m", "active width").rising());

  define(
      list,
      {.name = "cutting.sanding_force",
       .handbook_id = "CUT-SANDING-FORCE",
       .symbol = "F_t",
       .unit = "N",
       .title = "Tangential force of a sanding wheel or pad",
       .source = "millwright_derivations, definition",
       .validity = "sharp tool, stationary cutting"},
      [](const auto&... x) { return cutting::sanding_force(x...); },
      quantity("friction", "μ", "1", "friction coefficient abrasive/work").between(0, 1).typical(0.002, 0.4).rising(),
      quantity("contact_pressure", "p", "Pa", "contact pressure").rising(),
      quantity("contact_area", "A", "m^2", "contact area").rising());

  define(
      list,
      {.name = "cutting.extrusion_pressure",
       .handbook_id = "CUT-EXTRUSION-PRESSURE",
       .symbol = "Δp",
       .unit = "Pa",
       .title = "Pressure drop of melt in a nozzle land",
       .source = "bird_stewart_lightfoot2002, 2.3",
       .validity = "Newtonian melt, laminar"},
      [](const auto&... x) { return cutting::extrusion_pressure(x...); },
      quantity("viscosity", "η_v", "Pa.s", "melt viscosity").rising(),
      quantity("land_length", "L", "m", "nozzle land length").rising(),
      quantity("flow_rate", "Q", "m^3/s", "volume flow").rising(),
      quantity("nozzle_diameter", "d", "m", "nozzle bore").falling());

  define(
      list,
      {.name = "cutting.extrusion_force",
       .handbook_id = "CUT-EXTRUSION-FORCE",
       .symbol = "F",
       .unit = "N",
       .title = "Force that pushes filament against the melt pressure",
       .source = "millwright_derivations, definition",
       .validity = "no slip of the filament drive"},
      [](const auto&... x) { return cutting::extrusion_force(x...); },
      quantity("pressure", "Δp", "Pa", "melt pressure").rising(),
      quantity("filament_diameter", "d_f", "m", "filament diameter").rising());

  define(
      list,
      {.name = "cutting.grinding_removal_rate",
       .symbol = "Z",
       .unit = "m^3/s",
       .title = "Volume removed per time in traverse grinding",
       .source = "sander, eq. 2"},
      [](const auto&... x) { return cutting::grinding_removal_rate(x...); },
      quantity("depth_of_cut", "a", "m", "depth of cut").rising(),
      quantity("axial_feed", "f_a", "m", "feed along the wheel axis per pass").rising(),
      quantity("overlap", "U", "1", "overlap").at_least(1).typical(1, 10).rising(),
      quantity("feed_speed", "v_w", "m/s", "speed of the work").rising());

  define(
      list,
      {.name = "cutting.chip_thickness_factor",
       .symbol = "h^f",
       .unit = "1",
       .title = "Power of the equivalent chip thickness in micrometres by which grinding forces grow",
       .source = "sander, eq. 5"},
      [](const auto&... x) { return cutting::chip_thickness_factor(x...); },
      quantity("equivalent_chip_thickness", "h_eq", "m", "equivalent chip thickness").typical(1e-8, 2e-6).rising(),
      quantity("exponent", "f_e", "1", "exponent").typical(0.1, 0.9));

  define(
      list,
      {.name = "cutting.specific_grinding_force",
       .symbol = "F_t'",
       .unit = "N/m",
       .title = "Tangential grinding force per active width",
       .source = "sander, eq. 5"},
      [](const auto&... x) { return cutting::specific_grinding_force(x...); },
      quantity("specific_tangential_force", "F_1", "N/m", "tangential force per width at 1 µm").rising(),
      quantity("equivalent_chip_thickness", "h_eq", "m", "equivalent chip thickness").typical(1e-8, 2e-6).rising(),
      quantity("exponent", "f_e", "1", "exponent").typical(0.1, 0.9));

  define(
      list,
      {.name = "cutting.specific_normal_force",
       .symbol = "F_n'",
       .unit = "N/m",
       .title = "Normal grinding force per active width",
       .source = "sander, eq. 6"},
      [](const auto&... x) { return cutting::specific_normal_force(x...); },
      quantity("specific_tangential_force", "F_1", "N/m", "tangential force per width at 1 µm").rising(),
      quantity("friction", "μ", "1", "ratio of tangential to normal force").between(0, 1).typical(0.002, 0.4).falling(),
      quantity("equivalent_chip_thickness", "h_eq", "m", "equivalent chip thickness").typical(1e-8, 2e-6).rising(),
      quantity("exponent", "f_e", "1", "exponent").typical(0.1, 0.9));

  define(
      list,
      {.name = "cutting.force_of_width",
       .symbol = "F",
       .unit = "N",
       .title = "Grinding force over the active width",
       .source = "sander, eq. 7"},
      [](const auto&... x) { return cutting::force_of_width(x...); },
      quantity("specific_force", "F_w", "N/m", "force per width").rising(),
      quantity("active_width", "b", "m", "active width").rising());
}

}  // namespace millwright::mechanics
