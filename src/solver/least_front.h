// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/stage_plan.h"
#include "solver/staircase.h"

namespace millwright::solver {

/// A lower staircase of what a stage adds to the first two scores, whatever label arrives: that of candidates.h at the
/// best state that can arrive, where every design that is not proved infeasible counts. Valid at any node limit.
std::vector<Pair> least_front(const StagePlan& plan, std::size_t node_limit, Desk& desk);

}  // namespace millwright::solver
