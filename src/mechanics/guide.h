// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Linear guides. x along the travel, y across, z up from the base; the origin lies in the middle of the four
/// carriages, at their mid-plane. Forces and moments are those on the table: weights, process and inertia. The drive
/// takes the force along x on its own line. Everything in SI. Valid, besides what a formula says: rigid table and
/// rails, equal carriages, small deflections.
namespace millwright::mechanics::guide {

using namespace scalar;

/// Pitching moment on the carriages (N·m): the force acts above the drive line, the weight off the centre.
/// [hiwin_linear_guideway, load calculation]
template <class T>
T pitch_moment(const T& force_x, const T& force_z, const T& point_x, const T& point_z, const T& drive_z) {
  return (point_z - drive_z) * force_x - point_x * force_z;
}

/// Rolling moment on the carriages (N·m). [hiwin_linear_guideway, load calculation]
template <class T>
T roll_moment(const T& force_y, const T& force_z, const T& point_y, const T& point_z) {
  return point_y * force_z - point_z * force_y;
}

/// Yawing moment on the carriages (N·m). [hiwin_linear_guideway, load calculation]
template <class T>
T yaw_moment(const T& force_x, const T& force_y, const T& point_x, const T& point_y, const T& drive_y) {
  return point_x * force_y - (point_y - drive_y) * force_x;
}

/// Vertical force of the table on one of four carriages, signed like the total force (N). Sum forces and moments of
/// several loads first. Valid: four carriages on two rails. [hiwin_linear_guideway, load calculation]
template <class T>
T carriage_vertical_load(const T& force_z,
                         const T& roll_moment,
                         const T& pitch_moment,
                         const T& carriage_spacing,
                         const T& rail_spacing,
                         const T& side_x,
                         const T& side_y) {
  watch_validity<T>("guide.carriage_vertical_load",
                    force_z,
                    roll_moment,
                    pitch_moment,
                    carriage_spacing,
                    rail_spacing,
                    side_x,
                    side_y);
  return force_z / 4.0 - side_x * pitch_moment / (2.0 * carriage_spacing) + side_y * roll_moment / (2.0 * rail_spacing);
}

/// Lateral force of the table on one of four carriages, signed (N). Valid: four carriages on two rails.
/// [hiwin_linear_guideway, load calculation]
template <class T>
T carriage_lateral_load(const T& force_y, const T& yaw_moment, const T& carriage_spacing, const T& side_x) {
  watch_validity<T>("guide.carriage_lateral_load", force_y, yaw_moment, carriage_spacing, side_x);
  return force_y / 4.0 + side_x * yaw_moment / (2.0 * carriage_spacing);
}

/// Safe bound of the equivalent load on the worst of four carriages (N). Valid: four carriages on two rails.
/// [hiwin_linear_guideway, load calculation]
template <class T>
T largest_carriage_load(const T& force_z,
                        const T& roll_moment,
                        const T& pitch_moment,
                        const T& force_y,
                        const T& yaw_moment,
                        const T& carriage_spacing,
                        const T& rail_spacing) {
  return absolute(force_z) / 4.0 + absolute(pitch_moment) / (2.0 * carriage_spacing) +
         absolute(roll_moment) / (2.0 * rail_spacing) + absolute(force_y) / 4.0 +
         absolute(yaw_moment) / (2.0 * carriage_spacing);
}

/// Equivalent load of a carriage that is equally strong in all four directions (N). [hiwin_linear_guideway, load
/// calculation]
template <class T>
T equivalent_load(const T& vertical_load, const T& lateral_load) {
  return absolute(vertical_load) + absolute(lateral_load);
}

/// Equivalent load of a carriage that takes moments itself (one or two carriages) (N). [hiwin_linear_guideway, load
/// calculation]
template <class T>
T equivalent_load_with_moments(const T& vertical_load,
                               const T& lateral_load,
                               std::span<const T> moments,
                               std::span<const T> static_moment_ratings,
                               const T& static_load_rating) {
  const T moment_share = sum_of(common_length(moments, static_moment_ratings),
                                [&](std::size_t n) { return absolute(moments[n]) / static_moment_ratings[n]; });
  return absolute(vertical_load) + absolute(lateral_load) + static_load_rating * moment_share;
}

/// Constant load with the same life as the loads of the duty cycle (N); exponent 3 for balls, 10/3 for rollers.
/// [hiwin_linear_guideway, load calculation]
template <class T>
T mean_load(std::span<const T> equivalent_loads, std::span<const T> distances, const T& exponent) {
  watch_validity<T>("guide.mean_load", equivalent_loads, distances, exponent);
  const std::size_t count = common_length(equivalent_loads, distances);
  const T one = in_unit<T>(1.0, dimension::force);
  const T damage =
      sum_of(count, [&](std::size_t n) { return pow(equivalent_loads[n] / one, exponent) * distances[n]; });
  return one * pow(damage / sum_of(count, [&](std::size_t n) { return distances[n]; }), 1.0 / exponent);
}

/// Distance that 90 % of ball carriages reach (m). The rating distance belongs to the load rating: 50 km in Asian, 100
/// km in European catalogues. Load factor 1.0 to 1.2 up to 0.25 m/s, 1.2 to 1.5 up to 1 m/s, 1.5 to 2 above.
/// [iso14728_1]
template <class T>
T ball_life_distance(const T& dynamic_load_rating,
                     const T& mean_load,
                     const T& load_factor,
                     const T& condition_factor,
                     const T& rating_distance) {
  watch_validity<T>(
      "guide.ball_life_distance", dynamic_load_rating, mean_load, load_factor, condition_factor, rating_distance);
  return rating_distance * cube(condition_factor * dynamic_load_rating / (load_factor * mean_load));
}

/// Distance that 90 % of roller carriages reach (rating distance 100 km) (m). [iso14728_1]
template <class T>
T roller_life_distance(const T& dynamic_load_rating,
                       const T& mean_load,
                       const T& load_factor,
                       const T& condition_factor) {
  watch_validity<T>("guide.roller_life_distance", dynamic_load_rating, mean_load, load_factor, condition_factor);
  return in_unit<T>(1e5, dimension::length) *
         pow(condition_factor * dynamic_load_rating / (load_factor * mean_load), 10.0 / 3.0);
}

/// Load rating referred to 50 km of a ball carriage rated for 100 km, 1.26 times (N). Valid: ball carriages only.
/// [iso14728_1]
template <class T>
T dynamic_load_rating_50_km(const T& dynamic_load_rating_100_km) {
  return std::cbrt(2.0) * dynamic_load_rating_100_km;
}

/// Life at the mean speed over the whole duty cycle (s). [hiwin_linear_guideway, load calculation]
template <class T>
T life_time(const T& life_distance, const T& mean_speed) {
  return life_distance / mean_speed;
}

/// Static load rating over the largest equivalent load. Usual: 1 to 1.3 without shock, 2 to 3 with shock, 3 when
/// cutting. [thk_lm_guide, static safety]
template <class T>
T static_safety(const T& static_load_rating, const T& largest_load) {
  return static_load_rating / largest_load;
}

/// Friction of all carriages with their seals (N). Balls 0.002 to 0.004, rollers 0.001 to 0.002, plain polymer 0.05 to
/// 0.2; seals 1 to 5 N each. [hiwin_linear_guideway, load calculation]
template <class T>
T friction_force(const T& friction, const T& load_sum, const T& carriage_count, const T& seal_drag) {
  watch_validity<T>("guide.friction_force", friction, load_sum, carriage_count, seal_drag);
  return friction * load_sum + carriage_count * seal_drag;
}

/// Elastic deflection of a carriage (m). [hiwin_linear_guideway, load calculation]
template <class T>
T carriage_deflection(const T& load, const T& stiffness) {
  return load / stiffness;
}

/// Pitching stiffness of four carriages (N·m/rad); with the rail spacing it is the rolling stiffness.
/// [hiwin_linear_guideway, load calculation]
template <class T>
T pitch_stiffness(const T& carriage_stiffness, const T& carriage_spacing) {
  return carriage_stiffness * square(carriage_spacing);
}

/// Midspan deflection of an end-supported round shaft under two bushings in the middle (m). Valid: simply supported
/// ends, bushings centred, spacing below the span. [shigley, Table A-9]
template <class T>
T shaft_deflection(
    const T& force, const T& span, const T& bushing_spacing, const T& elastic_modulus, const T& diameter) {
  watch_validity<T>("guide.shaft_deflection", force, span, bushing_spacing, elastic_modulus, diameter);
  const T force_distance = named("a", (span - bushing_spacing) / 2.0);
  const T second_moment = named("I", pi<T>() * pow(diameter, 4.0) / 64.0);
  return force / 2.0 * force_distance * (3.0 * square(span) - 4.0 * square(force_distance)) /
         (24.0 * elastic_modulus * second_moment);
}

/// Slope of the shaft at a bushing (rad). Limit 0.5° for self-aligning bushings, 0.1° otherwise. Valid: simply
/// supported ends, bushings centred, spacing below the span. [shigley, Table A-9]
template <class T>
T shaft_slope(const T& force, const T& span, const T& bushing_spacing, const T& elastic_modulus, const T& diameter) {
  watch_validity<T>("guide.shaft_slope", force, span, bushing_spacing, elastic_modulus, diameter);
  const T force_distance = named("a", (span - bushing_spacing) / 2.0);
  const T second_moment = named("I", pi<T>() * pow(diameter, 4.0) / 64.0);
  return force / 2.0 * force_distance * (span - 2.0 * force_distance) / (2.0 * elastic_modulus * second_moment);
}

/// Bending stress of an end-supported round shaft between its two bushings (Pa). Valid: simply supported ends, bushings
/// centred, spacing below the span. [khurmi_gupta2005, chapter 14]
template <class T>
T shaft_stress(const T& force, const T& span, const T& bushing_spacing, const T& diameter) {
  watch_validity<T>("guide.shaft_stress", force, span, bushing_spacing, diameter);
  return force / 2.0 * (span - bushing_spacing) / 2.0 * 32.0 / (pi<T>() * cube(diameter));
}

/// Bearing length a plain bushing needs so that a driving force off its axis does not jam it (m). Friction 0.25 gives
/// the 2:1 rule. Valid: plain bushing, force parallel to the guide. [millwright_derivations, definition]
template <class T>
T required_bushing_length(const T& friction, const T& force_offset, const T& safety_factor) {
  watch_validity<T>("guide.required_bushing_length", friction, force_offset, safety_factor);
  return 2.0 * friction * force_offset * safety_factor;
}

}  // namespace millwright::mechanics::guide
