// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Power (lead) screws: geometry, torque and efficiency; strength and nut in power_screw_strength.h. One nut on one
/// screw; `force` is the axial load, positive. "Raising" moves against it, "lowering" with it. The friction of the
/// torque formulas is the effective one (effective_friction), which includes the flank angle. Everything in SI.
namespace millwright::mechanics::power_screw {

using namespace scalar;

enum class ThreadForm { square, trapezoidal, acme, metric_60 };

/// Half of the thread angle, in the axial plane (rad). [din103; asme_b1_5; iso724]
inline double flank_angle(ThreadForm form) {
  switch (form) {
    case ThreadForm::square:
      return 0.0;
    case ThreadForm::trapezoidal:
      return std::numbers::pi / 12.0;
    case ThreadForm::acme:
      return 14.5 * std::numbers::pi / 180.0;
    case ThreadForm::metric_60:
      return std::numbers::pi / 6.0;
  }
  return 0.0;
}

/// Advance per revolution (m). A multi-start screw advances by more than its pitch. [khurmi_gupta2005, section 17.2]
template <class T>
T lead(const T& pitch, const T& starts) {
  return pitch * starts;
}

/// Mean (pitch) diameter (m). [din103; iso724]
template <class T>
T mean_diameter(ThreadForm form, const T& major_diameter, const T& pitch) {
  watch_validity<T>("power_screw.mean_diameter", form, major_diameter, pitch);
  if (form == ThreadForm::metric_60) return major_diameter - 0.375 * std::sqrt(3.0) * pitch;
  return major_diameter - 0.5 * pitch;
}

/// Core (minor) diameter (m); a catalogue value takes precedence. Trapezoidal and Acme threads have a crest clearance
/// that steps with the pitch. [din103; asme_b1_5; iso724]
template <class T>
T core_diameter(ThreadForm form, const T& major_diameter, const T& pitch) {
  watch_validity<T>("power_screw.core_diameter", form, major_diameter, pitch);
  const auto millimetres = [](double value) { return in_unit<T>(1e-3 * value, dimension::length); };
  // The limits are moved by 1e-9 so that a pitch of exactly 2, 5, 12 or 2.54 mm falls on its own side however it was
  // rounded on its way here.
  const auto clearance = [&](double limit, const T& below, const T& above) {
    return T(step_below(pitch, millimetres(limit), below, above));
  };
  const T profile = major_diameter - pitch;
  switch (form) {
    case ThreadForm::square:
      return profile;
    case ThreadForm::metric_60:
      return major_diameter - 17.0 / 24.0 * std::sqrt(3.0) * pitch;
    case ThreadForm::trapezoidal: {
      const T coarse = clearance(12.0 * (1.0 + 1e-9), millimetres(0.5), millimetres(1.0));
      const T medium = clearance(5.0 * (1.0 + 1e-9), millimetres(0.25), coarse);
      return profile - 2.0 * clearance(2.0 * (1.0 - 1e-9), millimetres(0.15), medium);
    }
    case ThreadForm::acme:
      return profile - clearance(2.54 * (1.0 - 1e-9), millimetres(0.254), millimetres(0.508));
  }
  return profile;
}

/// Depth (m) over which screw and nut bear on each other. [din103; iso724]
template <class T>
T thread_depth(ThreadForm form, const T& pitch) {
  if (form == ThreadForm::metric_60) return 0.3125 * std::sqrt(3.0) * pitch;
  return 0.5 * pitch;
}

/// Lead angle at the mean diameter (rad). [khurmi_gupta2005, section 17.4]
template <class T>
T lead_angle(const T& lead, const T& mean_diameter) {
  return atan(lead / (pi<T>() * mean_diameter));
}

/// Speed of the screw (rad/s) for a speed of the nut. [khurmi_gupta2005, chapter 17]
template <class T>
T angular_speed(const T& speed, const T& lead) {
  return 2.0 * pi<T>() * speed / lead;
}

/// Moment of inertia (kg.m²) of the screw as a cylinder; the mean diameter is good to a few percent.
/// [millwright_derivations]
template <class T>
T inertia(const T& density, const T& diameter, const T& length) {
  return pi<T>() * density * length * square(square(diameter)) / 32.0;
}

/// Friction coefficient of the equivalent square thread: the flank angle enlarges the normal force. Good for lead
/// angles below 20 degrees. [khurmi_gupta2005, section 17.12; bhandari, eq. 6.9]
template <class T>
T effective_friction(const T& friction, const T& flank_angle) {
  watch_validity<T>("power_screw.effective_friction", friction, flank_angle);
  return friction / cos(flank_angle);
}

/// The same for any lead angle, with the flank angle in the normal plane; slightly smaller.
/// [shigley, section 8-2]
template <class T>
T exact_effective_friction(const T& friction, const T& flank_angle, const T& lead_angle) {
  watch_validity<T>("power_screw.exact_effective_friction", friction, flank_angle, lead_angle);
  return friction / cos(atan(tan(flank_angle) * cos(lead_angle)));
}

/// What is left of the effective friction when the flank angle is taken in the normal plane: exact over approximate.
/// Valid: the approximation is for lead angles below 20 degrees; square threads need none.
/// [khurmi_gupta2005, section 17.12; shigley, section 8-2]
template <class T>
T exact_friction_ratio(const T& flank_angle, const T& lead_angle) {
  watch_validity<T>("power_screw.exact_friction_ratio", flank_angle, lead_angle);
  return sqrt(square(cos(flank_angle)) + square(sin(flank_angle) * cos(lead_angle)));
}

/// Torque (N.m) to move the nut against the force. Holds while friction * tan(lead angle) < 1.
/// [khurmi_gupta2005, section 17.4; bhandari, eq. 6.2; shigley, eq. 8-1]
template <class T>
T raising_torque(const T& force, const T& mean_diameter, const T& lead, const T& friction) {
  watch_validity<T>("power_screw.raising_torque", force, mean_diameter, lead, friction);
  const T slope = named("tan λ", lead / (pi<T>() * mean_diameter));
  return force * mean_diameter / 2.0 * ((slope + friction) / (1.0 - friction * slope));
}

/// Torque (N.m) to move the nut with the force: positive when it has to be driven (self-locking), negative when the
/// force drives the screw and the motor has to brake. [khurmi_gupta2005, section 17.5; bhandari, eq. 6.3]
template <class T>
T lowering_torque(const T& force, const T& mean_diameter, const T& lead, const T& friction) {
  watch_validity<T>("power_screw.lowering_torque", force, mean_diameter, lead, friction);
  const T slope = named("tan λ", lead / (pi<T>() * mean_diameter));
  return force * mean_diameter / 2.0 * ((friction - slope) / (1.0 + friction * slope));
}

/// Torque (N.m) of a sliding thrust collar, run in (uniform wear). None with a rolling bearing.
/// [khurmi_gupta2005, section 17.4; bhandari, eq. 6.5]
template <class T>
T collar_torque(const T& force, const T& collar_friction, const T& outer_radius, const T& inner_radius) {
  watch_validity<T>("power_screw.collar_torque", force, collar_friction, outer_radius, inner_radius);
  return collar_friction * force * (outer_radius + inner_radius) / 2.0;
}

/// Torque (N.m) of a new sliding thrust collar (uniform pressure); the quotient of the powers of the radii with its
/// common factor cancelled. [khurmi_gupta2005, section 17.4]
template <class T>
T collar_torque_uniform_pressure(const T& force,
                                 const T& collar_friction,
                                 const T& outer_radius,
                                 const T& inner_radius) {
  watch_validity<T>("power_screw.collar_torque_uniform_pressure", force, collar_friction, outer_radius, inner_radius);
  const T sum = outer_radius + inner_radius;
  return 2.0 / 3.0 * collar_friction * force * (sum - outer_radius * inner_radius / sum);
}

/// Work on the load over work put in, with the total torque (thread and collar). [khurmi_gupta2005, section 17.6]
template <class T>
T efficiency(const T& force, const T& lead, const T& torque) {
  return force * lead / (2.0 * pi<T>() * torque);
}

/// Efficiency of the thread alone while raising; largest at a lead angle of 45° - φ/2 with tan φ = friction.
/// [khurmi_gupta2005, section 17.6]
template <class T>
T thread_efficiency(const T& lead_angle, const T& friction) {
  watch_validity<T>("power_screw.thread_efficiency", lead_angle, friction);
  const T slope = named("tan λ", tan(lead_angle));
  return slope * (1.0 - friction * slope) / (slope + friction);
}

/// Largest efficiency any lead angle gives. [khurmi_gupta2005, section 17.7]
template <class T>
T greatest_thread_efficiency(const T& friction) {
  const T sine = named("sin φ", sin(atan(friction)));
  return (1.0 - sine) / (1.0 + sine);
}

/// Back-driven torque over force * lead / 2π; negative for a self-locking thread. [millwright_derivations]
template <class T>
T reverse_efficiency(const T& lead_angle, const T& friction) {
  watch_validity<T>("power_screw.reverse_efficiency", lead_angle, friction);
  const T slope = named("tan λ", tan(lead_angle));
  return (slope - friction) / ((1.0 + friction * slope) * slope);
}

/// Self-locking below 1. Use the lowest credible running friction, and never rely on it where a load can fall on a
/// person. [khurmi_gupta2005, section 17.9]
template <class T>
T self_locking_ratio(const T& lead_angle, const T& friction) {
  watch_validity<T>("power_screw.self_locking_ratio", lead_angle, friction);
  return tan(lead_angle) / friction;
}

/// Drag (N.m) of two nut halves that a spring forces apart: one half raises, the other lowers the spring force. Play
/// is removed while the axial load stays below it. [millwright_derivations]
template <class T>
T antibacklash_drag_torque(const T& spring_force, const T& mean_diameter, const T& lead, const T& friction) {
  watch_validity<T>("power_screw.antibacklash_drag_torque", spring_force, mean_diameter, lead, friction);
  return named("T_R", raising_torque(spring_force, mean_diameter, lead, friction)) +
         named("T_L", lowering_torque(spring_force, mean_diameter, lead, friction));
}

/// Power (W) at the screw. [millwright_derivations]
template <class T>
T power(const T& torque, const T& angular_speed) {
  return torque * angular_speed;
}

/// Twist (rad) of a round shaft over its loaded length. Usual limit 0.25 to 0.3 degrees per metre.
/// [sularso_suga, chapter 1]
template <class T>
T torsional_windup(const T& torque, const T& length, const T& shear_modulus, const T& diameter) {
  return 32.0 * torque * length / (pi<T>() * shear_modulus * square(square(diameter)));
}

/// Error of the nut's position (m) that a twist of the screw makes. [millwright_derivations]
template <class T>
T windup_error(const T& windup, const T& lead) {
  return windup * lead / (2.0 * pi<T>());
}

/// Axial stiffness (N/m) to which a torsional one between motor and nut amounts. [millwright_derivations]
template <class T>
T axial_stiffness_of_torsion(const T& torsional_stiffness, const T& lead) {
  return torsional_stiffness * square(2.0 * pi<T>() / lead);
}

/// Axial stiffness (N/m) of a screw held in one thrust bearing, `distance` from the nut; least at the far end.
/// [thk_catalogue, axial rigidity]
template <class T>
T axial_stiffness_one_end_fixed(const T& elastic_modulus, const T& core_diameter, const T& distance) {
  return pi<T>() * square(core_diameter) * elastic_modulus / (4.0 * distance);
}

/// Axial stiffness (N/m) of a screw held in thrust bearings `length` apart, the nut `distance` from one of them; least
/// at mid-span. The two parts are springs side by side. [thk_catalogue, axial rigidity]
template <class T>
T axial_stiffness_both_ends_fixed(const T& elastic_modulus,
                                  const T& core_diameter,
                                  const T& length,
                                  const T& distance) {
  watch_validity<T>("power_screw.axial_stiffness_both_ends_fixed", elastic_modulus, core_diameter, length, distance);
  return pi<T>() * square(core_diameter) * elastic_modulus / 4.0 * (1.0 / distance + 1.0 / (length - distance));
}

/// Growth (m) of a length by a rise of its temperature (K). [millwright_derivations]
template <class T>
T thermal_growth(const T& thermal_expansion, const T& length, const T& temperature_rise) {
  return thermal_expansion * length * temperature_rise;
}

}  // namespace millwright::mechanics::power_screw
