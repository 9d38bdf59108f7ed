// SPDX-License-Identifier: Apache-2.0
//
// The best builds found so far: one for a single objective, the front for several. A build counts here only after
// `evaluate` in double has found every utilisation <= 1 and every limit kept.
//
// Order between builds: objectives, then tie scores, then the smaller worst utilisation, then the smaller row numbers.
// (The last two decide between builds that are met. Labels are not told apart by what only moves utilisations that are
// kept anyway, so that a build of equal scores and smaller worst utilisation may never be met.)
//
// What lower bounds of its scores prove to be no better than a build is `hopeless`: pruned by bound.
//
// Of the tolerance T of a front that is covered to it, builds settle what is within 0.5 T (SolveRun), labels give up
// 0.9 of that in all (BranchAndBound::slack_of_labels), and noise that is left out takes 0.02 T: together 0.97 T. What
// the points of a cover stand for (SolveRun::leaf_tolerance) does not add to that, since it is in the lower bounds of
// their labels; it only has to stay below 0.5 T, or the build of a point would not settle its own label. Stage by stage
// points alone give something up, 0.9 T in all.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/criteria.h"
#include "solver/front_corners.h"

namespace millwright::solver {

struct RankedBuild {
  std::vector<double> score;
  Build build;
};

class Incumbents {
 public:
  explicit Incumbents(const Criteria& criteria) : criteria_(&criteria) {}

  /// A region is given up when it can better a build by less than this, relative. 0 without continuous variables that
  /// move scores; then the answer is exact.
  [[nodiscard]] double tolerance() const { return tolerance_; }
  void set_tolerance(double tolerance);
  /// Raises the tolerance, by tenths of it, until designs with at least these total scores and this worst utilisation
  /// cannot change the answer, or nothing is left of it (1).
  void widen_to_settle(std::span<const double> score_lower, double utilisation_lower);

  /// Whether designs with at least these total scores and this worst utilisation cannot change the answer.
  [[nodiscard]] bool hopeless(std::span<const double> score_lower, double utilisation_lower) const;
  /// True when the build is kept.
  bool offer(RankedBuild candidate);
  [[nodiscard]] const std::vector<RankedBuild>& builds() const { return builds_; }
  [[nodiscard]] std::vector<RankedBuild>& builds() { return builds_; }
  /// First objective of the best build in it; +infinity while there is none.
  [[nodiscard]] double best() const;
  /// Whether a total keeps every limit, with the slack of rounding: totals that compare as equal keep it alike.
  [[nodiscard]] bool within_limits(std::span<const double> score_lower) const;

 private:
  [[nodiscard]] bool settles(const RankedBuild& known,
                             std::span<const double> score,
                             double utilisation,
                             double tolerance) const;
  [[nodiscard]] bool guides_allow(std::span<const double> score_lower, std::span<const double> objectives) const;
  [[nodiscard]] bool fills_no_corner(std::span<const double> score_lower, double utilisation_lower) const;
  void note_corner(std::span<const double> score);
  [[nodiscard]] bool may_reach(std::span<const double> score_lower, double first, double second, bool strictly) const;
  [[nodiscard]] bool fills_no_gap(std::span<const double> score_lower, double utilisation_lower) const;
  [[nodiscard]] int compare_rest(const RankedBuild& known, std::span<const double> score, double utilisation) const;

  const Criteria* criteria_;
  double tolerance_ = 0.0;
  std::vector<RankedBuild> builds_;  ///< ascending in the first objective
  FrontCorners corners_;             ///< of three objectives
};

}  // namespace millwright::solver
