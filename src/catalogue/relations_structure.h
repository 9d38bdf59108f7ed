// SPDX-License-Identifier: Apache-2.0
// What usually holds for guides, bearings, sections, threads, fasteners and materials; as in relations_drive.h.
#pragma once

#include "catalogue/relation.h"

namespace millwright::catalogue::detail {

// clang-format off
inline constexpr Relation thread_relations[] = {
    {"pitch", "pitch for the diameter", 0.287, 0.13, 2, "ISO 261 coarse series", {{{"pitch", 1}, {"nominal_diameter", -0.7}}}, "coarse"},
    {"pitch", "pitch for the diameter", 0.216, 0.16, 2.5, "ISO 261 fine series", {{{"pitch", 1}, {"nominal_diameter", -0.7}}}, "fine"},
    {"thread-diameters", "pitch / nominal diameter", 0.91, 0.03, 1.2, "ISO 724: d2 = d - 0.6495 P", {{{"pitch_diameter", 1}, {"nominal_diameter", -1}}}},
    {"thread-diameters", "core diameter / pitch diameter", 0.91, 0.03, 1.2, "ISO 724", {{{"minor_diameter_external", 1}, {"pitch_diameter", -1}}}},
    {"thread-diameters", "nut's minor / nominal diameter", 0.865, 0.05, 1.4, "ISO 724: D1 = d - 1.0825 P", {{{"minor_diameter_internal", 1}, {"nominal_diameter", -1}}}},
    {"stress-area", "stress area / diameter squared", 0.6, 0.08, 1.5, "ISO 898-1", {{{"tensile_stress_area", 1}, {"nominal_diameter", -2}}}},
    {"stress-area", "core area / stress area", 0.92, 0.04, 1.4, "ISO 898-1", {{{"minor_area", 1}, {"tensile_stress_area", -1}}}},
    {"tap-drill", "tap drill / diameter", 0.875, 0.05, 1.3, "d - P", {{{"tap_drill_diameter", 1}, {"nominal_diameter", -1}}}},
    {"clearance-hole", "clearance hole / diameter", 1.104, 0.04, 1.4, "ISO 273 medium", {{{"clearance_hole_diameter", 1}, {"nominal_diameter", -1}}}},
    {"socket-head", "hexagon key / diameter", 0.8, 0.07, 1.6, "ISO 4762", {{{"hex_key_size", 1}, {"nominal_diameter", -1}}}},
    {"socket-head", "head diameter / diameter", 1.53, 0.08, 1.7, "ISO 4762", {{{"head_diameter", 1}, {"nominal_diameter", -1}}}},
    {"socket-head", "head height / diameter", 1, 0.03, 1.5, "ISO 4762", {{{"head_height", 1}, {"nominal_diameter", -1}}}},
};

inline constexpr Relation fastener_relations[] = {
    {"pitch", "pitch for the diameter", 0.28, 0.16, 2.5, "ISO 261", {{{"pitch", 1}, {"nominal_diameter", -0.7}}}},
    {"stress-area", "stress area / diameter squared", 0.58, 0.08, 1.5, "ISO 898-1", {{{"tensile_stress_area", 1}, {"nominal_diameter", -2}}}},
    {"property-class", "tensile strength", 420, 0.03, 1.5, "ISO 898-1", {{{"tensile_strength", 1}}}, "4.8"},
    {"property-class", "tensile strength", 810, 0.03, 1.5, "ISO 898-1", {{{"tensile_strength", 1}}}, "8.8"},
    {"property-class", "tensile strength", 1040, 0.03, 1.5, "ISO 898-1", {{{"tensile_strength", 1}}}, "10.9"},
    {"property-class", "tensile strength", 1220, 0.03, 1.5, "ISO 898-1", {{{"tensile_strength", 1}}}, "12.9"},
    {"property-class", "tensile strength", 700, 0.03, 1.5, "ISO 3506-1", {{{"tensile_strength", 1}}}, "A2-70"},
    {"property-class", "tensile strength", 800, 0.45, 4, "ISO 898-1 and ISO 3506-1", {{{"tensile_strength", 1}}}},
    {"property-class", "yield / tensile strength", 0.82, 0.12, 2, "the second figure of the class", {{{"yield_strength", 1}, {"tensile_strength", -1}}}},
    {"strength-order", "proof / yield strength", 0.92, 0.06, 1.6, "ISO 898-1", {{{"proof_strength", 1}, {"yield_strength", -1}}}},
    {"proof-load", "proof load / (proof strength x area)", 1, 0.01, 1.2, "ISO 898-1", {{{"proof_load", 1}, {"proof_strength", -1}, {"tensile_stress_area", -1}}}},
    {"ultimate-load", "ultimate load / (tensile strength x area)", 1, 0.01, 1.2, "ISO 898-1", {{{"ultimate_load", 1}, {"tensile_strength", -1}, {"tensile_stress_area", -1}}}},
    {"preload", "preload / proof load", 0.75, 0.05, 1.34, "VDI 2230 practice: 70 to 90 %", {{{"maximum_preload", 1}, {"proof_load", -1}}}},
    {"tightening-torque", "torque / (preload x diameter)", 1.91e-4, 0.12, 3, "nut factor 0.15 to 0.25", {{{"tightening_torque", 1}, {"maximum_preload", -1}, {"nominal_diameter", -1}}}},
    {"price-outlier", "price for the area", 0.0129, 0.45, 40, "published parts", {{{"price", 1}, {"tensile_stress_area", -0.7}}}},
};

inline constexpr Relation bearing_relations[] = {
    {"journal", "bore / screw diameter", 0.75, 0.08, 2, "step on which the inner ring rests", {{{"bore", 1}, {"screw_diameter", -1}}}, "fixed"},
    {"journal", "bore / screw diameter", 0.75, 0.14, 2, "step on which the inner ring rests", {{{"bore", 1}, {"screw_diameter", -1}}}, "supported"},
    {"journal", "bore / screw diameter", 0.9, 0.15, 2.5, "step or plain end", {{{"bore", 1}, {"screw_diameter", -1}}}},
    {"bearing-rating", "C / bore^1.5", 174, 0.18, 5, "angular contact pairs", {{{"dynamic_load_rating", 1}, {"bore", -1.5}}}, "fixed"},
    {"bearing-rating", "C / bore^1.5", 140, 0.22, 5, "deep groove ball bearings", {{{"dynamic_load_rating", 1}, {"bore", -1.5}}}, "supported"},
    {"bearing-rating", "C / bore^1.5", 140, 0.25, 5, "deep groove ball bearings", {{{"dynamic_load_rating", 1}, {"bore", -1.5}}}, "radial bearing"},
    {"bearing-rating", "C / bore^1.5", 150, 0.35, 6, "ball bearings", {{{"dynamic_load_rating", 1}, {"bore", -1.5}}}},
    {"load-ratings", "C0 / C", 0.47, 0.22, 4, "deep groove ball bearings", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}}}, "supported"},
    {"load-ratings", "C0 / C", 0.43, 0.22, 4, "deep groove ball bearings", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}}}, "radial bearing"},
    {"load-ratings", "C0 / C", 1.57, 0.25, 4, "thrust ball bearings", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}}}, "thrust bearing"},
    {"load-ratings", "C0 / C", 0.55, 0.6, 8, "ball bearings", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}}}},
    {"axial-load", "permissible axial load / C", 0.53, 0.25, 6, "published parts", {{{"permissible_axial_load", 1}, {"dynamic_load_rating", -1}}}},
    {"axial-stiffness", "axial stiffness for the bore", 15.5, 0.3, 6, "Hertz contact of an angular contact pair", {{{"axial_stiffness", 1}, {"bore", -0.7}}}},
    {"maximum-speed", "bore x speed", 5e4, 0.5, 8, "greased and sealed pair", {{{"maximum_speed", 1}, {"bore", 1}}}, "fixed"},
    {"maximum-speed", "bore x speed", 1e5, 0.3, 8, "greased deep groove bearing", {{{"maximum_speed", 1}, {"bore", 1}}}, "supported"},
    {"maximum-speed", "bore x speed", 3e5, 0.3, 8, "deep groove bearing, shielded", {{{"maximum_speed", 1}, {"bore", 1}}}, "radial bearing"},
    {"maximum-speed", "bore x speed", 8e4, 0.9, 40, "20 000 (pillow blocks) to 400 000 mm.rpm", {{{"maximum_speed", 1}, {"bore", 1}}}},
    {"center-height", "height of the axis / bore", 2, 0.32, 5, "published parts", {{{"center_height", 1}, {"bore", -1}}}},
    {"bearing-mass", "mass / bore squared", 0.00306, 0.4, 8, "steel housing", {{{"mass", 1}, {"bore", -2}}}, "fixed"},
    {"bearing-mass", "mass / bore squared", 0.002, 0.55, 8, "steel housing", {{{"mass", 1}, {"bore", -2}}}, "supported"},
    {"bearing-mass", "mass / bore squared", 1.9e-4, 0.28, 6, "bare bearing", {{{"mass", 1}, {"bore", -2}}}, "radial bearing"},
    {"bearing-mass", "mass / bore squared", 6e-4, 1.1, 50, "bare bearing to housing", {{{"mass", 1}, {"bore", -2}}}},
    {"price-outlier", "price for the mass", 17, 0.5, 40, "published parts", {{{"price", 1}, {"mass", -0.5}}}},
};

