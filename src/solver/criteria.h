// SPDX-License-Identifier: Apache-2.0
//
// What the search compares. The resources of a problem are turned into scores: first the objectives (one, or several
// for a front, or one weighted sum), then the resources that decide between equal objectives, then those with a limit.
// A resource that nobody asked for is no score and is never looked at. Where a resource has floors (stage.h), those are
// scores, too.
//
// Scores are compared after rounding to 40 binary digits (about 1e-12 relative): two designs whose cost is the same sum
// in another order must count as equal, or a rounding error of 1e-14 would decide over a kilogram. The rounding is
// monotone, so a lower bound stays a lower bound.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "solver/solver.h"

namespace millwright::solver {

/// Monotone rounding to so many binary digits of the fraction: the last ones, at least one, are rounded away.
inline double rounded(double x, int digits) {
  constexpr int all = 52;
  const std::uint64_t half = std::uint64_t{1} << (all - digits - 1);
  const std::uint64_t dropped = 2 * half - 1;
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) + half) & ~dropped);
}
/// So many binary digits decide whether two totals are equal.
inline constexpr int exact_digits = 40;
inline double rounded(double x) { return rounded(x, exact_digits); }

/// Relative: sums of the same numbers in another order differ by less.
inline constexpr double equal_sums = 1e-12;
/// Relative, and wider: what bounds are slackened by, so that none excludes a sum that is equal to it.
inline constexpr double bound_slack = 1e-11;

/// Whether a total keeps a limit, with the slack of rounding: two totals that count as equal keep it alike. False for
/// NaN.
inline bool within_limit(double total, double limit) { return total <= limit + equal_sums * std::fabs(limit); }

/// Lower bound of a total, from lower bounds of its parts. Infinity, which says that no design is feasible, stays (an
/// interval's lower end would become the largest number).
inline double total_down(double a, double b) {
  return a == infinity || b == infinity ? infinity : scalar::rounding::sum_down(a, b);
}

struct Criteria {
  std::size_t objectives = 1;                       ///< how many of the scores are objectives; they come first
  std::size_t ties = 0;                             ///< how many scores after them decide between equals
  std::size_t guides = 0;                           ///< weighted sums of others, the last scores: see add_guides
  std::vector<std::vector<double>> weight;          ///< [score][resource], never negative
  std::vector<double> limit;                        ///< [score]: the total must not exceed this
  std::vector<std::vector<double>> guide_mix = {};  ///< [guide][score]: weight in the sum; further scores have none
  std::vector<double> limit_worth = {};             ///< [guide] by add_limit_prices: what the limit comes to in the sum
  std::vector<Floor> floors = {};                   ///< of scores: indices of these
  std::vector<bool> states_in_floors = {};          ///< [component]: see Problem; shorter ones have none

  [[nodiscard]] std::size_t size() const { return weight.size(); }
  /// The score that is set against the first one in staircases: the second objective, or the first tie; 0 without one.
  [[nodiscard]] double second(std::span<const double> score) const { return size() > 1 ? score[1] : 0.0; }
  /// Whether designs that are no worse otherwise have to be compared in this score, which is no objective.
  [[nodiscard]] bool has_to_be_kept_low(std::size_t score) const;
  [[nodiscard]] bool is_floor(std::size_t score) const {
    return std::any_of(floors.begin(), floors.end(), [&](const Floor& floor) { return floor.bound == score; });
  }
  /// Whether designs need not be compared in a component of the state.
  [[nodiscard]] bool is_in_floors(std::size_t component) const {
    return component < states_in_floors.size() && states_in_floors[component];
  }
  /// Of two designs of which one is less in a score: whether it stays so whatever floors come to, which may be the same
  /// for both in the end.
  [[nodiscard]] bool is_less_by_floors(std::size_t score,
                                       std::span<const double> less,
                                       std::span<const double> than) const;
  /// Whether any score reads this resource.
  [[nodiscard]] bool reads(std::size_t resource) const;
  /// The scores of resources (value by value; the same order of additions for every T).
  template <class T>
  void scores(std::span<const T> resources, std::span<T> out) const {
    for (std::size_t k = 0; k < weight.size(); ++k) {
      T sum(0.0);
      for (std::size_t r = 0; r < resources.size(); ++r) {
        if (weight[k][r] == 1.0)
          sum = sum + resources[r];
        else if (weight[k][r] != 0.0)
          sum = sum + T(weight[k][r]) * resources[r];
      }
      out[k] = sum;
    }
  }
  /// The lower bounds of the same, of resources that are known as intervals.
  void least_scores(std::span<const Interval> resources, std::span<double> out) const;
  /// Whether, in the objectives, one build falls short of another by no more than a part of it.
  [[nodiscard]] bool is_as_good(std::span<const double> score, std::span<const double> than, double part) const;
  /// Lowers guides to the sums of these scores, where they say more.
  void lower_guides(std::span<double> score) const;
  /// Raises lower bounds of totals by what others say: floors, and of a single objective guides, of designs that keep a
  /// limit.
  void raise(std::span<double> total) const;
};

/// For a front in two or three objectives: adds weighted sums of them as further scores. They decide nothing, but the
/// least of a sum says far more about what can still be on the front than the least of each objective on its own.
/// `apart`: by how much builds of the front differ in each objective; one in which they do not is in no sum.
void add_guides(Criteria& criteria, std::span<const double> apart);

/// For a single objective and one more score with a limit: adds the objective plus each of these prices times that
/// score. Of designs that keep the limit, the least of such a sum less what the limit comes to in it is a lower bound
/// of the objective (Lagrange's relaxation of the limit).
void add_limit_prices(Criteria& criteria, std::size_t score, std::span<const double> prices);

/// Throws std::invalid_argument, naming the option, when an index or a weight makes no sense.
Criteria make_criteria(const Problem& problem, const Options& options);

}  // namespace millwright::solver
