// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Timing belts after Sularso and Suga; belt has the general formulas. Everything in SI.
namespace millwright::mechanics::timing_belt {

using namespace scalar;

/// Power a belt transmits at its allowable tension (W). The constant 0.6984e-6 of older handbooks (mm, r/min, kgf) is
/// this in metric horsepower. Valid: centrifugal below allowable tension. [sularso_suga, chapter 5; fdm_printer, eq.
/// 20]
template <class T>
T transmissible_power(const T& pitch_diameter,
                      const T& angular_speed,
                      const T& allowable_tension,
                      const T& centrifugal_tension) {
  watch_validity<T>(
      "timing_belt.transmissible_power", pitch_diameter, angular_speed, allowable_tension, centrifugal_tension);
  return pitch_diameter / 2.0 * angular_speed * (allowable_tension - centrifugal_tension);
}

/// Mass per length of a belt (kg/m). [fdm_printer, eq. 18]
template <class T>
T mass_per_length(const T& mass, const T& length) {
  return mass / length;
}

/// Length of a belt in pitches. Valid: approximation for a centre distance well above the pulley diameters.
/// [sularso_suga, chapter 5]
template <class T>
T length_in_pitches(const T& driving_teeth, const T& driven_teeth, const T& centre_distance_in_pitches) {
  watch_validity<T>("timing_belt.length_in_pitches", driving_teeth, driven_teeth, centre_distance_in_pitches);
  return (driving_teeth + driven_teeth) / 2.0 + 2.0 * centre_distance_in_pitches +
         square((driven_teeth - driving_teeth) / (2.0 * pi<T>())) / centre_distance_in_pitches;
}

}  // namespace millwright::mechanics::timing_belt
