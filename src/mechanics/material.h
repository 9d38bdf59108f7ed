// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Strength of ductile metals: equivalent and allowable stresses, fatigue screening. Everything in SI.
namespace millwright::mechanics::material {

using namespace scalar;

/// Shear modulus (Pa) of an isotropic material. [shigley, section 3-8]
template <class T>
T shear_modulus(const T& elastic_modulus, const T& poisson_ratio) {
  watch_validity<T>("material.shear_modulus", elastic_modulus, poisson_ratio);
  return elastic_modulus / (2.0 * (1.0 + poisson_ratio));
}

/// Equivalent stress (Pa) of one normal and one shear stress after von Mises. [shigley, section 5-5]
template <class T>
T von_mises_stress(const T& normal_stress, const T& shear_stress) {
  return sqrt(square(normal_stress) + 3.0 * square(shear_stress));
}

/// Maximum shear stress (Pa); compare with half the yield strength over the safety factor.
/// [khurmi_gupta2005, chapter 5]
template <class T>
T maximum_shear_stress(const T& normal_stress, const T& shear_stress) {
  return 0.5 * sqrt(square(normal_stress) + 4.0 * square(shear_stress));
}

/// Maximum principal stress (Pa), the criterion for brittle materials. [khurmi_gupta2005, chapter 5]
template <class T>
T maximum_principal_stress(const T& normal_stress, const T& shear_stress) {
  return 0.5 * (normal_stress + sqrt(square(normal_stress) + 4.0 * square(shear_stress)));
}

/// Allowable stress (Pa) from the yield strength. [khurmi_gupta2005, chapter 4]
template <class T>
T allowable_stress(const T& yield_strength, const T& safety_factor) {
  return yield_strength / safety_factor;
}

/// Allowable shear stress (Pa) of shafts. Valid: material factor 5.6 (guaranteed strength) to 6.0, notch factor 1.3
/// to 3.0. [sularso_suga, chapter 1; mini_mill, eq. 1]
template <class T>
T sularso_allowable_shear_stress(const T& tensile_strength, const T& material_factor, const T& notch_factor) {
  watch_validity<T>("material.sularso_allowable_shear_stress", tensile_strength, material_factor, notch_factor);
  return tensile_strength / (material_factor * notch_factor);
}

/// Shear stress (Pa) at yield after von Mises. [shigley, section 5-5; torch_table, eq. 23]
template <class T>
T von_mises_shear_yield(const T& yield_strength) {
  return yield_strength / std::sqrt(3.0);
}

/// Shear stress (Pa) at yield after Tresca. [khurmi_gupta2005, chapter 5]
template <class T>
T tresca_shear_yield(const T& yield_strength) {
  return 0.5 * yield_strength;
}

/// Safety against yield of the largest equivalent stress. [khurmi_gupta2005, chapter 4]
template <class T>
T yield_safety(const T& largest_stress, const T& yield_strength) {
  return yield_strength / largest_stress;
}

/// Endurance limit (Pa) of steel in rotating bending, times the product of the modifying factors (surface, size, load,
/// reliability). [shigley, section 6-7]
template <class T>
T endurance_limit(const T& tensile_strength, const T& modifying_factor) {
  return modifying_factor * smaller(0.5 * tensile_strength, in_unit<T>(700e6, dimension::pressure));
}

/// Surface factor of the endurance limit, at most 1; coefficient and exponent for the strength in MPa (machined: 4.51
/// and -0.265). [shigley, table 6-2]
template <class T>
T surface_factor(const T& tensile_strength, const T& coefficient, const T& exponent) {
  watch_validity<T>("material.surface_factor", tensile_strength, coefficient, exponent);
  return smaller(T(1.0), coefficient * pow(tensile_strength / in_unit<T>(1e6, dimension::pressure), exponent));
}

/// Size factor of the endurance limit for bending and torsion, diameters 2.79 mm to 51 mm. [shigley, eq. 6-20]
template <class T>
T size_factor(const T& diameter) {
  watch_validity<T>("material.size_factor", diameter);
  return 1.24 * pow(diameter / in_unit<T>(1e-3, dimension::length), -0.107);
}

/// Fatigue notch factor, by which a stress amplitude is multiplied. [shigley, eq. 6-32]
template <class T>
T fatigue_notch_factor(const T& notch_sensitivity, const T& stress_concentration) {
  watch_validity<T>("material.fatigue_notch_factor", notch_sensitivity, stress_concentration);
  return 1.0 + notch_sensitivity * (stress_concentration - 1.0);
}

/// Safety against fatigue after Goodman for a mean stress in tension. [shigley, section 6-12]
template <class T>
T goodman_safety(const T& stress_amplitude, const T& mean_stress, const T& endurance_limit, const T& tensile_strength) {
  return 1.0 / (stress_amplitude / endurance_limit + mean_stress / tensile_strength);
}

}  // namespace millwright::mechanics::material
