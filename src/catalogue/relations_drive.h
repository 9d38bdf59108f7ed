// SPDX-License-Identifier: Apache-2.0
// What usually holds for motors, screws, nuts and couplings. id, title, usual value, spread, impossible factor, origin,
// terms, kind. Figures in declared units. "published parts": the middle and the scatter of the shipped rows, rounded
// up.
#pragma once

#include "catalogue/relation.h"

namespace millwright::catalogue::detail {

// clang-format off
inline constexpr Relation stepper_relations[] = {
    {"time-constant", "electrical time constant L/R for the size (grows with the iron path)", 5.29e-4, 0.27, 15,
     "two-phase hybrids: 0.4 to 12 ms; magnetic diffusion grows with size", {{{"phase_inductance", 1}, {"phase_resistance", -1}, {"frame_size", -1.5}, {"body_length", -0.65}}}},
    {"copper-loss", "copper loss at rated current for the cooled surface", 0.01775, 0.26, 12,
     "80 K rise of the winding in still air: 5 to 15 W for a NEMA 17 or 23", {{{"rated_current", 2}, {"phase_resistance", 1}, {"frame_size", -1}, {"body_length", -0.5}}}},
    {"torque-constant", "magnetic energy L I^2 per holding torque", 19.85, 0.31, 10,
     "torque is the change of magnetic energy over a tooth pitch of 7.2 degrees", {{{"phase_inductance", 1}, {"rated_current", 2}, {"holding_torque", -1}}}},
    {"holding-torque", "holding torque for frame, length and step", 5.04e-7, 0.22, 5,
     "air-gap shear of saturated iron: 2.5 to 20 N.m a litre, larger for larger frames, a sixth less at half the step", {{{"holding_torque", 1}, {"frame_size", -2.21}, {"body_length", -1.4}, {"step_angle", -0.23, true}}}, "!NEMA11"},
    {"holding-torque", "holding torque for frame, length and step", 2.55e-7, 0.22, 5,
     "published parts: small rotors have thin teeth", {{{"holding_torque", 1}, {"frame_size", -2.21}, {"body_length", -1.4}, {"step_angle", -0.23, true}}}, "NEMA11"},
    {"torque-energy", "holding torque for magnetic energy L I^2, frame, length and step", 1.29e-5, 0.19, 5,
     "what the winding magnetises and what the iron carries; published parts", {{{"holding_torque", 1}, {"phase_inductance", -0.28}, {"rated_current", -0.56}, {"frame_size", -1.52}, {"body_length", -1.06}, {"step_angle", -0.32, true}}}, "!NEMA11"},
    {"torque-energy", "holding torque for magnetic energy L I^2, frame, length and step", 7e-6, 0.19, 5,
     "published parts: small rotors have thin teeth", {{{"holding_torque", 1}, {"phase_inductance", -0.28}, {"rated_current", -0.56}, {"frame_size", -1.52}, {"body_length", -1.06}, {"step_angle", -0.32, true}}}, "NEMA11"},
    {"torque-mass", "holding torque per mass, a little more for larger frames", 0.41, 0.21, 8,
     "published parts: 0.5 to 2.8 N.m/kg", {{{"holding_torque", 1}, {"mass", -1.11}, {"frame_size", -0.32}, {"step_angle", -0.28, true}}}, "!NEMA11"},
    {"torque-mass", "holding torque per mass, a little more for larger frames", 0.209, 0.21, 8,
     "published parts: small rotors have thin teeth", {{{"holding_torque", 1}, {"mass", -1.11}, {"frame_size", -0.32}, {"step_angle", -0.28, true}}}, "NEMA11"},
    {"motor-mass", "mass for frame and length", 5.91e-6, 0.12, 2.3,
     "bulk of steel, copper and air, end caps aside: 2.8 to 5.2 kg a litre", {{{"mass", 1}, {"frame_size", -1.6}, {"body_length", -1.3}}}},
    {"rotor-inertia", "rotor inertia for frame and length", 1.93e-7, 0.3, 5,
     "a steel cylinder of 0.40 to 0.61 of the frame, shorter than the body by its end caps", {{{"rotor_inertia", 1}, {"frame_size", -3.3}, {"body_length", -1.9}}}},
    {"inertia-torque", "rotor inertia per holding torque and frame", 3.35, 0.36, 8,
     "both grow with the length of the rotor", {{{"rotor_inertia", 1}, {"holding_torque", -1}, {"frame_size", -1}}}},
    {"inertia-mass", "rotor inertia for mass and frame", 7.37, 0.26, 6,
     "published parts", {{{"rotor_inertia", 1}, {"mass", -1.45}, {"frame_size", -1}}}},
    {"detent-torque", "detent torque per holding torque", 0.04, 0.5, 8,
     "usual 2 to 10 %", {{{"detent_torque", 1}, {"holding_torque", -1}}}},
    {"shaft-diameter", "shaft diameter per frame", 0.118, 0.16, 3.5,
     "NEMA ICS 16: 5 mm on 42 mm, 6.35 mm on 57 mm, 14 mm on 86 mm", {{{"shaft_diameter", 1}, {"frame_size", -1}}}},
    {"body-length", "body length per frame", 1.11, 0.4, 6,
     "one to four stacks of laminations", {{{"body_length", 1}, {"frame_size", -1}}}},
    {"frame-width", "width of the flange", 48, 0.45, 12, "NEMA 8 to 42: 20 to 110 mm", {{{"frame_size", 1}}}},
    {"maximum-voltage", "limit of the winding's voltage", 75, 0.6, 12, "insulation of small motors", {{{"maximum_voltage", 1}}}},
    {"price-outlier", "price for the mass", 36, 0.8, 60, "published parts; by maker where enough are known", {{{"price", 1}, {"mass", -0.6}}}},
};

inline constexpr Relation ball_screw_relations[] = {
    {"root-diameter", "root diameter / nominal diameter", 0.868, 0.06, 2, "d - 0.83 ball diameters; ISO 3408-1", {{{"root_diameter", 1}, {"nominal_diameter", -1}}}},
    {"root-diameter", "root diameter / pitch circle", 0.843, 0.06, 2, "pitch circle less a ball diameter; ISO 3408-1", {{{"root_diameter", 1}, {"pitch_circle_diameter", -1}}}},
    {"pitch-circle", "pitch circle / nominal diameter", 1.031, 0.03, 1.5, "ISO 3408-1: the balls run half sunk in the shaft", {{{"pitch_circle_diameter", 1}, {"nominal_diameter", -1}}}},
    {"outside-diameter", "outside diameter / nominal diameter", 1, 0.03, 1.5, "the nominal size is the rounded outside diameter", {{{"outside_diameter", 1}, {"nominal_diameter", -1}}}},
    {"lead", "lead a start / nominal diameter", 0.3125, 0.6, 12, "ISO 3408-2: leads of 0.1 to 2 diameters", {{{"lead", 1}, {"nominal_diameter", -1}, {"starts", -1}}}},
    {"ball-diameter", "ball diameter for lead a start and diameter", 0.4345, 0.18, 4, "balls fill 0.6 of a single start's lead", {{{"ball_diameter", 1}, {"nominal_diameter", -0.3}, {"lead", -0.63}, {"starts", 1.15}}}},
    {"load-ratings", "C0 / C for the diameter", 0.943, 0.2, 5, "ISO 3408-5: C0 grows with the square, C with the power 1.8 of the balls", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}, {"nominal_diameter", -0.3}}}},
    {"dynamic-rating", "C for the diameter", 86, 0.45, 12, "published parts", {{{"dynamic_load_rating", 1}, {"nominal_diameter", -1.6}}}},
    {"dynamic-rating", "C for balls and loaded turns", 310, 0.22, 6, "ISO 3408-5: C ~ ball diameter^1.8 turns^0.86 at equal ball count", {{{"dynamic_load_rating", 1}, {"ball_diameter", -1.3}, {"nominal_diameter", -0.4}, {"turns_per_circuit", -0.8}, {"circuits", -0.8}}}},
    {"static-rating", "C0 for the diameter", 55.4, 0.42, 12, "published parts", {{{"static_load_rating", 1}, {"nominal_diameter", -2}}}},
    {"static-rating", "C0 for balls, turns and diameter", 132.6, 0.24, 6, "ISO 3408-5: C0 ~ balls x ball diameter^2", {{{"static_load_rating", 1}, {"ball_diameter", -0.8}, {"nominal_diameter", -1.1}, {"turns_per_circuit", -0.9}, {"circuits", -0.9}}}},
    {"nut-stiffness", "nut stiffness for diameter and turns", 18.3, 0.25, 6, "Hertz contact of all loaded balls", {{{"nut_stiffness", 1}, {"nominal_diameter", -0.7}, {"turns_per_circuit", -0.6}, {"circuits", -0.6}}}},
    {"nut-size", "nut diameter / nominal diameter", 1.6, 0.14, 3, "DIN 69051", {{{"nut_outside_diameter", 1}, {"nominal_diameter", -1}}}},
    {"flange-size", "flange diameter / nut diameter", 1.6, 0.1, 2.2, "DIN 69051", {{{"flange_outside_diameter", 1}, {"nut_outside_diameter", -1}}}},
    {"flange-thickness", "flange thickness for the nut diameter", 1.7, 0.18, 4, "DIN 69051", {{{"flange_thickness", 1}, {"nut_outside_diameter", -0.5}}}},
    {"nut-length", "nut length for lead a start and nut diameter", 6.06, 0.28, 6, "published parts", {{{"nut_length", 1}, {"lead", -0.5}, {"nut_outside_diameter", -0.35}, {"starts", 0.7}}}},
    {"screw-mass", "mass per length / section of the shaft", 0.0062, 0.06, 1.7, "steel, 7850 kg/m3, between root and outside", {{{"screw_mass_per_length", 1}, {"outside_diameter", -1}, {"root_diameter", -1}}}},
    {"nut-mass", "nut mass for body, flange and bore", 3.74e-6, 0.13, 3, "hollow steel body with flange", {{{"nut_mass", 1}, {"nut_outside_diameter", -1.85}, {"nut_length", -0.79}, {"flange_outside_diameter", -0.94}, {"nominal_diameter", 0.69}}}},
    {"nut-mass", "nut mass / its envelope", 5.24e-6, 0.2, 3, "hollow steel body with flange", {{{"nut_mass", 1}, {"nut_outside_diameter", -2}, {"nut_length", -1}}}},
    {"maximum-length", "longest shaft / diameter", 150, 0.45, 10, "rolled 75 to 200 diameters, ground 35 and more", {{{"maximum_length", 1}, {"nominal_diameter", -1}}}},
    {"dn-limit", "limit of diameter x speed", 7e4, 0.4, 5, "50 000 to 160 000 mm.rpm for return tubes to end caps", {{{"dn_limit", 1}}}},
    {"lead-error", "lead error over 300 mm", 45, 0.6, 12, "ISO 3408-3 grades: 8 (C3), 23 (T5), 52 (T7), 210 (T10) um", {{{"lead_error_per_300mm", 1}}}},
    {"price-outlier", "price of the nut for the diameter", 3.5, 1.2, 100, "published parts; by maker where enough are known", {{{"price", 1}, {"nominal_diameter", -1}}}},
    {"price-outlier", "price of the shaft for its mass", 115, 1.1, 100, "published parts; by maker where enough are known", {{{"price_per_length", 1}, {"screw_mass_per_length", -0.5}}}},
    {"price-outlier", "price of the nut / price of a metre of shaft", 0.47, 0.33, 12, "published parts", {{{"price", 1}, {"price_per_length", -1}}}},
};

