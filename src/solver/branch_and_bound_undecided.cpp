// SPDX-License-Identifier: Apache-2.0
//
// What a search label by label leaves undecided: its bound, and in which designs it is, for a finer search.
#include <algorithm>
#include <limits>

#include "solver/branch_and_bound.h"

namespace millwright::solver {

/// Without its boxes what is undecided is all of a design.
void BranchAndBound::keep_boxes(std::vector<OpenBox>& boxes) {
  constexpr std::size_t most_kept = 2000000;
  if (boxes_kept_ + boxes.size() > most_kept) boxes = {};
  boxes_kept_ += boxes.size();
}

void BranchAndBound::leave_undecided(Undecided undecided) {
  constexpr std::size_t most_kept = 100000;
  criteria_.raise(undecided.score);
  if (incumbents_.hopeless(undecided.score, undecided.utilisation)) return;
  undecided_bound_ = std::min(undecided_bound_, undecided.score[0]);
  keep_boxes(undecided.boxes);
  if (undecided_.size() < most_kept) {
    undecided_.push_back(std::move(undecided));
    return;
  }
  if (!many_undecided_) least_undecided_ = undecided.score;
  many_undecided_ = true;
  for (std::size_t k = 0; k < undecided.score.size(); ++k)
    least_undecided_[k] = std::min(least_undecided_[k], undecided.score[k]);
}

/// Something undecided matters only if no build known is as good.
void BranchAndBound::forget_settled() {
  if (many_undecided_) return;
  std::erase_if(undecided_, [&](const Undecided& each) { return incumbents_.hopeless(each.score, each.utilisation); });
  undecided_bound_ = std::numeric_limits<double>::infinity();
  for (const Undecided& each : undecided_) undecided_bound_ = std::min(undecided_bound_, each.score[0]);
}

void BranchAndBound::settle_open() {
  const auto settle = [&](const Node& node) {
    if (labels_[node.label].alive && can_end(node.score)) incumbents_.widen_to_settle(node.score, node.utilisation);
  };
  open_.for_each(settle);
  for (const Undecided& each : undecided_) incumbents_.widen_to_settle(each.score, each.utilisation);
  if (many_undecided_) incumbents_.widen_to_settle(least_undecided_, 0.0);
}

UndecidedDesigns BranchAndBound::undecided_designs() const {
  if (many_undecided_ || !precision_.refined_later) return precision_.among;
  using Origin = UndecidedDesigns::Origin;
  UndecidedDesigns designs;
  const auto add = [&](Origin before, const std::vector<Row>& rows, const std::vector<OpenBox>& boxes, Origin after) {
    if (boxes.empty()) designs.add(before, rows, {{}, after});
    for (const OpenBox& box : boxes) designs.add(before, rows, {box.sides, after});
  };
  std::vector<Origin> origin_of(labels_.size(), UndecidedDesigns::everything);  // everything: not noted yet
  origin_of[0] = designs.add_origin();
  std::vector<std::uint32_t> chain;
  for (const Undecided& each : undecided_) {
    chain.clear();
    for (std::uint32_t i = each.label; origin_of[i] == UndecidedDesigns::everything; i = labels_[i].parent)
      chain.push_back(i);
    for (; !chain.empty(); chain.pop_back()) {
      const Label& label = labels_[chain.back()];
      origin_of[chain.back()] = designs.add_origin();
      add(origin_of[label.parent], label.rows, label.boxes, origin_of[chain.back()]);
    }
    add(origin_of[each.label], each.rows, each.boxes, UndecidedDesigns::everything);
  }
  return designs;
}

}  // namespace millwright::solver
