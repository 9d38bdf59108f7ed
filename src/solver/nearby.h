// SPDX-License-Identifier: Apache-2.0
//
// A good build near a feasible one: rows changed one by one (neighbours.h) and variables moved by local solvers
// (multipliers.h), in turn. A search that begins with it need not look at anything worse.
#pragma once

#include <functional>

#include "solver/solver.h"

namespace millwright::solver {

/// Of the single objective of `options`; `build` has to be feasible, and so is the answer, which is never worse.
/// Nothing is proved about it. `stop` is asked now and then.
Build best_nearby(const Problem& problem, const Options& options, Build build, const std::function<bool()>& stop);

}  // namespace millwright::solver
