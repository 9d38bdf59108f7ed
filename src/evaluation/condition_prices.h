// SPDX-License-Identifier: Apache-2.0
//
// What each thing that is asked costs on its own, all else as it is.
#pragma once

#include "evaluation/slot_choices.h"

namespace millwright::evaluation {

/// Fills `prices`, `unsettled` and `costless` of an explanation whose design is known. Throws TimeIsUp.
void find_prices(ConditionTrials& trials, const BestBuild& best, Explanation& result);

}  // namespace millwright::evaluation