inline constexpr Relation guide_relations[] = {
    {"load-ratings", "C0 / C", 1.45, 0.13, 3, "ISO 14728-1 and -2", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}}}},
    {"load-ratings", "C0 / C for the relative length", 0.753, 0.14, 3, "C grows with fewer powers of the balls under load than C0; ISO 14728", {{{"static_load_rating", 1}, {"dynamic_load_rating", -1}, {"block_length", -0.5}, {"size", 0.5}}}, "profile rail*"},
    {"guide-rating", "C / size squared", 48.7, 0.16, 5, "published profile rails", {{{"dynamic_load_rating", 1}, {"size", -2}}}, "profile rail"},
    {"guide-rating", "C0 / (size x length)", 18.4, 0.15, 5, "balls under load fill the carriage", {{{"static_load_rating", 1}, {"size", -1}, {"block_length", -1}}}, "profile rail"},
    {"guide-rating", "C / size squared", 25.2, 0.17, 5, "published miniature rails", {{{"dynamic_load_rating", 1}, {"size", -2}}}, "profile rail miniature"},
    {"guide-rating", "C0 / (size x length)", 9.4, 0.14, 5, "balls under load fill the carriage", {{{"static_load_rating", 1}, {"size", -1}, {"block_length", -1}}}, "profile rail miniature"},
    {"guide-rating", "C / size squared", 3, 0.4, 6, "published ball bushes", {{{"dynamic_load_rating", 1}, {"size", -2}}}, "linear ball*"},
    {"guide-rating", "C0 / (size x length)", 1.7, 0.26, 6, "published ball bushes", {{{"static_load_rating", 1}, {"size", -1}, {"block_length", -1}}}, "linear ball*"},
    {"guide-rating", "C0 / (size x length)", 1.4, 0.26, 6, "published ball bushes", {{{"static_load_rating", 1}, {"size", -1}, {"block_length", -1}}}, "supported*"},
    {"rating-distance", "distance that C is stated for", 62, 0.4, 3, "50 or 100 km", {{{"rating_distance", 1}}}, {}, true},
    {"block-length", "carriage length / size", 3.6, 0.17, 3, "published rails", {{{"block_length", 1}, {"size", -1}}}, "profile rail*"},
    {"block-length", "carriage length / size", 2.5, 0.18, 3, "ISO 10285", {{{"block_length", 1}, {"size", -1}}}, "linear ball*"},
    {"block-length", "carriage length / size", 2.6, 0.18, 3, "published parts", {{{"block_length", 1}, {"size", -1}}}, "supported*"},
    {"block-width", "carriage width / size", 2.27, 0.2, 2.5, "ISO 12090", {{{"block_width", 1}, {"size", -1}}}, "profile rail*"},
    {"block-width", "carriage width / size", 1.75, 0.12, 2, "ISO 10285", {{{"block_width", 1}, {"size", -1}}}, "linear ball bush"},
    {"block-width", "carriage width / size", 3.1, 0.2, 2.5, "published parts", {{{"block_width", 1}, {"size", -1}}}, "linear ball bush block"},
    {"block-width", "carriage width / size", 2.4, 0.2, 2.5, "published parts", {{{"block_width", 1}, {"size", -1}}}, "supported*"},
    {"assembly-height", "height / size", 1.5, 0.12, 2, "ISO 12090", {{{"assembly_height", 1}, {"size", -1}}}, "profile rail"},
    {"assembly-height", "height / size", 1.08, 0.06, 1.8, "ISO 12090 miniature", {{{"assembly_height", 1}, {"size", -1}}}, "profile rail miniature"},
    {"assembly-height", "height / size", 2.2, 0.17, 2.5, "published parts", {{{"assembly_height", 1}, {"size", -1}}}, "linear ball*"},
    {"assembly-height", "height / size", 1.95, 0.17, 2.5, "published parts", {{{"assembly_height", 1}, {"size", -1}}}, "supported*"},
    {"rail-width", "rail width / size", 1, 0.05, 1.6, "the size is the rail width or the shaft", {{{"rail_width", 1}, {"size", -1}}}},
    {"rail-height", "rail height / size", 0.88, 0.08, 2, "ISO 12090", {{{"rail_height", 1}, {"size", -1}}}, "profile rail"},
    {"rail-height", "rail height / size", 0.667, 0.08, 2, "ISO 12090 miniature", {{{"rail_height", 1}, {"size", -1}}}, "profile rail miniature"},
    {"rail-height", "rail height / size", 1, 0.05, 1.6, "a round shaft", {{{"rail_height", 1}, {"size", -1}}}, "linear ball*"},
    {"moment-rating", "roll moment / (C0 x rail width)", 4.8e-4, 0.12, 4, "two rows of balls about half a rail width from the axis", {{{"roll_moment_rating", 1}, {"static_load_rating", -1}, {"rail_width", -1}}}},
    {"moment-rating", "pitch moment / (C0 x length)", 1.05e-4, 0.16, 4, "rows of balls of 0.6 of the carriage length", {{{"pitch_moment_rating", 1}, {"static_load_rating", -1}, {"block_length", -1}}}},
    {"moment-rating", "yaw / pitch moment", 0.97, 0.2, 3, "equal for equal contact angles", {{{"yaw_moment_rating", 1}, {"pitch_moment_rating", -1}}}},
    {"guide-stiffness", "stiffness for size and length", 5, 0.35, 6, "Hertz contact of the loaded balls", {{{"radial_stiffness", 1}, {"size", -0.5}, {"block_length", -0.5}}}},
    {"carriage-mass", "mass / envelope", 3.08e-6, 0.13, 2.3, "steel block less rail and balls", {{{"carriage_mass", 1}, {"block_length", -1}, {"block_width", -1}, {"assembly_height", -1}}}, "profile rail*"},
    {"carriage-mass", "mass / envelope", 2.3e-6, 0.09, 2.5, "aluminium block with a steel bush", {{{"carriage_mass", 1}, {"block_length", -1}, {"block_width", -1}, {"assembly_height", -1}}}, "linear ball bush block"},
    {"carriage-mass", "mass / (length x size squared)", 7.3e-6, 0.4, 5, "steel bush", {{{"carriage_mass", 1}, {"block_length", -1}, {"size", -2}}}, "linear ball bush"},
    {"carriage-mass", "mass / (length x size squared)", 1.1e-5, 0.3, 5, "published parts", {{{"carriage_mass", 1}, {"block_length", -1}, {"size", -2}}}},
    {"rail-mass", "mass / (width x height)", 0.0065, 0.06, 1.6, "steel less grooves and holes", {{{"rail_mass_per_length", 1}, {"rail_width", -1}, {"rail_height", -1}}}, "profile rail*"},
    {"rail-mass", "mass / (width x height)", 0.006166, 0.04, 1.6, "steel shaft", {{{"rail_mass_per_length", 1}, {"rail_width", -1}, {"rail_height", -1}}}, "linear ball*"},
    {"rail-mass", "mass / (width x height)", 0.0065, 0.12, 2.5, "shaft on an aluminium rail", {{{"rail_mass_per_length", 1}, {"rail_width", -1}, {"rail_height", -1}}}, "supported*"},
    {"friction", "coefficient of friction", 0.0037, 0.25, 6, "rolling: 0.002 to 0.005", {{{"friction_coefficient", 1}}}},
    {"maximum-length", "longest rail for the size", 500, 0.35, 6, "published parts", {{{"maximum_rail_length", 1}, {"size", -0.6}}}},
    {"price-outlier", "price for the mass", 70, 1.1, 80, "published parts; by maker where enough are known", {{{"price", 1}, {"carriage_mass", -0.5}}}},
    {"price-outlier", "price a metre for the mass", 70, 1.1, 80, "published parts; by maker where enough are known", {{{"price_per_length", 1}, {"rail_mass_per_length", -0.5}}}},
    {"price-outlier", "price of a carriage / price of a metre of rail", 0.4, 0.7, 30, "published parts", {{{"price", 1}, {"price_per_length", -1}}}},
};

