// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scalar/elementary.h"

/// Stress and twist of cross sections. Everything in SI.
/// Valid, besides what a formula says: sharp corners, homogeneous section.
namespace millwright::mechanics::section {

using namespace scalar;

/// Bending stress at the extreme fibre (Pa). Valid: linear elastic, away from where the load enters. [khurmi_gupta2005,
/// chapter 5]
template <class T>
T bending_stress(const T& moment, const T& second_moment_of_area, const T& fibre_distance) {
  return moment * fibre_distance / second_moment_of_area;
}

/// Shear stress at the surface of a round bar in torsion (Pa). Valid: linear elastic, away from where the load enters.
/// [khurmi_gupta2005, chapter 5]
template <class T>
T round_torsional_stress(const T& torque, const T& diameter) {
  return 16.0 * torque / (pi<T>() * cube(diameter));
}

/// Shear stress in the wall of a closed thin-walled tube in torsion (Pa). Valid: linear elastic, wall thin.
/// [khurmi_gupta2005, chapter 5]
template <class T>
T thin_tube_torsional_stress(const T& torque, const T& enclosed_area, const T& wall_thickness) {
  return torque / (2.0 * enclosed_area * wall_thickness);
}

/// Twist of a bar in torsion (rad). Valid: linear elastic, free to warp. [khurmi_gupta2005, chapter 5]
template <class T>
T twist(const T& torque, const T& length, const T& shear_modulus, const T& torsion_constant) {
  return torque * length / (shear_modulus * torsion_constant);
}

/// Diameter from its square (m). [millwright_derivations, definition]
template <class T>
T diameter_of_square(const T& diameter_squared) {
  return sqrt(diameter_squared);
}

/// Direct stress (Pa). Valid: force through the centroid. [khurmi_gupta2005, chapter 4]
template <class T>
T direct_stress(const T& force, const T& area) {
  return force / area;
}

/// Direct stress in a round bar (Pa). Valid: force through the centroid. [khurmi_gupta2005, chapter 4]
template <class T>
T round_direct_stress(const T& force, const T& diameter) {
  return force / (pi<T>() / 4.0 * square(diameter));
}

/// What stands under the root of the principal stresses (Pa²). [torch_table, eq. 20; khurmi_gupta2005, chapter 5]
template <class T>
T stress_radicand(const T& normal_stress, const T& shear_stress) {
  return square(normal_stress) + 4.0 * square(shear_stress);
}

/// Root in the principal stresses, twice the maximum shear stress (Pa). [torch_table, eq. 20; khurmi_gupta2005, chapter
/// 5]
template <class T>
T stress_root(const T& normal_stress, const T& shear_stress) {
  return sqrt(stress_radicand(normal_stress, shear_stress));
}

/// Root in the principal stresses, from its radicand (Pa). [torch_table, eq. 20; khurmi_gupta2005, chapter 5]
template <class T>
T stress_of_radicand(const T& radicand) {
  return sqrt(radicand);
}

/// Bending stress from the section modulus (Pa). Valid: linear elastic. [khurmi_gupta2005, chapter 5]
template <class T>
T bending_stress_of_modulus(const T& moment, const T& section_modulus) {
  return moment / section_modulus;
}

/// Section modulus (m³). [khurmi_gupta2005, chapter 5]
template <class T>
T modulus(const T& second_moment_of_area, const T& fibre_distance) {
  return second_moment_of_area / fibre_distance;
}

}  // namespace millwright::mechanics::section
