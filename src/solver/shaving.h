// SPDX-License-Identifier: Apache-2.0
//
// Rows that cannot be in any feasible design of a stage are left out before anything else is done. Rows of short tables
// are asked about one by one; of long ones sets of alike rows are (row_profile.h), where a sample says that it is worth
// it.
#pragma once

#include "solver/stage_plan.h"

namespace millwright::solver {

/// Whether an answer shows that nothing it was given for is feasible, or leads to something that is.
bool hopeless(const StagePlan& plan, const Answer<Interval>& answer);
/// Whether no design of the region is feasible, or leads to one, at any of the inherited states.
bool hopeless(const StagePlan& plan, std::span<const Interval> inherited, const Region& region, Desk& desk);

/// Finds out what tells a slot's rows apart at these states.
void find_profile(
    const StagePlan& plan, std::span<const Interval> inherited, std::size_t slot, RowProfile& profile, Desk& desk);

/// Removes rows that cannot be in a feasible design at any of the inherited states: of short tables all that `bound`
/// shows to be so; of long ones nothing if none in a sample is, else all but a few among rows like them. False when a
/// slot is empty. Parts of long tables are taken from `tables`, or kept there for other shared choices.
bool shave(StagePlan& plan, std::span<const Interval> inherited, Desk& desk, TableMemory& tables);

}  // namespace millwright::solver