inline constexpr Relation lead_screw_relations[] = {
    {"pitch", "pitch for the diameter", 0.663, 0.28, 4, "ISO 2904 series: 2 on 8 to 10, 4 on 16, 8 on 48", {{{"pitch", 1}, {"major_diameter", -0.6}}}, "trapezoidal*"},
    {"pitch", "pitch for the diameter", 0.574, 0.3, 4, "published parts", {{{"pitch", 1}, {"major_diameter", -0.6}}}, "square*"},
    {"pitch", "pitch for the diameter", 0.379, 0.2, 3, "ISO 261 coarse series", {{{"pitch", 1}, {"major_diameter", -0.6}}}, "metric*"},
    {"starts", "number of starts", 1.3, 0.7, 10, "1 to 4 usual", {{{"starts", 1}}}},
    {"thread-diameters", "pitch diameter / major diameter", 0.9, 0.04, 1.3, "ISO 2904: d2 = d - P/2", {{{"pitch_diameter", 1}, {"major_diameter", -1}}}},
    {"thread-diameters", "core / major diameter", 0.78, 0.09, 1.8, "ISO 2904: d3 = d - P - 2 ac", {{{"minor_diameter", 1}, {"major_diameter", -1}}}},
    {"nut-thread", "nut's major diameter / screw's", 1.028, 0.03, 1.4, "ISO 2904: D4 = d + 2 ac", {{{"nut_major_diameter", 1}, {"major_diameter", -1}}}},
    {"nut-thread", "nut's minor diameter / screw's core", 1.037, 0.03, 1.4, "ISO 2904: D1 = d - P", {{{"nut_minor_diameter", 1}, {"minor_diameter", -1}}}},
    {"thread-height", "thread height / pitch", 0.58, 0.09, 2, "0.5 P + ac; 0.6134 P metric", {{{"thread_height", 1}, {"pitch", -1}}}},
    {"lead-angle", "lead angle of lead and pitch diameter", 18.2, 0.04, 1.5, "atan(lead / pi d2), nearly linear", {{{"lead_angle", 1}, {"lead", -1}, {"pitch_diameter", 1}}}},
    {"screw-mass", "mass per length / pitch diameter squared", 0.006165, 0.05, 1.7, "steel rod, 7850 kg/m3", {{{"screw_mass_per_length", 1}, {"pitch_diameter", -2}}}},
    {"yield-strength", "yield strength", 430, 0.2, 4, "rolled C45 and stainless", {{{"yield_strength", 1}}}},
    {"lead-error", "lead error over 300 mm", 110, 0.5, 12, "rolled threads: 50 to 300 um", {{{"lead_error_per_300mm", 1}}}},
    {"maximum-length", "longest piece", 2500, 0.5, 12, "bars of 1 to 6 m", {{{"maximum_length", 1}}}},
    {"price-outlier", "price a metre for the mass", 16, 0.65, 40, "published parts", {{{"price_per_length", 1}, {"screw_mass_per_length", -0.5}}}},
};

