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
  const Options& options = control_.options();
  const std::size_t many = criteria_.objectives > 1 ? options.labels_together : options.labels_together_for_one;
  return cells_[label] != nullptr && cells_[label]->labels >= many;
}

/// A part that labels share, for that of `from`. False: nothing in it can follow that label.
bool BranchAndBound::make_part(const Node& from, SharedPart& part, Node& node) const {
  const Label& label = labels_[from.label];
  node.label = from.label;
  node.part = &part;
  node.utilisation = from.utilisation;
  node.depth = from.depth + 1;
  shared_[label.stage]->hand_on(*cells_[from.label], label.enclosure, part.bounds, node.handed_on);
  if (!bearable(plans_[label.stage], node.handed_on)) return false;
  note_scores(part.bounds, node);
  node.take_over_bounds(from);
  return true;
}

/// Takes up a part as far as it may matter: of what others have divided all that is no dearer than `up_to` at once, the
/// rest when its turn comes. Null: nothing is feasible in it.
void BranchAndBound::go_down(const Node& from, SharedPart* part, double up_to, Outcome& outcome) const {
  if (part == nullptr) return;
  const Label& label = labels_[from.label];
  thread_local std::vector<double> score;
  score.resize(part->least.size());
  for (std::size_t k = 0; k < score.size(); ++k) score[k] = total_down(label.score_lower[k], part->least[k]);
  criteria_.raise(score);
  const double utilisation = std::max(from.utilisation, part->bounds.utilisation);
  if (!can_end(score) || incumbents_.hopeless(score, utilisation)) return;
  Node node;
  if (!make_part(from, *part, node)) return;
  if (!part->divided || node.score[0] > up_to) return outcome.nodes.push_back(std::move(node));
  if (useless(node)) return;
  for (const auto& half : part->halves) go_down(node, half.get(), up_to, outcome);
}

/// The region that a label comes to next has to be known before it is known who asks.
void BranchAndBound::find_region(Node& node) const {
  if (node.next_region != whole_stage && shares_regions(node.label))
    node.next_region = first_to_follow(labels_[node.label], node.next_region);
}

/// Whether another label has asked all that `expand` has to know. (What others have divided may only be looked at while
/// nobody divides.)
bool BranchAndBound::asks_nothing(const Node& node) const {
  if (node.part != nullptr) return node.part->divided;
  if (node.next_region == whole_stage || !shares_regions(node.label)) return false;
  const std::vector<char>& bounded = cells_[node.label]->bounded;
  return node.next_region >= bounded.size() || bounded[node.next_region] != 0;
}

void BranchAndBound::expand_part(const Node& node, Outcome& outcome, Desk& desk) const {
  const std::size_t stage = labels_[node.label].stage;
  SharedPart& part = *node.part;
  if (part.single_design || !shared_[stage]->divide(*cells_[node.label], part, worth_[stage], desk))
    return offer(node, part.region, outcome, desk);
  outcome.divided = part.slot;
  for (const auto& half : part.halves) go_down(node, half.get(), node.score[0], outcome);
}

}  // namespace millwright::solver
