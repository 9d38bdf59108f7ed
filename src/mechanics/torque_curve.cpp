// SPDX-License-Identifier: Apache-2.0
#include "mechanics/torque_curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace millwright::mechanics {

using scalar::Interval;

namespace {

using Point = PullOutCurve::Point;

bool usable(double number) { return std::isfinite(number) && number >= 0.0; }

/// Torque at one speed between two points, with its rounding; exact at the points themselves.
Interval on_segment(const Point& from, const Point& to, double speed) {
  if (speed == from.speed) return from.torque;
  if (speed == to.speed) return to.torque;
  const Interval share = (Interval(speed) - from.speed) / (Interval(to.speed) - from.speed);
  const Interval torque = from.torque + share * (Interval(to.torque) - from.torque);
  const auto [least, most] = std::minmax(from.torque, to.torque);
  return {std::clamp(torque.lower, least, most), std::clamp(torque.upper, least, most)};
}

/// The least torque on the way from the first point to each speed.
std::vector<Point> least_so_far(const std::vector<Point>& published) {
  std::vector<Point> result{published.front()};
  for (std::size_t i = 1; i < published.size(); ++i) {
    const Point &from = published[i - 1], &to = published[i];
    const double least = result.back().torque;
    if (from.torque > least && to.torque < least) {
      const double share = (from.torque - least) / (from.torque - to.torque);
      const double crossing = from.speed + share * (to.speed - from.speed);
      if (crossing > result.back().speed && crossing < to.speed) result.push_back({crossing, least});
    }
    result.push_back({to.speed, std::min(to.torque, least)});
  }
  return result;
}

}  // namespace

PullOutCurve::PullOutCurve(std::vector<Point> points) : points_(std::move(points)) {
  if (points_.empty()) throw std::invalid_argument("a pull-out curve has no points");
  std::sort(points_.begin(), points_.end(), [](const Point& a, const Point& b) { return a.speed < b.speed; });
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!usable(points_[i].speed) || !usable(points_[i].torque))
      throw std::invalid_argument("a point of a pull-out curve is negative or not a number");
    if (i > 0 && points_[i].speed == points_[i - 1].speed)
      throw std::invalid_argument("two points of a pull-out curve share a speed");
  }
  points_ = least_so_far(points_);
}

std::size_t PullOutCurve::points_up_to(double speed) const {
  const auto above =
      std::upper_bound(points_.begin(), points_.end(), speed, [](double v, const Point& p) { return v < p.speed; });
  return static_cast<std::size_t>(above - points_.begin());
}

double PullOutCurve::operator()(double speed) const {
  const std::size_t above = points_up_to(speed);
  if (above == 0) return points_.front().torque;
  if (above == points_.size()) return points_.back().torque;
  const Point& from = points_[above - 1];
  const Point& to = points_[above];
  const double torque = from.torque + (speed - from.speed) / (to.speed - from.speed) * (to.torque - from.torque);
  const auto [least, most] = std::minmax(from.torque, to.torque);
  return std::clamp(torque, least, most);
}

Interval PullOutCurve::operator()(const Interval& speed) const {
  const auto at = [this](double v) -> Interval {
    const std::size_t above = points_up_to(v);
    if (above == 0) return points_.front().torque;
    if (above == points_.size()) return points_.back().torque;
    return on_segment(points_[above - 1], points_[above], v);
  };
  return {at(speed.upper).lower, at(speed.lower).upper};  // it never rises
}

double PullOutCurve::slope(double speed) const {
  const std::size_t above = points_up_to(speed);
  if (above == 0 || above == points_.size()) return 0.0;
  const Point& from = points_[above - 1];
  const Point& to = points_[above];
  return (to.torque - from.torque) / (to.speed - from.speed);
}

Interval PullOutCurve::slopes(const Interval& speed) const {
  // Segment k lies below point k; the first and the last are the level continuations. A kink at an end of the range
  // counts with both its segments.
  const auto segment = [this](std::size_t k) -> Interval {
    if (k == 0 || k == points_.size()) return 0.0;
    const Point& from = points_[k - 1];
    const Point& to = points_[k];
    return (Interval(to.torque) - from.torque) / (Interval(to.speed) - from.speed);
  };
  std::size_t k = points_up_to(speed.lower);
  if (k > 0 && points_[k - 1].speed == speed.lower) --k;
  Interval all = segment(k);
  for (; k < points_.size() && points_[k].speed <= speed.upper; ++k) all = hull(all, segment(k + 1));
  return all;
}

namespace {

/// Straight between the speeds of both and where they cross.
PullOutCurve lesser_of(const PullOutCurve& a, const PullOutCurve& b) {
  std::vector<double> speeds;
  for (const PullOutCurve* curve : {&a, &b})
    for (const Point& point : curve->points()) speeds.push_back(point.speed);
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  const auto least = [&](double speed) { return std::min(a(speed), b(speed)); };
  std::vector<Point> points;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double before = i > 0 ? a(speeds[i - 1]) - b(speeds[i - 1]) : 0.0, here = a(speeds[i]) - b(speeds[i]);
    if (before * here < 0.0) {
      const double crossing = speeds[i - 1] + before / (before - here) * (speeds[i] - speeds[i - 1]);
      if (crossing > speeds[i - 1] && crossing < speeds[i]) points.push_back({crossing, least(crossing)});
    }
    points.push_back({speeds[i], least(speeds[i])});
  }
  return PullOutCurve(std::move(points));
}

}  // namespace

PullOutCurve least_of(std::span<const PullOutCurve> curves) {
  if (curves.empty()) throw std::invalid_argument("the least of no pull-out curve");
  PullOutCurve least = curves.front();
  for (const PullOutCurve& curve : curves.subspan(1)) least = lesser_of(least, curve);
  return least;
}

}  // namespace millwright::mechanics
