// SPDX-License-Identifier: Apache-2.0
//
// Which choices of the best build are forced, and what the next best of the others costs.
#pragma once

#include "evaluation/condition_trials.h"

namespace millwright::evaluation {

/// The best build, as the search knows it.
struct BestBuild {
  std::unique_ptr<MachineModel> model;
  solver::Build build;
};
/// Throws TimeIsUp.
BestBuild find_best(ConditionTrials& trials, const std::string& objective);

/// Fills `choices` of an explanation whose design is known: for every slot, and for the supply voltage where there is a
/// choice, the machine is solved without what the best build has there. Throws TimeIsUp; what was found until then
/// stays.
void find_choices(ConditionTrials& trials, const BestBuild& best, Explanation& result);

}  // namespace millwright::evaluation
