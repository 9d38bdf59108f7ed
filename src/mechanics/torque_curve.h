// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "scalar/dual.h"
#include "scalar/elementary.h"
#include "scalar/interval.h"

namespace millwright::mechanics {

/// What a published pull-out curve lets a motor do: torque (N·m) at angular speeds (rad/s), straight lines between the
/// points. The demand must stay below it at every speed of the profile, and a motor gets to a speed through all slower
/// ones: so at a speed counts the least on the way there, and where a curve rises its torque is held [handbook,
/// stepper]. Below the first speed its torque is held. Above the last speed the last torque is held too: the caller
/// takes the smaller of it and the model there, because the maker claims nothing.
class PullOutCurve {
 public:
  struct Point {
    double speed = 0.0;
    double torque = 0.0;
  };

  /// Points in any order. Throws std::invalid_argument when there is none, when a number is not finite or negative, or
  /// when two points share a speed.
  explicit PullOutCurve(std::vector<Point> points);

  /// Ascending in speed, none with more torque than one before it; where a curve that rose comes down to what is held
  /// there is a point more than published.
  const std::vector<Point>& points() const { return points_; }
  double first_speed() const { return points_.front().speed; }
  double last_speed() const { return points_.back().speed; }
  /// Up to here the maker claims something: the last speed, as far as rounding can tell, so that a motion at the very
  /// speed of the last point is on the curve.
  double end() const { return last_speed() * (1.0 + 1e-9); }

  double operator()(double speed) const;
  /// Every torque on the range of speeds.
  scalar::Interval operator()(const scalar::Interval& speed) const;
  /// At a point of the curve the slope of the segment above it.
  template <int N>
  scalar::Dual<double, N> operator()(const scalar::Dual<double, N>& speed) const {
    return speed.chain((*this)(speed.value), slope(speed.value));
  }
  /// The slopes of every segment touched.
  template <int N>
  scalar::Dual<scalar::Interval, N> operator()(const scalar::Dual<scalar::Interval, N>& speed) const {
    return speed.chain((*this)(speed.value), slopes(speed.value));
  }

 private:
  double slope(double speed) const;
  scalar::Interval slopes(const scalar::Interval& speed) const;
  std::size_t points_up_to(double speed) const;

  std::vector<Point> points_;
};

/// Of several curves that were measured of one motor the least at every speed, each held below its first and above its
/// last speed. Throws std::invalid_argument when there is none.
PullOutCurve least_of(std::span<const PullOutCurve> curves);

}  // namespace millwright::mechanics
