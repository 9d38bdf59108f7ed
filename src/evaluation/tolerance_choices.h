// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "evaluation/condition_trials.h"

namespace millwright::evaluation {

/// For every estimated figure of the chosen parts with a stated tolerance: the best build if it were at either end.
/// Stops after so many seconds; what was not tried is counted.
void find_figure_ends(ConditionTrials& trials, double seconds, Explanation& result);

}  // namespace millwright::evaluation
