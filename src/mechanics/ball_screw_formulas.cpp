// SPDX-License-Identifier: Apache-2.0
#include "mechanics/ball_screw.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_ball_screw(FormulaList& list) {
  define(
      list,
      {.name = "ball_screw.mean_speed",
       .handbook_id = "BS-MEAN-SPEED",
       .symbol = "ω_m",
       .unit = "rad/s",
       .title = "Mean speed over the cycle",
       .source = "iso3408_5, section 7.1"},
      [](const auto&... x) { return ball_screw::mean_speed(x...); },
      list_of("angular_speeds", "ω", "rad/s", "angular speed in each phase").any_sign(),
      list_of("durations", "t", "s", "duration of each phase, dwells included").as_long_as(0));

  define(
      list,
      {.name = "ball_screw.mean_load",
       .handbook_id = "BS-MEAN-LOAD",
       .symbol = "F_m",
       .unit = "N",
       .title = "Cubic mean load",
       .source = "iso3408_5, section 7.1.2"},
      [](const auto&... x) { return ball_screw::mean_load(x...); },
      list_of("forces", "F", "N", "axial load in each phase").any_sign(),
      list_of("angular_speeds", "ω", "rad/s", "angular speed in each phase").any_sign().as_long_as(0),
      list_of("durations", "t", "s", "duration of each phase, dwells included").as_long_as(0));

  define(
      list,
      {.name = "ball_screw.mean_load_linear",
       .handbook_id = "BS-MEAN-LOAD-LINEAR",
       .symbol = "F_m",
       .unit = "N",
       .title = "Mean load, varying linearly",
       .source = "thk_catalogue, average load",
       .validity = "smallest_force <= largest_force"},
      [](const auto&... x) { return ball_screw::mean_load_linear(x...); },
      quantity("smallest_force", "F_min", "N", "smallest load").rising(),
      quantity("largest_force", "F_max", "N", "largest load").rising())
      .valid_when("smallest_force <= largest_force",
                  [](double smallest_force, double largest_force) { return smallest_force <= largest_force; });

  define(
      list,
      {.name = "ball_screw.loaded_side_force",
       .handbook_id = "BS-PRELOAD-LOADED-SIDE",
       .symbol = "F_1",
       .unit = "N",
       .title = "Load of the loaded side of a preloaded nut",
       .source = "iso3408_5, section 7.1.3"},
      [](const auto&... x) { return ball_screw::loaded_side_force(x...); },
      quantity("force", "F", "N", "axial load").rising(),
      quantity("preload", "F_pr", "N", "preload").rising());

  define(
      list,
      {.name = "ball_screw.unloaded_side_force",
       .handbook_id = "BS-PRELOAD-UNLOADED-SIDE",
       .symbol = "F_2",
       .unit = "N",
       .title = "Load of the unloaded side of a preloaded nut",
       .source = "iso3408_5, section 7.1.3"},
      [](const auto&... x) { return ball_screw::unloaded_side_force(x...); },
      quantity("force", "F", "N", "axial load").falling(),
      quantity("preload", "F_pr", "N", "preload").rising());

  define(
      list,
      {.name = "ball_screw.required_preload",
       .handbook_id = "BS-PRELOAD-MIN",
       .symbol = "F_pr",
       .unit = "N",
       .title = "Preload that keeps the nut free of play",
       .source = "iso3408_5, section 7.1.3; thk_catalogue, preload"},
      [](const auto&... x) { return ball_screw::required_preload(x...); },
      quantity("largest_force", "F_max", "N", "largest load").rising());

  define(
      list,
      {.name = "ball_screw.life_revolutions",
       .handbook_id = "BS-LIFE-REV",
       .symbol = "L",
       .unit = "1",
       .title = "Nominal life in revolutions",
       .source = "iso3408_5, section 7.2; thk_catalogue, nominal life"},
      [](const auto&... x) { return ball_screw::life_revolutions(x...); },
      quantity("dynamic_load_rating", "C", "N", "basic dynamic axial load rating").typical(1000.0, 100000.0).rising(),
      quantity("mean_load", "F_m", "N", "mean load").falling(),
      quantity("load_factor", "f_w", "1", "load factor (shock)").typical(1, 3.5).falling());

  define(
      list,
      {.name = "ball_screw.combined_life",
       .handbook_id = "BS-LIFE-COMBINED",
       .symbol = "L_r",
       .unit = "1",
       .title = "Life of two raceway pairs",
       .source = "iso3408_5, section 7.2.3"},
      [](const auto&... x) { return ball_screw::combined_life(x...); },
      quantity("first_life", "L_1", "1", "life of the first raceway pair in revolutions")
          .typical(1000000.0, 10000000000.0)
          .rising(),
      quantity("second_life", "L_2", "1", "life of the second raceway pair in revolutions")
          .typical(1000000.0, 10000000000.0)
          .rising());

  define(
      list,
      {.name = "ball_screw.life_time",
       .handbook_id = "BS-LIFE-HOURS",
       .symbol = "L_h",
       .unit = "s",
       .display_unit = "h",
       .title = "Life in time",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::life_time(x...); },
      quantity("life_revolutions", "L", "1", "life in revolutions").typical(1000000.0, 10000000000.0).rising(),
      quantity("mean_speed", "ω_m", "rad/s", "mean speed over the cycle").falling());

  define(
      list,
      {.name = "ball_screw.life_distance",
       .handbook_id = "BS-LIFE-DISTANCE",
       .symbol = "L_s",
       .unit = "m",
       .title = "Life in travel",
       .source = "millwright_derivations"},
      [](const auto&... x) { return ball_screw::life_distance(x...); },
      quantity("life_revolutions", "L", "1", "life in revolutions").typical(1000000.0, 10000000000.0).rising(),
      quantity("lead", "l", "m", "lead").typical(0.001, 0.04).rising());

  define(
      list,
      {.name = "ball_screw.reliable_life",
       .handbook_id = "BS-LIFE-RELIABILITY",
       .symbol = "L_ar",
       .unit = "1",
       .title = "Life for another reliability",
       .source = "iso3408_5, section 7.2.4"},
      [](const auto&... x) { return ball_screw::reliable_life(x...); },
      quantity("life_revolutions", "L", "1", "life in revolutions").typical(1000000.0, 10000000000.0).rising(),
      quantity("reliability_factor", "f_ar", "1", "reliability factor").between(0, 1).typical(0.21, 1).rising());

  define(
      list,
      {.name = "ball_screw.required_dynamic_load_rating",
       .handbook_id = "BS-RATING-REQUIRED",
       .symbol = "C",
       .unit = "N",
       .title = "Dynamic load rating for a life",
       .source = "iso3408_5, section 7.2"},
      [](const auto&... x) { return ball_screw::required_dynamic_load_rating(x...); },
      quantity("mean_load", "F_m", "N", "mean load").rising(),
      quantity("load_factor", "f_w", "1", "load factor (shock)").typical(1, 3.5).rising(),
      quantity("life_revolutions", "L", "1", "life in revolutions").typical(1000000.0, 10000000000.0).rising(),
      quantity("reliability_factor", "f_ar", "1", "reliability factor").between(0, 1).typical(0.21, 1).falling());

  define(
      list,
      {.name = "ball_screw.modified_dynamic_load_rating",
       .handbook_id = "BS-RATING-MODIFIED",
       .symbol = "C_m",
       .unit = "N",
       .title = "Corrected dynamic load rating",
       .source = "iso3408_5, clause 6"},
      [](const auto&... x) { return ball_screw::modified_dynamic_load_rating(x...); },
      quantity("dynamic_load_rating", "C", "N", "basic dynamic axial load rating").typical(1000.0, 100000.0).rising(),
      quantity("hardness_factor", "f_h", "1", "hardness factor").between(0, 1).typical(0.3, 1).rising(),
      quantity("accuracy_factor", "f_ac", "1", "accuracy-grade factor").between(0, 1).typical(0.5, 1).rising(),
      quantity("melting_factor", "f_m", "1", "steel-melting factor").typical(1, 1.71).rising());

  define(
      list,
      {.name = "ball_screw.static_safety",
       .handbook_id = "BS-STATIC-SAFETY",
       .symbol = "f_s",
       .unit = "1",
       .title = "Static safety of a ball screw",
       .source = "thk_catalogue, static safety factor"},
      [](const auto&... x) { return ball_screw::static_safety(x...); },
      quantity("static_load_rating", "C_0", "N", "basic static axial load rating").typical(1000.0, 200000.0).rising(),
      quantity("largest_force", "F_max", "N", "largest load").falling());
}

}  // namespace millwright::mechanics
