// SPDX-License-Identifier: Apache-2.0
#include "mechanics/accuracy.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_accuracy(FormulaList& list) {
  define(
      list,
      {.name = "accuracy.linear_resolution",
       .handbook_id = "RES-LINEAR",
       .symbol = "Δx",
       .unit = "m",
       .title = "Travel per microstep",
       .source = "sander",
       .validity = "rigid drive"},
      [](const auto&... x) { return accuracy::linear_resolution(x...); },
      quantity("lead", "l", "m", "travel per output revolution (lead or pi*d)").rising(),
      count("full_steps", "S", "full steps per revolution").typical(100, 400).falling(),
      count("microsteps", "μ_s", "microsteps per full step").typical(1, 64).falling(),
      quantity("ratio", "i", "1", "reduction ratio").typical(1, 10).falling());

  define(
      list,
      {.name = "accuracy.load_lag",
       .handbook_id = "ACC-LOAD-LAG",
       .symbol = "δ",
       .unit = "m",
       .title = "Position error of a stepper axis under load",
       .source = "millwright_derivations, definition",
       .validity = "load torque at most the static torque"},
      [](const auto&... x) { return accuracy::load_lag(x...); },
      quantity("load_torque", "T_L", "N.m", "motor load torque").rising(),
      quantity("static_torque", "T_s", "N.m", "static torque amplitude").falling(),
      count("rotor_teeth", "N_r", "rotor teeth").typical(25, 100).falling(),
      quantity("lead", "l", "m", "travel per motor revolution").rising())
      .valid_when("load_torque <= static_torque", [](double load_torque, double static_torque, double, double) {
        return load_torque <= static_torque;
      });

  define(
      list,
      {.name = "accuracy.abbe_error",
       .handbook_id = "ACC-ABBE",
       .symbol = "e",
       .unit = "m",
       .title = "Error from an angular error under an offset between scale and tool",
       .source = "slocum1992, chapter 2",
       .validity = "small angles"},
      [](const auto&... x) { return accuracy::abbe_error(x...); },
      quantity("angular_error", "θ", "rad", "angular error").typical(1e-6, 1e-2).rising(),
      quantity("offset", "h", "m", "Abbe offset").rising());

  define(
      list,
      {.name = "accuracy.worst_case_error",
       .handbook_id = "ACC-BUDGET-WORST",
       .symbol = "e",
       .unit = "m",
       .title = "Sum of the error magnitudes",
       .source = "slocum1992, chapter 2",
       .validity = "small errors"},
      [](const auto&... x) { return accuracy::worst_case_error(x...); },
      list_of("errors", "e", "m", "error magnitudes").any_sign().typical(-5e-5, 5e-5));

  define(
      list,
      {.name = "accuracy.root_sum_square_error",
       .handbook_id = "ACC-BUDGET-RSS",
       .symbol = "e",
       .unit = "m",
       .title = "Root of the sum of squares of independent random errors",
       .source = "slocum1992, chapter 2",
       .validity = "small independent errors of similar size"},
      [](const auto&... x) { return accuracy::root_sum_square_error(x...); },
      list_of("errors", "e", "m", "error magnitudes").any_sign().typical(-5e-5, 5e-5));

  define(
      list,
      {.name = "accuracy.mixed_error",
       .handbook_id = "ACC-BUDGET-MIXED",
       .symbol = "e",
       .unit = "m",
       .title = "Systematic errors added, random ones by root of sum of squares",
       .source = "slocum1992, chapter 2",
       .validity = "small errors"},
      [](const auto&... x) { return accuracy::mixed_error(x...); },
      list_of("systematic_errors", "e_sys", "m", "systematic errors").any_sign().typical(-5e-5, 5e-5),
      list_of("random_errors", "e_rnd", "m", "independent random errors").any_sign().typical(-5e-5, 5e-5));
}

}  // namespace millwright::mechanics