inline constexpr Relation extrusion_relations[] = {
    {"area", "area / (width x height)", 0.353, 0.23, 2.8, "hollow slotted profiles", {{{"area", 1}, {"width", -1}, {"height", -1}}}},
    {"section-mass", "mass per length / area", 0.0027, 0.04, 1.3, "aluminium, 2700 kg/m3", {{{"mass_per_length", 1}, {"area", -1}}}},
    {"second-moment", "second moment x / (area x height squared)", 0.096, 0.1, 2.6, "between a filled rectangle, 1/12, and flanges, 1/4", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}},
    {"second-moment", "second moment y / (area x width squared)", 0.1, 0.1, 2.5, "between a filled rectangle, 1/12, and flanges, 1/4", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}},
    {"section-modulus", "section modulus x height / second moment", 2, 0.03, 1.5, "W = I / (h/2)", {{{"section_modulus_x", 1}, {"second_moment_x", -1}, {"height", 1}}}},
    {"section-modulus", "section modulus y width / second moment", 2, 0.03, 1.5, "W = I / (b/2)", {{{"section_modulus_y", 1}, {"second_moment_y", -1}, {"width", 1}}}},
    {"slot", "slot for the width", 1.34, 0.18, 3, "5, 6, 8, 10 mm", {{{"slot", 1}, {"width", -0.5}}}},
    {"profile-size", "width", 38, 0.4, 8, "series 20, 30, 40, 45, 50, 80", {{{"width", 1}}}},
    {"profile-size", "height / width", 1.4, 0.45, 6, "one to four modules", {{{"height", 1}, {"width", -1}}}},
    {"alloy", "elastic modulus", 69000, 0.02, 1.3, "aluminium", {{{"elastic_modulus", 1}}}},
    {"alloy", "yield strength", 180, 0.18, 3, "EN 755-2: 6060 to 6082, T5 and T6", {{{"yield_strength", 1}}}},
    {"price-outlier", "price / mass", 10.5, 0.45, 20, "6 to 30 a kilogram", {{{"price_per_length", 1}, {"mass_per_length", -1}}}},
};

// clang-format on

static_assert(sound(Family::threads, thread_relations));
static_assert(sound(Family::screws, fastener_relations));
static_assert(sound(Family::support_bearings, bearing_relations));
static_assert(sound(Family::linear_guides, guide_relations));
static_assert(sound(Family::extrusions, extrusion_relations));

}  // namespace millwright::catalogue::detail
