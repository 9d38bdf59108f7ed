// SPDX-License-Identifier: Apache-2.0
//
// A label is a complete choice for the first stages: what they cost together (scores) and what they hand on (state).
// The stages after it need to know nothing else, so two labels can be compared (dominance.h) and one forgotten.
//
// When a continuous variable moves scores or state, one label stands for many designs that differ by about the
// tolerance. It is then a point (a real, feasible design) and an enclosure: lower bounds of the scores, and intervals
// of the state, of everything it stands for. Without such variables point and enclosure are the same. While a search is
// to be refined (leaf_precision.h) the point may be infeasible where others in the enclosure may not be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/stage_plan.h"

namespace millwright::solver {

/// A box of the variables of one stage in which something is undecided (undecided_designs.h).
struct OpenBox {
  using Origin = std::uint32_t;
  std::vector<Interval> sides = {};  ///< none: any
  Origin origin = 0;                 ///< what may follow designs in it
};

struct Label {
  std::uint32_t parent = 0;  ///< index of the label before it in the store; the first label is its own parent
  std::size_t stage = 0;     ///< the next stage to be chosen
  std::vector<Row> rows;     ///< of the stage before `stage`
  std::vector<double> variables;
  std::vector<OpenBox> boxes = {};            ///< of variables that it stands for, where they are kept
  std::vector<OpenBox::Origin> origins = {};  ///< what may follow it; none: anything
  std::vector<double> resources;              ///< totals of the point
  std::vector<double> score;                  ///< totals of the point
  std::vector<double> score_lower;            ///< totals of the enclosure
  std::vector<double> state;                  ///< of the point
  std::vector<Interval> enclosure;            ///< of the state, contains the point
  double utilisation = 0.0;                   ///< worst so far
  bool alive = true;                          ///< not dominated by a later label
  bool exact = true;                          ///< point and enclosure are the same
  bool feasible = true;  ///< false: the point itself breaks a constraint that others in the enclosure may keep
};

/// Lower bounds of what some designs are worth before the next stage.
struct Worth {
  std::span<const double> score;
  std::span<const Interval> state;
  double utilisation = 0.0;
};

/// The label before the first stage.
inline Label first_label(const Problem& problem, const Criteria& criteria) {
  Label label;
  label.resources.assign(problem.resources.size(), 0.0);
  label.score.assign(criteria.size(), 0.0);
  label.score_lower = label.score;
  label.state = problem.first_state;
  label.enclosure.assign(problem.first_state.begin(), problem.first_state.end());
  return label;
}

}  // namespace millwright::solver
