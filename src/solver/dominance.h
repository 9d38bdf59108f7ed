// SPDX-License-Identifier: Apache-2.0
//
// When a label, or a whole region of designs that have not been looked at yet, can be forgotten because a known label
// is at least as good in everything that can still matter: objectives, resources with a limit, and every state
// component in its proved direction (monotonicity.h); a component without a proved direction has to be equal.
//
// Equal objectives are decided by the tie scores and then by the worst utilisation: a label that is strictly better in
// an objective need not be as good in those; one that is equal in all objectives must be.
#pragma once

#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "solver/archive.h"
#include "solver/labels.h"

namespace millwright::solver {

/// The labels before one stage.
class LabelSet {
 public:
  LabelSet(const Criteria& criteria, std::span<const Direction> directions, std::deque<Label>& store);

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
  Archive known_;     ///< keys of labels that are alive
  Archive replaced_;  ///< the same turned round: minus the keys of what they stand for
};

}  // namespace millwright::solver
