// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/vibration.h"

namespace millwright::mechanics {

void define_vibration(FormulaList& list) {
  define(
      list,
      {.name = "vibration.natural_frequency",
       .handbook_id = "FREQ-SDOF",
       .symbol = "f",
       .unit = "Hz",
       .title = "Natural frequency of a mass on a spring",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::natural_frequency(x...); },
      quantity("stiffness", "k", "N/m", "stiffness").rising(),
      quantity("mass", "m", "kg", "mass").falling());

  define(
      list,
      {.name = "vibration.natural_frequency_of_static_deflection",
       .handbook_id = "FREQ-STATIC-DEFLECTION",
       .symbol = "f",
       .unit = "Hz",
       .title = "Natural frequency from the static deflection under one g in the direction of vibration",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::natural_frequency_of_static_deflection(x...); },
      quantity("static_deflection", "δ", "m", "static deflection under the own weight of the mass")
          .typical(1e-6, 1e-2)
          .falling());

  define(
      list,
      {.name = "vibration.cantilever_natural_frequency",
       .handbook_id = "FREQ-CANT-TIP-MASS",
       .symbol = "f",
       .unit = "Hz",
       .title = "First natural frequency of a cantilever with a mass at its tip",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::cantilever_natural_frequency(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "length").falling(),
      quantity("tip_mass", "m", "kg", "tip mass").falling(),
      quantity("beam_mass", "m_b", "kg", "beam mass").falling());

  define(
      list,
      {.name = "vibration.supported_natural_frequency",
       .handbook_id = "FREQ-SS-MID-MASS",
       .symbol = "f",
       .unit = "Hz",
       .title = "First natural frequency of a simply supported beam with a mass in the middle",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::supported_natural_frequency(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "span").falling(),
      quantity("midspan_mass", "m", "kg", "mass at midspan").falling(),
      quantity("beam_mass", "m_b", "kg", "beam mass").falling());

  define(
      list,
      {.name = "vibration.fixed_natural_frequency",
       .symbol = "f",
       .unit = "Hz",
       .title = "First natural frequency of a beam clamped at both ends with a mass in the middle",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::fixed_natural_frequency(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "span").falling(),
      quantity("midspan_mass", "m", "kg", "mass at midspan").falling(),
      quantity("beam_mass", "m_b", "kg", "beam mass").falling());

  define(
      list,
      {.name = "vibration.uniform_beam_natural_frequency",
       .handbook_id = "FREQ-BEAM-UNIFORM",
       .symbol = "f",
       .unit = "Hz",
       .title = "First natural frequency of a uniform beam",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::uniform_beam_natural_frequency(x...); },
      quantity("eigenvalue", "λ_e", "1", "end-condition eigenvalue").typical(1.8, 4.8).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("mass_per_length", "m_l", "kg/m", "mass per length").falling(),
      quantity("length", "L", "m", "length").falling());

  define(
      list,
      {.name = "vibration.dunkerley_frequency",
       .handbook_id = "FREQ-DUNKERLEY",
       .symbol = "f",
       .unit = "Hz",
       .title = "Lower bound of the first natural frequency from those of partial systems",
       .source = "blevins",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::dunkerley_frequency(x...); },
      list_of("partial_frequencies", "f", "Hz", "partial frequencies"));

  define(
      list,
      {.name = "vibration.required_natural_frequency",
       .handbook_id = "FREQ-REQUIRED",
       .symbol = "f",
       .unit = "Hz",
       .title = "Natural frequency above which a step of acceleration leaves at most the permitted ringing",
       .source = "machine_frame_lab",
       .validity = "undamped, small amplitude"},
      [](const auto&... x) { return vibration::required_natural_frequency(x...); },
      quantity("acceleration", "a", "m/s^2", "acceleration step").rising(),
      quantity("ringing_amplitude", "δ", "m", "permitted ringing amplitude").typical(1e-7, 1e-3).falling());
}

}  // namespace millwright::mechanics
