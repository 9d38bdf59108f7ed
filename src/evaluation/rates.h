// SPDX-License-Identifier: Apache-2.0
//
// What a little of each condition is worth where continuous dimensions move the objective: its derivative with respect
// to the condition's value, with the parts of the best build kept.
#pragma once

#include "evaluation/condition_trials.h"

namespace millwright::evaluation {

/// Fills `rates` of an explanation whose design is known. From the multipliers of the constraints that hold the build's
/// dimensions (solver/multipliers.h); each rate is then tried: local solvers settle the same parts once more with the
/// condition a thousandth looser, and where that does not save what the rate says there is none. Throws TimeIsUp.
void find_rates(ConditionTrials& trials, Explanation& result);

}  // namespace millwright::evaluation
