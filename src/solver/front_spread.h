// SPDX-License-Identifier: Apache-2.0
//
// Builds from all over a front, for a search that was ended before it got there: best first in one objective, it knows
// the end that it began with.
#pragma once

#include <functional>
#include <vector>

#include "solver/solver.h"

namespace millwright::solver {

/// The front of `known`, which have to be feasible, and of what is found near the best of them in each objective, going
/// step by step to what counts another one more. Of builds that differ by no more than Options::gap, to which
/// continuous variables are found, there is one. Ascending in the first objective. Nothing is proved about it. `stop`
/// is asked now and then.
std::vector<Build> spread_front(const Problem& problem,
                                const Options& options,
                                std::vector<Build> known,
                                const std::function<bool()>& stop);

}  // namespace millwright::solver
