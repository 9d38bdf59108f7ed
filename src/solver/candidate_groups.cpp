// SPDX-License-Identifier: Apache-2.0
#include "solver/candidate_groups.h"

#include <algorithm>

#include "solver/rest_curve.h"

namespace millwright::solver {

CandidateGroups::CandidateGroups(std::span<const CandidateQuestion* const> questions)
    : questions_(questions.begin(), questions.end()) {
  for (const CandidateQuestion* question : questions_) {
    std::vector<double>& reference = references_.emplace_back();
    for (const Interval& side : question->states) reference.push_back(middle(side));
  }
}

const CandidateGroups::View& CandidateGroups::view(GroupSet groups) {
  const int first = std::countr_zero(groups);
  const int last = static_cast<int>(std::bit_width(groups)) - 1;
  std::unique_ptr<const View>& known = views_[{first, last}];
  if (known == nullptr) {
    auto view = std::make_unique<View>();
    view->first = static_cast<std::size_t>(first);
    view->states = questions_[view->first]->states;
    const auto end = static_cast<std::size_t>(last) + 1;
    for (std::size_t group = view->first + 1; group < end; ++group)
      for (std::size_t c = 0; c < view->states.size(); ++c)
        view->states[c] = hull(view->states[c], questions_[group]->states[c]);
    for (std::size_t group = view->first; group < end; ++group) view->carried.push_back(carry(group, view->states));
    const std::vector<double> nothing(view->states.size(), 0.0);
    const auto& to_reference = view->carried.front().to_reference;
    for (std::size_t h = 0; h < to_reference.size(); ++h) {
      const double inherited = questions_[view->first]->form->change(h, nothing, references_[view->first]);
      view->to_own_share.emplace_back(to_reference[h].first - inherited, to_reference[h].second - inherited);
    }
    known = std::move(view);
  }
  return *known;
}

CandidateGroups::Carried CandidateGroups::carry(std::size_t group, std::span<const Interval> states) const {
  const CandidateQuestion& question = *questions_[group];
  const std::vector<double>& reference = references_[group];
  Carried carried;
  // From a bound over the states to one at the reference: the linear part is taken to the worst corner and back.
  for (std::size_t h = 0; h < states.size(); ++h) {
    double low = 0.0;
    double high = 0.0;
    double least = 0.0;
    for (std::size_t c = 0; c < states.size(); ++c) {
      const double slope = question.form->slope[h][c];
      least += slope *
               (slope > 0.0 ? question.states[c].lower - states[c].lower : question.states[c].upper - states[c].upper);
      const double at_lower = slope * (reference[c] - states[c].lower);
      const double at_upper = slope * (reference[c] - states[c].upper);
      low += std::max(at_lower, at_upper);
      high += std::min(at_lower, at_upper);
    }
    carried.to_reference.emplace_back(low, high);
    carried.to_own_states.push_back(least);
  }
  return carried;
}

bool CandidateGroups::may_matter(std::size_t group, const View& view, const Bounds& bounds) const {
  const CandidateQuestion& question = *questions_[group];
  return below_staircase(question.useful, bounds.score[0], question.plan->criteria->second(bounds.score)) &&
         may_lead_on(group, view, bounds);
}

/// Whether the cheapest label with a design of these bounds, and what must follow then, is below some corner.
bool CandidateGroups::may_lead_on(std::size_t group, const View& view, const Bounds& bounds) const {
  const CandidateQuestion& question = *questions_[group];
  const StagePlan& plan = *question.plan;
  if ((plan.curves.empty() && plan.planes.empty()) || question.corners.empty()) return true;
  const Carried& carried = view.of(group);
  const auto at_own_states = [&](std::size_t h) { return bounds.handed_on[h].lower + carried.to_own_states[h]; };
  double second = question.least.second + plan.criteria->second(bounds.score);
  if (plan.criteria->size() > 1) second += rest_given(plan, 1, at_own_states);
  LeastTotals totals(question.least.first + bounds.score[0] + rest_given(plan, 0, at_own_states), second);
  const auto own_share = [&](std::size_t h) { return bounds.handed_on[h].lower + view.to_own_share[h].first; };
  const auto add_all = [&](const auto& all) {
    for (const auto& each : all) totals.add(each.mix, each.mix.of(bounds.score) + rest_by(each, own_share));
  };
  add_all(question.totals);
  add_all(question.total_stairs);
  const RestVectors& vectors = question.total_vectors;
  return totals.below(question.corners) &&
         (vectors.add.empty() ||
          vectors.reach({bounds.score[0], plan.criteria->second(bounds.score)}, own_share, question.corners));
}

double CandidateGroups::least_total(std::size_t group, const View& view, const Bounds& bounds) const {
  const CandidateQuestion& question = *questions_[group];
  return question.total_vectors.least(
      *question.mix,
      {bounds.score[0], question.plan->criteria->second(bounds.score)},
      [&](std::size_t h) { return bounds.handed_on[h].lower + view.to_own_share[h].first; },
      question.corners);
}

namespace {

/// Of bounds to which something is added.
void key_of_sum(const Comparison& comparison,
                const Bounds& bounds,
                std::span<const std::pair<double, double>> add,
                std::vector<double>& key) {
  thread_local std::vector<Interval> handed_on;
  handed_on.assign(bounds.handed_on.begin(), bounds.handed_on.end());
  for (std::size_t h = 0; h < add.size(); ++h) {
    handed_on[h].lower += add[h].first;
    handed_on[h].upper += add[h].second;
  }
  key.resize(comparison.dimensions());
  comparison.best_key(bounds.score, handed_on, key.data());
}

}  // namespace

void CandidateGroups::best_key(std::size_t group,
                               const View& view,
                               const Bounds& bounds,
                               std::vector<double>& key) const {
  key_of_sum(*questions_[group]->comparison, bounds, view.of(group).to_reference, key);
}

void CandidateGroups::best_own_key(const View& view, const Bounds& bounds, std::vector<double>& key) const {
  key_of_sum(*questions_[view.first]->comparison, bounds, view.to_own_share, key);
}

}  // namespace millwright::solver
