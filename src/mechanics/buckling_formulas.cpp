// SPDX-License-Identifier: Apache-2.0
#include "mechanics/buckling.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_buckling(FormulaList& list) {
  define(
      list,
      {.name = "buckling.slenderness",
       .handbook_id = "SCREW-SLENDERNESS",
       .symbol = "L/k",
       .unit = "1",
       .title = "Slenderness of a screw",
       .source = "khurmi_gupta2005, chapter 16"},
      [](const auto&... x) { return buckling::slenderness(x...); },
      quantity("length", "L", "m", "unsupported length under compression").typical(0.1, 2).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).falling());

  define(
      list,
      {.name = "buckling.transition_slenderness",
       .handbook_id = "SCREW-SLENDERNESS-TRANSITION",
       .symbol = "(L/k)_1",
       .unit = "1",
       .title = "Slenderness between Johnson and Euler",
       .source = "shigley, section 4-13"},
      [](const auto&... x) { return buckling::transition_slenderness(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).falling());

  define(
      list,
      {.name = "buckling.euler_load",
       .handbook_id = "SCREW-BUCKLING-EULER",
       .symbol = "W_cr",
       .unit = "N",
       .title = "Critical load after Euler",
       .source = "khurmi_gupta2005, section 16.4; shigley, section 4-12",
       .validity = "slenderness above transition_slenderness"},
      [](const auto&... x) { return buckling::euler_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "unsupported length").typical(0.1, 2).falling());

  define(
      list,
      {.name = "buckling.johnson_load",
       .handbook_id = "SCREW-BUCKLING-JOHNSON",
       .symbol = "W_cr",
       .unit = "N",
       .title = "Critical load after Johnson",
       .source = "khurmi_gupta2005, section 16.10; shigley, section 4-13",
       .validity = "slenderness <= transition_slenderness"},
      [](const auto&... x) { return buckling::johnson_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "unsupported length").typical(0.1, 2).falling())
      .valid_when(
          "slenderness <= transition_slenderness",
          [](double end_fixity, double elastic_modulus, double yield_strength, double core_diameter, double length) {
            return buckling::slenderness(length, core_diameter) <=
                   buckling::transition_slenderness(end_fixity, elastic_modulus, yield_strength);
          });

  define(
      list,
      {.name = "buckling.critical_load",
       .handbook_id = "SCREW-BUCKLING-LOAD",
       .symbol = "W_cr",
       .unit = "N",
       .title = "Critical (buckling) load of a screw",
       .source = "shigley, sections 4-12 and 4-13"},
      [](const auto&... x) { return buckling::critical_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus of elasticity").typical(2000000000.0, 220000000000.0).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(100000000.0, 1000000000.0).rising(),
      quantity("core_diameter", "d_c", "m", "core (minor) diameter").typical(0.004, 0.05).rising(),
      quantity("length", "L", "m", "unsupported length").typical(0.1, 2).falling());
}

}  // namespace millwright::mechanics
