// SPDX-License-Identifier: Apache-2.0
//
// When a label, or a whole region of designs that have not been looked at yet, can be forgotten because a known label
// is at least as good in everything that can still matter: objectives, resources with a limit, and every state
// component in its proved direction (monotonicity.h); a component without a proved direction has to be equal.
//
// Equal objectives are decided by the tie scores and then by the worst utilisation: a label that is strictly better in
// an objective need not be as good in those; one that is equal in all objectives must be.
//
// A label that stands for more than its own point (labels.h) does so for anything that is no better than the best of
// what it stands for: what is done with its lower bounds covers that, too, and it is no further from its point. Only
// where a finer search is to look at what is left undecided (leaf_precision.h) has the point itself to be as good: what
// a label stands for is written down there.
#pragma once

#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "solver/archive.h"
#include "solver/labels.h"

namespace millwright::solver {

/// By what a label dominates: by its point, or by the best of what it stands for.
enum class Dominating { point, lower_bound };

/// The labels before one stage.
class LabelSet {
 public:
  LabelSet(const Criteria& criteria, std::span<const Direction> directions, std::deque<Label>& store, Dominating by);

  /// Whether some label makes everything in `worth` superfluous.
  [[nodiscard]] bool dominates(const Worth& worth) const;
  /// Adds label `index` of the store and marks those it dominates as not alive.
  void add(std::uint32_t index);
  [[nodiscard]] std::size_t size() const { return known_.size(); }

 private:
  /// What has to be at most as large for one to dominate the other: of labels, and of what they stand for.
  void key_of(const Label& label, std::vector<double>& key) const;
  void key_of(const Worth& worth, std::vector<double>& key) const;
  [[nodiscard]] bool wins_tie(const Label& label, const Worth& worth) const;

  const Criteria* criteria_;
  std::vector<std::pair<std::size_t, Direction>> compared_;  ///< state components that matter
  std::deque<Label>* store_;
  Dominating by_;
  Archive known_;     ///< keys of labels that are alive
  Archive replaced_;  ///< the same turned round: minus the keys of what they stand for
};

}  // namespace millwright::solver
