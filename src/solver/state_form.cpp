// SPDX-License-Identifier: Apache-2.0
#include "solver/state_form.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

/// Slopes of constants come out of interval arithmetic with this much rounding at most, as a part of themselves.
constexpr double rounding_width = 1e-13;

bool vanishes(const Interval& slope) { return slope.lower >= -1e-200 && slope.upper <= 1e-200; }

}  // namespace

StateForm find_state_form(const StagePlan& plan, Desk& desk) {
  StateForm form;
  const std::size_t components = plan.inherited.size();
  form.influences.assign(components, false);
  form.moves_scores.assign(components, false);
  form.exact.assign(components, true);
  form.slope.assign(components, std::vector<double>(components, 0.0));
  form.slope_error = form.slope;
  for (std::size_t c = 0; c < components; ++c) {
    if (plan.inherited[c].lower == plan.inherited[c].upper) continue;  // the same for every label
    const auto& slopes =
        desk.slopes(*plan.stage, plan.shared, plan.inherited, plan.region, {Input::Kind::inherited, c});
    form.influences[c] = !std::all_of(slopes.utilisation.begin(), slopes.utilisation.end(), vanishes);
    for (std::size_t r = 0; r < slopes.resources.size(); ++r) {
      if (plan.criteria->reads(r) && !vanishes(slopes.resources[r])) form.moves_scores[c] = true;
    }
    for (std::size_t h = 0; h < components; ++h) {
      const Interval& slope = slopes.handed_on[h];
      // Steps of a rounded figure have slopes without bound.
      const bool bounded = std::isfinite(slope.lower) && std::isfinite(slope.upper);
      const bool constant = bounded && slope.upper - slope.lower <= rounding_width * magnitude(slope);
      // What is irrelevant now may have mattered when prices were found that are still in use.
      if (constant) form.slope[h][c] = middle(slope);
      if (constant) form.slope_error[h][c] = slope.upper - slope.lower;
      if (!constant) form.exact[h] = false;
      // What is handed on at least then hangs on it.
      if (!constant && plan.moved_state == h) form.influences[c] = true;
      if (!constant && bounded && plan.after[h] != Direction::irrelevant) form.additive = false;
    }
  }
  if (plan.moved_state) form.exact[*plan.moved_state] = false;
  return form;
}

Comparison::Comparison(const Criteria& criteria, std::span<const Direction> directions, Compared compared, int digits)
    : digits_(digits) {
  const std::size_t ties_end = criteria.objectives + criteria.ties;
  for (std::size_t k = 0; k + criteria.guides < criteria.size(); ++k) {
    const bool is_objective = k < criteria.objectives;
    const bool is_tie = !is_objective && k < ties_end && !std::isfinite(criteria.limit[k]);
    if (compared == Compared::objectives ? !is_objective : compared == Compared::without_ties && is_tie) continue;
    scores_.push_back(k);
    // Where objectives have floors, what is less in one may come to the same in the end: ties are not decided before.
    is_tie_.push_back(is_tie && criteria.floors.empty());
  }
  if (compared == Compared::objectives) return;
  for (std::size_t c = 0; c < directions.size(); ++c) {
    const Direction direction = directions[c];
    if (direction == Direction::irrelevant || criteria.is_in_floors(c)) continue;
    if (direction != Direction::larger_is_better) states_.push_back({c, false});
    if (direction != Direction::smaller_is_better) states_.push_back({c, true});
  }
  is_tie_.resize(dimensions(), false);
}

void Comparison::key(std::span<const double> score, std::span<const double> state, double* out) const {
  for (const std::size_t k : scores_) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) *out++ = rounded(c.falling ? -state[c.component] : state[c.component], digits_);
}

void Comparison::best_key(std::span<const double> score,
                          std::span<const double> least,
                          std::span<const double> most,
                          double* out) const {
  for (const std::size_t k : scores_) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) *out++ = rounded(c.falling ? -most[c.component] : least[c.component], digits_);
}

void Comparison::best_key(std::span<const double> score, std::span<const Interval> state, double* out) const {
  for (const std::size_t k : scores_) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) {
    *out++ = rounded(c.falling ? -state[c.component].upper : state[c.component].lower, digits_);
  }
}

KnownKeys::KnownKeys(const Comparison& comparison)
    : is_tie_(comparison.is_tie()),
      known_(comparison.dimensions() - static_cast<std::size_t>(std::count(is_tie_.begin(), is_tie_.end(), true))) {
  for (std::size_t i = 0; i < is_tie_.size(); ++i)
    if (is_tie_[i]) leading_ = i + 1;
}

std::span<const double> KnownKeys::counted(std::span<const double> key) const {
  if (leading_ == 0) return key;
  thread_local std::vector<double> counted;
  counted.clear();
  for (std::size_t i = 0; i < key.size(); ++i)
    if (!is_tie_[i]) counted.push_back(key[i]);
  return counted;
}

bool KnownKeys::dominates(std::span<const double> key) const {
  // Both are equal in what comes first, or the known one is less there.
  const auto wins = [&](Archive::Name name) {
    const double* const known = decided_by_.data() + name * leading_;
    for (std::size_t i = 0; i < leading_; ++i)
      if (known[i] != key[i]) return known[i] < key[i];
    return true;
  };
  return known_.any_at_most(counted(key), wins);
}

void KnownKeys::add(std::span<const double> key) {
  if (leading_ == 0) return known_.add(key);
  const auto name = static_cast<Archive::Name>(decided_by_.size() / leading_);
  decided_by_.insert(decided_by_.end(), key.begin(), key.begin() + static_cast<std::ptrdiff_t>(leading_));
  known_.add(counted(key), name);
}

}  // namespace millwright::solver
