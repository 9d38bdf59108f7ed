// SPDX-License-Identifier: Apache-2.0
//
// When the variables of a region are to be halved before its rows are told apart. With all its range left a variable
// that moves scores makes bounds loose: each part of a score takes the end that is best for it (a long ramp for the
// torque, a short one for the time). To find that out of every single design by itself takes as many times longer as
// there are designs; most of them differ in what moves no score.
//
// Stages without slots have one design, and continuous.h for it.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "solver/stage_plan.h"

namespace millwright::solver {

/// Of the variables that move the outcome the one that has most of its range left, if that is much.
std::optional<std::size_t> wide_variable(const StagePlan& plan, const Region& region);

/// The one that is to be halved first, if any: a wide one, or one that loosens the objectives more than the rows do.
/// `least`: what bounds say of the region's own share of the scores at these states.
std::optional<std::size_t> variable_to_halve(const StagePlan& plan,
                                             std::span<const Interval> inherited,
                                             const Region& region,
                                             std::span<const double> least,
                                             Desk& desk);

/// A region in two, at the middle of a variable's side.
std::pair<Region, Region> halved(const Region& region, std::size_t variable);

}  // namespace millwright::solver
