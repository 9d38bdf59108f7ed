// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Rack and pinion, spur teeth with 20 degrees pressure angle, full depth. Everything in SI.
namespace millwright::mechanics::rack {

using namespace scalar;

/// Pitch diameter (m) of the pinion. [khurmi_gupta2005, chapter 28]
template <class T>
T pitch_diameter(const T& module, const T& teeth) {
  return module * teeth;
}

/// Tangential force (N) of the pinion. [khurmi_gupta2005, chapter 28]
template <class T>
T tangential_force(const T& torque, const T& pitch_diameter) {
  return 2.0 * torque / pitch_diameter;
}

/// Form factor of the Lewis equation with the module (π times the tooth form factor y). [khurmi_gupta2005, chapter 28]
template <class T>
T lewis_form_factor(const T& teeth) {
  watch_validity<T>("rack.lewis_form_factor", teeth);
  return pi<T>() * (0.154 - 0.912 / teeth);
}

/// Bending stress (Pa) at the root of a tooth after Lewis, for screening. [khurmi_gupta2005, chapter 28]
template <class T>
T lewis_stress(const T& tangential_force, const T& face_width, const T& module, const T& form_factor) {
  return tangential_force / (face_width * module * form_factor);
}

/// Share of the allowable static stress that a moving tooth may bear, commercially cut, at a pitch line speed (m/s);
/// the 3 is a speed. Valid: up to 12.5 m/s. [khurmi_gupta2005, chapter 28]
template <class T>
T velocity_factor(const T& speed) {
  watch_validity<T>("rack.velocity_factor", speed);
  const T three = in_unit<T>(3.0, dimension::speed);
  return three / (three + speed);
}

}  // namespace millwright::mechanics::rack
