// SPDX-License-Identifier: Apache-2.0
//
// When a label, or a whole region of designs that have not been looked at yet, can be forgotten because a known label
// is at least as good in everything that can still matter: objectives, resources with a limit, and every state
// component in its proved direction (monotonicity.h); a component without a proved direction has to be equal. States
// are compared as objectives are (criteria.h): the same sum in another order counts as equal.
//
// Components that only make a total the largest of its floors (stage.h) need not be compared: the floors are, instead.
// A label that is less in an objective is so in the end only if it is less in its floors, too.
//
// Equal objectives are decided by the tie scores and then by the worst utilisation: a label that is strictly better in
// an objective need not be as good in those; one that is equal in all objectives must be.
//
// Of a front that is covered to a tolerance, objectives that are worse by a part of what the whole comes to at least
// may count as being as good: `slack`. Thousands of labels differ by less, in states of which none is better in
// everything. What is forgotten so falls short of what is known by that part before each stage, no more: a label that
// has been added is only forgotten for one that is as good without slack. (Objectives with a limit have none: what
// exceeds it could stand for what keeps it.) Ties still decide between equals, the worst utilisation does not: between
// builds within a tolerance it is not looked at either (incumbents.h).
//
// A label that stands for more than its own point (labels.h) does so for anything that is no better than the best of
// what it stands for, too: whatever can follow that can follow something within its enclosure (of which nothing is more
// than later stages can bear), and what is done below the label is done for its enclosure and with its lower bounds. So
// such designs are not followed one by one, but their points may be feasible where the label's is not: a finer search
// after one that left something undecided (leaf_precision.h) compares with points again. So does one whose undecided
// designs are written down for that: what a label stands for is among them.
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
  LabelSet(const Criteria& criteria,
           std::span<const Direction> directions,
           std::deque<Label>& store,
           Dominating by,
           double slack);

  /// From now on; more than before.
  void set_slack(double slack) { slack_ = slack; }
  /// Whether some label makes everything in `worth` superfluous. `total`: lower bounds of the whole's scores.
  [[nodiscard]] bool dominates(const Worth& worth, std::span<const double> total) const;
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
  double slack_;
  Archive known_;     ///< keys of labels that are alive
  Archive replaced_;  ///< the same turned round: minus the keys of what they stand for
};

}  // namespace millwright::solver
