// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/motion.h"

/// The jerk-limited (seven-segment) part of namespace motion: jerk +j, 0, -j while speeding up, cruise, and the mirror
/// image while slowing down. Same limits in both directions. Everything in SI.
/// Source: biagiotti_melchiorri2008, section 3.4.
namespace millwright::mechanics::motion {

/// Time (s) to reach `speed`: the acceleration limit is reached from speed a²/j on.
template <class T>
T speed_up_time(const T& speed, const T& acceleration_limit, const T& jerk_limit) {
  return where_below(
      speed,
      square(acceleration_limit) / jerk_limit,
      [&](const T& v) { return T(2.0 * sqrt(v / jerk_limit)); },
      [&](const T& v) { return T(v / acceleration_limit + acceleration_limit / jerk_limit); });
}

/// Rising in speed, falling in both limits.
inline Interval speed_up_time(const Interval& speed, const Interval& acceleration_limit, const Interval& jerk_limit) {
  using namespace corner_bounds;
  if (!all_positive(speed, acceleration_limit, jerk_limit))
    return speed_up_time<Interval>(speed, acceleration_limit, jerk_limit);
  return between_corners([](const auto&... x) { return speed_up_time<Interval>(x...); },
                         Rising{speed},
                         Falling{acceleration_limit},
                         Falling{jerk_limit});
}

/// Speed (m/s) at which speeding up and slowing down would just fill the distance.
template <class T>
T s_curve_unlimited_speed(const T& distance, const T& acceleration_limit, const T& jerk_limit) {
  return where_below(
      distance,
      2.0 * cube(acceleration_limit) / square(jerk_limit),
      [&](const T& s) { return T(cbrt(square(s) * jerk_limit / 4.0)); },
      [&](const T& s) {
        const T knee = square(acceleration_limit) / jerk_limit;
        return T(0.5 * (sqrt(square(knee) + 4.0 * acceleration_limit * s) - knee));
      });
}

/// More way, acceleration or jerk never gives less speed.
inline Interval s_curve_unlimited_speed(const Interval& distance,
                                        const Interval& acceleration_limit,
                                        const Interval& jerk_limit) {
  using namespace corner_bounds;
  if (!all_positive(distance, acceleration_limit, jerk_limit))
    return s_curve_unlimited_speed<Interval>(distance, acceleration_limit, jerk_limit);
  return between_corners([](const auto&... x) { return s_curve_unlimited_speed<Interval>(x...); },
                         Rising{distance},
                         Rising{acceleration_limit},
                         Rising{jerk_limit});
}

/// Speed reached (m/s): the limit; or less, where the distance is too short for it; or less still, where it is too
/// short even for the acceleration limit.
template <class T>
T s_curve_peak_speed(const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  return smaller(speed_limit, s_curve_unlimited_speed(distance, acceleration_limit, jerk_limit));
}

/// Duration (s) of the move; never less than trapezoidal_time, which it approaches as the jerk limit grows.
template <class T>
T s_curve_time(const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  const T speed = named("v_p", s_curve_peak_speed(distance, speed_limit, acceleration_limit, jerk_limit));
  return distance / speed + speed_up_time(speed, acceleration_limit, jerk_limit);
}

/// The profile is the fastest within its limits, so wider limits or a shorter way never take longer.
inline Interval s_curve_time(const Interval& distance,
                             const Interval& speed_limit,
                             const Interval& acceleration_limit,
                             const Interval& jerk_limit) {
  using namespace corner_bounds;
  if (!all_positive(distance, speed_limit, acceleration_limit, jerk_limit))
    return s_curve_time<Interval>(distance, speed_limit, acceleration_limit, jerk_limit);
  return between_corners([](const auto&... x) { return s_curve_time<Interval>(x...); },
                         Rising{distance},
                         Falling{speed_limit},
                         Falling{acceleration_limit},
                         Falling{jerk_limit});
}
template <int N>
Dual<Interval, N> s_curve_time(const Dual<Interval, N>& distance,
                               const Dual<Interval, N>& speed_limit,
                               const Dual<Interval, N>& acceleration_limit,
                               const Dual<Interval, N>& jerk_limit) {
  return corner_bounds::with_value(
      s_curve_time<Dual<Interval, N>>(distance, speed_limit, acceleration_limit, jerk_limit),
      s_curve_time(distance.value, speed_limit.value, acceleration_limit.value, jerk_limit.value));
}

/// Acceleration reached (m/s²). The torque peak lies at speed v_p - a_p²/(2j), not at v_p.
template <class T>
T s_curve_peak_acceleration(const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  const T speed = named("v_p", s_curve_peak_speed(distance, speed_limit, acceleration_limit, jerk_limit));
  return smaller(acceleration_limit, sqrt(jerk_limit * speed));
}

/// Root mean square acceleration (m/s²) over the move, without dwells.
template <class T>
T s_curve_rms_acceleration(const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  const T speed = named("v_p", s_curve_peak_speed(distance, speed_limit, acceleration_limit, jerk_limit));
  const T peak = named("a_p", s_curve_peak_acceleration(distance, speed_limit, acceleration_limit, jerk_limit));
  const T speed_up = named("T_a", speed_up_time(speed, acceleration_limit, jerk_limit));
  const T time = named("t", s_curve_time(distance, speed_limit, acceleration_limit, jerk_limit));
  return peak * sqrt(2.0 * (speed_up - 4.0 / 3.0 * (peak / jerk_limit)) / time);
}

/// Root mean square speed (m/s) over the move, without dwells: the three segments of speeding up, twice, and cruise.
template <class T>
T s_curve_rms_speed(const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  const T speed = named("v_p", s_curve_peak_speed(distance, speed_limit, acceleration_limit, jerk_limit));
  const T peak = named("a_p", s_curve_peak_acceleration(distance, speed_limit, acceleration_limit, jerk_limit));
  const T speed_up = named("T_a", speed_up_time(speed, acceleration_limit, jerk_limit));
  const T time = named("t", s_curve_time(distance, speed_limit, acceleration_limit, jerk_limit));
  const T jerk_time = named("t_j", peak / jerk_limit);
  const T first_speed = named("v_1", 0.5 * peak * jerk_time);
  const T steady_time = speed_up - 2.0 * jerk_time;
  const T jerk_part = square(jerk_limit) * cube(jerk_time) * square(jerk_time) / 20.0;
  const T steady_part = (cube(first_speed + peak * steady_time) - cube(first_speed)) / (3.0 * peak);
  const T ease_part = square(speed) * jerk_time - speed * jerk_limit * cube(jerk_time) / 3.0;
  const T ramps = named("I", 2.0 * (jerk_part + steady_part + ease_part + jerk_part));
  return sqrt((ramps + square(speed) * (time - 2.0 * speed_up)) / time);
}

/// Way (m) covered `time` after the start while speeding up, 0 <= time <= speed_up: the way of each of the three
/// segments as far as it has come (the three cases of the source in one line). `speed` and `peak` are the speed and
/// acceleration reached.
template <class T>
T speeding_up_distance(const T& time, const T& speed, const T& peak, const T& speed_up, const T& jerk_time) {
  const T rise = smaller(time, jerk_time);
  const T steady = larger(smaller(time, speed_up - jerk_time) - jerk_time, T(0.0));
  const T ease = larger(time - (speed_up - jerk_time), T(0.0));
  const T first_speed = 0.5 * peak * jerk_time;
  return peak * cube(rise) / (6.0 * jerk_time) + (first_speed * steady + 0.5 * peak * square(steady)) +
         ((speed - first_speed) * ease + 0.5 * peak * square(ease) - peak * cube(ease) / (6.0 * jerk_time));
}

/// Position (m) at `time` after the start: the way of speeding up, of the cruise and of slowing down (its mirror
/// image) as far as each has come. Before the start 0, after the end the distance.
template <class T>
T s_curve_position(
    const T& time, const T& distance, const T& speed_limit, const T& acceleration_limit, const T& jerk_limit) {
  const T speed = named("v_p", s_curve_peak_speed(distance, speed_limit, acceleration_limit, jerk_limit));
  const T peak = named("a_p", s_curve_peak_acceleration(distance, speed_limit, acceleration_limit, jerk_limit));
  const T speed_up = named("T_a", speed_up_time(speed, acceleration_limit, jerk_limit));
  const T total = named("t", s_curve_time(distance, speed_limit, acceleration_limit, jerk_limit));
  const T jerk_time = named("t_j", peak / jerk_limit);
  const auto way = [&](const T& x) { return speeding_up_distance(x, speed, peak, speed_up, jerk_time); };
  const T first = way(smaller(larger(time, T(0.0)), speed_up));
  const T cruise = speed * smaller(larger(time - speed_up, T(0.0)), larger(total - 2.0 * speed_up, T(0.0)));
  const T last = 0.5 * speed * speed_up - way(smaller(larger(total - time, T(0.0)), speed_up));
  return first + cruise + last;
}

}  // namespace millwright::mechanics::motion
