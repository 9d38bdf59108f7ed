// SPDX-License-Identifier: Apache-2.0
#include "solver/point_comparison.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {

bool as_good(const LeafQuestion& question,
             std::span<const double> known_score,
             std::span<const double> known_state,
             std::span<const double> score,
             std::span<const Interval> state,
             const Slack& allowed) {
  const StagePlan& plan = *question.plan;
  for (std::size_t k = 0; k < score.size(); ++k) {
    const double total = question.label->score_lower[k] + score[k] + plan.rest[k];
    if (known_score[k] > score[k] + allowed.part * std::fabs(total) + allowed.of_score(k)) return false;
  }
  for (std::size_t c = 0; c < state.size(); ++c) {
    // Without a bound nothing is known of what a point would stand for.
    if (plan.after[c] != Direction::irrelevant && !state[c].is_bounded()) return false;
    const double slack = allowed.part * magnitude(state[c]) + allowed.of_state(c);
    switch (plan.after[c]) {
      case Direction::irrelevant:
        break;
      case Direction::smaller_is_better:
        if (known_state[c] > state[c].lower + slack) return false;
        break;
      case Direction::larger_is_better:
        if (known_state[c] < state[c].upper - slack) return false;
        break;
      case Direction::equal_only:
        if (state[c].upper - state[c].lower > slack) return false;
        if (!(std::fabs(known_state[c] - middle(state[c])) <= slack)) return false;
        break;
    }
  }
  return true;
}

bool dominated_by(const StagePlan& plan,
                  std::span<const double> old_score,
                  std::span<const double> old_state,
                  std::span<const double> score,
                  std::span<const double> state) {
  for (std::size_t k = 0; k < score.size(); ++k)
    if (score[k] > old_score[k]) return false;
  for (std::size_t c = 0; c < state.size(); ++c) {
    switch (plan.after[c]) {
      case Direction::irrelevant:
        break;
      case Direction::smaller_is_better:
        if (state[c] > old_state[c]) return false;
        break;
      case Direction::larger_is_better:
        if (state[c] < old_state[c]) return false;
        break;
      case Direction::equal_only:
        if (state[c] != old_state[c]) return false;
        break;
    }
  }
  return true;
}

void stand_for(const StagePlan& plan, Interval& enclosure, const Interval& state, std::size_t component) {
  switch (plan.after[component]) {
    case Direction::irrelevant:
      break;
    case Direction::smaller_is_better:
      enclosure.lower = std::min(enclosure.lower, state.lower);
      break;
    case Direction::larger_is_better:
      enclosure.upper = std::max(enclosure.upper, state.upper);
      break;
    case Direction::equal_only:
      enclosure = hull(enclosure, state);
      break;
  }
}

}  // namespace millwright::solver