inline constexpr Relation lead_nut_relations[] = {
    {"nut-length", "length / thread diameter", 2, 0.26, 4, "1.5 to 2.5 diameters (DIN 103 practice)", {{{"length", 1}, {"nominal_diameter", -1}}}},
    {"nut-size", "body / thread diameter", 1.7, 0.2, 3, "published parts", {{{"outside_diameter", 1}, {"nominal_diameter", -1}}}},
    {"flange-size", "flange / body diameter", 1.75, 0.14, 2.5, "published parts", {{{"flange_outside_diameter", 1}, {"outside_diameter", -1}}}},
    {"lead", "lead / thread diameter", 0.25, 0.6, 12, "single and multiple threads", {{{"lead", 1}, {"nominal_diameter", -1}}}},
    {"nut-mass", "mass / envelope", 3.02e-6, 0.25, 5, "hollow bronze body, 8800 kg/m3", {{{"mass", 1}, {"length", -1}, {"outside_diameter", -1}, {"flange_outside_diameter", -1}}}, "bronze*"},
    {"nut-mass", "mass / envelope", 4.9e-6, 0.35, 5, "hollow brass body, 8400 kg/m3", {{{"mass", 1}, {"length", -1}, {"outside_diameter", -1}, {"flange_outside_diameter", -1}}}, "brass*"},
    {"nut-mass", "mass / envelope", 7e-7, 0.25, 5, "hollow polymer body, 1400 kg/m3", {{{"mass", 1}, {"length", -1}, {"outside_diameter", -1}, {"flange_outside_diameter", -1}}}, "iglidur*"},
    {"nut-mass", "mass / length and diameter squared", 2.6e-6, 0.7, 10, "1 to 9 kg a litre", {{{"mass", 1}, {"length", -1}, {"outside_diameter", -2}}}},
    {"nut-pressure", "allowable pressure", 7, 0.45, 6, "POM and polymers 5, bronze 10 MPa on moving threads", {{{"allowable_pressure", 1}}}},
    {"pv-limit", "PV limit / (pressure limit x speed limit)", 0.13, 0.6, 10, "heat allows about a tenth of both limits at once", {{{"maximum_pv", 1}, {"allowable_pressure", -1}, {"maximum_sliding_speed", -1}}}},
    {"sliding-speed", "limit of the sliding speed", 0.45, 0.5, 8, "0.3 bronze to 0.8 m/s polymers", {{{"maximum_sliding_speed", 1}}}},
    {"friction", "dry friction", 0.18, 0.22, 4, "0.12 to 0.25 of bearing materials on steel", {{{"friction_dry", 1}}}},
    {"friction", "greased / dry friction", 0.68, 0.12, 3, "published parts", {{{"friction_greased", 1}, {"friction_dry", -1}}}},
    {"backlash", "axial play", 0.08, 0.6, 15, "0.03 to 0.2 mm", {{{"backlash", 1}}}},
    {"drag-torque", "drag of a preloaded nut for the thread", 0.00137, 0.5, 12, "published parts", {{{"preload_drag_torque", 1}, {"nominal_diameter", -1}}}},
    {"price-outlier", "price for the thread diameter", 0.7, 1.0, 80, "published parts; by material where enough are known", {{{"price", 1}, {"nominal_diameter", -1}}}},
    {"price-outlier", "price for the mass", 40, 1.0, 80, "published parts; by material where enough are known", {{{"price", 1}, {"mass", -0.5}}}},
};

