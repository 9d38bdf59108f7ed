// SPDX-License-Identifier: Apache-2.0
//
// Labels that divide the regions of their stage together (shared_regions.h).
#include "solver/branch_and_bound.h"

namespace millwright::solver {

/// What may follow a label comes up.
void BranchAndBound::follow(std::uint32_t label) {
  const auto& shared = shared_[labels_[label].stage];
  cells_.push_back(shared != nullptr ? shared->cell_of(labels_[label].enclosure) : nullptr);
  Node stream;
  if (make_stream(label, 0, stream)) push(std::move(stream));
}

/// Few labels are done sooner one by one: at their own states bounds are closer.
bool BranchAndBound::shares_regions(std::uint32_t label) const {
  return cells_[label] != nullptr && cells_[label]->labels >= control_.options().labels_together;
}

/// A part that labels share, for that of `from`; null: nothing is feasible in it.
void BranchAndBound::offer(const Node& from, SharedPart* part, Outcome& outcome) const {
  if (part == nullptr) return;
  const Label& label = labels_[from.label];
  Node node;
  node.label = from.label;
  node.part = part;
  node.utilisation = from.utilisation;
  node.depth = from.depth + 1;
  shared_[label.stage]->hand_on(*cells_[from.label], label.enclosure, part->bounds, node.handed_on);
  if (!bearable(plans_[label.stage], node.handed_on)) return;
  note_scores(part->bounds, node);
  node.take_over_bounds(from);
  outcome.nodes.push_back(std::move(node));
}

/// Whether another label has asked all that `expand` has to know.
bool BranchAndBound::asks_nothing(const Node& node) const {
  if (node.part != nullptr) return node.part->divided;
  return node.next_region != whole_stage && shares_regions(node.label) &&
         cells_[node.label]->bounded[node.next_region] != 0;
}

void BranchAndBound::expand_part(const Node& node, Outcome& outcome, Desk& desk) const {
  const std::size_t stage = labels_[node.label].stage;
  SharedPart& part = *node.part;
  if (part.single_design || !shared_[stage]->divide(*cells_[node.label], part, worth_[stage], desk))
    return offer(node, part.region, outcome, desk);
  outcome.divided = part.slot;
  for (const auto& half : part.halves) offer(node, half.get(), outcome);
}

}  // namespace millwright::solver
