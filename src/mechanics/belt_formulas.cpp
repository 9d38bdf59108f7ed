// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "mechanics/belt.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_belt(FormulaList& list) {
  define(
      list,
      {.name = "belt.pitch_diameter",
       .handbook_id = "BELT-PITCH-DIAM",
       .symbol = "d",
       .unit = "m",
       .title = "Pitch diameter of a pulley",
       .source = "sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::pitch_diameter(x...); },
      count("teeth", "z", "number of teeth").typical(12, 80).rising(),
      quantity("pitch", "p", "m", "pitch").typical(0.0015, 0.008).rising());

  define(
      list,
      {.name = "belt.effective_tension_of_power",
       .handbook_id = "BELT-EFFECTIVE-TENSION",
       .symbol = "F_e",
       .unit = "N",
       .title = "Effective tension from power",
       .source = "sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::effective_tension_of_power(x...); },
      quantity("power", "P", "W", "transmitted power").rising(),
      quantity("speed", "v", "m/s", "speed").typical(0.01, 2).falling());

  define(
      list,
      {.name = "belt.effective_tension_of_torque",
       .handbook_id = "BELT-EFFECTIVE-TENSION-TORQUE",
       .symbol = "F_e",
       .unit = "N",
       .title = "Effective tension from torque",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::effective_tension_of_torque(x...); },
      quantity("torque", "T", "N.m", "torque").rising(),
      quantity("pitch_diameter", "d", "m", "pitch diameter").typical(0.008, 0.1).falling());

  define(
      list,
      {.name = "belt.centrifugal_tension",
       .handbook_id = "BELT-CENTRIFUGAL",
       .symbol = "F_c",
       .unit = "N",
       .title = "Centrifugal tension",
       .source = "sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::centrifugal_tension(x...); },
      quantity("mass_per_length", "m_b", "kg/m", "mass of the belt per length").typical(0.003, 0.2).rising(),
      quantity("speed", "v", "m/s", "speed").typical(0.01, 2).rising());

  define(
      list,
      {.name = "belt.tight_side_tension",
       .handbook_id = "BELT-TIGHT-TENSION",
       .symbol = "F_1",
       .unit = "N",
       .title = "Tension of the tight side",
       .source = "sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::tight_side_tension(x...); },
      quantity("effective_tension", "F_e", "N", "effective tension").rising(),
      quantity("centrifugal_tension", "F_c", "N", "centrifugal tension").rising());

  define(
      list,
      {.name = "belt.required_pretension",
       .handbook_id = "BELT-PRETENSION",
       .symbol = "F_0",
       .unit = "N",
       .title = "Pretension that keeps the belt taut",
       .source = "iso5295"},
      [](const auto&... x) { return belt::required_pretension(x...); },
      quantity("effective_tension", "F_e", "N", "effective tension").rising(),
      quantity("smallest_slack_tension", "F_2min", "N", "smallest tension that the slack side keeps").rising(),
      quantity("centrifugal_tension", "F_c", "N", "centrifugal tension").rising());

  define(
      list,
      {.name = "belt.largest_span_tension",
       .handbook_id = "BELT-SPAN-MAX-TENSION",
       .symbol = "F_1",
       .unit = "N",
       .title = "Largest tension in a span",
       .source = "iso5295"},
      [](const auto&... x) { return belt::largest_span_tension(x...); },
      quantity("pretension", "F_0", "N", "tension of each span at rest").rising(),
      quantity("effective_tension", "F_e", "N", "effective tension").rising());

  define(
      list,
      {.name = "belt.carriage_span_tension",
       .symbol = "F_1",
       .unit = "N",
       .title = "Largest tension in a span between drive pulley and carriage",
       .source = "millwright_derivations, unequal spans of a belt"},
      [](const auto&... x) { return belt::carriage_span_tension(x...); },
      quantity("pretension", "F_0", "N", "tension of each span at rest").rising(),
      quantity("effective_tension", "F_e", "N", "effective tension").rising());

  define(
      list,
      {.name = "belt.shaft_load",
       .handbook_id = "BELT-SHAFT-LOAD",
       .symbol = "F_R",
       .unit = "N",
       .title = "Radial load on the shaft",
       .source = "autodesk_synchronous_belts"},
      [](const auto&... x) { return belt::shaft_load(x...); },
      quantity("pretension", "F_0", "N", "tension of each span at rest").rising(),
      quantity("wrap_angle", "φ", "rad", "wrap angle").between(0, std::numbers::pi).typical(1, 3.1).rising());

  define(
      list,
      {.name = "belt.pulling_shaft_load",
       .symbol = "F_R",
       .unit = "N",
       .title = "Radial load on the shaft of a pulley that pulls a carriage close to it",
       .source = "millwright_derivations, unequal spans of a belt"},
      [](const auto&... x) { return belt::pulling_shaft_load(x...); },
      quantity("pretension", "F_0", "N", "tension of each span at rest").rising(),
      quantity("effective_tension", "F_e", "N", "effective tension").rising(),
      quantity("wrap_angle", "φ", "rad", "wrap angle").between(0, std::numbers::pi).typical(1, 3.1).rising());

  define(
      list,
      {.name = "belt.wrap_angle",
       .handbook_id = "BELT-WRAP-ANGLE",
       .symbol = "φ",
       .unit = "rad",
       .title = "Wrap angle on the smaller pulley",
       .source = "autodesk_synchronous_belts; sularso_suga, chapter 5",
       .validity = "small_diameter <= large_diameter < small_diameter + 2 * centre_distance"},
      [](const auto&... x) { return belt::wrap_angle(x...); },
      quantity("large_diameter", "D", "m", "pitch diameter of the larger pulley").typical(0.012, 0.1).falling(),
      quantity("small_diameter", "d", "m", "pitch diameter of the smaller pulley").typical(0.008, 0.08).rising(),
      quantity("centre_distance", "a", "m", "distance of the centres").typical(0.05, 2).rising())
      .valid_when("small_diameter <= large_diameter < small_diameter + 2 * centre_distance",
                  [](double large_diameter, double small_diameter, double centre_distance) {
                    return small_diameter <= large_diameter && large_diameter - small_diameter < 2.0 * centre_distance;
                  });

  define(
      list,
      {.name = "belt.length",
       .handbook_id = "BELT-LENGTH",
       .symbol = "L",
       .unit = "m",
       .title = "Length of a belt",
       .source = "autodesk_synchronous_belts",
       .validity = "small_diameter <= large_diameter < small_diameter + 2 * centre_distance"},
      [](const auto&... x) { return belt::length(x...); },
      quantity("large_diameter", "D", "m", "pitch diameter of the larger pulley").typical(0.012, 0.1).rising(),
      quantity("small_diameter", "d", "m", "pitch diameter of the smaller pulley").typical(0.008, 0.08).rising(),
      quantity("centre_distance", "a", "m", "distance of the centres").typical(0.05, 2).rising())
      .valid_when("small_diameter <= large_diameter < small_diameter + 2 * centre_distance",
                  [](double large_diameter, double small_diameter, double centre_distance) {
                    return small_diameter <= large_diameter && large_diameter - small_diameter < 2.0 * centre_distance;
                  });

  define(
      list,
      {.name = "belt.teeth_in_mesh",
       .handbook_id = "BELT-TEETH-IN-MESH",
       .symbol = "z_m",
       .unit = "1",
       .title = "Teeth in mesh",
       .source = "sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::teeth_in_mesh(x...); },
      count("teeth", "z", "number of teeth").typical(12, 80).rising(),
      quantity("wrap_angle", "φ", "rad", "wrap angle").between(0, std::numbers::pi).typical(1, 3.1).rising());

  define(
      list,
      {.name = "belt.tooth_factor",
       .handbook_id = "BELT-TOOTH-FACTOR",
       .symbol = "k_z",
       .unit = "1",
       .title = "Tooth factor",
       .source = "iso5295; autodesk_synchronous_belts; sularso_suga, chapter 5"},
      [](const auto&... x) { return belt::tooth_factor(x...); },
      quantity("teeth_in_mesh", "z_m", "1", "teeth in mesh").typical(1, 20).rising());

  define(
      list,
      {.name = "belt.design_power",
       .handbook_id = "BELT-DESIGN-POWER",
       .symbol = "P_d",
       .unit = "W",
       .title = "Design power",
       .source = "sularso_suga, chapter 5; fdm_printer"},
      [](const auto&... x) { return belt::design_power(x...); },
      quantity("service_factor", "f_c", "1", "service factor").typical(1, 2.5).rising(),
      quantity("power", "P", "W", "transmitted power").rising());

  define(
      list,
      {.name = "belt.power_capacity",
       .handbook_id = "BELT-POWER-CAPACITY",
       .symbol = "P_0",
       .unit = "W",
       .title = "Power capacity of a belt",
       .source = "autodesk_synchronous_belts; iso5295"},
      [](const auto&... x) { return belt::power_capacity(x...); },
      quantity("tooth_factor", "k_z", "1", "tooth factor").between(0, 1).typical(0.2, 1).rising(),
      quantity("allowable_tension", "F_a", "N", "allowable tension of the belt at its width")
          .typical(20, 1000.0)
          .rising(),
      quantity("mass_per_length", "m_b", "kg/m", "mass of the belt per length").typical(0.003, 0.2).falling(),
      quantity("speed", "v", "m/s", "speed").typical(0.01, 2));

  define(
      list,
      {.name = "belt.required_width",
       .handbook_id = "BELT-WIDTH-REQUIRED",
       .symbol = "b",
       .unit = "m",
       .title = "Required belt width",
       .source = "iso5295"},
      [](const auto&... x) { return belt::required_width(x...); },
      quantity("design_tension", "F_d", "N", "tension to design for").rising(),
      quantity("tooth_factor", "k_z", "1", "tooth factor").between(0, 1).typical(0.2, 1).falling(),
      quantity("allowable_tension_per_width", "f_a", "N/m", "allowable tension per width")
          .typical(4000.0, 50000.0)
          .falling());

  define(
      list,
      {.name = "belt.stiffness",
       .handbook_id = "BELT-STIFFNESS",
       .symbol = "k",
       .unit = "N/m",
       .title = "Stiffness of a belt at the carriage",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::stiffness(x...); },
      quantity("specific_stiffness", "c_sp", "N", "force per strain of the belt at its width")
          .typical(10000.0, 1000000.0)
          .rising(),
      quantity("first_span_length", "L_1", "m", "length of one span").typical(0.05, 2).falling(),
      quantity("second_span_length", "L_2", "m", "length of the other span").typical(0.05, 2).falling());

  define(
      list,
      {.name = "belt.least_stiffness",
       .handbook_id = "BELT-STIFFNESS-MIN",
       .symbol = "k_min",
       .unit = "N/m",
       .title = "Least stiffness of a belt axis",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::least_stiffness(x...); },
      quantity("specific_stiffness", "c_sp", "N", "force per strain of the belt at its width")
          .typical(10000.0, 1000000.0)
          .rising(),
      quantity("total_span_length", "L_tot", "m", "length of both spans").typical(0.2, 4).falling());

  define(
      list,
      {.name = "belt.position_error",
       .handbook_id = "BELT-POSITION-ERROR",
       .symbol = "δ",
       .unit = "m",
       .title = "Position error of a belt axis",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::position_error(x...); },
      quantity("force", "F", "N", "force on the carriage").rising(),
      quantity("stiffness", "k", "N/m", "stiffness").typical(10000.0, 1000000000.0).falling());

  define(
      list,
      {.name = "belt.span_frequency",
       .handbook_id = "BELT-SPAN-FREQUENCY",
       .symbol = "f",
       .unit = "Hz",
       .title = "Frequency of a plucked span",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::span_frequency(x...); },
      quantity("span_tension", "F_0", "N", "tension of the span").rising(),
      quantity("span_length", "L_s", "m", "free length of the span").typical(0.05, 1).falling(),
      quantity("mass_per_length", "m_b", "kg/m", "mass of the belt per length").typical(0.003, 0.2).falling());

  define(
      list,
      {.name = "belt.axis_resonant_frequency",
       .handbook_id = "BELT-AXIS-RESONANCE",
       .symbol = "f",
       .unit = "Hz",
       .title = "Resonance of a belt axis",
       .source = "millwright_derivations"},
      [](const auto&... x) { return belt::axis_resonant_frequency(x...); },
      quantity("stiffness", "k", "N/m", "stiffness").typical(10000.0, 1000000000.0).rising(),
      quantity("mass", "m", "kg", "mass of the carriage").falling());
}

}  // namespace millwright::mechanics
