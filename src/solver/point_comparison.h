// SPDX-License-Identifier: Apache-2.0
//
// When a point of a stage is as good as what may be elsewhere: in every score, and in every component of the state in
// its proved direction.
#pragma once

#include <span>
#include <vector>

#include "solver/continuous.h"

namespace millwright::solver {

/// By how much a point may be worse than what it stands for: a part of it, and what the label itself does not tell.
struct Slack {
  double part = 0.0;
  std::span<const double> score, state;

  [[nodiscard]] double of_score(std::size_t k) const { return score.empty() ? 0.0 : score[k]; }
  [[nodiscard]] double of_state(std::size_t c) const { return state.empty() ? 0.0 : state[c]; }
};

/// Points as keys: one is as good as another where its key is at most as large in every coordinate. Those are the own
/// share of each score and, of the state, each component that has a direction, turned so that less is better; one that
/// has to be equal counts twice, once turned.
class PointKeys {
 public:
  /// `question` has to outlive it.
  explicit PointKeys(const LeafQuestion& question);

  [[nodiscard]] std::size_t dimensions() const { return dimensions_; }
  void key_of(std::span<const double> score, std::span<const double> state, std::vector<double>& key) const;
  /// What the key of a point must not exceed if it is to stand for everything with at least these scores (own share)
  /// and with states in these ranges. False: no point can, since a range has no bound, or is wide and has to be equal.
  [[nodiscard]] bool limits_of(std::span<const double> score,
                               std::span<const Interval> state,
                               const Slack& allowed,
                               std::vector<double>& limits) const;

 private:
  const LeafQuestion& question_;
  std::size_t dimensions_ = 0;
};

/// Whether a known point may stand for everything with at least these scores (own share) and with states in these
/// ranges.
bool as_good(const PointKeys& keys,
             std::span<const double> known_score,
             std::span<const double> known_state,
             std::span<const double> score,
             std::span<const Interval> state,
             const Slack& allowed);

/// Widens the enclosure of a component so that it holds a state, too. In a good direction only the better side needs to
/// be enclosed: the worse is no better than the point.
void stand_for(const StagePlan& plan, Interval& enclosure, const Interval& state, std::size_t component);

}  // namespace millwright::solver
