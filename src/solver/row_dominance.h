// SPDX-License-Identifier: Apache-2.0
//
// Rows that another row of their slot can always stand in for are left out once a problem turns out not to be easy, and
// of very long tables before that. Row a stands in for row b where
//   - they are of one kind and fit the same rows of other slots;
//   - what is read of them is equal but for graded readings (Stage::graded_readings), and those of a are at least as
//     good: better towards the side for which it is proved, over all designs and all states that can arrive, that every
//     utilisation, every scored resource and everything handed on that matters becomes better (monotonicity.h);
//   - among equals, a has the smaller number.
// Whatever is feasible with b is so with a, and no worse in any score. A coupling that bears less at the same price is
// such a row.
//
// Only for who looks for what is best: that a row is missing in a plan then no longer says that it cannot be chosen.
#pragma once

#include "solver/stage_plan.h"

namespace millwright::solver {

/// Of all slots. Takes the plans' directions and the states that can arrive as they are. A search that was begun with
/// the plans cannot go on with them: their open regions change, too.
void leave_out_dominated_rows(std::vector<StagePlan>& plans, Desk& desk);

/// The same of one plan, whose open regions need not be known yet, in slots with that many rows at least.
void leave_out_dominated_rows(StagePlan& plan, Desk& desk, std::size_t least_rows);

}  // namespace millwright::solver
