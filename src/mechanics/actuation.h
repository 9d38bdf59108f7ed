// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// What an axis asks of its motor: moved mass, force, inertia, torque, power. Everything in SI.
/// Valid, besides what a formula says: rigid axis; elastic parts count in the stiffness chain.
namespace millwright::mechanics::actuation {

using namespace scalar;

/// Mass that an axis moves (kg): its own moving parts, every axis it carries, and the payload. [sander, 4.2]
template <class T>
T stacked_mass(std::span<const T> own_masses, const T& payload) {
  return sum_of(own_masses.size(), [&](std::size_t n) { return own_masses[n]; }) + payload;
}

/// Force of gravity along an inclined axis after the counterbalance, at standard gravity (N). [sander, 4.2]
template <class T>
T gravity_force(const T& mass, const T& inclination, const T& counterbalance_force) {
  watch_validity<T>("actuation.gravity_force", mass, inclination, counterbalance_force);
  return mass * in_unit<T>(9.80665, dimension::acceleration) * sin(inclination) - counterbalance_force;
}

/// Force the drive has to exert in one phase of the motion (N). [sander, 4.2]
template <class T>
T axial_force(const T& mass,
              const T& acceleration,
              const T& gravity_force,
              const T& friction_force,
              const T& direction,
              const T& process_force) {
  watch_validity<T>(
      "actuation.axial_force", mass, acceleration, gravity_force, friction_force, direction, process_force);
  return mass * acceleration + gravity_force + friction_force * direction + process_force;
}

/// All inertia at the motor of a screw axis, moved mass included (kg·m²). [sander, 4.2]
template <class T>
T screw_axis_inertia(const T& rotor_inertia,
                     const T& motor_side_inertia,
                     const T& output_side_inertia,
                     const T& mass,
                     const T& lead,
                     const T& ratio) {
  return rotor_inertia + motor_side_inertia +
         (output_side_inertia + mass * square(lead / (2.0 * pi<T>()))) / square(ratio);
}

/// All inertia at the motor of a belt axis, moved mass included (kg·m²). [sander, 4.2]
template <class T>
T belt_axis_inertia(const T& rotor_inertia,
                    const T& motor_side_inertia,
                    const T& pulley_inertia,
                    const T& mass,
                    const T& pitch_radius,
                    const T& ratio) {
  return rotor_inertia + motor_side_inertia + (pulley_inertia + mass * square(pitch_radius)) / square(ratio);
}

/// Motor torque of a screw axis (N·m). The force acts along the motion, positive against it, and holds the acceleration
/// of the moved mass; the rotating inertia therefore excludes it. A self-locking screw (negative reverse efficiency)
/// has to be driven down: an assisting force then asks for a positive torque. [sander, 4.2]
template <class T>
T screw_motor_torque(const T& force,
                     const T& lead,
                     const T& efficiency,
                     const T& reverse_efficiency,
                     const T& rotating_inertia,
                     const T& angular_acceleration,
                     const T& drag_torque,
                     const T& ratio,
                     const T& reducer_efficiency) {
  watch_validity<T>("actuation.screw_motor_torque",
                    force,
                    lead,
                    efficiency,
                    reverse_efficiency,
                    rotating_inertia,
                    angular_acceleration,
                    drag_torque,
                    ratio,
                    reducer_efficiency);
  const T per_turn = named("l_i", lead / (2.0 * pi<T>() * ratio));
  const auto driven = [&](const T& opposing) -> T { return opposing * per_turn / (efficiency * reducer_efficiency); };
  const auto driving = [&](const T& assisting) -> T {
    return where_below(
        reverse_efficiency,
        T(0.0),
        [&](const T& locking) -> T { return assisting * per_turn * locking / reducer_efficiency; },
        [&](const T& yielding) -> T { return assisting * per_turn * yielding * reducer_efficiency; });
  };
  return where_below(force, T(0.0), driving, driven) + rotating_inertia * angular_acceleration + drag_torque;
}

/// Motor torque of a belt axis (N·m). The force acts along the motion, positive against it, and holds the acceleration
/// of the moved mass. [sander, 4.2]
template <class T>
T belt_motor_torque(const T& force,
                    const T& pitch_radius,
                    const T& efficiency,
                    const T& rotating_inertia,
                    const T& angular_acceleration,
                    const T& drag_torque,
                    const T& ratio) {
  watch_validity<T>("actuation.belt_motor_torque",
                    force,
                    pitch_radius,
                    efficiency,
                    rotating_inertia,
                    angular_acceleration,
                    drag_torque,
                    ratio);
  const auto driven = [&](const T& opposing) -> T { return opposing * pitch_radius / (ratio * efficiency); };
  const auto driving = [&](const T& assisting) -> T { return assisting * pitch_radius * efficiency / ratio; };
  return where_below(force, T(0.0), driving, driven) + rotating_inertia * angular_acceleration + drag_torque;
}

/// Torque with which gravity drives the unpowered motor (N·m); 0 if friction or self-locking holds the axis. [sander,
/// 4.2]
template <class T>
T backdriving_torque(
    const T& gravity_force, const T& lead, const T& reverse_efficiency, const T& friction_force, const T& ratio) {
  watch_validity<T>("actuation.backdriving_torque", gravity_force, lead, reverse_efficiency, friction_force, ratio);
  return larger(gravity_force - friction_force, T(0.0)) * lead * larger(reverse_efficiency, T(0.0)) /
         (2.0 * pi<T>() * ratio);
}

/// Required torque over the permitted share of the available torque at the same speed: 0.7 of pull-out, 0.8 of holding
/// torque. [oriental_motor_sizing; sander, eq. 22]
template <class T>
T torque_utilisation(const T& required_torque, const T& available_torque, const T& permitted_fraction) {
  watch_validity<T>("actuation.torque_utilisation", required_torque, available_torque, permitted_fraction);
  return required_torque / (permitted_fraction * available_torque);
}

/// Mechanical power of a shaft (W). [sander, 4.2]
template <class T>
T power(const T& torque, const T& angular_speed) {
  return torque * angular_speed;
}

/// Work of the motor shaft over a cycle (J); braking energy counts as lost. [sander, 4.2]
template <class T>
T cycle_energy(std::span<const T> torques, std::span<const T> angular_speeds, std::span<const T> durations) {
  return sum_of(common_length(torques, angular_speeds, durations),
                [&](std::size_t n) { return larger(torques[n] * angular_speeds[n], T(0.0)) * durations[n]; });
}

/// Kinetic energy of an axis, referred to the motor (J). [sander, 4.2]
template <class T>
T kinetic_energy(const T& inertia, const T& angular_speed) {
  return 0.5 * inertia * square(angular_speed);
}

}  // namespace millwright::mechanics::actuation
