// SPDX-License-Identifier: Apache-2.0
//
// How the designs of a stage are gone through: regions in the ascending order of what they add, and in halves.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/split_worth.h"
#include "solver/stage_plan.h"
#include "solver/variable_halves.h"

namespace millwright::solver {

/// A positive sum of a region's coordinates, in the ascending order of which regions are taken.
class RegionOrder {
 public:
  /// `scores`: those that are the first coordinates.
  RegionOrder(const StagePlan& plan, std::span<const std::size_t> scores) {
    for (const std::size_t k : scores) weight_.push_back(1.0 / (std::fabs(plan.least[k]) + 1e-6));
  }
  /// Of a mix of the first two.
  RegionOrder(const StagePlan& plan, std::span<const std::size_t> scores, const Mix& mix) : RegionOrder(plan, scores) {
    const double unit = std::fabs(mix.of(plan.least)) + 1e-6;
    weight_[0] = mix.first / unit;
    weight_[1] = mix.second / unit;
  }
  [[nodiscard]] double value_of(std::span<const double> key, double weighed_state = 0.0) const {
    constexpr double state_weight = 1e-4;  // decides between equal scores
    double value = weighed_state;
    for (std::size_t i = 0; i < key.size(); ++i) value += key[i] * (i < weight_.size() ? weight_[i] : state_weight);
    return value;
  }

 private:
  std::vector<double> weight_;
};

/// The two halves of a region, in a wide variable or else in the rows of a slot, less rows without a partner. `open`:
/// as for RowProfile::split; `offer(part)` says what was reached with a part, or nothing when it is left out.
template <class Offer>
void branch(const StagePlan& plan,
            const Region& region,
            std::uint64_t open,
            const Reached& reached,
            SplitWorth& worth,
            Offer&& offer) {
  if (const auto variable = wide_variable(plan, region)) {
    auto [lower, upper] = halved(region, *variable);
    offer(std::move(lower));
    offer(std::move(upper));
    return;
  }
  const RowProfile::Split split = plan.profile.split(region, open, worth.of_slots());
  for (const RowSet& half : {split.left, split.right}) {
    Region part = region;
    part.rows[split.slot] = half;
    std::optional<Reached> of_part;
    if (plan.fits.filter(part, split.slot)) of_part = offer(std::move(part));
    worth.count(split.slot, reached, of_part);
  }
}

}  // namespace millwright::solver
