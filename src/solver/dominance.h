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

#include "solver/labels.h"

namespace millwright::solver {

/// The labels before one stage.
class LabelSet {
 public:
  LabelSet(const Criteria& criteria, std::span<const Direction> directions, std::deque<Label>& store)
      : criteria_(&criteria), store_(&store) {
    for (std::size_t c = 0; c < directions.size(); ++c) {
      if (directions[c] != Direction::irrelevant) compared_.emplace_back(c, directions[c]);
    }
  }

  /// Whether some label makes everything in `worth` superfluous.
  [[nodiscard]] bool dominates(const Worth& worth) const;
  /// Adds label `index` of the store and marks those it dominates as not alive.
  void add(std::uint32_t index);
  [[nodiscard]] std::size_t size() const { return members_.size(); }

 private:
  [[nodiscard]] int compare_scores(const Label& label, std::span<const double> score) const;
  [[nodiscard]] bool dominates(const Label& label, const Worth& worth) const;

  const Criteria* criteria_;
  std::vector<std::pair<std::size_t, Direction>> compared_;  ///< state components that matter
  std::deque<Label>* store_;
  std::vector<std::uint32_t> members_;  ///< alive, ascending in the first score
};

}  // namespace millwright::solver
