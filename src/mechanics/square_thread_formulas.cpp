// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/square_thread.h"

namespace millwright::mechanics {

void define_square_thread(FormulaList& list) {
  define(
      list,
      {.name = "square_thread.lead_tangent",
       .symbol = "tan α",
       .unit = "1",
       .title = "Tangent of the lead angle",
       .source = "khurmi_gupta2005, section 17.4"},
      [](const auto&... x) { return square_thread::lead_tangent(x...); },
      quantity("lead", "l", "m", "lead").rising(),
      quantity("mean_diameter", "d", "m", "mean diameter").falling());

  define(
      list,
      {.name = "square_thread.tangent_of_sum",
       .symbol = "tan(α+φ)",
       .unit = "1",
       .title = "Tangent of the sum of lead angle and friction angle",
       .source = "khurmi_gupta2005, section 17.4",
       .validity = "lead_tangent * friction < 1"},
      [](const auto&... x) { return square_thread::tangent_of_sum(x...); },
      quantity("lead_tangent", "t_a", "1", "tangent of the lead angle").between(0, 1).typical(0.01, 0.3).rising(),
      quantity("friction", "μ", "1", "coefficient of friction, the tangent of the friction angle")
          .between(0, 1)
          .typical(0.002, 0.4)
          .rising())
      .valid_when("lead_tangent·friction < 1",
                  [](double lead_tangent, double friction) { return lead_tangent * friction < 1.0; });

  define(
      list,
      {.name = "square_thread.torque",
       .symbol = "T",
       .unit = "N.m",
       .title = "Torque that the axial force causes on a diameter",
       .source = "khurmi_gupta2005, section 17.4"},
      [](const auto&... x) { return square_thread::torque(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("diameter", "d", "m", "diameter at which the thread bears").rising(),
      quantity("tangent", "t", "1", "tangent of the angle").typical(0.01, 0.6).rising());

  define(
      list,
      {.name = "square_thread.tangential_force",
       .symbol = "P",
       .unit = "N",
       .title = "Force at the circumference that a torque exerts",
       .source = "khurmi_gupta2005, section 17.4"},
      [](const auto&... x) { return square_thread::tangential_force(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("diameter", "d", "m", "diameter").falling());

  define(
      list,
      {.name = "square_thread.required_core_diameter_squared",
       .symbol = "d_c²",
       .unit = "m^2",
       .title = "Square of the core diameter that carries an axial force",
       .source = "torch_table, eq. 15; khurmi_gupta2005, section 17.10"},
      [](const auto&... x) { return square_thread::required_core_diameter_squared(x...); },
      quantity("force", "W", "N", "axial load").rising(),
      quantity("safety_factor", "SF", "1", "safety factor").at_least(1).typical(1, 8).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(5e7, 9e8).falling());
}

}  // namespace millwright::mechanics
