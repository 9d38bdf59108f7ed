// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/section.h"

namespace millwright::mechanics {

void define_section(FormulaList& list) {
  define(
      list,
      {.name = "section.rectangle_second_moment",
       .handbook_id = "SEC-RECT-I",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a rectangle",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section"},
      [](const auto&... x) { return section::rectangle_second_moment(x...); },
      quantity("width", "b", "m", "width parallel to the neutral axis").rising(),
      quantity("height", "h", "m", "height in the bending direction").rising());

  define(
      list,
      {.name = "section.rectangle_torsion_constant",
       .handbook_id = "SEC-RECT-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Torsion constant of a rectangle, within 0.5 % of the exact series",
       .source = "roark, Table 10.1",
       .validity = "sharp corners, homogeneous section"},
      [](const auto&... x) { return section::rectangle_torsion_constant(x...); },
      quantity("width", "b", "m", "one side").rising(),
      quantity("height", "h", "m", "other side").rising());

  define(
      list,
      {.name = "section.rectangular_tube_second_moment",
       .handbook_id = "SEC-RECT-TUBE-I",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a rectangular tube",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; wall below half of either side"},
      [](const auto&... x) { return section::rectangular_tube_second_moment(x...); },
      quantity("width", "b", "m", "outer width").rising(),
      quantity("height", "h", "m", "outer height in the bending direction").rising(),
      quantity("wall_thickness", "t", "m", "wall").rising())
      .valid_when("2·wall_thickness <= width and 2·wall_thickness <= height",
                  [](double width, double height, double wall_thickness) {
                    return 2.0 * wall_thickness <= width && 2.0 * wall_thickness <= height;
                  });

  define(
      list,
      {.name = "section.rectangular_tube_torsion_constant",
       .handbook_id = "SEC-RECT-TUBE-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Torsion constant of a rectangular tube after Bredt, over the middle line of the wall",
       .source = "roark, Table 10.1",
       .validity = "wall at most a quarter of either side, better thinner"},
      [](const auto&... x) { return section::rectangular_tube_torsion_constant(x...); },
      quantity("width", "b", "m", "outer width").rising(),
      quantity("height", "h", "m", "outer height").rising(),
      quantity("wall_thickness", "t", "m", "wall").rising())
      .valid_when("4·wall_thickness <= width and 4·wall_thickness <= height",
                  [](double width, double height, double wall_thickness) {
                    return 4.0 * wall_thickness <= width && 4.0 * wall_thickness <= height;
                  });

  define(
      list,
      {.name = "section.round_second_moment",
       .handbook_id = "SEC-ROUND-I",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a round bar or tube",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; inner below outer diameter"},
      [](const auto&... x) { return section::round_second_moment(x...); },
      quantity("outer_diameter", "D", "m", "outer diameter").rising(),
      quantity("inner_diameter", "d", "m", "inner diameter (0 = solid)").falling())
      .valid_when("inner_diameter <= outer_diameter",
                  [](double outer_diameter, double inner_diameter) { return inner_diameter <= outer_diameter; });

  define(
      list,
      {.name = "section.round_torsion_constant",
       .handbook_id = "SEC-ROUND-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Torsion constant of a round bar or tube",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; inner below outer diameter"},
      [](const auto&... x) { return section::round_torsion_constant(x...); },
      quantity("outer_diameter", "D", "m", "outer diameter").rising(),
      quantity("inner_diameter", "d", "m", "inner diameter (0 = solid)").falling())
      .valid_when("inner_diameter <= outer_diameter",
                  [](double outer_diameter, double inner_diameter) { return inner_diameter <= outer_diameter; });

  define(
      list,
      {.name = "section.angle_centroid",
       .handbook_id = "SEC-L-CENTROID",
       .symbol = "c",
       .unit = "m",
       .title = "Distance of the centroid of an angle from the outer face of its other leg",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; thickness below both legs"},
      [](const auto&... x) { return section::angle_centroid(x...); },
      quantity("height", "h", "m", "leg in the measured direction").rising(),
      quantity("width", "b", "m", "other leg"),
      quantity("thickness", "t", "m", "thickness"))
      .valid_when("thickness <= height and thickness <= width", [](double height, double width, double thickness) {
        return thickness <= height && thickness <= width;
      });

  define(
      list,
      {.name = "section.angle_second_moment",
       .handbook_id = "SEC-L-I",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of an angle about the axis parallel to its other leg",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; thickness below both legs"},
      [](const auto&... x) { return section::angle_second_moment(x...); },
      quantity("height", "h", "m", "leg in the bending direction").rising(),
      quantity("width", "b", "m", "other leg").rising(),
      quantity("thickness", "t", "m", "thickness").rising())
      .valid_when("thickness <= height and thickness <= width", [](double height, double width, double thickness) {
        return thickness <= height && thickness <= width;
      });

  define(
      list,
      {.name = "section.channel_strong_second_moment",
       .handbook_id = "SEC-CHANNEL-I-STRONG",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a channel about its strong axis",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; walls inside the outline"},
      [](const auto&... x) { return section::channel_strong_second_moment(x...); },
      quantity("depth", "h", "m", "depth").rising(),
      quantity("flange_width", "b", "m", "flange width").rising(),
      quantity("web_thickness", "t_w", "m", "web thickness").rising(),
      quantity("flange_thickness", "t_f", "m", "flange thickness").rising())
      .valid_when("web_thickness <= flange_width and 2·flange_thickness <= depth",
                  [](double depth, double flange_width, double web_thickness, double flange_thickness) {
                    return web_thickness <= flange_width && 2.0 * flange_thickness <= depth;
                  });

  define(
      list,
      {.name = "section.channel_weak_second_moment",
       .handbook_id = "SEC-CHANNEL-I-WEAK",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a channel about its weak axis",
       .source = "roark, appendix A",
       .validity = "sharp corners, homogeneous section; walls inside the outline"},
      [](const auto&... x) { return section::channel_weak_second_moment(x...); },
      quantity("depth", "h", "m", "depth").rising(),
      quantity("flange_width", "b", "m", "flange width").rising(),
      quantity("web_thickness", "t_w", "m", "web thickness").rising(),
      quantity("flange_thickness", "t_f", "m", "flange thickness").rising())
      .valid_when("web_thickness <= flange_width and 2·flange_thickness <= depth",
                  [](double depth, double flange_width, double web_thickness, double flange_thickness) {
                    return web_thickness <= flange_width && 2.0 * flange_thickness <= depth;
                  });

  define(
      list,
      {.name = "section.open_torsion_constant",
       .handbook_id = "SEC-OPEN-J",
       .symbol = "J",
       .unit = "m^4",
       .title = "Torsion constant of an open thin-walled section, a sum over its walls",
       .source = "roark, Table 10.1",
       .validity = "walls thin against their length"},
      [](const auto&... x) { return section::open_torsion_constant(x...); },
      list_of("wall_lengths", "b", "m", "wall lengths"),
      list_of("wall_thicknesses", "t", "m", "wall thicknesses").as_long_as(0));

  define(
      list,
      {.name = "section.shifted_second_moment",
       .handbook_id = "SEC-PARALLEL-AXIS",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area about an axis parallel to the centroidal one",
       .source = "roark, appendix A",
       .validity = "any section"},
      [](const auto&... x) { return section::shifted_second_moment(x...); },
      quantity("centroidal_second_moment", "I_c", "m^4", "second moment about the own centroid").rising(),
      quantity("area", "A", "m^2", "area").rising(),
      quantity("axis_distance", "e", "m", "distance between the axes").rising());

  define(
      list,
      {.name = "section.round_area",
       .symbol = "A",
       .unit = "m^2",
       .title = "Area of a circle",
       .source = "khurmi_gupta2005, chapter 4"},
      [](const auto&... x) { return section::round_area(x...); },
      quantity("diameter", "d", "m", "diameter").rising());

  define(
      list,
      {.name = "section.rectangle_term",
       .symbol = "BH³",
       .unit = "m^4",
       .title = "Twelve times the second moment of area of a rectangle",
       .source = "sander, eq. 32"},
      [](const auto&... x) { return section::rectangle_term(x...); },
      quantity("width", "B", "m", "width").rising(),
      quantity("height", "H", "m", "height").rising());

  define(
      list,
      {.name = "section.inner_rectangle_term",
       .symbol = "bh³",
       .unit = "m^4",
       .title = "Twelve times the second moment of area of the rectangle cut out of another one",
       .source = "sander, eq. 32",
       .validity = "cut-out inside the outline"},
      [](const auto&... x) { return section::inner_rectangle_term(x...); },
      quantity("width", "B", "m", "outer width").rising(),
      quantity("height", "H", "m", "outer height").rising(),
      quantity("side_wall", "t_2", "m", "thickness of each side wall").falling(),
      quantity("height_reduction", "t_1", "m", "outer less inner height").falling())
      .valid_when("2·side_wall <= width and height_reduction <= height",
                  [](double width, double height, double side_wall, double height_reduction) {
                    return 2.0 * side_wall <= width && height_reduction <= height;
                  });

  define(
      list,
      {.name = "section.reduced_rectangle_second_moment",
       .symbol = "I",
       .unit = "m^4",
       .title = "Second moment of area of a rectangle less one with the same centre",
       .source = "sander, eq. 32",
       .validity = "both rectangles with one centre, cut-out inside the outline"},
      [](const auto&... x) { return section::reduced_rectangle_second_moment(x...); },
      quantity("width", "B", "m", "outer width").rising(),
      quantity("height", "H", "m", "outer height").rising(),
      quantity("side_wall", "t_2", "m", "thickness of each side wall").rising(),
      quantity("height_reduction", "t_1", "m", "outer less inner height").rising())
      .valid_when("2·side_wall <= width and height_reduction <= height",
                  [](double width, double height, double side_wall, double height_reduction) {
                    return 2.0 * side_wall <= width && height_reduction <= height;
                  });

  define(
      list,
      {.name = "section.radius_of_gyration",
       .symbol = "k",
       .unit = "m",
       .title = "Radius of gyration",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::radius_of_gyration(x...); },
      quantity("second_moment_of_area", "I", "m^4", "second moment of area").typical(1e-10, 1e-6).rising(),
      quantity("area", "A", "m^2", "area").falling());

  define(
      list,
      {.name = "section.round_radius_of_gyration",
       .symbol = "k",
       .unit = "m",
       .title = "Radius of gyration of a solid circle",
       .source = "khurmi_gupta2005, chapter 5"},
      [](const auto&... x) { return section::round_radius_of_gyration(x...); },
      quantity("diameter", "d", "m", "diameter").rising());
}

}  // namespace millwright::mechanics
