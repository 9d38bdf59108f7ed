// SPDX-License-Identifier: Apache-2.0
#pragma once

// The columns of the families that hold and guide an axis: guides, bearings, fasteners, sections, materials; and the
// columns that every family has. number: name, unit, need, plausible range in that unit, meaning, basis column.

#include "catalogue/column.h"
#include "catalogue/cut_columns.h"

namespace millwright::catalogue::columns {

using enum Need;

/// First in every family, in this order.
inline constexpr ColumnDeclaration every_family[] = {
    text("manufacturer", required, "maker; generic where none is named", Identity::group),
    text("part_number", required, "part number, designation or name; unique for its manufacturer", Identity::group),
    money("price", "", "price of one piece (the nut of a ball screw, the carriage of a guide)"),
    money("price_per_length", "1/m", "price per length (the shaft of a screw, the rail of a guide, belts, profiles)"),
    money("price_per_mass", "1/kg", "price per mass (materials, bar stock)"),
    text("price_breaks", optional, "prices of a piece from so many pieces on: 10: 4.50; 100: 3.90"),
    text("currency", optional, "currency of the prices, ISO 4217: USD, EUR, IDR, ..."),
    text("price_basis", optional, "shop and date, or estimate with its tolerance"),
    text("evidence", optional, "found, mixed, computed, general (knowledge) or paper (only a publication names it)"),
    text("source", expected, "where the figures come from"),
    text("confidence", expected, "high, medium or low"),
    text("note", optional, "what a reader has to know"),
    text("supplier", optional, "who sells it at this price"),
    text("availability",
         optional,
         "unavailable, or preferred (is chosen where it costs little more); empty = can be bought"),
    number("owned_quantity", "1", optional, 0, 1e6, "pieces already owned, free of charge"),
    number("pack_size", "1", optional, 1, 1e6, "pieces in a pack, if only whole packs are sold"),
    text("waiver", optional, "lint rules that this row is excused from, with the reason: rule: reason"),
};

inline constexpr ColumnDeclaration threads[] = {
    number("nominal_diameter", "mm", required, 0.5, 200, "nominal diameter d"),
    number("pitch", "mm", required, 0.1, 10, "pitch P"),
    text("series", optional, "coarse or fine"),
    number("pitch_diameter", "mm", required, 0.4, 200, "pitch diameter d2"),
    number("minor_diameter_external", "mm", required, 0.3, 200, "minor diameter of the external thread d3"),
    number("minor_diameter_internal", "mm", expected, 0.3, 200, "minor diameter of the internal thread D1"),
    number("tensile_stress_area", "mm2", expected, 0.1, 30000, "tensile stress area As"),
    number("minor_area", "mm2", optional, 0.1, 30000, "area of the minor diameter d3"),
    number("tap_drill_diameter", "mm", optional, 0.3, 200, "tap drill"),
    number("clearance_hole_diameter", "mm", optional, 0.6, 220, "clearance hole, medium"),
    number("hex_key_size", "mm", optional, 0.5, 100, "hexagon socket of the socket head screw"),
    number("head_diameter", "mm", optional, 1, 300, "head diameter of the socket head screw"),
    number("head_height", "mm", optional, 0.5, 200, "head height of the socket head screw"),
    text("standard", optional, "standards"),
};

inline constexpr ColumnDeclaration screws[] = {
    text("designation", expected, "thread designation, a part_number of threads"),
    number("nominal_diameter", "mm", required, 0.5, 200, "nominal diameter"),
    number("pitch", "mm", required, 0.1, 10, "pitch"),
    text("property_class", required, "4.8, 8.8, 10.9, 12.9, A2-70, ..."),
    number("tensile_stress_area", "mm2", required, 0.1, 30000, "tensile stress area"),
    number("tensile_strength", "MPa", expected, 200, 2000, "tensile strength Rm"),
    number("yield_strength", "MPa", expected, 100, 1800, "yield strength"),
    number("proof_strength", "MPa", required, 100, 1800, "stress under proof load"),
    number("proof_load", "N", optional, 20, 3e7, "proof load = proof strength x stress area"),
    number("ultimate_load", "N", optional, 20, 4e7, "tensile strength x stress area"),
    number("maximum_preload", "N", expected, 10, 3e7, "75 % of the proof load"),
    number("tightening_torque", "N.m", optional, 0.005, 1e5, "torque to the maximum preload at friction 0.14"),
    text("standard", optional, "standards"),
};

inline constexpr ColumnDeclaration support_bearings[] = {
    text("series", optional, "BK, EK, FK, BF, EF, FF, KP, deep groove, thrust ball"),
    text("role", required, "fixed, supported, pillow block, flange block, radial bearing, thrust bearing"),
    number("screw_diameter", "mm", expected, 2, 200, "nominal diameter of the screw it is made for"),
    number("bore", "mm", required, 2, 200, "bore = diameter of the screw's journal"),
    text("bearing", optional, "rolling bearing inside"),
    number("dynamic_load_rating", "N", expected, 100, 1e6, "dynamic load rating, axial (fixed, thrust) or radial"),
    number("static_load_rating", "N", optional, 50, 2e6, "static load rating"),
    number("permissible_axial_load", "N", optional, 50, 1e6, "permissible axial load"),
    number("axial_stiffness", "N/um", optional, 2, 5000, "axial rigidity of the matched pair (fixed side)"),
    number("maximum_speed", "rpm", optional, 100, 100000, "maximum speed"),
    number("center_height", "mm", optional, 2, 400, "height of the screw axis over the base"),
    number("mass", "kg", expected, 0.001, 200, "mass"),
};

inline constexpr ColumnDeclaration linear_guides[] = {
    text("series", optional, "maker's series"),
    text("kind", required, "profile rail, profile rail miniature, linear ball bush (block), supported round rail"),
    number("size", "mm", required, 2, 150, "catalogue size: rail width or shaft diameter"),
    number("block_length", "mm", expected, 5, 600, "length of the carriage or bushing"),
    number("block_width", "mm", optional, 5, 400, "width of the carriage"),
    number("assembly_height", "mm", optional, 3, 300, "height from rail base to carriage top"),
    number("rail_width", "mm", optional, 2, 200, "rail width or shaft diameter"),
    number("rail_height", "mm", optional, 1, 200, "rail height"),
    number("dynamic_load_rating", "N", required, 50, 2e6, "dynamic load rating C for rating_distance"),
    number("static_load_rating", "N", required, 50, 4e6, "static load rating C0"),
    number("rating_distance", "km", expected, 50, 100, "travel that C is stated for: 50 or 100 km"),
    number("roll_moment_rating", "N.m", optional, 0.5, 200000, "static moment rating about the travel axis"),
    number("pitch_moment_rating", "N.m", optional, 0.3, 200000, "static moment rating, pitching"),
    number("yaw_moment_rating", "N.m", optional, 0.3, 200000, "static moment rating, yawing"),
    number("radial_stiffness", "N/um", optional, 5, 5000, "radial rigidity of a carriage"),
    number("carriage_mass", "kg", expected, 0.002, 60, "mass of a carriage"),
    number("rail_mass_per_length", "kg/m", expected, 0.05, 120, "mass of rail or shaft per length"),
    number("friction_coefficient", "1", expected, 0.0005, 0.05, "coefficient of friction"),
    number("maximum_rail_length", "mm", expected, 50, 10000, "longest rail in one piece"),
    stock_length,
    cutting_loss,
    cut_price,
};

inline constexpr ColumnDeclaration extrusions[] = {
    number("width", "mm", required, 5, 400, "width"),
    number("height", "mm", required, 5, 600, "height, the depth in strong bending"),
    number("slot", "mm", optional, 2, 30, "slot width"),
    number("area", "mm2", required, 20, 50000, "cross-section"),
    number("second_moment_x", "mm4", required, 50, 1e9, "second moment of area, bending over the height"),
    number("second_moment_y", "mm4", required, 50, 1e9, "second moment of area, bending over the width"),
    number("section_modulus_x", "mm3", expected, 10, 1e7, "section modulus, bending over the height"),
    number("section_modulus_y", "mm3", expected, 10, 1e7, "section modulus, bending over the width"),
    number("torsion_constant", "mm4", optional, 10, 1e9, "torsion constant"),
    number("mass_per_length", "kg/m", required, 0.05, 150, "mass per length"),
    text("alloy", optional, "alloy and temper"),
    number("elastic_modulus", "MPa", required, 30000, 300000, "elastic modulus"),
    number("yield_strength", "MPa", required, 20, 1000, "yield strength"),
    stock_length,
    cutting_loss,
    cut_price,
};

inline constexpr ColumnDeclaration steel_sections[] = {
    text("kind",
         required,
         "channel, equal angle, square hollow, rectangular hollow, circular hollow, flat bar, round bar"),
    text("standard", optional, "standard of the dimensions"),
    number("height", "mm", required, 1, 2000, "height, the depth in strong bending"),
    number("width", "mm", required, 1, 2000, "width"),
    number("web_thickness", "mm", optional, 0.3, 1000, "web or wall thickness"),
    number("flange_thickness", "mm", optional, 0.3, 1000, "flange or wall thickness"),
    number("area", "mm2", required, 1, 1e6, "cross-section"),
    number("mass_per_length", "kg/m", required, 0.005, 8000, "mass per length"),
    number("second_moment_x", "mm4", required, 0.05, 1e11, "second moment of area, bending over the height"),
    number("second_moment_y", "mm4", required, 0.05, 1e11, "second moment of area, bending over the width"),
    number("section_modulus_x", "mm3", expected, 0.1, 1e9, "section modulus, bending over the height"),
    number("section_modulus_y", "mm3", expected, 0.1, 1e9, "section modulus, bending over the width"),
    number("torsion_constant", "mm4", optional, 0.05, 1e11, "torsion constant"),
    text("material", required, "material, a part_number or alias of materials (alternatives divided by slashes)"),
    number("elastic_modulus", "MPa", required, 30000, 300000, "elastic modulus"),
    stock_length,
    cutting_loss,
    cut_price,
};

inline constexpr ColumnDeclaration materials[] = {
    text("aliases", optional, "other names, separated by semicolons"),
    text("class", expected, "steel, iron, aluminium, copper alloy, polymer, wood, stone"),
    number("elastic_modulus", "MPa", required, 5, 1.2e6, "elastic modulus"),
    number("shear_modulus", "MPa", expected, 2, 500000, "shear modulus"),
    number("poisson_ratio", "1", expected, 0, 0.5, "Poisson's ratio"),
    number("density", "kg/m3", required, 10, 23000, "density"),
    number("yield_strength", "MPa", required, 0.1, 5000, "yield strength (0.2 % proof stress)"),
    number("ultimate_strength", "MPa", expected, 0.1, 6000, "tensile strength"),
    number("endurance_limit", "MPa", optional, 0.1, 3000, "endurance limit, fully reversed", "endurance_basis"),
    text("endurance_basis", optional, "where the endurance limit comes from"),
    number("shear_yield_strength", "MPa", optional, 0.05, 3000, "yield strength in shear"),
    number("thermal_expansion", "1/K", expected, 1e-7, 5e-4, "coefficient of linear thermal expansion"),
    number("maximum_service_temperature", "degC", optional, 0, 3000, "highest service temperature"),
};

}  // namespace millwright::catalogue::columns
