// SPDX-License-Identifier: Apache-2.0
#include "solver/incumbents.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

/// -1, 0, +1: the rows of a against those of b.
int compare_rows(const Build& a, const Build& b) {
  if (a.shared != b.shared) return a.shared < b.shared ? -1 : 1;
  for (std::size_t i = 0; i < a.stages.size(); ++i) {
    if (a.stages[i].rows != b.stages[i].rows) return a.stages[i].rows < b.stages[i].rows ? -1 : 1;
  }
  return 0;
}

}  // namespace

/// Sign of (known - other) in tie scores and worst utilisation.
int Incumbents::compare_rest(const RankedBuild& known, std::span<const double> score, double utilisation) const {
  for (std::size_t k = criteria_->objectives; k < criteria_->objectives + criteria_->ties; ++k) {
    const double a = rounded(known.score[k]);
    const double b = rounded(score[k]);
    if (a != b) return a < b ? -1 : 1;
  }
  if (known.build.worst_utilisation != utilisation) return known.build.worst_utilisation < utilisation ? -1 : 1;
  return 0;
}

bool Incumbents::settles(const RankedBuild& known, std::span<const double> score, double utilisation) const {
  bool strictly = false;
  for (std::size_t k = 0; k < criteria_->objectives; ++k) {
    const double a = rounded(known.score[k]);
    const double b = rounded(score[k]);
    if (tolerance > 0.0) {
      if (a - tolerance * std::fabs(a) > b) return false;
      strictly = true;  // within the tolerance ties are not looked at
    } else {
      if (a > b) return false;
      strictly = strictly || a < b;
    }
  }
  return strictly || compare_rest(known, score, utilisation) <= 0;
}

bool Incumbents::within_limits(std::span<const double> score_lower) const {
  for (std::size_t k = 0; k < score_lower.size(); ++k) {
    const double limit = criteria_->limit[k];
    if (score_lower[k] > limit + 1e-12 * std::fabs(limit)) return false;
  }
  return true;
}

bool Incumbents::hopeless(std::span<const double> score_lower, double utilisation_lower) const {
  if (!within_limits(score_lower)) return true;
  if (criteria_->guides > 0 && !builds_.empty()) return fills_no_gap(score_lower, utilisation_lower);
  if (criteria_->objectives == 2 && tolerance > 0.0) {
    // Of those that are good enough in the first objective the last is the best in the second.
    const double first = rounded(score_lower[0]);
    const auto end = std::partition_point(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
      const double a = rounded(known.score[0]);
      return a - tolerance * std::fabs(a) <= first;
    });
    return end != builds_.begin() && settles(*std::prev(end), score_lower, utilisation_lower);
  }
  return std::any_of(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
    return settles(known, score_lower, utilisation_lower);
  });
}

/// Whether a design with these lower bounds can have objectives below (first, second).
bool Incumbents::may_reach(std::span<const double> score_lower, double first, double second, bool strictly) const {
  constexpr double slack = 1e-12;
  const auto below = [&](double lower, double upper) {
    return strictly ? rounded(lower) < rounded(upper) : rounded(lower) <= rounded(upper);
  };
  if (!below(score_lower[0], first) || !below(score_lower[1], second)) return false;
  if (!std::isfinite(first) || !std::isfinite(second)) return true;
  for (std::size_t k = score_lower.size() - criteria_->guides; k < score_lower.size(); ++k) {
    double rate = 0.0;
    for (std::size_t r = 0; r < criteria_->weight[k].size(); ++r) {
      if (criteria_->weight[1][r] != 0.0 && criteria_->weight[0][r] == 0.0) rate = criteria_->weight[k][r];
    }
    const double sum = first + rate * second;
    if (score_lower[k] > sum + slack * std::fabs(sum)) return false;
  }
  return true;
}

/// A front in two objectives is a staircase; something new must lie in one of the corners between two steps, or equal a
/// step and win the tie.
bool Incumbents::fills_no_gap(std::span<const double> score_lower, double utilisation_lower) const {
  const double left = 1.0 - tolerance;  // within the tolerance the next step settles it
  double second = infinity;
  for (const RankedBuild& step : builds_) {
    if (may_reach(score_lower, left * step.score[0], left * second, true)) return false;
    if (tolerance == 0.0 && compare_rest(step, score_lower, utilisation_lower) > 0 &&
        may_reach(score_lower, step.score[0], step.score[1], false)) {
      return false;
    }
    second = step.score[1];
  }
  return !may_reach(score_lower, infinity, left * second, true);
}

bool Incumbents::offer(RankedBuild candidate) {
  for (std::size_t k = 0; k < candidate.score.size(); ++k) {
    if (!(candidate.score[k] <= criteria_->limit[k])) return false;
  }
  // Between builds the comparison is exact: a build that is better by less than the tolerance is still better.
  const double kept = tolerance;
  tolerance = 0.0;
  const auto equal_in_all = [&](const RankedBuild& a) {
    for (std::size_t k = 0; k < criteria_->objectives; ++k) {
      if (rounded(a.score[k]) != rounded(candidate.score[k])) return false;
    }
    return compare_rest(a, candidate.score, candidate.build.worst_utilisation) == 0;
  };
  const bool beaten = std::any_of(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
    if (equal_in_all(known)) return compare_rows(known.build, candidate.build) <= 0;
    return settles(known, candidate.score, candidate.build.worst_utilisation);
  });
  if (!beaten) {
    std::erase_if(builds_, [&](const RankedBuild& known) {
      return settles(candidate, known.score, known.build.worst_utilisation);
    });
    const auto place = std::upper_bound(
        builds_.begin(), builds_.end(), candidate.score[0], [](double score, const RankedBuild& other) {
          return score < other.score[0];
        });
    builds_.insert(place, std::move(candidate));
  }
  tolerance = kept;
  return !beaten;
}

double Incumbents::best() const {
  return builds_.empty() ? std::numeric_limits<double>::infinity() : builds_.front().score[0];
}

}  // namespace millwright::solver
