// SPDX-License-Identifier: Apache-2.0
#include "solver/proved_directions.h"

#include "solver/stage_plan.h"

namespace millwright::solver {

std::span<const StageDirections> ProvedDirections::of(std::span<const Row> shared, Desk& desk) {
  const std::vector<Row> combination(shared.begin(), shared.end());
  auto found = known_.find(combination);
  if (found == known_.end()) {
    const Criteria criteria = make_criteria(problem_, options_);
    found = known_.emplace(combination, directions_of(problem_, combination, criteria, desk)).first;
  }
  return found->second;
}

}  // namespace millwright::solver
