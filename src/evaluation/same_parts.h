// SPDX-License-Identifier: Apache-2.0
//
// A build of one model in another one of the same machine, of which something else is asked.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// Whether two candidates are the same parts of one catalogue, in the same form and with the same settings.
bool same_candidate(const Candidate& a, const Candidate& b);
/// A row of each slot's list that fit each other, the first ones of which that holds; nothing if there are none.
std::optional<std::vector<solver::Row>> rows_that_fit(const solver::Stage& stage,
                                                      std::span<const solver::Row> shared,
                                                      const std::vector<std::vector<solver::Row>>& lists);
/// Whether two machines have the same candidates, row by row.
bool same_candidates(const std::vector<StageEntry>& a, const std::vector<StageEntry>& b);

/// `build` of the model `from` with the rows that the same parts and settings have in `to`, and its variables within
/// their ranges there; nothing where it has them no more. Not evaluated: it need not be compliant there.
std::optional<solver::Build> same_parts_in(const MachineModel& to,
                                           const MachineModel& from,
                                           const solver::Build& build);

}  // namespace millwright::evaluation
