// SPDX-License-Identifier: Apache-2.0
// What usually holds for belts, pulleys, racks, pinions, electronics and torque curves; as in relations_drive.h.
#pragma once

#include "catalogue/relation.h"

namespace millwright::catalogue::detail {

// clang-format off
inline constexpr Relation curve_relations[] = {
    {"curve-torque", "pull-out torque", 1.3, 0.85, 60, "NEMA 11 to 42: 0.02 to 30 N.m", {{{"torque", 1}}}},
    {"curve-current", "set current", 4, 0.55, 12, "0.3 to 10 A", {{{"phase_current", 1}}}},
    {"curve-voltage", "supply voltage", 40, 0.5, 12, "12 to 100 V", {{{"drive_voltage", 1}}}},
};

inline constexpr Relation belt_relations[] = {
    {"belt-width", "width / pitch", 3, 0.5, 10, "ISO 13050 and ISO 5296 widths", {{{"width", 1}, {"pitch", -1}}}},
    {"belt-tension", "allowable tension / (width x pitch)", 3.74, 0.65, 15, "glass fibre 2 to 4, steel cord up to 12 N/mm2", {{{"allowable_tension", 1}, {"width", -1}, {"pitch", -1}}}},
    {"breaking-tension", "breaking / allowable tension", 6, 0.3, 5, "makers allow a fourth to an eighth", {{{"breaking_tension", 1}, {"allowable_tension", -1}}}},
    {"belt-strain", "EA / allowable tension", 320, 0.5, 12, "strain of 0.1 to 0.5 % at the allowable tension", {{{"tensile_stiffness", 1}, {"allowable_tension", -1}}}},
    {"belt-stiffness", "EA / (width x pitch)", 1270, 0.6, 15, "glass fibre or steel cord, filling the same share", {{{"tensile_stiffness", 1}, {"width", -1}, {"pitch", -1}}}},
    {"belt-mass", "mass / (width x pitch)", 6.8e-4, 0.33, 5, "1100 kg/m3, about half a pitch thick", {{{"mass_per_length", 1}, {"width", -1}, {"pitch", -1}}}},
    {"pitch-line", "pitch line offset for the pitch", 0.22, 0.33, 5, "ISO 13050: 0.254 GT2, 0.381 HTD3M, 0.571 HTD5M mm", {{{"pitch_line_offset", 1}, {"pitch", -0.5}}}},
    {"fewest-teeth", "fewest teeth of a pulley", 12, 0.3, 4, "ISO 13050: 10 to 22", {{{"minimum_pulley_teeth", 1}}}},
    {"maximum-speed", "belt speed", 40, 0.35, 6, "20 to 80 m/s", {{{"maximum_speed", 1}}}},
    {"price-outlier", "price a metre for the mass", 57, 0.45, 30, "published parts", {{{"price_per_length", 1}, {"mass_per_length", -0.7}}}},
};

inline constexpr Relation pulley_relations[] = {
    {"belt-width", "belt width / pitch", 3, 0.4, 8, "ISO 13050 and ISO 5296 widths", {{{"belt_width", 1}, {"pitch", -1}}}},
    {"teeth", "number of teeth", 24, 0.5, 10, "10 to 72", {{{"teeth", 1}}}},
    {"bore-size", "bore / pitch diameter", 0.314, 0.5, 5, "published parts", {{{"bore", 1}, {"pitch_diameter", -1}}}},
    {"pitch-diameter", "pitch diameter / (teeth x pitch)", 0.3183, 0.02, 1.3, "1 / pi", {{{"pitch_diameter", 1}, {"teeth", -1}, {"pitch", -1}}}},
    {"outside-diameter", "outside / pitch diameter", 0.968, 0.03, 1.4, "less twice the pitch line offset", {{{"outside_diameter", 1}, {"pitch_diameter", -1}}}},
    {"flange-diameter", "flange / outside diameter", 1.21, 0.11, 2, "published parts", {{{"flange_diameter", 1}, {"outside_diameter", -1}}}},
    {"overall-width", "overall / belt width", 2.08, 0.26, 4, "hub for two set screws", {{{"overall_width", 1}, {"belt_width", -1}}}},
    {"pulley-mass", "mass / cylinder", 2e-6, 0.25, 6, "aluminium 2.1e-6 kg/mm3 x pi/4; steel 2.9 times", {{{"mass", 1}, {"outside_diameter", -2}, {"overall_width", -1}}}},
    {"inertia", "inertia / (mass x diameter squared)", 1.37, 0.13, 2.5, "m d^2/8 of a cylinder", {{{"inertia", 1}, {"mass", -1}, {"outside_diameter", -2}}}},
    {"price-outlier", "price for the mass", 13, 0.4, 30, "published parts", {{{"price", 1}, {"mass", -0.3}}}},
};

inline constexpr Relation rack_relations[] = {
    {"module", "module", 1.6, 0.5, 8, "DIN 780: 1 to 4 for drives", {{{"module", 1}}}},
    {"tooth-pitch", "pitch / module", 3.1416, 0.01, 1.2, "pi", {{{"pitch", 1}, {"module", -1}}}},
    {"face-width", "face width / module", 10.5, 0.25, 5, "8 to 15 modules", {{{"face_width", 1}, {"module", -1}}}},
    {"rack-height", "height / module", 10.5, 0.25, 5, "square bars", {{{"height", 1}, {"module", -1}}}},
    {"pitch-line", "height of the pitch line / height", 0.9, 0.05, 1.5, "a module below the tips", {{{"pitch_height", 1}, {"height", -1}}}},
    {"rack-mass", "mass per length / (width x height)", 0.00702, 0.05, 1.8, "steel bar less its gaps", {{{"mass_per_length", 1}, {"face_width", -1}, {"height", -1}}}},
    {"piece-length", "length of a piece", 900, 0.55, 6, "500, 1000, 2000 mm", {{{"piece_length", 1}}}},
    {"pitch-error", "pitch error over 1 m", 120, 0.7, 12, "DIN 3962: 30 (Q6) to 200 um (Q10)", {{{"pitch_error_per_1000mm", 1}}}},
    {"tooth-stress", "allowable stress of a tooth", 190, 0.35, 6, "a third of the strength of C45; hardened up to 450 MPa", {{{"allowable_stress", 1}}}},
    {"price-outlier", "price a metre for the mass", 22, 0.65, 40, "published parts", {{{"price_per_length", 1}, {"mass_per_length", -0.5}}}},
};

inline constexpr Relation pinion_relations[] = {
    {"module", "module", 1.6, 0.5, 8, "DIN 780: 1 to 4 for drives", {{{"module", 1}}}},
    {"teeth", "number of teeth", 22, 0.4, 8, "15 to 40", {{{"teeth", 1}}}},
    {"face-width", "face width / module", 11, 0.25, 5, "8 to 15 modules", {{{"face_width", 1}, {"module", -1}}}},
    {"bore-size", "bore / pitch diameter", 0.317, 0.45, 3, "published parts", {{{"bore", 1}, {"pitch_diameter", -1}}}},
    {"pitch-diameter", "pitch diameter / (module x teeth)", 1, 0.01, 1.2, "DIN 867", {{{"pitch_diameter", 1}, {"module", -1}, {"teeth", -1}}}},
    {"outside-diameter", "outside / pitch diameter", 1.09, 0.03, 1.3, "two modules more", {{{"outside_diameter", 1}, {"pitch_diameter", -1}}}},
    {"overall-width", "overall / face width", 1.6, 0.25, 3, "hub", {{{"overall_width", 1}, {"face_width", -1}}}},
    {"pinion-mass", "mass / cylinder", 5.07e-6, 0.2, 4, "steel less bore and hub", {{{"mass", 1}, {"pitch_diameter", -2}, {"overall_width", -1}}}},
    {"inertia", "inertia / (mass x diameter squared)", 1.29, 0.11, 2, "m d^2/8 of a ring, 1.25 and more", {{{"inertia", 1}, {"mass", -1}, {"pitch_diameter", -2}}}},
    {"tooth-stress", "allowable stress of a tooth", 190, 0.35, 6, "a third of the strength of C45; hardened up to 450 MPa", {{{"allowable_stress", 1}}}},
    {"price-outlier", "price for the mass", 23, 0.3, 30, "published parts", {{{"price", 1}, {"mass", -0.3}}}},
};

inline constexpr Relation driver_relations[] = {
    {"voltage-range", "highest / lowest voltage", 4, 0.5, 8, "published parts", {{{"maximum_voltage", 1}, {"minimum_voltage", -1}}}},
    {"maximum-voltage", "highest voltage", 48, 0.5, 8, "24 to 110 V", {{{"maximum_voltage", 1}}}},
    {"working-voltage", "working / highest voltage", 0.875, 0.14, 2.5, "margin for what the motor feeds back", {{{"recommended_maximum_voltage", 1}, {"maximum_voltage", -1}}}},
    {"rms-current", "peak / RMS current", 1.41, 0.13, 4, "sqrt(2) for a sine", {{{"peak_current", 1}, {"rms_current", -1}}}},
    {"driver-current", "peak current", 4.5, 0.6, 12, "1.5 to 10 A", {{{"peak_current", 1}}}},
    {"driver-current", "peak current", 6, 0.45, 8, "2 to 10 A", {{{"peak_current", 1}}}, "box"},
    {"driver-current", "peak current", 2.2, 0.35, 6, "1.5 to 5 A", {{{"peak_current", 1}}}, "step stick"},
    {"overvoltage-trip", "trip / highest voltage", 1.2, 0.12, 3, "published parts", {{{"overvoltage_trip", 1}, {"maximum_voltage", -1}}}},
    {"microsteps", "finest microstepping", 100, 1.0, 100, "16 to 256", {{{"maximum_microsteps", 1}}}},
    {"driver-mass", "mass / (voltage x current)", 1e-3, 0.4, 10, "heat sink and case", {{{"mass", 1}, {"maximum_voltage", -1}, {"peak_current", -1}}}, "box"},
    {"driver-mass", "mass / (voltage x current)", 2.6e-5, 0.4, 15, "bare board", {{{"mass", 1}, {"maximum_voltage", -1}, {"peak_current", -1}}}, "step stick"},
    {"driver-mass", "mass / (voltage x current)", 3e-4, 1.5, 100, "board to case", {{{"mass", 1}, {"maximum_voltage", -1}, {"peak_current", -1}}}},
    {"price-outlier", "price for voltage and current", 1.6, 0.9, 60, "published parts", {{{"price", 1}, {"maximum_voltage", -0.5}, {"peak_current", -0.5}}}},
    {"price-outlier", "price for voltage and current", 2.1, 0.6, 40, "published parts", {{{"price", 1}, {"maximum_voltage", -0.5}, {"peak_current", -0.5}}}, "box"},
    {"price-outlier", "price for voltage and current", 0.67, 0.5, 40, "published parts", {{{"price", 1}, {"maximum_voltage", -0.5}, {"peak_current", -0.5}}}, "step stick"},
};

inline constexpr Relation supply_relations[] = {
    {"output-voltage", "output voltage", 36, 0.55, 8, "12 to 80 V", {{{"output_voltage", 1}}}},
    {"supply-power", "power / (voltage x current)", 1, 0.02, 1.5, "what volt and ampere are", {{{"power", 1}, {"output_voltage", -1}, {"output_current", -1}}}},
    {"supply-size", "power / volume", 3.1e-4, 0.3, 5, "200 to 500 W a litre", {{{"power", 1}, {"length", -1}, {"width", -1}, {"height", -1}}}},
    {"supply-mass", "mass / volume", 9.4e-7, 0.17, 3, "0.7 to 1.3 kg a litre", {{{"mass", 1}, {"length", -1}, {"width", -1}, {"height", -1}}}},
    {"supply-mass", "mass for the power", 0.0144, 0.22, 4, "published parts", {{{"mass", 1}, {"power", -0.7}}}},
    {"supply-size", "length / width", 1.81, 0.26, 4, "published parts", {{{"length", 1}, {"width", -1}}}},
    {"supply-size", "length / height", 5.3, 0.4, 6, "published parts", {{{"length", 1}, {"height", -1}}}},
    {"adjustment", "highest / nominal voltage", 1.1, 0.05, 1.6, "trimmed by a tenth", {{{"adjustment_maximum", 1}, {"output_voltage", -1}}}},
    {"adjustment", "lowest / nominal voltage", 0.9, 0.05, 1.6, "trimmed by a tenth", {{{"adjustment_minimum", 1}, {"output_voltage", -1}}}},
    {"peak-current", "peak / rated current", 1.6, 0.35, 4, "published parts", {{{"peak_current", 1}, {"output_current", -1}}}},
    {"efficiency", "efficiency", 89, 0.04, 1.6, "83 to 96 %", {{{"efficiency", 1}}}},
    {"price-outlier", "price for the power", 0.7, 0.4, 30, "published parts", {{{"price", 1}, {"power", -0.7}}}},
};
// clang-format on

static_assert(sound(Family::stepper_curves, curve_relations));
static_assert(sound(Family::belts, belt_relations));
static_assert(sound(Family::pulleys, pulley_relations));
static_assert(sound(Family::racks, rack_relations));
static_assert(sound(Family::pinions, pinion_relations));
static_assert(sound(Family::drivers, driver_relations));
static_assert(sound(Family::power_supplies, supply_relations));

}  // namespace millwright::catalogue::detail
