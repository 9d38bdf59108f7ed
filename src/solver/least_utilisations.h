// SPDX-License-Identifier: Apache-2.0
//
// Below what the utilisations of a stage do not come, whatever is chosen: a constraint of which that is above 1 is kept
// by no design. Proved slot by slot, from bounds over one row with everything else left open.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/box.h"

namespace millwright::solver {

/// Of one constraint.
struct LeastUtilisation {
  double value = 0.0;
  std::optional<std::size_t> slot;  ///< whose rows say so; empty where the bound over all designs says as much
  Row row = 0;                      ///< of that slot, the one that comes nearest; of equal ones the first
};

/// For every constraint, over the rows and intervals of `whole` and all states in `inherited`. What is above 1 is the
/// largest, over the slots, of the least bound among the rows of each (and of the bound over all of them); what is not
/// says only that no single slot makes the constraint fail. Of constraints that are not `asked` about the bound over
/// all designs is all that is said. Long tables are cut into sets of alike rows, of which most are never looked at row
/// by row. Throws OutOfTime when `desk.interrupt` says so.
std::vector<LeastUtilisation> least_utilisations(const Stage& stage,
                                                 std::span<const Row> shared,
                                                 std::span<const Interval> inherited,
                                                 const Region& whole,
                                                 const std::vector<bool>& asked,
                                                 Desk& desk);

}  // namespace millwright::solver
