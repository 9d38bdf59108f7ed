// SPDX-License-Identifier: Apache-2.0
//
// Stages of a front whose variables move scores or states and that have no slots: label by label.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/stagewise_search.h"

namespace millwright::solver {
namespace {

/// Labels between which the stage cannot tell: equal in every component that one of its utilisations or scores reads.
struct Group {
  std::vector<std::uint32_t> labels;
  Label best;  ///< the least of each score and, of components that it does not read, of each state's magnitude
  LeafAnswer answer;
};

void take_smaller(Label& best, const Label& label, const std::vector<bool>& reads) {
  for (std::size_t k = 0; k < best.score.size(); ++k) best.score[k] = std::min(best.score[k], label.score[k]);
  for (std::size_t c = 0; c < best.state.size(); ++c) {
    if (!reads[c] && std::fabs(label.state[c]) < std::fabs(best.state[c])) best.state[c] = label.state[c];
  }
}

std::vector<Group> group_labels(const std::vector<Label>& labels, const StateForm& form) {
  std::vector<bool> reads(form.influences);
  for (std::size_t c = 0; c < reads.size(); ++c) reads[c] = reads[c] || form.moves_scores[c];
  std::vector<Group> groups;
  std::map<std::vector<double>, std::size_t> known;
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    std::vector<double> deciding;
    for (std::size_t c = 0; c < reads.size(); ++c) {
      if (reads[c]) deciding.push_back(labels[i].state[c]);
    }
    const auto [place, first] = known.try_emplace(deciding, groups.size());
    if (first) {
      groups.emplace_back();
      groups.back().best = labels[i];
    }
    Group& group = groups[place->second];
    group.labels.push_back(i);
    take_smaller(group.best, labels[i], reads);
  }
  for (Group& group : groups) {
    group.best.exact = true;
    group.best.score_lower = group.best.score;
    group.best.enclosure.assign(group.best.state.begin(), group.best.state.end());
  }
  return groups;
}

}  // namespace

/// All labels before a stage of this kind to those before the next; false when time is up.
bool StagewiseSearch::advance_covered(std::size_t stage, const Comparison& comparison) {
  const StagePlan& plan = plans_[stage];
  const std::vector<Pair>& useful = useful_[stage + 1];
  Region region;
  region.variables = plan.region.variables;
  std::vector<Group> groups = group_labels(labels_[stage], forms_[stage]);
  control_.crew().run(groups.size(), [&](std::size_t i, unsigned thread) {
    if (control_.time_is_up()) return;
    Group& group = groups[i];
    const auto hopeless = [&](const Worth& worth) {
      return !below_staircase(useful, group.best.score[0] + worth.score[0], group.best.score[1] + worth.score[1]);
    };
    group.answer = solve_leaf(
        {&plan, &group.best, &region, leaf_tolerance_, false, hopeless, [this] { return control_.time_is_up(); }},
        control_.desk(thread));
  });
  if (control_.time_is_up()) return false;
  std::vector<Label> arrived;
  for (const Group& group : groups) {
    undecided_ = undecided_ || group.answer.undecided;
    control_.nodes += group.answer.points.size();
    for (const StagePoint& point : group.answer.points) {
      for (const std::uint32_t parent : group.labels) {
        Label label;
        if (!evaluate(stage, parent, {}, point.variables, label)) {
          // It breaks a limit; what it stands for may keep it.
          undecided_ = undecided_ || !point.exact;
          continue;
        }
        if (below_staircase(useful, label.score[0], label.score[1])) arrived.push_back(std::move(label));
      }
    }
  }
  keep_undominated(std::move(arrived), stage + 1, comparison);
  control_.report(incumbents_.best());
  return true;
}

/// The same for a stage that chooses nothing and whose scores depend on the state.
bool StagewiseSearch::advance_each(std::size_t stage, const Comparison& comparison) {
  const StagePlan& plan = plans_[stage];
  std::vector<Label> arrived;
  for (std::uint32_t parent = 0; parent < labels_[stage].size(); ++parent) {
    const auto& answer =
        control_.desk(0).evaluate(*plan.stage, Point{plan.shared, labels_[stage][parent].state, {}, {}});
    Label label;
    if (parent % 1024 == 0 && control_.time_is_up()) return false;
    if (worst_of(answer.utilisation) <= 1.0 && evaluate(stage, parent, {}, {}, label) &&
        below_staircase(useful_[stage + 1], label.score[0], criteria_.second(label.score)))
      arrived.push_back(std::move(label));
  }
  control_.nodes += labels_[stage].size();
  keep_undominated(std::move(arrived), stage + 1, comparison);
  return true;
}

/// Of some labels before a stage those that no other is at least as good as in every coordinate.
void StagewiseSearch::keep_undominated(std::vector<Label> labels, std::size_t stage, const Comparison& comparison) {
  const std::size_t n = comparison.dimensions();
  std::vector<double> keys(labels.size() * n);
  for (std::size_t i = 0; i < labels.size(); ++i) comparison.key(labels[i].score, labels[i].state, &keys[i * n]);
  const auto key_of = [&](std::size_t i) { return std::span<const double>(keys).subspan(i * n, n); };
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto left = key_of(a);
    const auto right = key_of(b);
    return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end());
  });
  KnownKeys known(comparison);
  for (const std::size_t i : order) {
    if (known.dominates(key_of(i))) continue;
    known.add(key_of(i));
    labels_[stage].push_back(std::move(labels[i]));
  }
}

}  // namespace millwright::solver