inline constexpr Relation coupling_relations[] = {
    {"coupling-length", "length / diameter", 1.29, 0.18, 3.5, "published parts", {{{"length", 1}, {"outside_diameter", -1}}}},
    {"bore-size", "largest bore / diameter", 0.48, 0.2, 2, "wall for the clamp screw", {{{"maximum_bore", 1}, {"outside_diameter", -1}}}},
    {"bore-range", "smallest / largest bore", 0.5, 0.4, 8, "published parts", {{{"minimum_bore", 1}, {"maximum_bore", -1}}}},
    {"rated-torque", "rated torque / diameter cubed", 1.84e-4, 0.75, 20, "shear of section", {{{"rated_torque", 1}, {"outside_diameter", -3}}}},
    {"rated-torque", "rated torque / diameter cubed", 4.6e-4, 0.36, 8, "pressure on an elastomer spider", {{{"rated_torque", 1}, {"outside_diameter", -3}}}, "jaw*"},
    {"rated-torque", "rated torque / diameter cubed", 1.54e-4, 0.3, 8, "thin bellows", {{{"rated_torque", 1}, {"outside_diameter", -3}}}, "bellows*"},
    {"maximum-torque", "maximum / rated torque", 2, 0.25, 4, "twice the rated torque is usual", {{{"maximum_torque", 1}, {"rated_torque", -1}}}},
    {"stiffness", "torsional stiffness / rated torque", 87, 1.7, 300, "published parts", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}},
    {"stiffness", "torsional stiffness / rated torque", 20, 0.5, 15, "elastomer twisted 3 degrees at rated torque", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "jaw*"},
    {"stiffness", "torsional stiffness / rated torque", 500, 0.8, 20, "metal bellows", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "bellows*"},
    {"stiffness", "torsional stiffness / rated torque", 110, 0.5, 15, "slit aluminium", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "beam*"},
    {"stiffness", "torsional stiffness / diameter cubed", 0.0083, 0.5, 15, "published parts", {{{"torsional_stiffness", 1}, {"outside_diameter", -3}}}, "jaw*"},
    {"stiffness", "torsional stiffness / rated torque", 1000, 0.7, 20, "a tube of aluminium", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "rigid*"},
    {"stiffness", "torsional stiffness / rated torque", 65, 0.6, 20, "sliding disc of acetal", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "Oldham*"},
    {"stiffness", "torsional stiffness / rated torque", 750, 0.6, 20, "spring discs in tension", {{{"torsional_stiffness", 1}, {"rated_torque", -1}}}, "double disc*"},
    {"inertia", "inertia / (mass x diameter squared)", 1.39, 0.14, 1.8, "ring: between m d^2/8 and m d^2/4", {{{"inertia", 1}, {"mass", -1}, {"outside_diameter", -2}}}},
    {"coupling-mass", "mass / envelope", 1.42e-6, 0.22, 5, "aluminium with bore and slots; steel up to 2.8 times", {{{"mass", 1}, {"length", -1}, {"outside_diameter", -2}}}},
    {"maximum-speed", "diameter x speed", 3.8e5, 0.55, 8, "rim speed of 5 to 35 m/s", {{{"maximum_speed", 1}, {"outside_diameter", 1}}}},
    {"misalignment", "angular misalignment", 1, 0.4, 8, "0.9 to 3 degrees", {{{"angular_misalignment", 1}}}},
    {"misalignment", "parallel misalignment", 0.15, 0.8, 20, "0.04 to 1 mm", {{{"parallel_misalignment", 1}}}},
    {"misalignment", "axial misalignment", 0.115, 0.6, 15, "published parts", {{{"axial_misalignment", 1}, {"outside_diameter", -0.5}}}},
    {"price-outlier", "price for the mass", 60, 1.0, 80, "published parts; by maker where enough are known", {{{"price", 1}, {"mass", -0.5}}}},
};
// clang-format on

static_assert(sound(Family::steppers, stepper_relations));
static_assert(sound(Family::ball_screws, ball_screw_relations));
static_assert(sound(Family::lead_screws, lead_screw_relations));
static_assert(sound(Family::lead_nuts, lead_nut_relations));
static_assert(sound(Family::couplings, coupling_relations));

}  // namespace millwright::catalogue::detail
