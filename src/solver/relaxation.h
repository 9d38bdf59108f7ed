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

/// Cuts a box of variables down to what may be feasible, by bisecting one after the other while the others keep their
/// whole range; false: nothing is. Constraints that read one variable only (the ramp of one of several moves, say) are
/// settled so in a line of boxes, where bisecting all variables together takes a number with as many factors. A
/// variable of which more than `most_pieces` pieces stay open is left at that.
bool narrow_one_by_one(const StagePlan& plan,
                       std::span<const Interval> inherited,
                       const Region& region,
                       std::vector<Interval>& sides,
                       std::size_t most_pieces,
                       Desk& desk);

inline constexpr std::size_t usual_proof_boxes = 60;
/// Whether designs of which `bound` says this are of no use even if they are feasible.
using OfNoUse = std::function<bool(const Answer<Interval>& answer)>;
/// Whether bisection of the variables proves, within `limit` boxes, that a region has no feasible design, or none but
/// such as are of no use.
bool proves_infeasible(const StagePlan& plan,
                       std::span<const Interval> inherited,
                       const Region& region,
                       std::size_t limit,
                       Desk& desk,
                       const OfNoUse& of_no_use = {});

}  // namespace millwright::solver
