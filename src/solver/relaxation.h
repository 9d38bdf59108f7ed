// SPDX-License-Identifier: Apache-2.0
//
// The least that one stage can add to a score (or to a state component), whatever label arrives: best-first branch and
// bound at the best state that can arrive. The bound is valid whenever the search stops. The regions left open at the
// end cover every design that is feasible for some label, so the search proper starts from them instead of starting
// from the whole stage for every label again.
#pragma once

#include "solver/stage_plan.h"

namespace millwright::solver {

/// What is made small: a score, or a component of the state handed on in its good direction.
struct RelaxedTarget {
  enum class Kind { score, state } kind = Kind::score;
  std::size_t index = 0;
};

struct Relaxation {
  double least = 0.0;  ///< +infinity: no design is feasible at any state that can arrive
  std::vector<OpenRegion> open;
};

Relaxation relax(const StagePlan& plan, RelaxedTarget target, std::size_t node_limit, Desk& desk);

/// Whether bisection of the variables proves, within `limit` boxes, that a region has no feasible design.
bool proves_infeasible(
    const StagePlan& plan, std::span<const Interval> inherited, const Region& region, std::size_t limit, Desk& desk);

}  // namespace millwright::solver
