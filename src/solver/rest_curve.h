// SPDX-License-Identifier: Apache-2.0
//
// How dear what is left must be, by what has been handed on. The least of each stage on its own (StagePlan::rest) is
// found at the best state that can arrive, and so says nothing of a label that spent little and left the next stage a
// heavy load, or used up most of a tolerance that all stages share. A curve does: for some values s of one component
//
//   R_i(s) = min over the designs of stage i that are feasible from s on: score + R_(i+1)(what they hand on),
//
// from the base to the tool, by best-first search over the stage's open regions. A component has a curve
// only where smaller is proved to be better (monotonicity.h): then nothing that is feasible with more is cheaper than
// R_i(s). All other components are at the best that can arrive, so that a curve is a lower bound for every label.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/stage_plan.h"

namespace millwright::solver {

/// What a curve may take: `steps` states, each further from the best by the same factor, and so many nodes for all (for
/// each state that is asked between them, where a stage has few designs).
struct CurveEffort {
  std::size_t steps = 10, nodes = 50;
  /// Where a search is long. Catalogues with many rows have many designs that differ little, by loads and powers that
  /// lie between the steps of a coarse curve.
  static constexpr CurveEffort thorough() { return {80, 2000}; }
  /// Where thousands of labels arrive at each stage, with loads that differ little: each that a close curve settles
  /// would have to be divided and bounded by itself.
  static constexpr CurveEffort closest() { return {80, 30000}; }
};

/// Fills StagePlan::curves of all stages, for the objectives. `most[score]` is a total above which nothing matters: a
/// curve need not be known where it leads beyond that (infinity: everything matters).
void find_rest_curves(std::vector<StagePlan>& plans,
                      std::span<const double> most,
                      const CurveEffort& effort,
                      Desk& desk);

/// What a plane or a staircase says of what is handed on; infinity where no later design is feasible.
template <class Lower>
double rest_by(const RestPlane& plane, Lower&& lower) {
  double priced = 0.0;
  for (std::size_t c = 0; c < plane.weight.size(); ++c)
    if (plane.weight[c] > 0.0) priced += plane.weight[c] * lower(c);
  return plane.constant + priced - bound_slack * std::fabs(priced);
}
template <class Lower>
double rest_by(const RestStairs& stairs, Lower&& lower) {
  double priced = stairs.constant;
  double left = stairs.limit * (1.0 + bound_slack);
  for (std::size_t c = 0; c < stairs.weight.size(); ++c) {
    if (stairs.weight[c] > 0.0) priced += stairs.weight[c] * lower(c);
    if (stairs.use[c] > 0.0) left -= stairs.use[c] * lower(c);
  }
  return priced - bound_slack * std::fabs(priced) + least_within(stairs.least, left);
}

/// What all later stages add at least to a score, given what is handed to them; infinity where none of their designs is
/// feasible. `lower(component)` is the least that is handed on.
template <class Lower>
double rest_given(const StagePlan& plan, std::size_t score, Lower&& lower) {
  double rest = plan.rest[score];
  for (const RestCurve& curve : plan.curves) {
    if (curve.score != score) continue;
    double state = lower(curve.component);
    state -= bound_slack * std::fabs(state);
    const auto end = std::ranges::upper_bound(curve.from, state);
    if (end != curve.from.begin())
      rest = std::max(rest, curve.least[static_cast<std::size_t>(end - curve.from.begin()) - 1]);
  }
  if (score > 1) return rest;  // planes and staircases are of the first two
  for (const RestPlane& plane : plan.planes)
    if (plane.mix == Mix::only(score)) rest = std::max(rest, rest_by(plane, lower));
  for (const RestStairs& stairs : plan.stairs)
    if (stairs.mix == Mix::only(score)) rest = std::max(rest, rest_by(stairs, lower));
  return rest;
}
inline double rest_after(const StagePlan& plan, std::size_t score, std::span<const Interval> handed_on) {
  return rest_given(plan, score, [&](std::size_t component) { return handed_on[component].lower; });
}
inline double rest_after(const StagePlan& plan, std::size_t score, std::span<const double> handed_on) {
  return rest_given(plan, score, [&](std::size_t component) { return handed_on[component]; });
}

/// Lower bounds of totals: of the first two scores, and of mixes of them.
class LeastTotals {
 public:
  LeastTotals(double first, double second) : first_(first), second_(second) {}

  /// Beyond a certain number nothing is taken in, which makes the bounds no less valid.
  void add(const Mix& mix, double least) {
    if (mix == Mix::only(0) || least == std::numeric_limits<double>::infinity()) {
      first_ = std::max(first_, least);
    } else if (mix == Mix::only(1)) {
      second_ = std::max(second_, least);
    } else if (number_ < mixed_.size()) {
      mixed_[number_++] = {mix, least - bound_slack * std::fabs(least)};
    }
  }
  /// By what the mixed planes and staircases of a stage say of a total up to it and what is handed on.
  template <class Lower>
  void add_mixed(const StagePlan& plan, std::span<const double> score, Lower&& lower) {
    const auto add_all = [&](const auto& all) {
      for (const auto& each : all)
        if (!each.mix.is_pure()) add(each.mix, each.mix.of(score) + rest_by(each, lower));
    };
    add_all(plan.planes);
    add_all(plan.stairs);
  }

  /// Whether some corner of an upper staircase is at least as large in everything.
  [[nodiscard]] bool below(const std::vector<Pair>& corners) const {
    if (first_ == infinity || second_ == infinity) return false;  // no completion is feasible
    auto corner = std::lower_bound(
        corners.begin(), corners.end(), first_, [](const Pair& point, double value) { return point.first < value; });
    for (; corner != corners.end() && corner->second >= second_; ++corner)
      if (reaches(*corner)) return true;
    return false;
  }

 private:
  struct Mixed {
    Mix mix;
    double least = 0.0;
  };
  [[nodiscard]] bool reaches(const Pair& corner) const {
    for (std::size_t i = 0; i < number_; ++i)
      if (mixed_[i].mix.first * corner.first + mixed_[i].mix.second * corner.second < mixed_[i].least) return false;
    return true;
  }

  double first_, second_;
  std::array<Mixed, 40> mixed_;
  std::size_t number_ = 0;
};

}  // namespace millwright::solver
