// SPDX-License-Identifier: Apache-2.0
#include "solver/dominance.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {

/// Whether the label is at least as good in scores: -1 no, 0 equal in all that decides, +1 strictly better.
int LabelSet::compare_scores(const Label& label, std::span<const double> score) const {
  const std::size_t objectives = criteria_->objectives;
  bool strictly = false;
  for (std::size_t k = 0; k < objectives; ++k) {
    const double known = rounded(label.score[k]);
    const double other = rounded(score[k]);
    if (known > other) return -1;
    strictly = strictly || known < other;
  }
  for (std::size_t k = objectives; k < criteria_->size(); ++k) {
    if (std::isfinite(criteria_->limit[k]) && label.score[k] > score[k]) return -1;
  }
  if (strictly) return 1;
  for (std::size_t k = objectives; k < objectives + criteria_->ties; ++k) {
    const double known = rounded(label.score[k]);
    const double other = rounded(score[k]);
    if (known != other) return known < other ? 1 : -1;
  }
  return 0;
}

bool LabelSet::dominates(const Label& label, const Worth& worth) const {
  const int comparison = compare_scores(label, worth.score);
  if (comparison < 0 || (comparison == 0 && label.utilisation > worth.utilisation)) return false;
  for (const auto& [component, direction] : compared_) {
    const Interval& state = worth.state[component];
    const double known = label.state[component];
    if (direction == Direction::smaller_is_better  ? known > state.lower
        : direction == Direction::larger_is_better ? known < state.upper
                                                   : known != state.lower || known != state.upper) {
      return false;
    }
  }
  return true;
}

bool LabelSet::dominates(const Worth& worth) const {
  const double limit = rounded(worth.score[0]);
  for (const std::uint32_t index : members_) {
    const Label& label = (*store_)[index];
    if (rounded(label.score[0]) > limit) return false;
    if (dominates(label, worth)) return true;
  }
  return false;
}

void LabelSet::add(std::uint32_t index) {
  const Label& added = (*store_)[index];
  std::erase_if(members_, [&](std::uint32_t other) {
    Label& label = (*store_)[other];
    if (rounded(label.score_lower[0]) < rounded(added.score[0])) return false;
    if (!dominates(added, Worth{label.score_lower, label.enclosure, label.utilisation})) return false;
    label.alive = false;
    return true;
  });
  const auto place = std::upper_bound(members_.begin(), members_.end(), added.score[0], [&](double score, auto other) {
    return score < (*store_)[other].score[0];
  });
  members_.insert(place, index);
}

}  // namespace millwright::solver
