// SPDX-License-Identifier: Apache-2.0
// What usually holds for steel sections and materials; as in relations_drive.h.
#pragma once

#include "catalogue/relation.h"

namespace millwright::catalogue::detail {

// clang-format off
inline constexpr Relation section_relations[] = {
    {"section-mass", "mass per length / area", 0.00785, 0.02, 1.3, "steel, 7850 kg/m3", {{{"mass_per_length", 1}, {"area", -1}}}},
    {"area", "area / (width x height)", 0.23, 0.3, 4, "hollow sections", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "square*"},
    {"area", "area / (width x height)", 0.2, 0.3, 4, "hollow sections", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "rectangular*"},
    {"area", "area / (width x height)", 0.21, 0.3, 4, "hollow sections", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "circular*"},
    {"area", "area / (width x height)", 0.19, 0.2, 4, "EN 10056", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "equal angle"},
    {"area", "area / (width x height)", 0.24, 0.2, 4, "DIN 1026", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "channel"},
    {"area", "area / (width x height)", 1, 0.02, 1.2, "a rectangle", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "flat bar"},
    {"area", "area / (width x height)", 0.7854, 0.02, 1.2, "a circle", {{{"area", 1}, {"width", -1}, {"height", -1}}}, "round bar"},
    {"wall", "area / (wall x height)", 3.58, 0.08, 1.8, "four walls less corners", {{{"area", 1}, {"web_thickness", -1}, {"height", -1}}}, "square*"},
    {"wall", "area / (wall x height)", 2.8, 0.12, 2, "four walls less corners", {{{"area", 1}, {"web_thickness", -1}, {"height", -1}}}, "rectangular*"},
    {"wall", "area / (wall x height)", 2.9, 0.06, 1.8, "pi less the wall", {{{"area", 1}, {"web_thickness", -1}, {"height", -1}}}, "circular*"},
    {"wall", "area / (wall x height)", 1.92, 0.04, 1.6, "two legs", {{{"area", 1}, {"web_thickness", -1}, {"height", -1}}}, "equal angle"},
    {"wall", "area / (web x height)", 2.28, 0.15, 2, "web and two flanges", {{{"area", 1}, {"web_thickness", -1}, {"height", -1}}}, "channel"},
    {"wall", "flange / web thickness", 1, 0.02, 1.5, "one wall", {{{"flange_thickness", 1}, {"web_thickness", -1}}}, "square*"},
    {"wall", "flange / web thickness", 1, 0.02, 1.5, "one wall", {{{"flange_thickness", 1}, {"web_thickness", -1}}}, "rectangular*"},
    {"wall", "flange / web thickness", 1, 0.02, 1.5, "one wall", {{{"flange_thickness", 1}, {"web_thickness", -1}}}, "circular*"},
    {"wall", "flange / web thickness", 1, 0.02, 1.5, "one wall", {{{"flange_thickness", 1}, {"web_thickness", -1}}}, "equal angle"},
    {"wall", "flange / web thickness", 1.37, 0.15, 2, "DIN 1026", {{{"flange_thickness", 1}, {"web_thickness", -1}}}, "channel"},
    {"second-moment", "second moment x / (area x height squared)", 0.142, 0.07, 1.8, "thin square tube: 1/6", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "square*"},
    {"second-moment", "second moment y / (area x width squared)", 0.142, 0.07, 1.8, "thin square tube: 1/6", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "square*"},
    {"second-moment", "second moment x / (area x height squared)", 0.127, 0.07, 1.8, "thin tube", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "rectangular*"},
    {"second-moment", "second moment y / (area x width squared)", 0.162, 0.07, 1.8, "thin tube", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "rectangular*"},
    {"second-moment", "second moment x / (area x height squared)", 0.108, 0.06, 1.6, "thin round tube: 1/8", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "circular*"},
    {"second-moment", "second moment y / (area x width squared)", 0.108, 0.06, 1.6, "thin round tube: 1/8", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "circular*"},
    {"second-moment", "second moment x / (area x height squared)", 0.0912, 0.04, 1.6, "EN 10056", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "equal angle"},
    {"second-moment", "second moment y / (area x width squared)", 0.0912, 0.04, 1.6, "EN 10056", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "equal angle"},
    {"second-moment", "second moment x / (area x height squared)", 0.151, 0.05, 1.6, "DIN 1026", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "channel"},
    {"second-moment", "second moment y / (area x width squared)", 0.0865, 0.05, 1.6, "DIN 1026", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "channel"},
    {"second-moment", "second moment x / (area x height squared)", 0.08333, 0.02, 1.3, "a rectangle", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "flat bar"},
    {"second-moment", "second moment y / (area x width squared)", 0.08333, 0.02, 1.3, "a rectangle", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "flat bar"},
    {"second-moment", "second moment x / (area x height squared)", 0.0625, 0.02, 1.3, "a circle", {{{"second_moment_x", 1}, {"area", -1}, {"height", -2}}}, "round bar"},
    {"second-moment", "second moment y / (area x width squared)", 0.0625, 0.02, 1.3, "a circle", {{{"second_moment_y", 1}, {"area", -1}, {"width", -2}}}, "round bar"},
    {"section-modulus", "section modulus x height / second moment", 1.39, 0.03, 1.6, "I / (h - centroid)", {{{"section_modulus_x", 1}, {"second_moment_x", -1}, {"height", 1}}}, "equal angle"},
    {"section-modulus", "section modulus y width / second moment", 1.39, 0.03, 1.6, "I / (b - centroid)", {{{"section_modulus_y", 1}, {"second_moment_y", -1}, {"width", 1}}}, "equal angle"},
    {"section-modulus", "section modulus y width / second moment", 1.44, 0.06, 1.6, "I / (b - centroid)", {{{"section_modulus_y", 1}, {"second_moment_y", -1}, {"width", 1}}}, "channel"},
    {"section-modulus", "section modulus x height / second moment", 1.9, 0.15, 2, "W = I / (h/2)", {{{"section_modulus_x", 1}, {"second_moment_x", -1}, {"height", 1}}}},
    {"section-modulus", "section modulus y width / second moment", 1.8, 0.15, 2, "W = I / (b/2)", {{{"section_modulus_y", 1}, {"second_moment_y", -1}, {"width", 1}}}},
    {"torsion", "torsion constant / second moment", 1.66, 0.06, 2, "thin square tube: 3/2", {{{"torsion_constant", 1}, {"second_moment_y", -1}}}, "square*"},
    {"torsion", "torsion constant / second moment", 2.4, 0.12, 2, "thin tube", {{{"torsion_constant", 1}, {"second_moment_y", -1}}}, "rectangular*"},
    {"torsion", "torsion constant / second moment", 2, 0.03, 1.5, "a tube", {{{"torsion_constant", 1}, {"second_moment_y", -1}}}, "circular*"},
    {"torsion", "torsion constant / second moment", 2, 0.03, 1.5, "a circle", {{{"torsion_constant", 1}, {"second_moment_y", -1}}}, "round bar"},
    {"torsion", "torsion constant / second moment", 3.6, 0.05, 1.6, "thin strip: 4", {{{"torsion_constant", 1}, {"second_moment_y", -1}}}, "flat bar"},
    {"torsion", "torsion constant / (area x thickness squared)", 0.347, 0.04, 1.8, "open section: 1/3", {{{"torsion_constant", 1}, {"area", -1}, {"web_thickness", -2}}}, "equal angle"},
    {"torsion", "torsion constant / (area x flange squared)", 0.29, 0.1, 2, "open section: 1/3", {{{"torsion_constant", 1}, {"area", -1}, {"flange_thickness", -2}}}, "channel"},
    {"alloy", "elastic modulus", 206000, 0.02, 1.2, "steel", {{{"elastic_modulus", 1}}}},
    {"price-length", "price a metre / (price a kilogram x mass)", 1, 0.02, 1.5, "they say the same", {{{"price_per_length", 1}, {"price_per_mass", -1}, {"mass_per_length", -1}}}},
    {"price-outlier", "price a kilogram", 1.6, 0.4, 15, "bar stock: 1 to 6", {{{"price_per_mass", 1}}}},
};

inline constexpr Relation material_relations[] = {
    {"material-class", "elastic modulus of the class", 206e3, 0.03, 1.3, "steel", {{{"elastic_modulus", 1}}}, "steel"},
    {"material-class", "elastic modulus of the class", 1.3e5, 0.3, 2.5, "grey to ductile iron", {{{"elastic_modulus", 1}}}, "iron"},
    {"material-class", "elastic modulus of the class", 70e3, 0.03, 1.3, "aluminium", {{{"elastic_modulus", 1}}}, "aluminium"},
    {"material-class", "elastic modulus of the class", 1.05e5, 0.12, 1.8, "brass and bronze", {{{"elastic_modulus", 1}}}, "copper alloy"},
    {"material-class", "elastic modulus of the class", 2500, 0.4, 8, "unfilled polymers", {{{"elastic_modulus", 1}}}, "polymer"},
    {"material-class", "density of the class", 7850, 0.015, 1.2, "steel", {{{"density", 1}}}, "steel"},
    {"material-class", "density of the class", 7130, 0.03, 1.3, "iron", {{{"density", 1}}}, "iron"},
    {"material-class", "density of the class", 2700, 0.025, 1.3, "aluminium", {{{"density", 1}}}, "aluminium"},
    {"material-class", "density of the class", 8600, 0.04, 1.3, "brass and bronze", {{{"density", 1}}}, "copper alloy"},
    {"material-class", "density of the class", 1200, 0.13, 2.2, "unfilled polymers", {{{"density", 1}}}, "polymer"},
    {"material-class", "thermal expansion of the class", 1.22e-5, 0.13, 2, "ferritic 11 to austenitic 17", {{{"thermal_expansion", 1}}}, "steel"},
    {"material-class", "thermal expansion of the class", 1.1e-5, 0.1, 2, "iron", {{{"thermal_expansion", 1}}}, "iron"},
    {"material-class", "thermal expansion of the class", 2.35e-5, 0.04, 1.5, "aluminium", {{{"thermal_expansion", 1}}}, "aluminium"},
    {"material-class", "thermal expansion of the class", 1.85e-5, 0.08, 1.6, "brass and bronze", {{{"thermal_expansion", 1}}}, "copper alloy"},
    {"material-class", "thermal expansion of the class", 8e-5, 0.3, 4, "polymers", {{{"thermal_expansion", 1}}}, "polymer"},
    {"material-class", "tensile strength of the class", 550, 0.45, 6, "S235 to hardened", {{{"ultimate_strength", 1}}}, "steel"},
    {"material-class", "tensile strength of the class", 230, 0.55, 5, "soft to 7075", {{{"ultimate_strength", 1}}}, "aluminium"},
    {"material-class", "tensile strength of the class", 56, 0.35, 6, "polymers", {{{"ultimate_strength", 1}}}, "polymer"},
    {"strength-order", "yield / tensile strength", 0.72, 0.25, 4, "published materials", {{{"yield_strength", 1}, {"ultimate_strength", -1}}}},
    {"endurance", "endurance limit / tensile strength", 0.42, 0.3, 5, "half for steel, a third and less for others", {{{"endurance_limit", 1}, {"ultimate_strength", -1}}}},
    {"shear-modulus", "shear / elastic modulus", 0.384, 0.05, 1.7, "1 / (2 (1 + nu))", {{{"shear_modulus", 1}, {"elastic_modulus", -1}}}},
    {"poisson", "Poisson's ratio", 0.31, 0.12, 1.7, "metals 0.26 to 0.35, polymers up to 0.45", {{{"poisson_ratio", 1}}}},
    {"shear-yield", "shear yield / yield strength", 0.577, 0.04, 1.7, "von Mises: 1/sqrt(3)", {{{"shear_yield_strength", 1}, {"yield_strength", -1}}}},
    {"price-outlier", "price a kilogram", 1.7, 0.6, 20, "published prices", {{{"price_per_mass", 1}}}, "steel"},
    {"price-outlier", "price a kilogram", 6, 0.4, 20, "published prices", {{{"price_per_mass", 1}}}, "aluminium"},
    {"price-outlier", "price a kilogram", 5, 1.1, 50, "published prices", {{{"price_per_mass", 1}}}},
};
// clang-format on

static_assert(sound(Family::steel_sections, section_relations));
static_assert(sound(Family::materials, material_relations));

}  // namespace millwright::catalogue::detail
