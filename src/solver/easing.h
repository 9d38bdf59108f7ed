// SPDX-License-Identifier: Apache-2.0
//
// Variables that move one component handed on (least_state.h) stand, in a build that a search has found, where it is
// least. A build whose later stages do not need the last bit of it (a supply that could do more) is better off with
// less strain: a choice between equals, nothing is claimed about it.
#pragma once

#include <vector>

#include "solver/criteria.h"
#include "solver/stage_plan.h"

namespace millwright::solver {

/// Moves these variables towards where the worst utilisation of their own stage is small, all together if that can be,
/// else one stage after the other and as far as that can be: the build stays feasible and its scores as they are.
void ease(
    const Problem& problem, const Criteria& criteria, const std::vector<StagePlan>& plans, Build& build, Desk& desk);

}  // namespace millwright::solver
