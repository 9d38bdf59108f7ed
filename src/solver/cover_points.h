// SPDX-License-Identifier: Apache-2.0
//
// The feasible points that cover a box of variables (cover.h), and what each stands for.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/point_comparison.h"

namespace millwright::solver {

class CoverPoints {
 public:
  /// `question` has to outlive it.
  explicit CoverPoints(const LeafQuestion& question) : question_(question) {}

  [[nodiscard]] bool empty() const { return known_.empty(); }
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
    std::vector<double> score;  ///< own share of the point itself
    bool needed = false;
  };
  void replace_dominated(Known& known);
  [[nodiscard]] bool is_as_good(const Known& known, const Bounds& bounds, const Slack& slack) const {
    return as_good(question_, known.score, known.point.state, bounds.score, bounds.handed_on, slack);
  }
  void add_to_boxes(StagePoint& point) const;

  const LeafQuestion& question_;
  std::vector<Known> known_;
};

}  // namespace millwright::solver
