// SPDX-License-Identifier: Apache-2.0
//
// The second half of continuous.h: covers the useful designs of a box of variables that move the outcome by feasible
// points.
#pragma once

#include "solver/continuous.h"

namespace millwright::solver {

/// For a question whose plan is covered (is_covered).
LeafAnswer cover(const LeafQuestion& question, Desk& desk);

}  // namespace millwright::solver
