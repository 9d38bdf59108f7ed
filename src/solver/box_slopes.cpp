// SPDX-License-Identifier: Apache-2.0
#include "solver/box_slopes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/criteria.h"

namespace millwright::solver {
namespace {

/// A design counts as feasible when its utilisation is at most 1 as computed in double; this much may be lost there.
constexpr double utilisation_limit = 1.0 + bound_slack;

}  // namespace

BoxSlopes::BoxSlopes(const LeafQuestion& question, const VariableBox& box, Desk& desk)
    : question_(question), open_(box.bounds.open), middle_(middle_of(box.side)) {
  const StagePlan& plan = *question.plan;
  Region region = *question.region;
  region.variables = box.side;
  slope_.resize(box.side.size());
  for (std::size_t v = 0; v < box.side.size(); ++v) {
    width_.push_back(box.side[v].upper - box.side[v].lower);
    slope_[v] = answers_of(
        desk.slopes(*plan.stage, plan.shared, question.label->enclosure, region, {Input::Kind::variable, v}));
  }
  const std::vector<Interval> middle(middle_.begin(), middle_.end());
  at_middle_ = answers_of(desk.bound(*plan.stage, plan.shared, question.label->enclosure, region, middle));
}

BoxSlopes::Answers BoxSlopes::answers_of(const Answer<Interval>& answer) const {
  const Criteria& criteria = *question_.plan->criteria;
  Answers answers{answer.utilisation, std::vector<Interval>(criteria.size()), answer.handed_on};
  criteria.scores<Interval>(answer.resources, answers.score);
  return answers;
}

template <class Function>
double BoxSlopes::least_of(Function&& function, std::span<const Interval> side) const {
  Interval sum = function(at_middle_);
  for (std::size_t v = 0; v < side.size(); ++v)
    if (!side[v].is_point() || side[v].lower != middle_[v])
      sum = sum + function(slope_[v]) * (side[v] - Interval(middle_[v]));
  return sum.lower;
}

bool BoxSlopes::narrow(std::span<Interval> side) const {
  for (std::size_t c = 0; c < at_middle_.utilisation.size(); ++c) {
    if (!is_open(c)) continue;
    for (std::size_t v = 0; v < side.size(); ++v) {
      // With the others where they help most, this is what the variable may still add.
      double rest = at_middle_.utilisation[c].lower;
      for (std::size_t w = 0; w < side.size(); ++w) {
        const Interval add = slope_[w].utilisation[c] * (side[w] - Interval(middle_[w]));
        if (w != v) rest = scalar::rounding::sum_down(rest, add.lower);
      }
      const Interval slope = slope_[v].utilisation[c];
      if (!std::isfinite(rest) || !slope.is_bounded() || (slope.lower <= 0.0 && slope.upper >= 0.0)) continue;
      const Interval reach = Interval(middle_[v]) + (Interval(utilisation_limit) - Interval(rest)) / slope;
      if (slope.lower > 0.0)
        side[v].upper = std::min(side[v].upper, reach.upper);
      else
        side[v].lower = std::max(side[v].lower, reach.lower);
      if (!(side[v].lower <= side[v].upper)) return false;
    }
  }
  return true;
}

void BoxSlopes::raise(std::span<const Interval> side, Bounds& bounds) const {
  // The greatest lower bound of a function of the answers: alone, and with each open constraint at each price that
  // cancels the slope of one variable.
  const auto least = [&](auto&& value) {
    double best = least_of(value, side);
    for (std::size_t c = 0; c < at_middle_.utilisation.size(); ++c) {
      if (!is_open(c)) continue;
      for (std::size_t v = 0; v < side.size(); ++v) {
        const double price = -middle(value(slope_[v])) / middle(slope_[v].utilisation[c]);
        if (!(price > 0.0) || !std::isfinite(price)) continue;
        const double bound =
            least_of([&](const Answers& all) { return value(all) + Interval(price) * all.utilisation[c]; }, side);
        best = std::max(best, (Interval(bound) - Interval(price) * Interval(utilisation_limit)).lower);
      }
    }
    return best - bound_slack * std::fabs(best);
  };
  for (std::size_t k = 0; k < bounds.score.size(); ++k)
    bounds.score[k] = std::max(bounds.score[k], least([k](const Answers& all) { return all.score[k]; }));
  for (std::size_t s = 0; s < bounds.handed_on.size(); ++s) {
    Interval& state = bounds.handed_on[s];
    const Direction direction = question_.plan->after[s];
    if (direction == Direction::smaller_is_better)
      state.lower = std::clamp(least([s](const Answers& all) { return all.state[s]; }), state.lower, state.upper);
    else if (direction == Direction::larger_is_better)
      state.upper = std::clamp(-least([s](const Answers& all) { return -all.state[s]; }), state.lower, state.upper);
  }
}

double BoxSlopes::change_over(std::size_t variable, const Bounds& bounds, bool scores_count) const {
  constexpr double very_steep = 1e12;
  const StagePlan& plan = *question_.plan;
  const Answers& slope = slope_[variable];
  double most = 0.0;
  for (std::size_t c = 0; c < slope.utilisation.size(); ++c)
    if (is_open(c)) most = std::max(most, magnitude(slope.utilisation[c]));
  if (plan.moves_outcome[variable] && scores_count) {
    for (std::size_t k = 0; k < slope.score.size(); ++k) {
      const double total = question_.label->score_lower[k] + bounds.score[k] + plan.rest[k];
      most = std::max(most, magnitude(slope.score[k]) / std::max(std::fabs(total), 1e-9));
    }
    for (std::size_t s = 0; s < plan.after.size(); ++s) {
      if (plan.after[s] == Direction::irrelevant) continue;
      most = std::max(most, magnitude(slope.state[s]) / std::max(magnitude(bounds.handed_on[s]), 1e-9));
    }
  }
  return width_[variable] * std::min(most, very_steep);
}

}  // namespace millwright::solver
