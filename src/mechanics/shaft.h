// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Solid round shafts in bending and torsion. Everything in SI.
/// Valid, besides what a formula says: solid round shaft, steady rotation.
namespace millwright::mechanics::shaft {

using namespace scalar;

/// Diameter for a bending moment (m). [khurmi_gupta2005, 14.5]
template <class T>
T required_diameter_bending(const T& moment, const T& allowable_bending_stress) {
  return cbrt(32.0 * moment / (pi<T>() * allowable_bending_stress));
}

/// Diameter for bending and torsion by the largest shear stress (m). Shock factors, bending and torsion: steady 1.5 and
/// 1, light shock 1.5 to 2 and 1 to 1.5, heavy 2 to 3 and 1.5 to 3. [khurmi_gupta2005, 14.9, 14.11; sularso_suga,
/// chapter 1]
template <class T>
T required_diameter_maximum_shear(const T& moment,
                                  const T& torque,
                                  const T& bending_factor,
                                  const T& torsion_factor,
                                  const T& allowable_shear_stress) {
  watch_validity<T>(
      "shaft.required_diameter_maximum_shear", moment, torque, bending_factor, torsion_factor, allowable_shear_stress);
  return cbrt(16.0 / (pi<T>() * allowable_shear_stress) *
              sqrt(square(bending_factor * moment) + square(torsion_factor * torque)));
}

/// Diameter for bending and torsion by the distortion energy (m). [khurmi_gupta2005, chapter 14]
template <class T>
T required_diameter_von_mises(
    const T& moment, const T& torque, const T& bending_factor, const T& torsion_factor, const T& allowable_stress) {
  watch_validity<T>(
      "shaft.required_diameter_von_mises", moment, torque, bending_factor, torsion_factor, allowable_stress);
  return cbrt(32.0 / (pi<T>() * allowable_stress) *
              sqrt(square(bending_factor * moment) + 0.75 * square(torsion_factor * torque)));
}

/// Diameter for torsion with bending not yet known, allowed for by a factor of 1.2 to 2.3 (m). The source writes 5.1
/// for 16/π. [sularso_suga, chapter 1]
template <class T>
T required_diameter_torsion(const T& torque,
                            const T& torsion_factor,
                            const T& bending_allowance,
                            const T& allowable_shear_stress) {
  watch_validity<T>(
      "shaft.required_diameter_torsion", torque, torsion_factor, bending_allowance, allowable_shear_stress);
  return cbrt(16.0 / pi<T>() * torsion_factor * bending_allowance * torque / allowable_shear_stress);
}

/// Diameter for a permitted twist (0.25 to 0.30° per metre) (m). [khurmi_gupta2005, chapter 14]
template <class T>
T required_diameter_twist(const T& torque, const T& length, const T& shear_modulus, const T& permitted_twist) {
  return pow(32.0 * torque * length / (pi<T>() * shear_modulus * permitted_twist), 0.25);
}

/// Torque of a shaft from its power (N·m). The constant 9.74e5 of older handbooks (kW, r/min, kgf·mm) is this.
/// [sularso_suga, chapter 1; mini_mill, eq. 18]
template <class T>
T torque_of_power(const T& power, const T& angular_speed) {
  return power / angular_speed;
}

/// Twist of a solid round shaft (rad). The constant 584 of older handbooks is 32 · 180 / π². Valid: linear elastic.
/// [sularso_suga, chapter 1; mini_mill, eq. 19]
template <class T>
T twist(const T& torque, const T& length, const T& shear_modulus, const T& diameter) {
  return 32.0 * torque * length / (pi<T>() * shear_modulus * pow(diameter, 4.0));
}

/// Bending moment that a solid round shaft bears per cube of its diameter (Pa). [torch_table, eq. 14]
template <class T>
T bending_constant(const T& bending_stress) {
  return pi<T>() * bending_stress / 32.0;
}

/// Cube of the diameter of a shaft in bending (m³). [torch_table, eq. 14]
template <class T>
T diameter_cubed(const T& moment, const T& bending_constant) {
  return moment / bending_constant;
}

/// Diameter from its cube (m). [millwright_derivations, definition]
template <class T>
T diameter_of_cube(const T& diameter_cubed) {
  return cbrt(diameter_cubed);
}

}  // namespace millwright::mechanics::shaft
