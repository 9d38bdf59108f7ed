// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "mechanics/sums.h"
#include "scalar/elementary.h"

/// Shaft couplings and torsion of the drive line: rigid bodies, linear elastic torsion. Everything in SI.
namespace millwright::mechanics::coupling {

using namespace scalar;

/// Torque (N.m) a coupling has to be rated for: the load's share of the motor's peak torque while accelerating, times
/// the shock factor (uniform 1.5, reversing and stepper 2). [ktr_couplings]
template <class T>
T required_torque(const T& peak_torque, const T& motor_inertia, const T& load_inertia, const T& shock_factor) {
  return shock_factor * peak_torque / (motor_inertia / load_inertia + 1.0);
}

/// Twist (rad) of a coupling. [millwright_derivations]
template <class T>
T windup(const T& torque, const T& torsional_stiffness) {
  return torque / torsional_stiffness;
}

/// Torsional stiffness (N.m/rad) of elements in series, all referred to the same shaft. [millwright_derivations]
template <class T>
T series_stiffness(std::span<const T> torsional_stiffnesses) {
  return mechanics::series_stiffness(torsional_stiffnesses);
}

/// Torsional stiffness (N.m/rad) of a round solid shaft. [khurmi_gupta2005, chapter 5]
template <class T>
T shaft_torsional_stiffness(const T& shear_modulus, const T& diameter, const T& length) {
  return pi<T>() * shear_modulus * square(square(diameter)) / (32.0 * length);
}

/// Frequency (Hz) at which motor and load swing against each other on the coupling. [millwright_derivations]
template <class T>
T resonant_frequency(const T& torsional_stiffness, const T& motor_inertia, const T& load_inertia) {
  return sqrt(torsional_stiffness * (1.0 / motor_inertia + 1.0 / load_inertia)) / (2.0 * pi<T>());
}

}  // namespace millwright::mechanics::coupling
