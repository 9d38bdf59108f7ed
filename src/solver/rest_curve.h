// SPDX-License-Identifier: Apache-2.0
//
// How dear what is left must be, by what has been handed on. The least of each stage on its own (StagePlan::rest) is
// found at the best state that can arrive, and so says nothing of a label that spent little and left the next stage a
// heavy load, or used up most of a tolerance that all stages share. A curve does: for some values s of one component
//
//   R_i(s) = min over the designs of stage i that are feasible from s on: score + R_(i+1)(what they hand on),
//
// from the base to the tool, by best-first search over the regions of the stage's frontier. A component has a curve
// only where smaller is proved to be better (monotonicity.h): then nothing that is feasible with more is cheaper than
// R_i(s). All other components are at the best that can arrive, so that a curve is a lower bound for every label.
#pragma once

#include "solver/stage_plan.h"

namespace millwright::solver {

/// Fills StagePlan::curves of all stages, for the objectives. `most[score]` is a total above which nothing matters: a
/// curve need not be known where it leads beyond that (infinity: everything matters).
void find_rest_curves(std::vector<StagePlan>& plans, std::span<const double> most, Desk& desk);

/// What all later stages add at least to a score, given what is handed to them; infinity where none of their designs is
/// feasible. `lower(component)` is the least that is
/// handed on.
template <class Lower>
double rest_given(const StagePlan& plan, std::size_t score, Lower&& lower) {
  constexpr double slack = 1e-11;  // a state is the same sum in another order in the end
  double rest = plan.rest[score];
  for (const RestCurve& curve : plan.curves) {
    if (curve.score != score) continue;
    double state = lower(curve.component);
    state -= slack * (state < 0.0 ? -state : state);
    for (std::size_t i = curve.from.size(); i-- > 0;) {
      if (curve.from[i] > state) continue;
      if (curve.least[i] > rest) rest = curve.least[i];
      break;
    }
  }
  for (const RestPlane& plane : plan.planes) {
    if (plane.score != score) continue;
    double priced = 0.0;
    for (std::size_t c = 0; c < plane.weight.size(); ++c) {
      if (plane.weight[c] > 0.0) priced += plane.weight[c] * lower(c);
    }
    const double least = plane.constant + priced - slack * (priced < 0.0 ? -priced : priced);
    if (least > rest) rest = least;
  }
  for (const RestStairs& stairs : plan.stairs) {
    if (stairs.score != score) continue;
    double priced = stairs.constant;
    double left = stairs.limit * (1.0 + slack);
    for (std::size_t c = 0; c < stairs.weight.size(); ++c) {
      if (stairs.weight[c] > 0.0) priced += stairs.weight[c] * lower(c);
      if (stairs.use[c] > 0.0) left -= stairs.use[c] * lower(c);
    }
    priced -= slack * (priced < 0.0 ? -priced : priced);
    const double least = priced + least_within(stairs.least, left);
    if (least > rest) rest = least;
  }
  return rest;
}
inline double rest_after(const StagePlan& plan, std::size_t score, std::span<const Interval> handed_on) {
  return rest_given(plan, score, [&](std::size_t component) { return handed_on[component].lower; });
}
inline double rest_after(const StagePlan& plan, std::size_t score, std::span<const double> handed_on) {
  return rest_given(plan, score, [&](std::size_t component) { return handed_on[component]; });
}

}  // namespace millwright::solver
