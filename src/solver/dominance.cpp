// SPDX-License-Identifier: Apache-2.0
#include "solver/dominance.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

using ComparedStates = std::vector<std::pair<std::size_t, Direction>>;

ComparedStates components_that_matter(const Criteria& criteria, std::span<const Direction> directions) {
  ComparedStates compared;
  for (std::size_t c = 0; c < directions.size(); ++c)
    if (directions[c] != Direction::irrelevant && !criteria.is_in_floors(c)) compared.emplace_back(c, directions[c]);
  return compared;
}

/// One coordinate for each objective and each further score with a limit or that is a floor, one or two for each state
/// component that matters.
std::size_t coordinates(const Criteria& criteria, const ComparedStates& compared) {
  std::size_t count = criteria.objectives;
  for (std::size_t k = criteria.objectives; k < criteria.size(); ++k) count += criteria.has_to_be_kept_low(k) ? 1 : 0;
  for (const auto& [component, direction] : compared) count += direction == Direction::equal_only ? 2 : 1;
  return count;
}

void add_scores(const Criteria& criteria, std::span<const double> score, std::vector<double>& key) {
  for (std::size_t k = 0; k < criteria.objectives; ++k) key.push_back(rounded(score[k]));
  for (std::size_t k = criteria.objectives; k < criteria.size(); ++k)
    if (criteria.has_to_be_kept_low(k)) key.push_back(std::isfinite(criteria.limit[k]) ? score[k] : rounded(score[k]));
}

/// The best of what a label stands for.
Worth best_of(const Label& label) { return {label.score_lower, label.enclosure, label.utilisation}; }

}  // namespace

LabelSet::LabelSet(const Criteria& criteria,
                   std::span<const Direction> directions,
                   std::deque<Label>& store,
                   Dominating by,
                   double slack)
    : criteria_(&criteria),
      compared_(components_that_matter(criteria, directions)),
      store_(&store),
      by_(by),
      slack_(slack),
      known_(coordinates(criteria, compared_)),
      replaced_(known_) {}

void LabelSet::key_of(const Label& label, std::vector<double>& key) const {
  if (by_ == Dominating::lower_bound) return key_of(best_of(label), key);
  key.clear();
  add_scores(*criteria_, label.score, key);
  for (const auto& [component, direction] : compared_) {
    if (direction != Direction::larger_is_better) key.push_back(rounded(label.state[component]));
    if (direction != Direction::smaller_is_better) key.push_back(rounded(-label.state[component]));
  }
}

void LabelSet::key_of(const Worth& worth, std::vector<double>& key) const {
  key.clear();
  add_scores(*criteria_, worth.score, key);
  for (const auto& [component, direction] : compared_) {
    if (direction != Direction::larger_is_better) key.push_back(rounded(worth.state[component].lower));
    if (direction != Direction::smaller_is_better) key.push_back(rounded(-worth.state[component].upper));
  }
}

/// Of a label that is at least as good in all objectives, but for the slack.
bool LabelSet::wins_tie(const Label& label, const Worth& worth) const {
  const std::vector<double>& score = by_ == Dominating::point ? label.score : label.score_lower;
  const std::size_t objectives = criteria_->objectives;
  for (std::size_t k = 0; k < objectives + criteria_->ties; ++k) {
    const double known = rounded(score[k]);
    const double other = rounded(worth.score[k]);
    if (slack_ > 0.0 && k < objectives && known != other) return true;
    if (known < other && criteria_->is_less_by_floors(k, score, worth.score)) return true;
    if (known > other) return false;
  }
  return slack_ > 0.0 || label.utilisation <= worth.utilisation;
}

bool LabelSet::dominates(const Worth& worth, std::span<const double> total) const {
  thread_local std::vector<double> key;
  key_of(worth, key);
  // (Of a lower bound below zero no part is known to be a part of the total.)
  for (std::size_t k = 0; slack_ > 0.0 && k < criteria_->objectives; ++k)
    if (std::isinf(criteria_->limit[k])) key[k] += slack_ * std::max(0.0, total[k]);
  return known_.any_at_most(key, [&](Archive::Name index) { return wins_tie((*store_)[index], worth); });
}

void LabelSet::add(std::uint32_t index) {
  const Label& added = (*store_)[index];
  // What may be anything is no better than all others.
  const auto is_bounded = [&](const auto& compared) { return added.enclosure[compared.first].is_bounded(); };
  if (by_ == Dominating::lower_bound && !std::all_of(compared_.begin(), compared_.end(), is_bounded)) return;
  const auto turned = [](std::vector<double>& key) {
    for (double& each : key) each = -each;
  };
  std::vector<double> key, other;
  key_of(added, key);
  turned(key);
  replaced_.remove_at_most(key, [&](Archive::Name name) {
    Label& label = (*store_)[name];
    if (!wins_tie(added, best_of(label))) return false;
    label.alive = false;
    key_of(label, other);
    known_.remove(other, name);
    return true;
  });
  turned(key);
  known_.add(key, index);
  key_of(best_of(added), key);
  turned(key);
  replaced_.add(key, index);
}

}  // namespace millwright::solver
