// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Inertia and torque across a reduction; `ratio` is motor speed over output speed. Everything in SI.
namespace millwright::mechanics::transmission {

using namespace scalar;

/// Moment of inertia (kg.m²) of a hollow or solid cylinder about its axis. [millwright_derivations; sander, eq. 4.2]
template <class T>
T cylinder_inertia(const T& mass, const T& outer_diameter, const T& inner_diameter) {
  watch_validity<T>("transmission.cylinder_inertia", mass, outer_diameter, inner_diameter);
  return mass * (square(outer_diameter) + square(inner_diameter)) / 8.0;
}

/// Inertia (kg.m²) at the screw of the mass it moves. [oriental_motor_sizing; sander, eq. 4.2]
template <class T>
T screw_load_inertia(const T& mass, const T& lead) {
  return mass * square(lead / (2.0 * pi<T>()));
}

/// Inertia (kg.m²) at the pulley or pinion of the mass it moves. [oriental_motor_sizing]
template <class T>
T belt_load_inertia(const T& mass, const T& pitch_radius) {
  return mass * square(pitch_radius);
}

/// Inertia (kg.m²) of the output side as the motor feels it. [oriental_motor_sizing]
template <class T>
T reflected_inertia(const T& inertia, const T& ratio) {
  return inertia / square(ratio);
}

/// Motor torque (N.m) for an output torque, while the motor drives. [oriental_motor_sizing]
template <class T>
T motor_torque(const T& output_torque, const T& ratio, const T& efficiency) {
  watch_validity<T>("transmission.motor_torque", output_torque, ratio, efficiency);
  return output_torque / (ratio * efficiency);
}

/// Ratio that makes the largest output acceleration from a given motor torque, regardless of speed.
/// [millwright_derivations]
template <class T>
T optimal_ratio(const T& load_inertia, const T& motor_inertia, const T& load_torque, const T& motor_torque) {
  const T torque_ratio = load_torque / motor_torque;
  return torque_ratio + sqrt(square(torque_ratio) + load_inertia / motor_inertia);
}

/// Play of the output (m) from an angular play of the output shaft. [millwright_derivations]
template <class T>
T linear_backlash(const T& angular_backlash, const T& lead) {
  return angular_backlash * lead / (2.0 * pi<T>());
}

}  // namespace millwright::mechanics::transmission
