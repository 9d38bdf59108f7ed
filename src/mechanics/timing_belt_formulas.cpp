// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "mechanics/formula_definition.h"
#include "mechanics/timing_belt.h"

namespace millwright::mechanics {

void define_timing_belt(FormulaList& list) {
  define(
      list,
      {.name = "timing_belt.transmissible_power",
       .symbol = "P_0",
       .unit = "W",
       .title = "Power a belt transmits at its allowable tension",
       .source = "sularso_suga, chapter 5; fdm_printer, eq. 20",
       .validity = "centrifugal below allowable tension"},
      [](const auto&... x) { return timing_belt::transmissible_power(x...); },
      quantity("pitch_diameter", "d", "m", "pitch diameter of the pulley").rising(),
      quantity("angular_speed", "ω", "rad/s", "angular speed of the pulley").rising(),
      quantity("allowable_tension", "F_a", "N", "allowable tension").rising(),
      quantity("centrifugal_tension", "F_c", "N", "centrifugal tension").falling())
      .valid_when("centrifugal_tension <= allowable_tension",
                  [](double, double, double allowable_tension, double centrifugal_tension) {
                    return centrifugal_tension <= allowable_tension;
                  });

  define(
      list,
      {.name = "timing_belt.mass_per_length",
       .symbol = "m_b",
       .unit = "kg/m",
       .title = "Mass per length of a belt",
       .source = "fdm_printer, eq. 18"},
      [](const auto&... x) { return timing_belt::mass_per_length(x...); },
      quantity("mass", "m", "kg", "mass").rising(),
      quantity("length", "l", "m", "length").falling());

  define(
      list,
      {.name = "timing_belt.length_in_pitches",
       .symbol = "L_p",
       .unit = "1",
       .title = "Length of a belt in pitches",
       .source = "sularso_suga, chapter 5",
       .validity = "approximation for a centre distance well above the pulley diameters"},
      [](const auto&... x) { return timing_belt::length_in_pitches(x...); },
      count("driving_teeth", "z_1", "teeth of the driving pulley").typical(10, 60),
      count("driven_teeth", "z_2", "teeth of the driven pulley").typical(10, 60),
      quantity("centre_distance_in_pitches", "c", "1", "centre distance over belt pitch").typical(20, 200))
      .valid_when("driving_teeth + driven_teeth < 2·π·centre_distance_in_pitches",
                  [](double driving_teeth, double driven_teeth, double centre_distance_in_pitches) {
                    // Else the pulleys touch each other.
                    return driving_teeth + driven_teeth < 2.0 * std::numbers::pi * centre_distance_in_pitches;
                  });
}

}  // namespace millwright::mechanics
