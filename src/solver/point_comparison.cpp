// SPDX-License-Identifier: Apache-2.0
#include "solver/point_comparison.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {

PointKeys::PointKeys(const LeafQuestion& question) : question_(question) {
  dimensions_ = question.plan->criteria->size();
  for (const Direction direction : question.plan->after)
    dimensions_ += direction == Direction::irrelevant ? 0 : direction == Direction::equal_only ? 2 : 1;
}

void PointKeys::key_of(std::span<const double> score, std::span<const double> state, std::vector<double>& key) const {
  key.assign(score.begin(), score.end());
  for (std::size_t c = 0; c < state.size(); ++c) {
    const Direction direction = question_.plan->after[c];
    if (direction == Direction::smaller_is_better || direction == Direction::equal_only) key.push_back(state[c]);
    if (direction == Direction::larger_is_better || direction == Direction::equal_only) key.push_back(-state[c]);
  }
}

bool PointKeys::limits_of(std::span<const double> score,
                          std::span<const Interval> state,
                          const Slack& allowed,
                          std::vector<double>& limits) const {
  const StagePlan& plan = *question_.plan;
  limits.clear();
  for (std::size_t k = 0; k < score.size(); ++k) {
    const double total = question_.label->score_lower[k] + score[k] + plan.rest[k];
    limits.push_back(score[k] + allowed.part * std::fabs(total) + allowed.of_score(k));
  }
  for (std::size_t c = 0; c < state.size(); ++c) {
    if (plan.after[c] == Direction::irrelevant) continue;
    // Without a bound nothing is known of what a point would stand for.
    if (!state[c].is_bounded()) return false;
    const double slack = allowed.part * magnitude(state[c]) + allowed.of_state(c);
    if (plan.after[c] == Direction::smaller_is_better) {
      limits.push_back(state[c].lower + slack);
    } else if (plan.after[c] == Direction::larger_is_better) {
      limits.push_back(slack - state[c].upper);
    } else {
      if (state[c].upper - state[c].lower > slack) return false;
      limits.push_back(middle(state[c]) + slack);
      limits.push_back(slack - middle(state[c]));
    }
  }
  return true;
}

bool as_good(const PointKeys& keys,
             std::span<const double> known_score,
             std::span<const double> known_state,
             std::span<const double> score,
             std::span<const Interval> state,
             const Slack& allowed) {
  thread_local std::vector<double> limits, key;
  if (!keys.limits_of(score, state, allowed, limits)) return false;
  keys.key_of(known_score, known_state, key);
  for (std::size_t d = 0; d < key.size(); ++d)
    if (key[d] > limits[d]) return false;
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
