// SPDX-License-Identifier: Apache-2.0
//
// In which order nodes come up, and what need not be looked at any further: what the builds known settle, or a label
// known dominates.
#include "solver/branch_and_bound.h"

#include <algorithm>
#include <cmath>

#include "solver/rest_curve.h"

namespace millwright::solver {

/// Where designs hardly differ in the first objective (a time, say, of which most is the same for all of them) the
/// others put them in order: a hundred parts of those are worth as much as one part of the first.
void BranchAndBound::rate_objectives() {
  constexpr double little = 0.01;
  if (tail_.front().empty()) return;
  const std::vector<double>& least = tail_.front().front();
  for (std::size_t k = 1; k < criteria_.objectives; ++k) {
    const double rate = little * least[0] / least[k];
    rates_.push_back(least[0] > 0.0 && least[k] > 0.0 && std::isfinite(rate) ? rate : 0.0);
  }
}

double BranchAndBound::order_of(const Node& node) const {
  double order = node.score[0];
  for (std::size_t i = 0; i < rates_.size(); ++i)
    if (rates_[i] > 0.0) order += rates_[i] * node.score[i + 1];
  return rounded(order);
}

/// Of a front to a tolerance: nearly all that builds leave of it, in equal parts before each stage but the first. What
/// is given up falls short of a label by one part before each stage, and that of a build known by what builds settle
/// (Incumbents::tolerance, half of the front's). Only once: what a search leaves undecided for a finer one has made use
/// of it already.
double BranchAndBound::slack_of_labels() const {
  constexpr double share = 0.9;  // of what builds settle
  if (criteria_.objectives < 2 || precision_.refinements > 0 || plans_.size() < 2) return 0.0;
  return share * incumbents_.tolerance() / static_cast<double>(plans_.size() - 1);
}

double BranchAndBound::slack_given() const { return slack_ * static_cast<double>(plans_.size() - 1); }

/// Where a front widens: what is settled, what a point stands for and what labels give up grow alike. (Labels in the
/// set are forgotten only for what is as good without slack: so what is given up falls short of something known by the
/// largest slack before each stage.)
void BranchAndBound::widen() {
  constexpr double step = 1.25;
  if (criteria_.objectives < 2 || !control_.options().widens) return;
  const double asked = control_.options().tolerance_of_front();
  const double widening = control_.tolerance_of_front() / asked;
  if (widening < step * widening_) return;
  incumbents_.set_tolerance(std::max(incumbents_.tolerance(), 0.5 * asked * widening));
  precision_.tolerance *= widening / widening_;
  widening_ = widening;
  slack_ = std::max(slack_, slack_of_labels());
  for (LabelSet& labels : label_sets_) labels.set_slack(slack_);
}

bool BranchAndBound::can_end(std::span<const double> score) const {
  const auto is_infinite = [](double least) { return least == infinity; };
  return std::ranges::none_of(score.first(criteria_.objectives), is_infinite) &&
         std::ranges::none_of(score.last(criteria_.guides), is_infinite);
}

bool BranchAndBound::useless(const Node& node) const {
  const Label& label = labels_[node.label];
  if (!label.alive || !can_end(node.score) || incumbents_.hopeless(node.score, node.utilisation)) return true;
  if (node.next_region != whole_stage || label.stage + 1 >= plans_.size()) return false;
  return label_sets_[label.stage + 1].dominates({node.reached, node.handed_on, node.utilisation}, node.score);
}

/// The same for a part of a leaf, by its own share of the scores.
bool BranchAndBound::useless(const Label& label, std::size_t stage, const Worth& own) const {
  std::vector<double> reached(own.score.begin(), own.score.end());
  for (std::size_t k = 0; k < reached.size(); ++k) reached[k] = total_down(reached[k], label.score_lower[k]);
  const double utilisation = std::max(label.utilisation, own.utilisation);
  const std::vector<double> total = with_rest(stage, reached, own.state);
  if (!can_end(total) || incumbents_.hopeless(total, utilisation)) return true;
  return stage + 1 < plans_.size() && label_sets_[stage + 1].dominates({reached, own.state, utilisation}, total);
}

/// Lower bounds of totals, by the least of all that follows a stage.
std::vector<double> BranchAndBound::with_rest(std::size_t stage,
                                              std::span<const double> reached,
                                              std::span<const Interval> handed_on) const {
  std::vector<double> total(reached.begin(), reached.end());
  for (std::size_t k = 0; k < total.size(); ++k)
    total[k] = total_down(total[k], rest_after(plans_[stage], k, handed_on));
  criteria_.raise(total);
  return total;
}

}  // namespace millwright::solver
