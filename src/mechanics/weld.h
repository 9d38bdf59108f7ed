// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Fillet welds with equal legs, the load taken as shear on the throat. Everything in SI.
/// Valid, besides what a formula says: fillet weld with equal legs, stress even over the throat.
namespace millwright::mechanics::weld {

using namespace scalar;

/// Throat of an equal-leg fillet weld (m). [khurmi_gupta2005, chapter 10]
template <class T>
T throat(const T& leg_length) {
  return leg_length / std::sqrt(2.0);
}

/// Shear stress on the throat when the force is shared evenly (Pa). The length is the effective one, without start and
/// end. [khurmi_gupta2005, chapter 10]
template <class T>
T direct_stress(const T& force, const T& leg_length, const T& weld_length) {
  return force / (leg_length / std::sqrt(2.0) * weld_length);
}

/// Section modulus of a weld all around a rectangle (m³). [khurmi_gupta2005, Table 10.7]
template <class T>
T rectangle_section_modulus(const T& throat, const T& width, const T& height) {
  return throat * (width * height + square(height) / 3.0);
}

/// Polar moment of a weld all around a rectangle (m⁴). [khurmi_gupta2005, Table 10.7]
template <class T>
T rectangle_polar_moment(const T& throat, const T& width, const T& height) {
  return throat * cube(width + height) / 6.0;
}

/// Polar moment of two parallel welds (m⁴). [khurmi_gupta2005, chapter 10]
template <class T>
T parallel_polar_moment(const T& throat, const T& weld_length, const T& weld_distance) {
  return 2.0 * throat * weld_length * (square(weld_length) / 12.0 + square(weld_distance) / 4.0);
}

/// Equivalent stress on the throat (Pa): direct and torsional parts added, bending square to them; to be compared with
/// the shear allowable. Valid: safe side. [shigley, chapter 9]
template <class T>
T combined_stress(const T& direct_stress, const T& bending_stress, const T& torsional_stress) {
  return sqrt(square(direct_stress + torsional_stress) + square(bending_stress));
}

/// Shear stress at the worst corner of two parallel welds under an in-plane force square to the welds and off their
/// centroid (Pa). [bhandari, example 8.9]
template <class T>
T eccentric_stress(
    const T& force, const T& eccentricity, const T& throat, const T& weld_length, const T& weld_distance) {
  const T direct = named("τ_1", force / (2.0 * weld_length * throat));
  const T radius = named("r", sqrt(square(weld_length) + square(weld_distance)) / 2.0);
  const T torsional =
      named("τ_2", force * eccentricity * radius / parallel_polar_moment(throat, weld_length, weld_distance));
  return sqrt(square(direct + torsional * (weld_length / 2.0) / radius) +
              square(torsional * (weld_distance / 2.0) / radius));
}

/// Allowable stress on the throat from the strength of the electrode (Pa): 0.30 of the tensile strength in shear. (One
/// paper takes 0.60, the share for tension.) [shigley, chapter 9]
template <class T>
T allowable_stress(const T& electrode_strength, const T& fraction) {
  watch_validity<T>("weld.allowable_stress", electrode_strength, fraction);
  return electrode_strength * fraction;
}

}  // namespace millwright::mechanics::weld
