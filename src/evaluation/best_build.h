// SPDX-License-Identifier: Apache-2.0
//
// The best build by one objective, in the way that is quick for it: ramps at their shortest for the least cycle time, a
// cheap build to begin with where the search itself would long know none.
#pragma once

#include "evaluation/search_options.h"

namespace millwright::evaluation {

/// By the one objective of the options. Its status is a limit where time or the stop ended it; the bound then holds.
solver::Summary best_build(const MachineModel& model, const SearchOptions& options);

}  // namespace millwright::evaluation
