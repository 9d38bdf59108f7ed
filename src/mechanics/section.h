// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Properties of cross sections, and the stresses that follow from them. Heights lie in the bending direction, widths
/// along the neutral axis. Everything in SI.
/// Valid, besides what a formula says: sharp corners, homogeneous section.
namespace millwright::mechanics::section {

using namespace scalar;

/// Second moment of area of a rectangle (m⁴). [roark, appendix A]
template <class T>
T rectangle_second_moment(const T& width, const T& height) {
  return width * cube(height) / 12.0;
}

/// Torsion constant of a rectangle, within 0.5 % of the exact series (m⁴). [roark, Table 10.1]
template <class T>
T rectangle_torsion_constant(const T& width, const T& height) {
  const T half_long = named("a", larger(width, height) / 2.0);
  const T half_short = named("c", smaller(width, height) / 2.0);
  return half_long * cube(half_short) *
         (16.0 / 3.0 - 3.36 * half_short / half_long * (1.0 - pow(half_short, 4.0) / (12.0 * pow(half_long, 4.0))));
}

/// Second moment of area of a rectangular tube (m⁴). Valid: wall below half of either side. [roark, appendix A]
template <class T>
T rectangular_tube_second_moment(const T& width, const T& height, const T& wall_thickness) {
  watch_validity<T>("section.rectangular_tube_second_moment", width, height, wall_thickness);
  return (width * cube(height) - (width - 2.0 * wall_thickness) * cube(height - 2.0 * wall_thickness)) / 12.0;
}

/// Torsion constant of a rectangular tube after Bredt, over the middle line of the wall (m⁴). Valid: wall at most a
/// quarter of either side, better thinner. [roark, Table 10.1]
template <class T>
T rectangular_tube_torsion_constant(const T& width, const T& height, const T& wall_thickness) {
  watch_validity<T>("section.rectangular_tube_torsion_constant", width, height, wall_thickness);
  const T mean_width = named("b_m", width - wall_thickness);
  const T mean_height = named("h_m", height - wall_thickness);
  return 2.0 * wall_thickness * square(mean_width) * square(mean_height) / (mean_width + mean_height);
}

/// Second moment of area of a round bar or tube (inner diameter 0 = solid) (m⁴). Valid: inner below outer diameter.
/// [roark, appendix A]
template <class T>
T round_second_moment(const T& outer_diameter, const T& inner_diameter) {
  watch_validity<T>("section.round_second_moment", outer_diameter, inner_diameter);
  return pi<T>() * (pow(outer_diameter, 4.0) - pow(inner_diameter, 4.0)) / 64.0;
}

/// Torsion constant of a round bar or tube (inner diameter 0 = solid) (m⁴). Valid: inner below outer diameter. [roark,
/// appendix A]
template <class T>
T round_torsion_constant(const T& outer_diameter, const T& inner_diameter) {
  watch_validity<T>("section.round_torsion_constant", outer_diameter, inner_diameter);
  return pi<T>() * (pow(outer_diameter, 4.0) - pow(inner_diameter, 4.0)) / 32.0;
}

/// Distance of the centroid of an angle from the outer face of its other leg (m). Rolled angles differ by 2 to 3 %
/// because of fillets. Valid: thickness below both legs. [roark, appendix A]
template <class T>
T angle_centroid(const T& height, const T& width, const T& thickness) {
  watch_validity<T>("section.angle_centroid", height, width, thickness);
  return (height * thickness * height / 2.0 + (width - thickness) * thickness * thickness / 2.0) /
         (thickness * (height + width - thickness));
}

/// Second moment of area of an angle about the axis parallel to its other leg (m⁴). A single angle buckles about its
/// weak principal axis (about 0.41 of this for equal legs): take table values there. Valid: thickness below both legs.
/// [roark, appendix A]
template <class T>
T angle_second_moment(const T& height, const T& width, const T& thickness) {
  watch_validity<T>("section.angle_second_moment", height, width, thickness);
  const T centroid = named("c", angle_centroid(height, width, thickness));
  return thickness * cube(height) / 12.0 + thickness * height * square(height / 2.0 - centroid) +
         (width - thickness) * cube(thickness) / 12.0 +
         (width - thickness) * thickness * square(thickness / 2.0 - centroid);
}

/// Second moment of area of a channel about its strong axis (m⁴). Valid: walls inside the outline. [roark, appendix A]
template <class T>
T channel_strong_second_moment(const T& depth,
                               const T& flange_width,
                               const T& web_thickness,
                               const T& flange_thickness) {
  watch_validity<T>("section.channel_strong_second_moment", depth, flange_width, web_thickness, flange_thickness);
  return (flange_width * cube(depth) - (flange_width - web_thickness) * cube(depth - 2.0 * flange_thickness)) / 12.0;
}

/// Second moment of area of a channel about its weak axis (m⁴). Tapered flanges of rolled channels make it 13 % high:
/// prefer table values. Valid: walls inside the outline. [roark, appendix A]
template <class T>
T channel_weak_second_moment(const T& depth, const T& flange_width, const T& web_thickness, const T& flange_thickness) {
  watch_validity<T>("section.channel_weak_second_moment", depth, flange_width, web_thickness, flange_thickness);
  const T web_area = named("A_1", depth * web_thickness);
  const T web_centre = named("c_1", web_thickness / 2.0);
  const T flange_area = named("A_2", 2.0 * (flange_width - web_thickness) * flange_thickness);
  const T flange_centre = named("c_2", web_thickness + (flange_width - web_thickness) / 2.0);
  const T centroid = named("c", (web_area * web_centre + flange_area * flange_centre) / (web_area + flange_area));
  return depth * cube(web_thickness) / 12.0 + web_area * square(web_centre - centroid) +
         2.0 * flange_thickness * cube(flange_width - web_thickness) / 12.0 +
         flange_area * square(flange_centre - centroid);
}

/// Torsion constant of an open thin-walled section, a sum over its walls (m⁴). Open sections are soft in torsion.
/// Valid: walls thin against their length. [roark, Table 10.1]
template <class T>
T open_torsion_constant(std::span<const T> wall_lengths, std::span<const T> wall_thicknesses) {
  return sum_of(common_length(wall_lengths, wall_thicknesses),
                [&](std::size_t n) { return wall_lengths[n] * cube(wall_thicknesses[n]); }) /
         3.0;
}

/// Second moment of area about an axis parallel to the centroidal one (m⁴). Valid: any section. [roark, appendix A]
template <class T>
T shifted_second_moment(const T& centroidal_second_moment, const T& area, const T& axis_distance) {
  return centroidal_second_moment + area * square(axis_distance);
}

/// Area of a circle (m²). [khurmi_gupta2005, chapter 4]
template <class T>
T round_area(const T& diameter) {
  return pi<T>() / 4.0 * square(diameter);
}

/// Twelve times the second moment of area of a rectangle (m⁴). [sander, eq. 32]
template <class T>
T rectangle_term(const T& width, const T& height) {
  return width * cube(height);
}

/// Twelve times the second moment of area of the rectangle cut out of another one (m⁴). Valid: cut-out inside the
/// outline. [sander, eq. 32]
template <class T>
T inner_rectangle_term(const T& width, const T& height, const T& side_wall, const T& height_reduction) {
  watch_validity<T>("section.inner_rectangle_term", width, height, side_wall, height_reduction);
  return (width - 2.0 * side_wall) * cube(height - height_reduction);
}

/// Second moment of area of a rectangle less one with the same centre (m⁴). The paper uses it for a channel, whose
/// parts have no common centre: there it is wrong, see channel_strong_second_moment. Valid: both rectangles with one
/// centre, cut-out inside the outline. [sander, eq. 32]
template <class T>
T reduced_rectangle_second_moment(const T& width, const T& height, const T& side_wall, const T& height_reduction) {
  watch_validity<T>("section.reduced_rectangle_second_moment", width, height, side_wall, height_reduction);
  return (rectangle_term(width, height) - inner_rectangle_term(width, height, side_wall, height_reduction)) / 12.0;
}

/// Radius of gyration (m). [khurmi_gupta2005, chapter 5]
template <class T>
T radius_of_gyration(const T& second_moment_of_area, const T& area) {
  return sqrt(second_moment_of_area / area);
}

/// Radius of gyration of a solid circle (m). [khurmi_gupta2005, chapter 5]
template <class T>
T round_radius_of_gyration(const T& diameter) {
  return diameter / 4.0;
}

}  // namespace millwright::mechanics::section
