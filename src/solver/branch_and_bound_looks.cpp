// SPDX-License-Identifier: Apache-2.0
//
// Two ways to a build that makes much of what is open hopeless, which prove nothing: a beam search through the stages,
// for a good one, and a dive, for any.
#include <cmath>
#include <utility>

#include "solver/branch_and_bound.h"

namespace millwright::solver {

void BranchAndBound::look(std::size_t labels, std::uint64_t most_nodes) {
  start();
  for (last_stage_ = 0; last_stage_ < plans_.size() && !control_.time_is_up(); ++last_stage_) {
    std::uint64_t since_arrival = 0;
    while (!open_.empty() && waiting_.size() < labels && !control_.time_is_up()) {
      if (since_arrival > (waiting_.empty() ? most_nodes : most_nodes / 10)) break;
      const std::uint64_t before = nodes_;
      const std::size_t arrived = waiting_.size();
      work_on_batch();
      since_arrival = waiting_.size() > arrived ? 0 : since_arrival + nodes_ - before;
      control_.report(incumbents_.best());
    }
    open_ = {};
    for (Node& node : std::exchange(waiting_, {})) put(std::move(node));
  }
}

/// Until a node is a design of all stages.
double BranchAndBound::divisions_left(const Node& node) const {
  const std::size_t stage = labels_[node.label].stage;
  const double after = divisions_after_[stage];
  if (node.next_region != whole_stage) return after + plans_[stage].open_regions[node.next_region].region.divisions();
  return after + (node.part != nullptr ? node.part->divisions : node.region.divisions());
}

void BranchAndBound::dive(std::uint64_t most_nodes) {
  constexpr double expected_rise = 0.1;  // of the least score, from the whole to a design
  divisions_after_.assign(plans_.size(), 0.0);
  double all = 0.0;
  for (std::size_t stage = plans_.size(); stage-- > 0;) {
    divisions_after_[stage] = all;
    all += plans_[stage].region.divisions();
  }
  start();
  if (open_.empty() || !(all > 0.0) || !std::isfinite(open_.first().score[0])) return;
  later_for_divisions_ = expected_rise * std::fabs(open_.first().score[0]) / all;
  const double known = incumbents_.best();
  while (!open_.empty() && nodes_ < most_nodes && !(incumbents_.best() < known) && !control_.time_is_up()) {
    work_on_batch();
    control_.report(incumbents_.best());
  }
}

}  // namespace millwright::solver
