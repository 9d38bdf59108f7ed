// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/guide.h"

namespace millwright::mechanics {

void define_guide(FormulaList& list) {
  define(
      list,
      {.name = "guide.pitch_moment",
       .handbook_id = "GUIDE-MOMENT-Y",
       .symbol = "M_y",
       .unit = "N.m",
       .title = "Pitching moment on the carriages",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::pitch_moment(x...); },
      quantity("force_x", "F_x", "N", "force along travel").any_sign().typical(-500, 500),
      quantity("force_z", "F_z", "N", "vertical force (down negative or positive as drawn: +z away from the base)")
          .any_sign()
          .typical(-500, 500),
      quantity("point_x", "x_F", "m", "point of action along travel").any_sign().typical(-0.3, 0.3),
      quantity("point_z", "z_F", "m", "its height").any_sign().typical(-0.3, 0.3),
      quantity("drive_z", "z_d", "m", "height of the drive line").any_sign().typical(-0.3, 0.3));

  define(
      list,
      {.name = "guide.roll_moment",
       .handbook_id = "GUIDE-MOMENT-X",
       .symbol = "M_x",
       .unit = "N.m",
       .title = "Rolling moment on the carriages",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::roll_moment(x...); },
      quantity("force_y", "F_y", "N", "lateral force").any_sign().typical(-500, 500),
      quantity("force_z", "F_z", "N", "vertical force").any_sign().typical(-500, 500),
      quantity("point_y", "y_F", "m", "lateral point of action").any_sign().typical(-0.3, 0.3),
      quantity("point_z", "z_F", "m", "height above the carriage mid-plane").any_sign().typical(-0.3, 0.3));

  define(
      list,
      {.name = "guide.yaw_moment",
       .handbook_id = "GUIDE-MOMENT-Z",
       .symbol = "M_z",
       .unit = "N.m",
       .title = "Yawing moment on the carriages",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::yaw_moment(x...); },
      quantity("force_x", "F_x", "N", "force along travel").any_sign().typical(-500, 500),
      quantity("force_y", "F_y", "N", "lateral force").any_sign().typical(-500, 500),
      quantity("point_x", "x_F", "m", "point of action along travel").any_sign().typical(-0.3, 0.3),
      quantity("point_y", "y_F", "m", "lateral").any_sign().typical(-0.3, 0.3),
      quantity("drive_y", "y_d", "m", "lateral position of the drive line").any_sign().typical(-0.3, 0.3));

  define(
      list,
      {.name = "guide.carriage_vertical_load",
       .handbook_id = "GUIDE-LOAD-VERTICAL",
       .symbol = "P_z",
       .unit = "N",
       .title = "Vertical force of the table on one of four carriages, signed like the total force",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections; four carriages on two rails"},
      [](const auto&... x) { return guide::carriage_vertical_load(x...); },
      quantity("force_z", "F_z", "N", "total vertical force on the table").any_sign().typical(-500, 500),
      quantity("roll_moment", "M_x", "N.m", "roll moment").any_sign().typical(-50, 50),
      quantity("pitch_moment", "M_y", "N.m", "pitch moment").any_sign().typical(-50, 50),
      quantity("carriage_spacing", "l_x", "m", "carriage spacing along the rail"),
      quantity("rail_spacing", "l_y", "m", "rail spacing"),
      quantity("side_x", "s_x", "1", "+1 or -1 carriage side along the rail").between(-1, 1).typical(-1, 1),
      quantity("side_y", "s_y", "1", "+1 or -1 rail side").between(-1, 1).typical(-1, 1));

  define(
      list,
      {.name = "guide.carriage_lateral_load",
       .handbook_id = "GUIDE-LOAD-LATERAL",
       .symbol = "P_y",
       .unit = "N",
       .title = "Lateral force of the table on one of four carriages, signed",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections; four carriages on two rails"},
      [](const auto&... x) { return guide::carriage_lateral_load(x...); },
      quantity("force_y", "F_y", "N", "total lateral force").any_sign().typical(-500, 500),
      quantity("yaw_moment", "M_z", "N.m", "yaw moment").any_sign().typical(-50, 50),
      quantity("carriage_spacing", "l_x", "m", "carriage spacing along the rail"),
      quantity("side_x", "s_x", "1", "+1 or -1").between(-1, 1).typical(-1, 1));

  define(
      list,
      {.name = "guide.largest_carriage_load",
       .handbook_id = "GUIDE-LOAD-MAX",
       .symbol = "P_max",
       .unit = "N",
       .title = "Safe bound of the equivalent load on the worst of four carriages",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections; four carriages on two rails"},
      [](const auto&... x) { return guide::largest_carriage_load(x...); },
      quantity("force_z", "F_z", "N", "vertical force").any_sign().typical(-500, 500),
      quantity("roll_moment", "M_x", "N.m", "roll moment").any_sign().typical(-50, 50),
      quantity("pitch_moment", "M_y", "N.m", "pitch moment").any_sign().typical(-50, 50),
      quantity("force_y", "F_y", "N", "lateral force").any_sign().typical(-500, 500),
      quantity("yaw_moment", "M_z", "N.m", "yaw moment").any_sign().typical(-50, 50),
      quantity("carriage_spacing", "l_x", "m", "carriage spacing along the rail").falling(),
      quantity("rail_spacing", "l_y", "m", "rail spacing").falling());

  define(
      list,
      {.name = "guide.equivalent_load",
       .handbook_id = "GUIDE-EQUIVALENT-LOAD",
       .symbol = "P",
       .unit = "N",
       .title = "Equivalent load of a carriage that is equally strong in all four directions",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::equivalent_load(x...); },
      quantity("vertical_load", "P_z", "N", "vertical load on one carriage").any_sign().typical(-500, 500),
      quantity("lateral_load", "P_y", "N", "lateral load on it").any_sign().typical(-500, 500));

  define(
      list,
      {.name = "guide.equivalent_load_with_moments",
       .handbook_id = "GUIDE-EQUIVALENT-LOAD-SINGLE",
       .symbol = "P",
       .unit = "N",
       .title = "Equivalent load of a carriage that takes moments itself",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::equivalent_load_with_moments(x...); },
      quantity("vertical_load", "P_z", "N", "vertical load on the carriage").any_sign().typical(-500, 500),
      quantity("lateral_load", "P_y", "N", "lateral load").any_sign().typical(-500, 500),
      list_of("moments", "M", "N.m", "moments on the carriage").any_sign().typical(-50, 50),
      list_of("static_moment_ratings", "M_0", "N.m", "matching static moment ratings").as_long_as(2),
      quantity("static_load_rating", "C_0", "N", "static load rating").rising());

  define(
      list,
      {.name = "guide.mean_load",
       .handbook_id = "GUIDE-MEAN-LOAD",
       .symbol = "P_m",
       .unit = "N",
       .title = "Constant load with the same life as the loads of the duty cycle",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::mean_load(x...); },
      list_of("equivalent_loads", "P", "N", "equivalent loads"),
      list_of("distances", "s", "m", "travelled distances").as_long_as(0),
      quantity("exponent", "e", "1", "exponent 3 (ball) or 10/3 (roller)").between(1, 4).typical(3, 3.4).rising());

  define(
      list,
      {.name = "guide.ball_life_distance",
       .handbook_id = "GUIDE-LIFE-BALL",
       .symbol = "L",
       .unit = "m",
       .title = "Distance that 90 % of ball carriages reach",
       .source = "iso14728_1",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::ball_life_distance(x...); },
      quantity("dynamic_load_rating", "C", "N", "dynamic load rating").rising(),
      quantity("mean_load", "P", "N", "mean equivalent load").falling(),
      quantity("load_factor", "f_w", "1", "load factor").at_least(1).typical(1, 3.5).falling(),
      quantity("condition_factor", "f_hct", "1", "product of hardness, temperature and contact factors")
          .between(0, 1)
          .typical(0.5, 1)
          .rising(),
      quantity("rating_distance", "L_ref", "m", "rating distance: 50 000 or 100 000").typical(5e4, 1e5).rising());

  define(
      list,
      {.name = "guide.roller_life_distance",
       .handbook_id = "GUIDE-LIFE-ROLLER",
       .symbol = "L",
       .unit = "m",
       .title = "Distance that 90 % of roller carriages reach",
       .source = "iso14728_1",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::roller_life_distance(x...); },
      quantity("dynamic_load_rating", "C", "N", "dynamic load rating (100 km)").rising(),
      quantity("mean_load", "P", "N", "mean equivalent load").falling(),
      quantity("load_factor", "f_w", "1", "load factor").at_least(1).typical(1, 3.5).falling(),
      quantity("condition_factor", "f_hct", "1", "product of factors").between(0, 1).typical(0.5, 1).rising());

  define(
      list,
      {.name = "guide.dynamic_load_rating_50_km",
       .handbook_id = "GUIDE-RATING-100-TO-50",
       .symbol = "C_50",
       .unit = "N",
       .title = "Load rating referred to 50 km of a ball carriage rated for 100 km, 1.26 times",
       .source = "iso14728_1",
       .validity = "ball carriages only"},
      [](const auto&... x) { return guide::dynamic_load_rating_50_km(x...); },
      quantity("dynamic_load_rating_100_km", "C_100", "N", "ball-guide rating based on 100 km").rising());

  define(
      list,
      {.name = "guide.life_time",
       .handbook_id = "GUIDE-LIFE-HOURS",
       .symbol = "L_h",
       .unit = "s",
       .display_unit = "h",
       .title = "Life at the mean speed over the whole duty cycle",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::life_time(x...); },
      quantity("life_distance", "L", "m", "life distance").typical(1e5, 1e9).rising(),
      quantity("mean_speed", "v_m", "m/s", "mean speed over the whole duty cycle").falling());

  define(
      list,
      {.name = "guide.static_safety",
       .handbook_id = "GUIDE-STATIC-SAFETY",
       .symbol = "f_s",
       .unit = "1",
       .title = "Static load rating over the largest equivalent load",
       .source = "thk_lm_guide, static safety",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::static_safety(x...); },
      quantity("static_load_rating", "C_0", "N", "static load rating").rising(),
      quantity("largest_load", "P_max", "N", "largest equivalent load incl. shock").falling());

  define(
      list,
      {.name = "guide.friction_force",
       .handbook_id = "GUIDE-FRICTION",
       .symbol = "F_f",
       .unit = "N",
       .title = "Friction of all carriages with their seals",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::friction_force(x...); },
      quantity("friction", "μ", "1", "friction coefficient").between(0, 1).typical(0.002, 0.4).rising(),
      quantity("load_sum", "P_sum", "N", "sum of the absolute equivalent carriage loads").rising(),
      count("carriage_count", "n_c", "number of carriages").typical(1, 8).rising(),
      quantity("seal_drag", "f_seal", "N", "seal drag per carriage").rising());

  define(
      list,
      {.name = "guide.carriage_deflection",
       .handbook_id = "GUIDE-CARRIAGE-DEFLECTION",
       .symbol = "δ",
       .unit = "m",
       .title = "Elastic deflection of a carriage",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::carriage_deflection(x...); },
      quantity("load", "P", "N", "load on the carriage").rising(),
      quantity("stiffness", "k_c", "N/m", "carriage stiffness in that direction").falling());

  define(
      list,
      {.name = "guide.pitch_stiffness",
       .handbook_id = "GUIDE-PITCH-STIFFNESS",
       .symbol = "k_θ",
       .unit = "N.m/rad",
       .title = "Pitching stiffness of four carriages",
       .source = "hiwin_linear_guideway, load calculation",
       .validity = "rigid table and rails, equal carriages, small deflections"},
      [](const auto&... x) { return guide::pitch_stiffness(x...); },
      quantity("carriage_stiffness", "k_c", "N/m", "vertical stiffness of one carriage").rising(),
      quantity("carriage_spacing", "l_x", "m", "carriage spacing along the rail").rising());

  define(
      list,
      {.name = "guide.shaft_deflection",
       .handbook_id = "GUIDE-SHAFT-DEFLECTION",
       .symbol = "δ",
       .unit = "m",
       .title = "Midspan deflection of an end-supported round shaft under two bushings in the middle",
       .source = "shigley, Table A-9",
       .validity = "simply supported ends, bushings centred, spacing below the span"},
      [](const auto&... x) { return guide::shaft_deflection(x...); },
      quantity("force", "F", "N", "load per shaft").rising(),
      quantity("span", "L", "m", "span between shaft supports").rising(),
      quantity("bushing_spacing", "s_b", "m", "spacing of the two bushings").falling(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("diameter", "d", "m", "shaft diameter").falling())
      .valid_when("bushing_spacing < span",
                  [](double, double span, double bushing_spacing, double, double) { return bushing_spacing < span; });

  define(
      list,
      {.name = "guide.shaft_slope",
       .handbook_id = "GUIDE-SHAFT-SLOPE",
       .symbol = "φ",
       .unit = "rad",
       .title = "Slope of the shaft at a bushing",
       .source = "shigley, Table A-9",
       .validity = "simply supported ends, bushings centred, spacing below the span"},
      [](const auto&... x) { return guide::shaft_slope(x...); },
      quantity("force", "F", "N", "load per shaft").rising(),
      quantity("span", "L", "m", "span between shaft supports").rising(),
      quantity("bushing_spacing", "s_b", "m", "spacing of the two bushings"),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).falling(),
      quantity("diameter", "d", "m", "shaft diameter").falling())
      .valid_when("bushing_spacing < span",
                  [](double, double span, double bushing_spacing, double, double) { return bushing_spacing < span; });

  define(
      list,
      {.name = "guide.shaft_stress",
       .handbook_id = "GUIDE-SHAFT-STRESS",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Bending stress of an end-supported round shaft between its two bushings",
       .source = "khurmi_gupta2005, chapter 14",
       .validity = "simply supported ends, bushings centred, spacing below the span"},
      [](const auto&... x) { return guide::shaft_stress(x...); },
      quantity("force", "F", "N", "load per shaft").rising(),
      quantity("span", "L", "m", "span").rising(),
      quantity("bushing_spacing", "s_b", "m", "spacing of the two bushings").falling(),
      quantity("diameter", "d", "m", "shaft diameter").falling())
      .valid_when("bushing_spacing < span",
                  [](double, double span, double bushing_spacing, double) { return bushing_spacing < span; });

  define(
      list,
      {.name = "guide.required_bushing_length",
       .handbook_id = "GUIDE-BINDING-LENGTH",
       .symbol = "l",
       .unit = "m",
       .title = "Bearing length a plain bushing needs so that a driving force off its axis does not jam it",
       .source = "millwright_derivations, definition",
       .validity = "plain bushing, force parallel to the guide"},
      [](const auto&... x) { return guide::required_bushing_length(x...); },
      quantity("friction", "μ", "1", "friction coefficient of a plain bushing")
          .between(0, 1)
          .typical(0.002, 0.4)
          .rising(),
      quantity("force_offset", "e", "m", "offset of the driving force from the guide axis").rising(),
      quantity("safety_factor", "k_b", "1", "safety factor (2:1 rule uses mu=0.25)")
          .at_least(1)
          .typical(1, 8)
          .rising());
}

}  // namespace millwright::mechanics
