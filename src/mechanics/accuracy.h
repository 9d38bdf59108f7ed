// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/stepper_sizing.h"
#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Resolution and error budget of an axis. Everything in SI.
namespace millwright::mechanics::accuracy {

using namespace scalar;

/// Travel per microstep (m). Valid: rigid drive. [sander]
template <class T>
T linear_resolution(const T& lead, const T& full_steps, const T& microsteps, const T& ratio) {
  return lead / (full_steps * microsteps * ratio);
}

/// Position error of a stepper axis under load (m); it turns round with the sign of friction. Valid: load torque at
/// most the static torque. [millwright_derivations, definition]
template <class T>
T load_lag(const T& load_torque, const T& static_torque, const T& rotor_teeth, const T& lead) {
  watch_validity<T>("accuracy.load_lag", load_torque, static_torque, rotor_teeth, lead);
  return lead / (2.0 * pi<T>()) * stepper::load_angle(load_torque, static_torque, rotor_teeth);
}

/// Error from an angular error under an offset between scale and tool (m). Valid: small angles. [slocum1992, chapter 2]
template <class T>
T abbe_error(const T& angular_error, const T& offset) {
  return angular_error * offset;
}

/// Sum of the error magnitudes (m): the worst case. Valid: small errors. [slocum1992, chapter 2]
template <class T>
T worst_case_error(std::span<const T> errors) {
  return sum_of(errors.size(), [&](std::size_t n) { return absolute(errors[n]); });
}

/// Root of the sum of squares of independent random errors (m). Valid: small independent errors of similar size.
/// [slocum1992, chapter 2]
template <class T>
T root_sum_square_error(std::span<const T> errors) {
  return sqrt(sum_of(errors.size(), [&](std::size_t n) { return square(errors[n]); }));
}

/// Systematic errors added, random ones by root of sum of squares (m). Valid: small errors. [slocum1992, chapter 2]
template <class T>
T mixed_error(std::span<const T> systematic_errors, std::span<const T> random_errors) {
  return worst_case_error(systematic_errors) + root_sum_square_error(random_errors);
}

}  // namespace millwright::mechanics::accuracy
