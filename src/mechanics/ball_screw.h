// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include "mechanics/buckling.h"
#include "mechanics/corner_bounds.h"
#include "mechanics/critical_speed.h"
#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Ball screws: mean load, preload, life, torque, permissible speed and load, stiffness, accuracy. Loads are
/// magnitudes; a preloaded nut is judged by both of its raceway pairs. Everything in SI; life in revolutions.
namespace millwright::mechanics::ball_screw {

using namespace scalar;

/// Mean speed (rad/s) over the duty cycle, dwells included. [iso3408_5, section 7.1]
template <class T>
T mean_speed(std::span<const T> angular_speeds, std::span<const T> durations) {
  const std::size_t count = common_length(angular_speeds, durations);
  return sum_of(count, [&](std::size_t i) { return T(absolute(angular_speeds[i]) * durations[i]); }) /
         sum_of(count, [&](std::size_t i) { return durations[i]; });
}

/// Cubic mean of the load (N) over the revolutions; dwells vanish. Loads in both directions on a nut without preload:
/// one mean for each direction. [iso3408_5, section 7.1.2]
template <class T>
T mean_load(std::span<const T> forces, std::span<const T> angular_speeds, std::span<const T> durations) {
  const std::size_t count = common_length(forces, angular_speeds, durations);
  const auto turns = [&](std::size_t i) { return T(absolute(angular_speeds[i]) * durations[i]); };
  const T weighted = sum_of(count, [&](std::size_t i) { return T(cube(absolute(forces[i])) * turns(i)); });
  return cbrt(weighted / sum_of(count, turns));
}

/// Mean load (N) when the load varies linearly with travel; up to 8 % above the exact cubic mean.
/// [thk_catalogue, average load]
template <class T>
T mean_load_linear(const T& smallest_force, const T& largest_force) {
  watch_validity<T>("ball_screw.mean_load_linear", smallest_force, largest_force);
  return (2.0 * largest_force + smallest_force) / 3.0;
}

/// External force (N) at which the unloaded raceway pair of a preloaded nut lifts off.
template <class T>
T lift_off_force(const T& preload) {
  return 2.0 * std::sqrt(2.0) * preload;
}

/// Load (N) of the raceway pair that the external force adds to, in a preloaded nut. Exact without force and from
/// lift-off on, within 3.5 % of Hertz between. [iso3408_5, section 7.1.3]
template <class T>
T loaded_side_force(const T& force, const T& preload) {
  return where_below(
      force,
      lift_off_force(preload),
      [&](const T& f) { return T(preload * pow(1.0 + f / lift_off_force(preload), 1.5)); },
      [](const T& f) { return f; });
}

/// With u = F / lift-off force < 1 the slopes are 0.53 √(1+u) in the force and √(1+u) (1 - u/2) in the preload: rising.
inline Interval loaded_side_force(const Interval& force, const Interval& preload) {
  using namespace corner_bounds;
  if (force.lower < 0.0 || !all_positive(preload)) return loaded_side_force<Interval>(force, preload);
  return between_corners(
      [](const auto&... x) { return loaded_side_force<Interval>(x...); }, Rising{force}, Rising{preload});
}
template <int N>
Dual<Interval, N> loaded_side_force(const Dual<Interval, N>& force, const Dual<Interval, N>& preload) {
  return corner_bounds::with_value(loaded_side_force<Dual<Interval, N>>(force, preload),
                                   loaded_side_force(force.value, preload.value));
}

/// Load (N) of the other raceway pair; zero from lift-off on. [iso3408_5, section 7.1.3]
template <class T>
T unloaded_side_force(const T& force, const T& preload) {
  return larger(T(0.0), loaded_side_force(force, preload) - force);
}

/// Falling in the force, because the slope of the loaded side stays below 0.75; rising in the preload.
inline Interval unloaded_side_force(const Interval& force, const Interval& preload) {
  using namespace corner_bounds;
  if (force.lower < 0.0 || !all_positive(preload)) return unloaded_side_force<Interval>(force, preload);
  return between_corners(
      [](const auto&... x) { return unloaded_side_force<Interval>(x...); }, Falling{force}, Rising{preload});
}
template <int N>
Dual<Interval, N> unloaded_side_force(const Dual<Interval, N>& force, const Dual<Interval, N>& preload) {
  return corner_bounds::with_value(unloaded_side_force<Dual<Interval, N>>(force, preload),
                                   unloaded_side_force(force.value, preload.value));
}

/// Preload (N) that keeps the nut free of play up to a force. [iso3408_5, section 7.1.3; thk_catalogue, preload]
template <class T>
T required_preload(const T& largest_force) {
  return largest_force / (2.0 * std::sqrt(2.0));
}

/// Life in revolutions that 90 % reach. The load factor (1.0 smooth to 3.5 shock) is a vendors' practice; the standard
/// has none. [iso3408_5, section 7.2; thk_catalogue, nominal life]
template <class T>
T life_revolutions(const T& dynamic_load_rating, const T& mean_load, const T& load_factor) {
  return 1e6 * cube(dynamic_load_rating / (load_factor * mean_load));
}

/// Life in revolutions of two raceway pairs (or load directions) together. [iso3408_5, section 7.2.3]
template <class T>
T combined_life(const T& first_life, const T& second_life) {
  return pow(pow(first_life, -10.0 / 9.0) + pow(second_life, -10.0 / 9.0), -9.0 / 10.0);
}

/// Life in time (s) at the mean speed of the whole cycle. [millwright_derivations]
template <class T>
T life_time(const T& life_revolutions, const T& mean_speed) {
  return 2.0 * pi<T>() * life_revolutions / mean_speed;
}

/// Life in travel (m). [millwright_derivations]
template <class T>
T life_distance(const T& life_revolutions, const T& lead) {
  return life_revolutions * lead;
}

/// Life in revolutions for another reliability than 90 % (95 %: factor 0.62, 99 %: 0.21). [iso3408_5, section 7.2.4]
template <class T>
T reliable_life(const T& life_revolutions, const T& reliability_factor) {
  watch_validity<T>("ball_screw.reliable_life", life_revolutions, reliability_factor);
  return reliability_factor * life_revolutions;
}

/// Dynamic load rating (N) that a life in revolutions takes; inversion of life_revolutions. [iso3408_5, section 7.2]
template <class T>
T required_dynamic_load_rating(const T& mean_load,
                               const T& load_factor,
                               const T& life_revolutions,
                               const T& reliability_factor) {
  watch_validity<T>(
      "ball_screw.required_dynamic_load_rating", mean_load, load_factor, life_revolutions, reliability_factor);
  return load_factor * mean_load * cbrt(life_revolutions / (1e6 * reliability_factor));
}

/// Dynamic load rating (N) corrected for hardness, accuracy grade and melting process. Ratings of rolled screws often
/// include the accuracy factor already. [iso3408_5, clause 6]
template <class T>
T modified_dynamic_load_rating(const T& dynamic_load_rating,
                               const T& hardness_factor,
                               const T& accuracy_factor,
                               const T& melting_factor) {
  watch_validity<T>(
      "ball_screw.modified_dynamic_load_rating", dynamic_load_rating, hardness_factor, accuracy_factor, melting_factor);
  return hardness_factor * accuracy_factor * melting_factor * dynamic_load_rating;
}

/// Static safety against the largest force, shock and preload included. [thk_catalogue, static safety factor]
template <class T>
T static_safety(const T& static_load_rating, const T& largest_force) {
  return static_load_rating / largest_force;
}

/// Efficiency while driving the load, with the equivalent rolling friction (0.003 to 0.01, not a sliding one).
/// [thk_catalogue, efficiency; iso3408_5]
template <class T>
T efficiency(const T& friction, const T& lead_angle) {
  watch_validity<T>("ball_screw.efficiency", friction, lead_angle);
  const T slope = named("tan λ", tan(lead_angle));
  return (1.0 - friction * slope) / (1.0 + friction / slope);
}

/// Efficiency while the load drives: ball screws do not lock. [thk_catalogue, efficiency; iso3408_5]
template <class T>
T reverse_efficiency(const T& friction, const T& lead_angle) {
  watch_validity<T>("ball_screw.reverse_efficiency", friction, lead_angle);
  const T slope = named("tan λ", tan(lead_angle));
  return (1.0 - friction / slope) / (1.0 + friction * slope);
}

/// Torque (N.m) to move against a force. [thk_catalogue, rotational torque]
template <class T>
T drive_torque(const T& force, const T& lead, const T& efficiency) {
  watch_validity<T>("ball_screw.drive_torque", force, lead, efficiency);
  return force * lead / (2.0 * pi<T>() * efficiency);
}

/// Torque (N.m) that holds a force which drives the screw. Of a self-locking thread, whose reverse efficiency is
/// negative, it is the torque to lower the load, with the other sign. [thk_catalogue, rotational torque;
/// khurmi_gupta2005, section 17.5]
template <class T>
T backdriving_torque(const T& force, const T& lead, const T& reverse_efficiency) {
  watch_validity<T>("ball_screw.backdriving_torque", force, lead, reverse_efficiency);
  return force * lead * reverse_efficiency / (2.0 * pi<T>());
}

/// Drag (N.m) of a preloaded nut, ± 40 %, without seals and bearings. [jis_b1192; thk_catalogue, preload torque]
template <class T>
T preload_torque(const T& preload, const T& lead, const T& lead_angle) {
  watch_validity<T>("ball_screw.preload_torque", preload, lead, lead_angle);
  const T coefficient = named("K", 0.05 / sqrt(tan(lead_angle)));
  return coefficient * preload * lead / (2.0 * pi<T>());
}

/// Ball pitch circle diameter times speed (m.rad/s), the "DN value" that catalogues give in mm times rpm.
/// [thk_catalogue, DN value]
template <class T>
T speed_value(const T& pitch_circle_diameter, const T& angular_speed) {
  return pitch_circle_diameter * angular_speed;
}

/// Permissible speed (rad/s) of the catalogues: 0.8 times the critical speed of a steel shaft with the root diameter.
/// The 0.8 is inside. [thk_catalogue, permissible rotational speed; hsk_ball_screw]
template <class T>
T permissible_speed(const T& eigenvalue, const T& root_diameter, const T& length) {
  return 0.8 * critical_speed::critical_speed(eigenvalue,
                                              root_diameter,
                                              length,
                                              in_unit<T>(2.06e11, dimension::pressure),
                                              in_unit<T>(7850.0, dimension::density));
}

/// Permissible load (N) of the catalogues: half the Euler load of a steel shaft with the root diameter. The half is
/// inside; short shafts: permissible_axial_load as well. [thk_catalogue, permissible axial load; hsk_ball_screw]
template <class T>
T permissible_buckling_load(const T& end_fixity, const T& root_diameter, const T& length) {
  return 0.5 * buckling::euler_load(end_fixity, in_unit<T>(2.06e11, dimension::pressure), root_diameter, length);
}

/// Permissible tension or compression (N) of the shaft, with a permissible stress of 147 N/mm² for hardened steel.
/// [thk_catalogue, permissible axial load]
template <class T>
T permissible_axial_load(const T& permissible_stress, const T& root_diameter) {
  return permissible_stress * pi<T>() * square(root_diameter) / 4.0;
}

/// Axial stiffness (N/m) of a nut without preload, from the catalogue's value at 30 % of the dynamic load rating.
/// [thk_catalogue, axial rigidity]
template <class T>
T nut_stiffness(const T& catalogue_stiffness, const T& force, const T& dynamic_load_rating) {
  return 0.8 * catalogue_stiffness * cbrt(force / (0.3 * dynamic_load_rating));
}

/// Deflection (m) of a nut without preload under an axial load: the load over nut_stiffness, in one power of the load.
/// [thk_catalogue, axial rigidity]
template <class T>
T nut_deflection(const T& catalogue_stiffness, const T& force, const T& dynamic_load_rating) {
  return square(cbrt(force)) * cbrt(0.3 * dynamic_load_rating) / (0.8 * catalogue_stiffness);
}

/// Axial stiffness (N/m) of a preloaded nut, from the catalogue's value at a preload of 10 % of the dynamic load
/// rating. [thk_catalogue, axial rigidity]
template <class T>
T preloaded_nut_stiffness(const T& catalogue_stiffness, const T& preload, const T& dynamic_load_rating) {
  return 0.8 * catalogue_stiffness * cbrt(preload / (0.1 * dynamic_load_rating));
}

/// Axial stiffness (N/m) of a preloaded pair of angular-contact bearings. [thk_catalogue, axial rigidity]
template <class T>
T bearing_stiffness(const T& bearing_preload, const T& preload_displacement) {
  return 3.0 * bearing_preload / preload_displacement;
}

/// Axial stiffness (N/m) of shaft, nut, bearing and bracket in series. [thk_catalogue, axial rigidity]
template <class T>
T chain_stiffness(std::span<const T> stiffnesses) {
  return series_stiffness(stiffnesses);
}

/// Elastic deflection (m) under a force. [millwright_derivations]
template <class T>
T elastic_error(const T& force, const T& stiffness) {
  return force / stiffness;
}

/// Reversal error (m): the friction changes sign, and the play is crossed. [millwright_derivations]
template <class T>
T lost_motion(const T& friction_force, const T& stiffness, const T& backlash) {
  return 2.0 * friction_force / stiffness + backlash;
}

/// Travel error (m, plus or minus) of a transport screw from its permitted variation in 300 mm. [iso3408_3]
template <class T>
T transport_travel_error(const T& travel_variation, const T& useful_travel) {
  return 2.0 * travel_variation * useful_travel / in_unit<T>(0.3, dimension::length);
}

/// Tension (N) of a shaft stretched by what a rise of temperature (K) would lengthen it. [millwright_derivations]
template <class T>
T pretension_force(const T& elastic_modulus,
                   const T& root_diameter,
                   const T& thermal_expansion,
                   const T& temperature_rise) {
  return elastic_modulus * pi<T>() * square(root_diameter) / 4.0 * thermal_expansion * temperature_rise;
}

/// Heat (W) of the friction torque. [millwright_derivations]
template <class T>
T friction_heat(const T& friction_torque, const T& angular_speed) {
  return friction_torque * angular_speed;
}

}  // namespace millwright::mechanics::ball_screw
