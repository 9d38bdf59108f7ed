// SPDX-License-Identifier: Apache-2.0
#include "solver/leaf_precision.h"

#include <algorithm>

namespace millwright::solver {

LeafPrecision first_precision(const std::vector<StagePlan>& plans, double tolerance, std::size_t objectives) {
  constexpr double coarse = 0.01;
  const bool needs_many = std::any_of(plans.begin(), plans.end(), [](const StagePlan& plan) {
    return is_covered(plan) && std::count(plan.after.begin(), plan.after.end(), Direction::equal_only) > 0;
  });
  if (needs_many && objectives == 1) return {std::max(coarse, tolerance), 0, true, {}};
  return {tolerance, 0, false, {}};
}

bool may_be_finer(const LeafPrecision& precision, double tolerance) {
  constexpr int fewest = 4, most = 12;
  constexpr double far = 1e-4;
  return precision.refinements < fewest || (precision.refinements < most && precision.tolerance > far * tolerance);
}

LeafPrecision finer(const LeafPrecision& precision, UndecidedDesigns undecided) {
  return {refined_part * precision.tolerance, precision.refinements + 1, precision.refined_later, std::move(undecided)};
}

}  // namespace millwright::solver
