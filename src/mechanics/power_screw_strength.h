// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/material.h"
#include "mechanics/power_screw.h"
#include "mechanics/validity_watch.h"

/// The strength part of namespace power_screw: stresses in the core, the thread and the nut, and wear. The load is
/// shared equally by the engaged turns, at most 10 of them. Turns are counted by the pitch, also on multi-start
/// screws. Everything in SI.
namespace millwright::mechanics::power_screw {

/// Normal stress in the core (Pa). [khurmi_gupta2005, section 17.13]
template <class T>
T axial_stress(const T& force, const T& core_diameter) {
  return 4.0 * force / (pi<T>() * square(core_diameter));
}

/// Shear stress in the core (Pa) from the torque that passes through it. [khurmi_gupta2005, section 17.13]
template <class T>
T torsional_stress(const T& torque, const T& core_diameter) {
  return 16.0 * torque / (pi<T>() * cube(core_diameter));
}

/// Maximum shear stress in the core (Pa), theory of Guest and Tresca. [khurmi_gupta2005, section 17.13]
template <class T>
T maximum_shear_stress(const T& force, const T& torque, const T& core_diameter) {
  return material::maximum_shear_stress(named("σ", axial_stress(force, core_diameter)),
                                        named("τ", torsional_stress(torque, core_diameter)));
}

/// Maximum principal stress in the core (Pa); no yield criterion for ductile metals. [khurmi_gupta2005, chapter 5]
template <class T>
T maximum_principal_stress(const T& force, const T& torque, const T& core_diameter) {
  return material::maximum_principal_stress(named("σ", axial_stress(force, core_diameter)),
                                            named("τ", torsional_stress(torque, core_diameter)));
}

/// Equivalent stress in the core (Pa) after von Mises, the criterion for ductile metals. [shigley, section 5-5]
template <class T>
T von_mises_stress(const T& force, const T& torque, const T& core_diameter) {
  return material::von_mises_stress(named("σ", axial_stress(force, core_diameter)),
                                    named("τ", torsional_stress(torque, core_diameter)));
}

/// Core diameter (m) that carries the force without torsion. [khurmi_gupta2005, section 17.13; torch_table, eq. 15]
template <class T>
T required_core_diameter(const T& force, const T& safety_factor, const T& yield_strength) {
  return sqrt(4.0 * force * safety_factor / (pi<T>() * yield_strength));
}

/// Number of turns in engagement. [khurmi_gupta2005, section 17.13]
template <class T>
T engaged_turns(const T& nut_height, const T& pitch) {
  return nut_height / pitch;
}

/// Pressure between the threads of screw and nut (Pa). [khurmi_gupta2005, section 17.13; bhandari, section 6.5]
template <class T>
T bearing_pressure(const T& force, const T& mean_diameter, const T& thread_depth, const T& engaged_turns) {
  return force / (pi<T>() * mean_diameter * thread_depth * engaged_turns);
}

/// Nut height (m) that keeps the bearing pressure allowable. [khurmi_gupta2005, section 17.13]
template <class T>
T required_nut_height(
    const T& force, const T& mean_diameter, const T& thread_depth, const T& pitch, const T& allowable_pressure) {
  return force * pitch / (pi<T>() * mean_diameter * thread_depth * allowable_pressure);
}

/// Thickness (m) of the thread at the root of the screw (root diameter = core) or nut (= major diameter); half a pitch
/// at the mean diameter and growing with the flank angle from there. [millwright_derivations]
template <class T>
T thread_root_thickness(const T& pitch, const T& flank_angle, const T& mean_diameter, const T& root_diameter) {
  watch_validity<T>("power_screw.thread_root_thickness", pitch, flank_angle, mean_diameter, root_diameter);
  return 0.5 * pitch + absolute(mean_diameter - root_diameter) * tan(flank_angle);
}

/// Mean transverse shear stress (Pa) at the root of the thread. [khurmi_gupta2005, section 17.13]
template <class T>
T thread_shear_stress(const T& force, const T& root_diameter, const T& root_thickness, const T& engaged_turns) {
  return force / (pi<T>() * root_diameter * root_thickness * engaged_turns);
}

/// Largest transverse shear stress (Pa) at the root, parabolic over its height. [shigley, section 8-2; fdm_printer,
/// eq. 2.8]
template <class T>
T maximum_thread_shear_stress(const T& force, const T& root_diameter, const T& root_thickness, const T& engaged_turns) {
  return 1.5 * force / (pi<T>() * root_diameter * root_thickness * engaged_turns);
}

/// Bending stress (Pa) at the root of the thread as a cantilever loaded at half its depth. [shigley, eq. 8-11]
template <class T>
T thread_bending_stress(
    const T& force, const T& root_diameter, const T& thread_depth, const T& root_thickness, const T& engaged_turns) {
  return 3.0 * force * thread_depth / (pi<T>() * root_diameter * engaged_turns * square(root_thickness));
}

/// Sliding speed (m/s) of the nut's thread on the screw's, along the helix. [millwright_derivations]
template <class T>
T sliding_speed(const T& angular_speed, const T& mean_diameter, const T& lead) {
  return angular_speed * sqrt(square(mean_diameter / 2.0) + square(lead / (2.0 * pi<T>())));
}

/// Pressure times sliding speed (Pa.m/s): the heat limit of a nut, mainly of plastics. [thomson_pv]
template <class T>
T pressure_velocity(const T& bearing_pressure, const T& sliding_speed) {
  return bearing_pressure * sliding_speed;
}

/// Axial wear (m) of the nut after a sliding distance; an order of magnitude. [tribology_abc]
template <class T>
T nut_wear(const T& wear_rate, const T& bearing_pressure, const T& sliding_distance, const T& flank_angle) {
  watch_validity<T>("power_screw.nut_wear", wear_rate, bearing_pressure, sliding_distance, flank_angle);
  return wear_rate * bearing_pressure * sliding_distance / cos(flank_angle);
}

/// Travel of the nut (m) until the allowable axial wear. [tribology_abc; millwright_derivations]
template <class T>
T nut_wear_travel(const T& wear_rate,
                  const T& bearing_pressure,
                  const T& flank_angle,
                  const T& allowable_wear,
                  const T& mean_diameter,
                  const T& lead) {
  watch_validity<T>(
      "power_screw.nut_wear_travel", wear_rate, bearing_pressure, flank_angle, allowable_wear, mean_diameter, lead);
  const T sliding = named("s_slide", allowable_wear * cos(flank_angle) / (wear_rate * bearing_pressure));
  return sliding / sqrt(square(pi<T>() * mean_diameter / lead) + 1.0);
}

}  // namespace millwright::mechanics::power_screw
