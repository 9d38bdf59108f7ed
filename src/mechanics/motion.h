// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "mechanics/corner_bounds.h"
#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Motion of one axis from rest to rest. Limits (speed, acceleration, deceleration, jerk) are what the controller
/// uses; all are positive. Rotary axes: read rad for m. Everything in SI.
namespace millwright::mechanics::motion {

using namespace scalar;

/// Speed reached (m/s) by the trapezoidal profile, or by the triangle that is left of it when the distance is too
/// short to reach the limit. Kink where the two meet. [biagiotti_melchiorri2008, section 3.2]
template <class T>
T trapezoidal_peak_speed(const T& distance, const T& speed_limit, const T& acceleration, const T& deceleration) {
  return smaller(speed_limit, sqrt(2.0 * distance / (1.0 / acceleration + 1.0 / deceleration)));
}

/// Duration (s) of the trapezoidal or triangular move. Rising in distance, falling in every limit: it is the least of
/// s/v + v/2 (1/a + 1/d) over 0 < v <= speed_limit. [millwright_derivations]
template <class T>
T trapezoidal_time(const T& distance, const T& speed_limit, const T& acceleration, const T& deceleration) {
  const T speed = named("v_p", trapezoidal_peak_speed(distance, speed_limit, acceleration, deceleration));
  return distance / speed + 0.5 * speed * (1.0 / acceleration + 1.0 / deceleration);
}

/// Over a box the time is spanned by two corners (see the proof above).
inline Interval trapezoidal_time(const Interval& distance,
                                 const Interval& speed_limit,
                                 const Interval& acceleration,
                                 const Interval& deceleration) {
  using namespace corner_bounds;
  if (!all_positive(distance, speed_limit, acceleration, deceleration))
    return trapezoidal_time<Interval>(distance, speed_limit, acceleration, deceleration);
  return between_corners([](const auto&... x) { return trapezoidal_time<Interval>(x...); },
                         Rising{distance},
                         Falling{speed_limit},
                         Falling{acceleration},
                         Falling{deceleration});
}
template <int N>
Dual<Interval, N> trapezoidal_time(const Dual<Interval, N>& distance,
                                   const Dual<Interval, N>& speed_limit,
                                   const Dual<Interval, N>& acceleration,
                                   const Dual<Interval, N>& deceleration) {
  return corner_bounds::with_value(
      trapezoidal_time<Dual<Interval, N>>(distance, speed_limit, acceleration, deceleration),
      trapezoidal_time(distance.value, speed_limit.value, acceleration.value, deceleration.value));
}

/// Smallest symmetric acceleration (m/s²) that covers the distance in the time; infinite when even the speed limit is
/// too slow. [millwright_derivations, inversion of trapezoidal_time]
template <class T>
T required_acceleration(const T& distance, const T& time, const T& speed_limit) {
  watch_validity<T>("motion.required_acceleration", distance, time, speed_limit);
  return where_below(
      speed_limit,
      2.0 * distance / time,
      [&](const T& speed) { return T(square(speed) / larger(speed * time - distance, T(0.0))); },
      [&] { return T(4.0 * distance / square(time)); });
}

/// A longer way, less time or a lower speed limit never needs less acceleration: two corners span the range.
inline Interval required_acceleration(const Interval& distance, const Interval& time, const Interval& speed_limit) {
  using namespace corner_bounds;
  if (!all_positive(distance, time, speed_limit)) return required_acceleration<Interval>(distance, time, speed_limit);
  return between_corners([](const auto&... x) { return required_acceleration<Interval>(x...); },
                         Rising{distance},
                         Falling{time},
                         Falling{speed_limit});
}
template <int N>
Dual<Interval, N> required_acceleration(const Dual<Interval, N>& distance,
                                        const Dual<Interval, N>& time,
                                        const Dual<Interval, N>& speed_limit) {
  return corner_bounds::with_value(required_acceleration<Dual<Interval, N>>(distance, time, speed_limit),
                                   required_acceleration(distance.value, time.value, speed_limit.value));
}

/// Root mean square speed (m/s) over the move, without dwells. [millwright_derivations]
template <class T>
T trapezoidal_rms_speed(const T& distance, const T& speed_limit, const T& acceleration, const T& deceleration) {
  const T speed = named("v_p", trapezoidal_peak_speed(distance, speed_limit, acceleration, deceleration));
  const T ramps = named("t_ramps", speed / acceleration + speed / deceleration);
  const T time = named("t", trapezoidal_time(distance, speed_limit, acceleration, deceleration));
  return speed * sqrt((ramps / 3.0 + (time - ramps)) / time);
}

/// Root mean square acceleration (m/s²) over the move: the inertial share of the thermal load of the motor.
/// [millwright_derivations]
template <class T>
T trapezoidal_rms_acceleration(const T& distance, const T& speed_limit, const T& acceleration, const T& deceleration) {
  const T speed = named("v_p", trapezoidal_peak_speed(distance, speed_limit, acceleration, deceleration));
  const T time = named("t", trapezoidal_time(distance, speed_limit, acceleration, deceleration));
  return sqrt(speed * (acceleration + deceleration) / time);
}

/// Root mean square of a quantity (any unit) that is constant within each phase of the duty cycle. Dwells are phases
/// with value 0. The cycle must be short against the thermal time constant of what it heats.
/// [oriental_motor_sizing, effective load torque]
template <class T>
T cycle_rms(std::span<const T> values, std::span<const T> durations) {
  const std::size_t count = common_length(values, durations);
  const T weighted = sum_of(count, [&](std::size_t i) { return T(square(values[i]) * durations[i]); });
  return sqrt(weighted / sum_of(count, [&](std::size_t i) { return durations[i]; }));
}

/// Mean speed (m/s) over the duty cycle; dwells count in the time. [millwright_derivations]
template <class T>
T cycle_mean_speed(std::span<const T> distances, std::span<const T> durations) {
  const std::size_t count = common_length(distances, durations);
  return sum_of(count, [&](std::size_t i) { return T(absolute(distances[i])); }) /
         sum_of(count, [&](std::size_t i) { return durations[i]; });
}

/// Root mean square of a quantity (any unit) that changes linearly from start to end. [millwright_derivations]
template <class T>
T ramp_rms(const T& start_value, const T& end_value) {
  return sqrt((square(start_value) + start_value * end_value + square(end_value)) / 3.0);
}

/// Root mean square of a quantity (any unit) that acts during a fraction of the time, as in interrupted cutting.
/// [millwright_derivations]
template <class T>
T pulse_rms(const T& value, const T& on_fraction) {
  watch_validity<T>("motion.pulse_rms", value, on_fraction);
  return value * sqrt(on_fraction);
}

/// Fraction of the cycle under load. [millwright_derivations]
template <class T>
T duty_factor(const T& on_time, const T& cycle_time) {
  watch_validity<T>("motion.duty_factor", on_time, cycle_time);
  return on_time / cycle_time;
}

/// Largest path speed (m/s) on an arc, for the centripetal acceleration of the slower axis. [millwright_derivations]
template <class T>
T arc_speed(const T& acceleration, const T& radius) {
  return sqrt(acceleration * radius);
}

/// Speed (m/s) through a corner whose path may deviate by `deviation` (junction-deviation rule). `corner_angle` is the
/// angle between the segments: pi is straight on (no limit), 0 a reversal (standstill). [grbl_planner]
template <class T>
T corner_speed(const T& acceleration, const T& deviation, const T& corner_angle) {
  watch_validity<T>("motion.corner_speed", acceleration, deviation, corner_angle);
  const T sine = sin(0.5 * corner_angle);
  return sqrt(acceleration * deviation * sine / (1.0 - sine));
}

}  // namespace millwright::mechanics::motion
