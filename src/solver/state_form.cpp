// SPDX-License-Identifier: Apache-2.0
#include "solver/state_form.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

/// Slopes of constants come out of interval arithmetic with this much rounding at most.
constexpr double rounding_width = 1e-13;

bool vanishes(const Interval& slope) { return slope.lower >= -1e-200 && slope.upper <= 1e-200; }

}  // namespace

StateForm find_state_form(const StagePlan& plan, Desk& desk) {
  StateForm form;
  const std::size_t components = plan.inherited.size();
  form.influences.assign(components, false);
  form.exact.assign(components, true);
  form.slope.assign(components, std::vector<double>(components, 0.0));
  for (std::size_t c = 0; c < components; ++c) {
    if (plan.inherited[c].lower == plan.inherited[c].upper) continue;  // the same for every label
    const auto& slopes =
        desk.slopes(*plan.stage, plan.shared, plan.inherited, plan.region, {Input::Kind::inherited, c});
    form.influences[c] = !std::all_of(slopes.utilisation.begin(), slopes.utilisation.end(), vanishes);
    for (std::size_t r = 0; r < slopes.resources.size(); ++r) {
      if (plan.criteria->reads(r) && !vanishes(slopes.resources[r])) form.additive = false;
    }
    for (std::size_t h = 0; h < components; ++h) {
      const Interval& slope = slopes.handed_on[h];
      // Steps of a rounded figure have slopes without bound.
      const bool bounded = std::isfinite(slope.lower) && std::isfinite(slope.upper);
      const bool constant = bounded && slope.upper - slope.lower <= rounding_width * std::max(1.0, magnitude(slope));
      // What is irrelevant now may have mattered when prices were found that are still in use.
      if (constant) form.slope[h][c] = middle(slope);
      if (!constant) form.exact[h] = false;
      if (!constant && bounded && plan.after[h] != Direction::irrelevant) form.additive = false;
    }
  }
  return form;
}

Comparison::Comparison(const Criteria& criteria, std::span<const Direction> directions, bool with_states, int digits)
    : scores_(with_states ? criteria.size() - criteria.guides : criteria.objectives), digits_(digits) {
  if (!with_states) return;
  for (std::size_t c = 0; c < directions.size(); ++c) {
    const Direction direction = directions[c];
    if (direction == Direction::irrelevant) continue;
    if (direction != Direction::larger_is_better) states_.push_back({c, false});
    if (direction != Direction::smaller_is_better) states_.push_back({c, true});
  }
}

void Comparison::key(std::span<const double> score, std::span<const double> state, double* out) const {
  for (std::size_t k = 0; k < scores_; ++k) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) *out++ = rounded(c.falling ? -state[c.component] : state[c.component], digits_);
}

void Comparison::best_key(std::span<const double> score,
                          std::span<const double> least,
                          std::span<const double> most,
                          double* out) const {
  for (std::size_t k = 0; k < scores_; ++k) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) *out++ = rounded(c.falling ? -most[c.component] : least[c.component], digits_);
}

void Comparison::best_key(std::span<const double> score, std::span<const Interval> state, double* out) const {
  for (std::size_t k = 0; k < scores_; ++k) *out++ = rounded(score[k], digits_);
  for (const Coordinate& c : states_) {
    *out++ = rounded(c.falling ? -state[c.component].upper : state[c.component].lower, digits_);
  }
}

}  // namespace millwright::solver
