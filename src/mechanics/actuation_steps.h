// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// The single steps of a drive calculation as handbooks and papers write them, where actuation.h has the whole in one
/// formula. Everything in SI.
/// Valid, besides what a formula says: rigid axis; elastic parts count in the stiffness chain.
namespace millwright::mechanics::actuation {

using namespace scalar;

/// Weight (N). Gravity is an argument because sources use 9.8, 9.81 and 10 m/s². [millwright_derivations, definition]
template <class T>
T weight(const T& mass, const T& gravity) {
  return mass * gravity;
}

/// Force that accelerates a mass (N). [millwright_derivations, definition]
template <class T>
T force_of_acceleration(const T& mass, const T& acceleration) {
  return mass * acceleration;
}

/// Torque, or bending moment, of a force on a lever arm (N·m). [millwright_derivations, definition]
template <class T>
T lever_torque(const T& force, const T& lever_arm) {
  return force * lever_arm;
}

/// Torque on a loss-free screw that overcomes the guide friction of a horizontal axis (N·m). Valid: horizontal axis,
/// loss-free screw. [sander, eq. 18]
template <class T>
T friction_torque(const T& friction, const T& mass, const T& gravity, const T& lead) {
  watch_validity<T>("actuation.friction_torque", friction, mass, gravity, lead);
  return friction * mass * gravity * lead / (2.0 * pi<T>());
}

/// Load torque at the motor through a gear (N·m). [sander, eq. 19]
template <class T>
T geared_load_torque(const T& screw_torque, const T& gear_ratio, const T& efficiency) {
  watch_validity<T>("actuation.geared_load_torque", screw_torque, gear_ratio, efficiency);
  return gear_ratio / efficiency * screw_torque;
}

/// Motor speed of a screw axis behind a gear (rad/s). [sander, eq. 20; mini_mill, eq. 15]
template <class T>
T geared_motor_speed(const T& speed, const T& lead, const T& gear_ratio) {
  return 2.0 * pi<T>() * speed / (lead * gear_ratio);
}

/// Inertia at the screw of the moved mass and the screw itself (kg·m²). [sander, eq. 16]
template <class T>
T screw_load_inertia(const T& mass, const T& lead, const T& screw_inertia) {
  return mass * square(lead / (2.0 * pi<T>())) + screw_inertia;
}

/// Load inertia at the motor through a gear (kg·m²). [sander, eq. 17]
template <class T>
T geared_load_inertia(const T& gear_ratio,
                      const T& screw_side_inertia,
                      const T& driven_gear_inertia,
                      const T& driving_gear_inertia) {
  return square(gear_ratio) * (screw_side_inertia + driven_gear_inertia) + driving_gear_inertia;
}

/// Mass times sum of the squared diameters, eight times the inertia of a hollow cylinder (kg·m²). [sander, eq. 9]
template <class T>
T flywheel_effect(const T& mass, const T& outer_diameter, const T& inner_diameter) {
  return mass * (square(outer_diameter) + square(inner_diameter));
}

/// Time of a stroke with equal ramps at both ends (s). Valid: stroke at least speed times ramp time. [sander, eq. 14;
/// millwright_derivations, definition]
template <class T>
T stroke_time(const T& distance, const T& speed, const T& acceleration_time) {
  watch_validity<T>("actuation.stroke_time", distance, speed, acceleration_time);
  return distance / speed + acceleration_time;
}

/// Angular acceleration of an even ramp from standstill (rad/s²). [millwright_derivations, definition]
template <class T>
T angular_acceleration(const T& angular_speed, const T& acceleration_time) {
  return angular_speed / acceleration_time;
}

/// Inertia the motor torque has to accelerate, the load through the transmission (kg·m²). [sander, eq. 23]
template <class T>
T accelerated_inertia(const T& rotor_inertia, const T& load_inertia, const T& efficiency) {
  watch_validity<T>("actuation.accelerated_inertia", rotor_inertia, load_inertia, efficiency);
  return rotor_inertia + load_inertia / efficiency;
}

/// Torque that accelerates an inertia (N·m). [millwright_derivations, definition]
template <class T>
T inertia_torque(const T& inertia, const T& angular_acceleration) {
  return inertia * angular_acceleration;
}

/// Mean of the squared torque over a cycle (N²·m²). [sander, eq. 25]
template <class T>
T mean_square_torque(std::span<const T> torques, std::span<const T> durations) {
  const std::size_t count = common_length(torques, durations);
  const T heating = sum_of(count, [&](std::size_t i) { return square(torques[i]) * durations[i]; });
  return heating / sum_of(count, [&](std::size_t i) { return durations[i]; });
}

/// Effective torque from the mean of its square (N·m). [sander, eq. 25]
template <class T>
T torque_of_mean_square(const T& mean_square) {
  return sqrt(mean_square);
}

/// Electrical power of a direct current (W). [millwright_derivations, definition]
template <class T>
T electrical_power(const T& voltage, const T& current) {
  return voltage * current;
}

/// Speed at the circumference (m/s). [millwright_derivations, definition]
template <class T>
T peripheral_speed(const T& angular_speed, const T& radius) {
  return angular_speed * radius;
}

}  // namespace millwright::mechanics::actuation
