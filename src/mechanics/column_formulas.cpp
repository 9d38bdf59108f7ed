// SPDX-License-Identifier: Apache-2.0
#include "mechanics/column.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_column(FormulaList& list) {
  define(
      list,
      {.name = "column.euler_load",
       .handbook_id = "COL-EULER",
       .symbol = "P_cr",
       .unit = "N",
       .title = "Elastic buckling load",
       .source = "khurmi_gupta2005, chapter 16",
       .validity = "straight, centrally loaded column; slender"},
      [](const auto&... x) { return column::euler_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").between(0, 4).typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("second_moment_of_area", "I", "m^4", "smallest second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "length").falling());

  define(
      list,
      {.name = "column.johnson_load",
       .handbook_id = "COL-JOHNSON",
       .symbol = "P_cr",
       .unit = "N",
       .title = "Buckling load of a stocky column by the Johnson parabola",
       .source = "shigley, 4-13",
       .validity = "straight, centrally loaded column; slenderness below the transition √(2 C π² E / σ_y)"},
      [](const auto&... x) { return column::johnson_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").between(0, 4).typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(5e7, 9e8),
      quantity("area", "A", "m^2", "area").rising(),
      quantity("second_moment_of_area", "I", "m^4", "smallest second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "length").falling())
      .valid_when("slenderness <= √(2·end_fixity·π²·elastic_modulus / yield_strength)",
                  [](double end_fixity,
                     double elastic_modulus,
                     double yield_strength,
                     double area,
                     double second_moment_of_area,
                     double length) {
                    return yield_strength * length * length * area <=
                           2.0 * end_fixity * 9.869604401089358 * elastic_modulus * second_moment_of_area;
                  });

  define(
      list,
      {.name = "column.critical_load",
       .handbook_id = "COL-BUCKLING-LOAD",
       .symbol = "P_cr",
       .unit = "N",
       .title = "Buckling load",
       .source = "shigley, 4-12, 4-13",
       .validity = "straight, centrally loaded column"},
      [](const auto&... x) { return column::critical_load(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").between(0, 4).typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(5e7, 9e8).rising(),
      quantity("area", "A", "m^2", "area").rising(),
      quantity("second_moment_of_area", "I", "m^4", "smallest second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("length", "L", "m", "length").falling());

  define(
      list,
      {.name = "column.portal_stiffness",
       .handbook_id = "FRAME-PORTAL-STIFFNESS",
       .symbol = "k",
       .unit = "N/m",
       .title = "Lateral stiffness of a portal with clamped feet under a force at beam level",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_stiffness(x...); },
      quantity("elastic_modulus", "E", "Pa", "modulus").typical(5e9, 6e11).rising(),
      quantity("column_second_moment", "I_c", "m^4", "second moment of each column").rising(),
      quantity("column_height", "h", "m", "column height").falling(),
      quantity("beam_second_moment", "I_b", "m^4", "second moment of the beam").rising(),
      quantity("beam_span", "L", "m", "beam span").falling());

  define(
      list,
      {.name = "column.portal_foot_moment",
       .symbol = "M_f",
       .unit = "N.m",
       .title = "Moment at the clamped feet of a portal under a force at beam level",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_foot_moment(x...); },
      quantity("force", "F", "N", "lateral force at beam level").rising(),
      quantity("column_height", "h", "m", "column height").rising(),
      quantity("stiffness_ratio", "κ", "1", "(I_b/L)/(I_c/h)").typical(0.1, 10).falling());

  define(
      list,
      {.name = "column.portal_corner_moment",
       .symbol = "M_c",
       .unit = "N.m",
       .title = "Moment at the upper corners of a portal under a force at beam level",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_corner_moment(x...); },
      quantity("force", "F", "N", "lateral force at beam level").rising(),
      quantity("column_height", "h", "m", "column height").rising(),
      quantity("stiffness_ratio", "κ", "1", "(I_b/L)/(I_c/h)").typical(0.1, 10).rising());

  define(
      list,
      {.name = "column.portal_corner_moment_of_beam_load",
       .symbol = "M_c",
       .unit = "N.m",
       .title = "Moment at the upper corners of a portal under a force on the middle of its beam",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_corner_moment_of_beam_load(x...); },
      quantity("force", "F", "N", "force on the middle of the beam").rising(),
      quantity("beam_span", "L", "m", "beam span").rising(),
      quantity("stiffness_ratio", "κ", "1", "(I_b/L)/(I_c/h)").typical(0.1, 10).falling());

  define(
      list,
      {.name = "column.portal_corner_moment_of_moving_load",
       .symbol = "M_c",
       .unit = "N.m",
       .title = "Largest moment at the upper corners of a portal under a force anywhere on its beam",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_corner_moment_of_moving_load(x...); },
      quantity("force", "F", "N", "force anywhere on the beam").rising(),
      quantity("beam_span", "L", "m", "beam span").rising(),
      quantity("stiffness_ratio", "κ", "1", "(I_b/L)/(I_c/h)").typical(0.1, 10).falling());

  define(
      list,
      {.name = "column.portal_foot_moment_of_moving_load",
       .symbol = "M_f",
       .unit = "N.m",
       .title = "Largest moment at the feet of a portal under a force anywhere on its beam",
       .source = "millwright_derivations, definition",
       .validity = "plane frame, axial strain neglected"},
      [](const auto&... x) { return column::portal_foot_moment_of_moving_load(x...); },
      quantity("force", "F", "N", "force anywhere on the beam").rising(),
      quantity("beam_span", "L", "m", "beam span").rising(),
      quantity("stiffness_ratio", "κ", "1", "(I_b/L)/(I_c/h)").typical(0.1, 10).falling());

  define(
      list,
      {.name = "column.johnson_load_of_radius",
       .symbol = "P_cr",
       .unit = "N",
       .title = "Buckling load of a stocky column by the Johnson parabola, from area and radius of gyration",
       .source = "fdm_printer, eq. 11; khurmi_gupta2005, chapter 16",
       .validity = "straight, centrally loaded; slenderness below the transition √(2 C π² E / σ_y)"},
      [](const auto&... x) { return column::johnson_load_of_radius(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").between(0, 4).typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "elastic modulus").typical(5e9, 6e11).rising(),
      quantity("yield_strength", "σ_y", "Pa", "yield strength").typical(5e7, 9e8),
      quantity("area", "A", "m^2", "area").rising(),
      quantity("length", "L", "m", "length").falling(),
      quantity("radius_of_gyration", "k", "m", "radius of gyration").rising())
      .valid_when("slenderness <= √(2·end_fixity·π²·elastic_modulus / yield_strength)",
                  [](double end_fixity,
                     double elastic_modulus,
                     double yield_strength,
                     double,
                     double length,
                     double radius_of_gyration) {
                    return yield_strength * length * length <= 2.0 * end_fixity * 9.869604401089358 * elastic_modulus *
                                                                   radius_of_gyration * radius_of_gyration;
                  });

  define(
      list,
      {.name = "column.euler_load_of_radius",
       .symbol = "P_cr",
       .unit = "N",
       .title = "Elastic buckling load from area and radius of gyration",
       .source = "khurmi_gupta2005, chapter 16",
       .validity = "straight, centrally loaded, slender"},
      [](const auto&... x) { return column::euler_load_of_radius(x...); },
      quantity("end_fixity", "C", "1", "end-fixity coefficient").between(0, 4).typical(0.25, 4).rising(),
      quantity("elastic_modulus", "E", "Pa", "elastic modulus").typical(5e9, 6e11).rising(),
      quantity("area", "A", "m^2", "area").rising(),
      quantity("length", "L", "m", "length").falling(),
      quantity("radius_of_gyration", "k", "m", "radius of gyration").rising());
}

}  // namespace millwright::mechanics
