// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/rack.h"

namespace millwright::mechanics {

void define_rack(FormulaList& list) {
  define(
      list,
      {.name = "rack.pitch_diameter",
       .handbook_id = "RACK-PITCH-DIAM",
       .symbol = "d",
       .unit = "m",
       .title = "Pitch diameter of a pinion",
       .source = "khurmi_gupta2005, chapter 28"},
      [](const auto&... x) { return rack::pitch_diameter(x...); },
      quantity("module", "m_n", "m", "module").typical(0.0005, 0.006).rising(),
      count("teeth", "z", "number of teeth of the pinion").typical(12, 80).rising());

  define(
      list,
      {.name = "rack.tangential_force",
       .handbook_id = "RACK-FORCE",
       .symbol = "F_t",
       .unit = "N",
       .title = "Tangential force of a pinion",
       .source = "khurmi_gupta2005, chapter 28"},
      [](const auto&... x) { return rack::tangential_force(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("pitch_diameter", "d", "m", "pitch diameter").typical(0.008, 0.1).falling());

  define(
      list,
      {.name = "rack.lewis_form_factor",
       .handbook_id = "RACK-LEWIS-FORM",
       .symbol = "Y",
       .unit = "1",
       .title = "Lewis form factor",
       .source = "khurmi_gupta2005, chapter 28"},
      [](const auto&... x) { return rack::lewis_form_factor(x...); },
      count("teeth", "z", "number of teeth").at_least(12).typical(12, 60).rising());

  define(
      list,
      {.name = "rack.lewis_stress",
       .handbook_id = "RACK-LEWIS-STRESS",
       .symbol = "σ",
       .unit = "Pa",
       .title = "Tooth bending stress after Lewis",
       .source = "khurmi_gupta2005, chapter 28"},
      [](const auto&... x) { return rack::lewis_stress(x...); },
      quantity("tangential_force", "F_t", "N", "tangential force").rising(),
      quantity("face_width", "b", "m", "face width").typical(0.005, 0.05).falling(),
      quantity("module", "m_n", "m", "module").typical(0.0005, 0.006).falling(),
      quantity("form_factor", "Y", "1", "form factor of Lewis").typical(0.2, 0.5).falling());

  define(
      list,
      {.name = "rack.velocity_factor",
       .symbol = "C_v",
       .unit = "1",
       .title = "Velocity factor of commercially cut teeth",
       .source = "khurmi_gupta2005, chapter 28"},
      [](const auto&... x) { return rack::velocity_factor(x...); },
      quantity("speed", "v", "m/s", "pitch line speed").between(0.0, 12.5).typical(0.01, 5).falling());
}

}  // namespace millwright::mechanics
