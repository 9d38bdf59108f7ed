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
  // What is handed on over the states, as if nothing had been inherited.
  std::vector<double> own(states.size());
  const std::vector<double> nothing(states.size(), 0.0);
  for (std::size_t h = 0; h < own.size(); ++h)
    own[h] = carried.to_reference[h].first - question.form->change(h, nothing, reference);
  const auto priced = [&](const std::vector<double>& weight) {
    double sum = 0.0;
    for (std::size_t h = 0; h < own.size(); ++h)
      if (weight[h] != 0.0) sum += weight[h] * own[h];
    return sum;
  };
  carried.totals = question.totals;
  carried.total_stairs = question.total_stairs;
  carried.total_vectors = question.total_vectors;
  for (RestPlane& plane : carried.totals) plane.constant += priced(plane.weight);
  for (RestStairs& stairs : carried.total_stairs) {
    stairs.constant += priced(stairs.weight);
    stairs.limit -= priced(stairs.use);
  }
  RestVectors& vectors = carried.total_vectors;
  for (std::size_t a = 0; a < vectors.limit.size(); ++a) vectors.limit[a] -= priced(vectors.use[a]);
  return carried;
}

bool CandidateGroups::may_matter(std::size_t group, const View& view, const Bounds& bounds) const {
  const CandidateQuestion& question = *questions_[group];
  return below_staircase(question.useful, bounds.score[0], question.plan->criteria->second(bounds.score)) &&
         may_lead_on(question, view.of(group), bounds);
}

/// Whether the cheapest label with a design of these bounds, and what must follow then, is below some corner.
bool CandidateGroups::may_lead_on(const CandidateQuestion& question,
                                  const Carried& carried,
                                  const Bounds& bounds) const {
  const StagePlan& plan = *question.plan;
  if ((plan.curves.empty() && plan.planes.empty()) || question.corners.empty()) return true;
  const auto own_lower = [&](std::size_t h) { return bounds.handed_on[h].lower + carried.to_own_states[h]; };
  double second = question.least.second + plan.criteria->second(bounds.score);
  if (plan.criteria->objectives > 1) second += rest_given(plan, 1, own_lower);
  LeastTotals totals(question.least.first + bounds.score[0] + rest_given(plan, 0, own_lower), second);
  const auto lower = [&](std::size_t h) { return bounds.handed_on[h].lower; };
  const auto add_all = [&](const auto& all) {
    for (const auto& each : all) totals.add(each.mix, each.mix.of(bounds.score) + rest_by(each, lower));
  };
  add_all(carried.totals);
  add_all(carried.total_stairs);
  const RestVectors& vectors = carried.total_vectors;
  return totals.below(question.corners) &&
         (vectors.add.empty() ||
          vectors.reach({bounds.score[0], plan.criteria->second(bounds.score)}, lower, question.corners));
}

double CandidateGroups::least_total(std::size_t group, const View& view, const Bounds& bounds) const {
  const CandidateQuestion& question = *questions_[group];
  return view.of(group).total_vectors.least(
      *question.mix,
      {bounds.score[0], question.plan->criteria->second(bounds.score)},
      [&](std::size_t h) { return bounds.handed_on[h].lower; },
      question.corners);
}

void CandidateGroups::best_key(std::size_t group,
                               const View& view,
                               const Bounds& bounds,
                               std::vector<double>& key) const {
  thread_local std::vector<Interval> handed_on;
  const auto& to_reference = view.of(group).to_reference;
  handed_on.assign(bounds.handed_on.begin(), bounds.handed_on.end());
  for (std::size_t h = 0; h < to_reference.size(); ++h) {
    handed_on[h].lower += to_reference[h].first;
    handed_on[h].upper += to_reference[h].second;
  }
  const Comparison& comparison = *questions_[group]->comparison;
  key.resize(comparison.dimensions());
  comparison.best_key(bounds.score, handed_on, key.data());
}

}  // namespace millwright::solver
