// SPDX-License-Identifier: Apache-2.0
//
// Where something new on a front of three objectives must lie: below one of the corners that the points known leave
// open, in every objective. Points that are beaten by others make no difference.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/archive.h"

namespace millwright::solver {

class FrontCorners {
 public:
  using Point = std::array<double, 3>;

  FrontCorners();

  /// Nothing that is at least this in every objective is new any more. What is endless in one leaves no corner.
  void add(const Point& point);
  /// Whether some corner is larger than `lower` in every objective and `accepted`. What no point known is below,
  /// endless or not, is below the corner that is as large as you like.
  template <class Accepted>
  [[nodiscard]] bool above(Point lower, Accepted&& accepted) const {
    for (double& x : lower) x = std::min(x, 0.5 * endless);
    const Point smallest = turned(next(lower));
    return corners_.any_at_most(smallest, [&](Archive::Name name) { return accepted(by_name_[name]); });
  }
  [[nodiscard]] std::size_t size() const { return corners_.size(); }

 private:
  /// What stands for "as large as you like": sums of such are still numbers.
  static constexpr double endless = 1e300;

  static Point turned(const Point& point) { return {-point[0], -point[1], -point[2]}; }
  static Point next(Point point) {
    for (double& x : point) x = std::nextafter(x, std::numeric_limits<double>::infinity());
    return point;
  }
  void keep(const Point& corner);

  Archive corners_;             ///< turned round: what is at most there is a corner at least as large
  std::vector<Point> by_name_;  ///< those that are gone too
  std::vector<Archive::Name> gone_;
};

}  // namespace millwright::solver
