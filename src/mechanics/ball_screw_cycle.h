// SPDX-License-Identifier: Apache-2.0
//
// Load of a ball screw over the two ramps of a move, accelerate and brake, taken together.
//
// One by one the two loads |b + c| and |b - c| (b the force at constant speed, c the inertia force) move in opposite
// directions with the mass, and bounds that add them up learn nothing. Their sum of cubes rises with both b and c: with
// L the load of the loaded raceway, rising and convex in the force, and g(F) = 3 L(F)^2 L'(F), also rising,
//     d/dc [L(b+c)^3 + L(|b-c|)^3] = g(b+c) - sign(b-c) g(|b-c|) >= 0,   and the same for b with the other sign.
#pragma once

#include "mechanics/ball_screw.h"

namespace millwright::mechanics::ball_screw {

/// Load (N) of the raceway that governs, from the force on the nut (N, not negative); preload 0 = a nut with play.
template <class T>
T raceway_load(const T& force, const T& preload, bool preloaded) {
  return preloaded ? T(loaded_side_force(force, preload)) : force;
}

/// Sum of the cubed raceway loads (N^3) of the two ramps of a move. `steady_force` is that at constant speed,
/// `inertia_force` mass times acceleration, not negative. [iso3408_5, section 7.1.2]
template <class T>
T cubed_ramp_loads(const T& steady_force, const T& inertia_force, const T& preload, bool preloaded) {
  const auto cubed = [&](const T& force) { return T(cube(raceway_load(T(absolute(force)), preload, preloaded))); };
  return cubed(steady_force + inertia_force) + cubed(steady_force - inertia_force);
}

namespace detail {

/// 3 L^2 L' over forces that are not negative.
inline Interval cubed_load_slope(const Interval& force, const Interval& preload, bool preloaded) {
  if (!preloaded) return 3.0 * square(force);
  const auto at = [&](const Interval& f, const Interval& p) {
    // 1.5 p/(2 sqrt(2) p) sqrt(1 + u) below lift-off, 1 above.
    const Interval slope = where_below(
        f,
        lift_off_force(p),
        [&](const Interval& x) { return Interval(1.5 / (2.0 * std::sqrt(2.0)) * sqrt(1.0 + x / lift_off_force(p))); },
        [](const Interval&) { return Interval(1.0); });
    return Interval(3.0 * square(loaded_side_force(f, p)) * slope);
  };
  return hull(at(Interval(force.lower), preload), at(Interval(force.upper), preload));
}

}  // namespace detail

inline Interval cubed_ramp_loads(const Interval& steady_force,
                                 const Interval& inertia_force,
                                 const Interval& preload,
                                 bool preloaded) {
  if (inertia_force.lower < 0.0) return cubed_ramp_loads<Interval>(steady_force, inertia_force, preload, preloaded);
  const Interval steady = absolute(steady_force);
  const auto at = [&](double b, double c, double p) {
    return cubed_ramp_loads<Interval>(Interval(b), Interval(c), Interval(p), preloaded);
  };
  return {at(steady.lower, inertia_force.lower, preload.lower).lower,
          at(steady.upper, inertia_force.upper, preload.upper).upper};
}

template <int N>
Dual<Interval, N> cubed_ramp_loads(const Dual<Interval, N>& steady_force,
                                   const Dual<Interval, N>& inertia_force,
                                   const Dual<Interval, N>& preload,
                                   bool preloaded) {
  const Dual<Interval, N> steady = absolute(steady_force);
  const Interval& b = steady.value;
  const Interval& c = inertia_force.value;
  if (c.lower < 0.0) return cubed_ramp_loads<Dual<Interval, N>>(steady_force, inertia_force, preload, preloaded);
  const Interval fast = detail::cubed_load_slope(b + c, preload.value, preloaded);
  const Interval slow = detail::cubed_load_slope(absolute(b - c), preload.value, preloaded);
  const Interval by_force(std::max(0.0, (fast - slow).lower), (fast + slow).upper);
  // dL/dp = sqrt(1 + u)(1 - u/2) falls from 1 to 0.71 at lift-off and is 0 after that.
  const auto squared = [&](const Interval& f) { return square(raceway_load(f, preload.value, preloaded)); };
  const Interval by_preload(0.0, preloaded ? (3.0 * (squared(b + c) + squared(absolute(b - c)))).upper : 0.0);
  Dual<Interval, N> result(cubed_ramp_loads(steady_force.value, c, preload.value, preloaded));
  for (std::size_t i = 0; i < result.slope.size(); ++i) {
    result.slope[i] = by_force * steady.slope[i] + by_force * inertia_force.slope[i] + by_preload * preload.slope[i];
  }
  return result;
}

/// Of a preloaded nut the cubed loads of both raceways (N^3) over the two ramps of a move, those of the loaded side
/// `weight` times, which is at least 1. With h(F) = 3 (weight F_1^2 dF_1/dF - F_2^2 |dF_2/dF|), which is positive and
/// rises, in place of g it rises with both forces, as above; with the preload by at most the slope 1 of either load.
template <int N>
Dual<Interval, N> uneven_ramp_loads(const Dual<Interval, N>& steady_force,
                                    const Dual<Interval, N>& inertia_force,
                                    const Dual<Interval, N>& preload,
                                    const Interval& weight) {
  const Dual<Interval, N> steady = absolute(steady_force), inertia = absolute(inertia_force);
  const Interval& p = preload.value;
  const Interval fast = steady.value + inertia.value, slow = absolute(steady.value - inertia.value);
  const auto other = [&](const Interval& f) { return unloaded_side_force(f, p); };
  // The slope of F_2 is that of F_1 less 1: at most 1 - 1.5/2^1.5 down.
  const auto excess = [&](const Interval& f) {
    const Interval falling(0.0, (3.0 * square(other(f)) * (1.0 - 1.5 / (2.0 * std::sqrt(2.0)))).upper);
    return Interval(weight * detail::cubed_load_slope(f, p, true) - falling);
  };
  const Interval by_force(0.0, (excess(fast) + excess(slow)).upper);
  const auto squares = [&](const Interval& f) {
    return Interval(weight * square(loaded_side_force(f, p)) + square(other(f)));
  };
  const Interval by_preload(0.0, (3.0 * (squares(fast) + squares(slow))).upper);
  Dual<Interval, N> result(weight * cubed_ramp_loads(steady.value, inertia.value, p, true) + cube(other(fast)) +
                           cube(other(slow)));
  for (std::size_t i = 0; i < result.slope.size(); ++i)
    result.slope[i] = by_force * (steady.slope[i] + inertia.slope[i]) + by_preload * preload.slope[i];
  return result;
}

}  // namespace millwright::mechanics::ball_screw
