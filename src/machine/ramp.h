// SPDX-License-Identifier: Apache-2.0
//
// The parts of a ramp from standstill to a speed, or back.
//
// A jerk-limited ramp of time t to the speed v has the acceleration rise, stay for t_c = sqrt(t^2 - 4 v/j), and fall in
// the same time t_j = (t - t_c)/2; its peak is a = 2 v/(t + t_c). Rising and falling stand in the cycle as two phases
// of t_j each at (1/2 -+ 1/sqrt(12)) a, the two points of Gauss: so mean, mean square and mean cube of all that is
// linear in the acceleration come out exact (RMS torque, mean load, as long as the force keeps its sign). Weighted with
// the speed too: speed is point symmetric about the middle of a ramp and acceleration mirror symmetric, so every part
// counts with the mean speed v/2. The peak counts at the full speed, which is on the safe side.
//
// Losses that grow with the speed follow the mean of its square over its mean: 2/3 v in an even ramp. With r = t_j/t
// the integral of the square over a jerk-limited one gives
//   v (1/2 + (1/6 - 2/3 r^2 + 8/15 r^3)/(1 - r)^2),
// which rises to 23/30 v where the acceleration never stays, r = 1/2: its slope has the sign of
// 1/3 - 4/3 r + 8/5 r^2 - 8/15 r^3, which falls to 0 there.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <type_traits>

#include "scalar/scalars.h"

namespace millwright::machine {

/// Parts of a jerk-limited ramp, as shares of its peak acceleration: at the peak, and the points of Gauss for the rest.
inline constexpr double rising_shares[] = {0.78867513459481288, 0.21132486540518712};

namespace detail {
template <class T>
T si(double value, const scalar::Dimension& dimension) {
  return scalar::in_unit<T>(value, dimension);
}

/// A part of a ramp with one acceleration.
template <class T>
struct RampPart {
  T acceleration{}, duration{};
  bool peak = true;
};

/// All parts of a ramp, the peak first. Every move of every question has them: no place for them is asked for.
template <class T>
struct RampParts {
  static constexpr std::size_t most = 1 + std::size(rising_shares);
  std::array<RampPart<T>, most> places{};
  std::size_t count = 0;
  T loss_share = T(2.0 / 3.0);  ///< Phase::loss_share of each
  void add(RampPart<T> part) { places[count++] = std::move(part); }
  [[nodiscard]] std::span<const RampPart<T>> all() const { return std::span(places).first(count); }
};

/// Over an interval of ramps what is positive and has no extreme inside but at `turning`.
template <class Of>
scalar::Interval over_ramps(const scalar::Interval& ramp, double turning, Of&& of) {
  constexpr double rounding = 1e-15;  // of the same worked out in numbers
  scalar::Interval range = hull(of(scalar::Interval(ramp.lower)), of(scalar::Interval(ramp.upper)));
  if (ramp.lower < turning && turning < ramp.upper) range = hull(range, of(scalar::Interval(turning)));
  return range * scalar::Interval(1.0 - rounding, 1.0 + rounding);
}

/// Phase::loss_share of a ramp whose acceleration rises, and falls, for such a share of its time, 1/2 at most.
template <class T>
T loss_share_of_ramp(const T& changing) {
  using namespace scalar;
  const auto share = [](const T& r) {
    return T(0.5 + (1.0 / 6.0 - square(r) * (2.0 / 3.0 - 8.0 / 15.0 * r)) / square(T(1.0 - r)));
  };
  if constexpr (std::is_same_v<T, Interval>)
    return over_ramps(T(std::min(changing.lower, 0.5), std::min(changing.upper, 0.5)), 0.0, share);  // it rises
  else if constexpr (std::is_constructible_v<T, Interval>)
    return share(T(smaller(changing, T(0.5))));  // no bound of a ramp's time leaves it less than what changes in it
  else
    return share(changing);
}

template <class T>
RampParts<T> ramp_parts(const T& speed, const T& ramp, const T* jerk) {
  using namespace scalar;
  RampParts<T> parts;
  if (jerk == nullptr) {
    parts.add({named("a", speed / ramp), ramp});
    return parts;
  }
  const T none = si<T>(0.0, dimension::time);
  // Without time for such a jerk, which C-SYS-TIME refuses, the acceleration rises and falls all the time.
  const T constant = where_below(
      square(ramp) - 4.0 * speed / *jerk,
      si<T>(0.0, dimension::time * dimension::time),
      [&](const T&) -> T { return none; },
      [](const T& squared) -> T { return sqrt(squared); });
  const T peak = named("a", 2.0 * speed / (ramp + constant));
  const T changing = larger(0.5 * (ramp - constant), none);
  parts.add({peak, constant});
  for (const double share : rising_shares) parts.add({share * peak, changing, false});
  parts.loss_share = loss_share_of_ramp(T(changing / ramp));
  return parts;
}

}  // namespace detail

}  // namespace millwright::machine
