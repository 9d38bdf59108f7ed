// SPDX-License-Identifier: Apache-2.0
#include "solver/leaf_precision.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace millwright::solver {

namespace {

constexpr double coarse = 0.01;

bool may_be_finer(const LeafPrecision& precision, double tolerance) {
  constexpr int fewest = 4, most = 12;
  constexpr double far = 1e-4;
  return precision.refinements < fewest || (precision.refinements < most && precision.tolerance > far * tolerance);
}

}  // namespace

LeafPrecision first_precision(const std::vector<StagePlan>& plans,
                              double tolerance,
                              std::size_t objectives,
                              bool left_open) {
  const bool needs_many = std::any_of(plans.begin(), plans.end(), [](const StagePlan& plan) {
    return is_covered(plan) && std::count(plan.after.begin(), plan.after.end(), Direction::equal_only) > 0;
  });
  if (needs_many && objectives == 1) return {std::max(coarse, tolerance), 0, true};
  if (left_open) return {tolerance, 0, true, 0};
  return {tolerance};
}

std::optional<LeafPrecision> next_precision(const LeafPrecision& last,
                                            UndecidedDesigns undecided,
                                            double tolerance,
                                            std::size_t objectives) {
  constexpr int enough = 1;  // refinements everywhere, which take longer and longer
  if (!last.refined_later && objectives == 1 && last.refinements == enough)
    return LeafPrecision{std::max(coarse, tolerance), 0, true, enough + 1};
  if (may_be_finer(last, tolerance))
    return LeafPrecision{refined_part * last.tolerance,
                         last.refinements + 1,
                         last.refined_later,
                         last.everywhere_next,
                         std::move(undecided)};
  if (!last.refined_later || !last.everywhere_next) return std::nullopt;
  return LeafPrecision{tolerance * std::pow(refined_part, *last.everywhere_next), *last.everywhere_next};
}

}  // namespace millwright::solver
