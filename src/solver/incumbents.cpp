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

bool Incumbents::settles(const RankedBuild& known,
                         std::span<const double> score,
                         double utilisation,
                         double tolerance) const {
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
    if (!within_limit(score_lower[k], criteria_->limit[k])) return false;
  }
  return true;
}

bool Incumbents::hopeless(std::span<const double> score_lower, double utilisation_lower) const {
  if (!within_limits(score_lower)) return true;
  if (criteria_->objectives == 3) return fills_no_corner(score_lower, utilisation_lower);
  if (criteria_->objectives == 2 && criteria_->guides > 0 && !builds_.empty())
    return fills_no_gap(score_lower, utilisation_lower);
  if (criteria_->objectives == 2 && tolerance_ > 0.0) {
    // Of those that are good enough in the first objective the last is the best in the second.
    const double first = rounded(score_lower[0]);
    const auto end = std::partition_point(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
      const double a = rounded(known.score[0]);
      return a - tolerance_ * std::fabs(a) <= first;
    });
    return end != builds_.begin() && settles(*std::prev(end), score_lower, utilisation_lower, tolerance_);
  }
  return std::any_of(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
    return settles(known, score_lower, utilisation_lower, tolerance_);
  });
}

/// Whether no guide says that a design with these lower bounds is above these objectives.
bool Incumbents::guides_allow(std::span<const double> score_lower, std::span<const double> objectives) const {
  for (std::size_t g = 0; g < criteria_->guides; ++g) {
    const double least = score_lower[criteria_->size() - criteria_->guides + g];
    double sum = 0.0;
    for (std::size_t k = 0; k < objectives.size(); ++k) sum += criteria_->guide_mix[g][k] * objectives[k];
    if (std::isfinite(least) && least > sum + equal_sums * std::fabs(sum)) return false;
  }
  return true;
}

/// A front in three objectives: something new must lie below a corner that the builds leave open, or equal a build and
/// win the tie.
bool Incumbents::fills_no_corner(std::span<const double> score_lower, double utilisation_lower) const {
  const FrontCorners::Point lower{rounded(score_lower[0]), rounded(score_lower[1]), rounded(score_lower[2])};
  if (corners_.above(lower, [&](const auto& corner) { return guides_allow(score_lower, corner); })) return false;
  return tolerance_ > 0.0 || std::ranges::none_of(builds_, [&](const RankedBuild& known) {
           for (std::size_t k = 0; k < lower.size(); ++k)
             if (rounded(known.score[k]) < lower[k]) return false;
           return compare_rest(known, score_lower, utilisation_lower) > 0 &&
                  guides_allow(score_lower, std::span(known.score).first(lower.size()));
         });
}

void Incumbents::note_corner(std::span<const double> score) {
  FrontCorners::Point point{};
  for (std::size_t k = 0; k < point.size(); ++k) {
    point[k] = rounded(score[k]);
    point[k] -= tolerance_ * std::fabs(point[k]);
  }
  corners_.add(point);
}

void Incumbents::set_tolerance(double tolerance) {
  if (tolerance == tolerance_) return;
  tolerance_ = tolerance;
  if (criteria_->objectives != 3) return;
  corners_ = {};
  for (const RankedBuild& known : builds_) note_corner(known.score);
}

void Incumbents::widen_to_settle(std::span<const double> score_lower, double utilisation_lower) {
  constexpr double least = 1e-6, step = 1.1;
  while (tolerance_ < 1.0 && !hopeless(score_lower, utilisation_lower))
    set_tolerance(std::min(1.0, std::max(least, step * tolerance_)));
}

/// Whether a design with these lower bounds can have objectives below (first, second).
bool Incumbents::may_reach(std::span<const double> score_lower, double first, double second, bool strictly) const {
  const auto below = [&](double lower, double upper) {
    return strictly ? rounded(lower) < rounded(upper) : rounded(lower) <= rounded(upper);
  };
  if (!below(score_lower[0], first) || !below(score_lower[1], second)) return false;
  const std::array objectives{first, second};
  return !std::isfinite(first) || !std::isfinite(second) || guides_allow(score_lower, objectives);
}

/// A front in two objectives is a staircase; something new must lie in one of the corners between two steps, or equal a
/// step and win the tie.
bool Incumbents::fills_no_gap(std::span<const double> score_lower, double utilisation_lower) const {
  const double left = 1.0 - tolerance_;  // within the tolerance the next step settles it
  double second = infinity;
  for (const RankedBuild& step : builds_) {
    if (may_reach(score_lower, left * step.score[0], left * second, true)) return false;
    if (tolerance_ == 0.0 && compare_rest(step, score_lower, utilisation_lower) > 0 &&
        may_reach(score_lower, step.score[0], step.score[1], false)) {
      return false;
    }
    second = step.score[1];
  }
  return !may_reach(score_lower, infinity, left * second, true);
}

bool Incumbents::offer(RankedBuild candidate) {
  if (!within_limits(candidate.score)) return false;
  // Between builds the comparison is exact: a build that is better by less than the tolerance is still better.
  constexpr double exactly = 0.0;
  const auto equal_in_all = [&](const RankedBuild& a) {
    for (std::size_t k = 0; k < criteria_->objectives; ++k) {
      if (rounded(a.score[k]) != rounded(candidate.score[k])) return false;
    }
    return compare_rest(a, candidate.score, candidate.build.worst_utilisation) == 0;
  };
  const bool beaten = std::any_of(builds_.begin(), builds_.end(), [&](const RankedBuild& known) {
    if (equal_in_all(known)) return compare_rows(known.build, candidate.build) <= 0;
    return settles(known, candidate.score, candidate.build.worst_utilisation, exactly);
  });
  if (!beaten) {
    std::erase_if(builds_, [&](const RankedBuild& known) {
      return settles(candidate, known.score, known.build.worst_utilisation, exactly);
    });
    const auto place = std::upper_bound(
        builds_.begin(), builds_.end(), candidate.score[0], [](double score, const RankedBuild& other) {
          return score < other.score[0];
        });
    if (criteria_->objectives == 3) note_corner(candidate.score);
    builds_.insert(place, std::move(candidate));
  }
  return !beaten;
}

double Incumbents::best() const {
  return builds_.empty() ? std::numeric_limits<double>::infinity() : builds_.front().score[0];
}

}  // namespace millwright::solver
