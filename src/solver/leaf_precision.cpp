// SPDX-License-Identifier: Apache-2.0
#include "solver/leaf_precision.h"

#include <algorithm>

namespace millwright::solver {

LeafPrecision first_precision(const std::vector<StagePlan>& plans, double tolerance, std::size_t objectives) {
  constexpr double coarse = 0.01;
  const bool needs_many = std::any_of(plans.begin(), plans.end(), [](const StagePlan& plan) {
    return plan.any_priced && std::count(plan.after.begin(), plan.after.end(), Direction::equal_only) > 0;
  });
  if (needs_many && objectives == 1) return {coarse, true, {}};
  return {tolerance, false, {}};
}

LeafPrecision finer(const LeafPrecision& precision, UndecidedDesigns undecided) {
  constexpr double part = 1.0 / 16.0;
  return {part * precision.tolerance, precision.refined_later, std::move(undecided)};
}

}  // namespace millwright::solver
