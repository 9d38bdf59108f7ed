// SPDX-License-Identifier: Apache-2.0
//
// The feasible points that cover a box of variables (cover.h), and what each stands for.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solver/archive.h"
#include "solver/point_comparison.h"

namespace millwright::solver {

class CoverPoints {
 public:
  /// `question` has to outlive it.
  explicit CoverPoints(const LeafQuestion& question)
      : question_(question), keys_(question), by_key_(keys_.dimensions()), turned_round_(keys_.dimensions()) {}

  [[nodiscard]] bool empty() const { return known_.size() == replaced_; }
  /// Takes a feasible point that stands for itself, unless a known one is as good. Those that it is as good as go.
  void add(StagePoint point);
  /// A point that is as good as all of these bounds allow, but for the slack; from now on it is needed. Null: none is.
  [[nodiscard]] StagePoint* cover(const Bounds& bounds, const Slack& slack);
  [[nodiscard]] bool has_as_good(const Bounds& bounds, const Slack& slack) const;
  /// Those that are needed, or all.
  [[nodiscard]] std::vector<StagePoint> take(bool all) &&;

 private:
  struct Known {
    StagePoint point;
    std::vector<double> key;
    bool needed = false;
    bool replaced = false;
  };
  void replace_dominated(Known& known);
  void take_over(const StagePoint& old, StagePoint& point) const;
  /// The place of a point whose key is at most these limits; none: the number of points.
  [[nodiscard]] std::size_t within(std::span<const double> limits) const;
  void add_to_boxes(StagePoint& point) const;

  const LeafQuestion& question_;
  PointKeys keys_;
  std::vector<Known> known_;
  Archive by_key_;        ///< of those that have not been replaced
  Archive turned_round_;  ///< the same: minus their keys
  std::size_t replaced_ = 0;
};

}  // namespace millwright::solver
