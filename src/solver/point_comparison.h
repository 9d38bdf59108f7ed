// SPDX-License-Identifier: Apache-2.0
//
// When a point of a stage is as good as what may be elsewhere: in every score, and in every component of the state in
// its proved direction.
#pragma once

#include <span>

#include "solver/continuous.h"

namespace millwright::solver {

/// By how much a point may be worse than what it stands for: a part of it, and what the label itself does not tell.
struct Slack {
  double part = 0.0;
  std::span<const double> score, state;

  [[nodiscard]] double of_score(std::size_t k) const { return score.empty() ? 0.0 : score[k]; }
  [[nodiscard]] double of_state(std::size_t c) const { return state.empty() ? 0.0 : state[c]; }
};

/// Whether a known point may stand for everything with at least these scores (own share) and with states in these
/// ranges.
bool as_good(const LeafQuestion& question,
             std::span<const double> known_score,
             std::span<const double> known_state,
             std::span<const double> score,
             std::span<const Interval> state,
             const Slack& allowed);

/// Whether a point is no better than another in any score and in any component of the state.
bool dominated_by(const StagePlan& plan,
                  std::span<const double> old_score,
                  std::span<const double> old_state,
                  std::span<const double> score,
                  std::span<const double> state);

/// Widens the enclosure of a component so that it holds a state, too. In a good direction only the better side needs to
/// be enclosed: the worse is no better than the point.
void stand_for(const StagePlan& plan, Interval& enclosure, const Interval& state, std::size_t component);

}  // namespace millwright::solver
