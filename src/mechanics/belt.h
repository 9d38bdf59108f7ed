// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/corner_bounds.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Synchronous (timing) belts: tension, teeth in mesh, power, stiffness. Everything in SI.
namespace millwright::mechanics::belt {

using namespace scalar;

/// Pitch diameter (m) of a pulley. [sularso_suga, chapter 5]
template <class T>
T pitch_diameter(const T& teeth, const T& pitch) {
  return teeth * pitch / pi<T>();
}

/// Effective tension (N) that transmits a power at a belt speed. [sularso_suga, chapter 5]
template <class T>
T effective_tension_of_power(const T& power, const T& speed) {
  return power / speed;
}

/// Effective tension (N) from the pulley's torque; on a linear axis the carriage force. [millwright_derivations]
template <class T>
T effective_tension_of_torque(const T& torque, const T& pitch_diameter) {
  return 2.0 * torque / pitch_diameter;
}

/// Centrifugal tension (N), from the mass per length of the belt itself. [sularso_suga, chapter 5]
template <class T>
T centrifugal_tension(const T& mass_per_length, const T& speed) {
  return mass_per_length * square(speed);
}

/// Tension (N) of the tight side when the slack side is taken as slack. [sularso_suga, chapter 5]
template <class T>
T tight_side_tension(const T& effective_tension, const T& centrifugal_tension) {
  return effective_tension + centrifugal_tension;
}

/// Pretension (N) that leaves the slack side its smallest tension; both spans equally stiff. [iso5295]
template <class T>
T required_pretension(const T& effective_tension, const T& smallest_slack_tension, const T& centrifugal_tension) {
  return 0.5 * effective_tension + smallest_slack_tension + centrifugal_tension;
}

/// Largest tension (N) in a span. [iso5295]
template <class T>
T largest_span_tension(const T& pretension, const T& effective_tension) {
  return pretension + 0.5 * effective_tension;
}

/// Largest tension (N) in the span between a carriage and the drive pulley that pulls it. Both spans stretch by the
/// same way, so that the shorter takes the larger share of the force: next to the pulley all of it.
/// [millwright_derivations, unequal spans of a belt]
template <class T>
T carriage_span_tension(const T& pretension, const T& effective_tension) {
  return pretension + effective_tension;
}

/// Radial load (N) on the shaft of a pulley at rest, wrap angle up to pi. [autodesk_synchronous_belts]
template <class T>
T shaft_load(const T& pretension, const T& wrap_angle) {
  watch_validity<T>("belt.shaft_load", pretension, wrap_angle);
  return 2.0 * pretension * sin(0.5 * wrap_angle);
}

/// The same of the drive pulley while it pulls a carriage close to it, wrap angle up to pi: its spans bear F_0 + F_e
/// and F_0. Along the line of centres that is (2 F_0 + F_e) sin(phi/2), across it F_e cos(phi/2).
/// [millwright_derivations, unequal spans of a belt]
template <class T>
T pulling_shaft_load(const T& pretension, const T& effective_tension, const T& wrap_angle) {
  watch_validity<T>("belt.pulling_shaft_load", pretension, effective_tension, wrap_angle);
  const T half = 0.5 * wrap_angle;
  return sqrt(square((2.0 * pretension + effective_tension) * sin(half)) + square(effective_tension * cos(half)));
}

/// Wrap angle (rad) on the smaller of two pulleys. [autodesk_synchronous_belts; sularso_suga, chapter 5]
template <class T>
T wrap_angle(const T& large_diameter, const T& small_diameter, const T& centre_distance) {
  watch_validity<T>("belt.wrap_angle", large_diameter, small_diameter, centre_distance);
  return pi<T>() - 2.0 * asin((large_diameter - small_diameter) / (2.0 * centre_distance));
}

/// Teeth in mesh on the smaller pulley (not rounded). [sularso_suga, chapter 5]
template <class T>
T teeth_in_mesh(const T& teeth, const T& wrap_angle) {
  watch_validity<T>("belt.teeth_in_mesh", teeth, wrap_angle);
  return teeth * wrap_angle / (2.0 * pi<T>());
}

/// Share of the belt's tension that few teeth in mesh can carry: 1 from six full teeth on, 0.2 less for each that is
/// missing. Steps at whole teeth. [iso5295; autodesk_synchronous_belts; sularso_suga, chapter 5]
template <class T>
T tooth_factor(const T& teeth_in_mesh) {
  // 1e-9 of a tooth so that a whole number reached by arithmetic counts as whole.
  const T whole = named("z_w", floor_of(teeth_in_mesh + 1e-9));
  return larger(T(0.0), smaller(T(1.0), 1.0 - 0.2 * (6.0 - whole)));
}

/// Length (m) of an open belt over two pulleys, before it is rounded to whole teeth. [autodesk_synchronous_belts]
template <class T>
T length(const T& large_diameter, const T& small_diameter, const T& centre_distance) {
  watch_validity<T>("belt.length", large_diameter, small_diameter, centre_distance);
  const T slope = named("γ", asin((large_diameter - small_diameter) / (2.0 * centre_distance)));
  return 2.0 * centre_distance * cos(slope) + 0.5 * pi<T>() * (large_diameter + small_diameter) +
         slope * (large_diameter - small_diameter);
}

/// The slopes are π/2 ± γ in the diameters and 2 cos γ in the distance, all positive.
inline Interval length(const Interval& large_diameter,
                       const Interval& small_diameter,
                       const Interval& centre_distance) {
  using namespace corner_bounds;
  const double widest =
      larger(large_diameter.upper - small_diameter.lower, small_diameter.upper - large_diameter.lower);
  if (!all_positive(large_diameter, small_diameter, centre_distance) || !(widest < 1.99 * centre_distance.lower))
    return length<Interval>(large_diameter, small_diameter, centre_distance);
  return between_corners([](const auto&... x) { return length<Interval>(x...); },
                         Rising{large_diameter},
                         Rising{small_diameter},
                         Rising{centre_distance});
}

/// Power (W) to design for. Service factor 1.2 to 2 by driver and duty. [sularso_suga, chapter 5; fdm_printer]
template <class T>
T design_power(const T& service_factor, const T& power) {
  return service_factor * power;
}

/// Power (W) that the belt can transmit at a speed. [autodesk_synchronous_belts; iso5295]
template <class T>
T power_capacity(const T& tooth_factor, const T& allowable_tension, const T& mass_per_length, const T& speed) {
  watch_validity<T>("belt.power_capacity", tooth_factor, allowable_tension, mass_per_length, speed);
  return (tooth_factor * allowable_tension - mass_per_length * square(speed)) * speed;
}

/// Width (m) that carries a tension; linear in width. [iso5295]
template <class T>
T required_width(const T& design_tension, const T& tooth_factor, const T& allowable_tension_per_width) {
  watch_validity<T>("belt.required_width", design_tension, tooth_factor, allowable_tension_per_width);
  return design_tension / (tooth_factor * allowable_tension_per_width);
}

/// Stiffness (N/m) at a carriage between its two spans, both under tension, motor locked. `specific_stiffness` is the
/// force per strain of the belt at its width. [millwright_derivations]
template <class T>
T stiffness(const T& specific_stiffness, const T& first_span_length, const T& second_span_length) {
  return specific_stiffness * (1.0 / first_span_length + 1.0 / second_span_length);
}

/// The same where it is least, at equal spans. [millwright_derivations]
template <class T>
T least_stiffness(const T& specific_stiffness, const T& total_span_length) {
  return 4.0 * specific_stiffness / total_span_length;
}

/// Deflection (m) of the carriage under a force. [millwright_derivations]
template <class T>
T position_error(const T& force, const T& stiffness) {
  return force / stiffness;
}

/// Frequency (Hz) of a plucked span, to check its tension. [millwright_derivations]
template <class T>
T span_frequency(const T& span_tension, const T& span_length, const T& mass_per_length) {
  return sqrt(span_tension / mass_per_length) / (2.0 * span_length);
}

/// Frequency (Hz) of the carriage on the belt, motor locked. [millwright_derivations]
template <class T>
T axis_resonant_frequency(const T& stiffness, const T& mass) {
  return sqrt(stiffness / mass) / (2.0 * pi<T>());
}

}  // namespace millwright::mechanics::belt
