// SPDX-License-Identifier: Apache-2.0
#include "solver/relief.h"

#include <algorithm>
#include <limits>

namespace millwright::solver {
namespace {

bool is_exactly_zero(const Interval& slope) { return slope.lower == 0.0 && slope.upper == 0.0; }

Interval hull_of(const std::vector<Interval>& parts) { return {parts.front().lower, parts.back().upper}; }

}  // namespace

Relief::Relief(LeafDesign& design)
    : design_(design), held_(design.question.region->variables.size()), divided_(held_.size()) {
  std::vector<std::size_t> variables;
  for (std::size_t v = 0; v < divided_.size(); ++v)
    if (!design.question.plan->moves_outcome[v] && !design.question.region->variables[v].is_point())
      variables.push_back(v);
  if (variables.size() > 1) find_groups(variables);
  for (const Group& group : groups_) {
    for (const std::size_t v : group.variables) held_[v] = true;
    if (group.variables.size() == 1) divided_[group.variables.front()] = true;
  }
}

void Relief::find_groups(const std::vector<std::size_t>& variables) {
  const LeafQuestion& question = design_.question;
  const StagePlan& plan = *question.plan;
  for (const std::size_t v : variables) {
    Group group{{v}, {}};
    const Input input{Input::Kind::variable, v};
    const auto& slopes =
        design_.desk.slopes(*plan.stage, plan.shared, question.label->enclosure, *question.region, input);
    for (std::size_t c = 0; c < slopes.utilisation.size(); ++c)
      if (!is_exactly_zero(slopes.utilisation[c])) group.constraints.push_back(c);
    // Groups that share a constraint with it become one with it.
    std::erase_if(groups_, [&](const Group& other) {
      if (std::find_first_of(
              group.constraints.begin(), group.constraints.end(), other.constraints.begin(), other.constraints.end()) ==
          group.constraints.end())
        return false;
      group.variables.insert(group.variables.end(), other.variables.begin(), other.variables.end());
      group.constraints.insert(group.constraints.end(), other.constraints.begin(), other.constraints.end());
      return true;
    });
    std::sort(group.constraints.begin(), group.constraints.end());
    group.constraints.erase(std::unique(group.constraints.begin(), group.constraints.end()), group.constraints.end());
    groups_.push_back(std::move(group));
  }
}

bool Relief::is_free(const Group& group, std::span<const Interval> side) {
  return std::any_of(
      group.variables.begin(), group.variables.end(), [&](std::size_t v) { return !side[v].is_point(); });
}

const Answer<Interval>& Relief::bound(std::span<const Interval> side) const {
  const LeafQuestion& question = design_.question;
  return design_.desk.bound(
      *question.plan->stage, question.plan->shared, question.label->enclosure, *question.region, side);
}

void Relief::relieve(std::vector<double>& variables, std::span<const Interval> box, bool thoroughly) {
  relieve_single(variables, box);
  for (Group& group : groups_) {
    if (group.variables.size() == 1 || !is_free(group, box)) continue;
    if (thoroughly || group.values.empty()) {
      const auto moved = design_.least_worst(box, variables, group.variables, group.constraints);
      group.values = moved ? *moved : variables;
    }
    for (const std::size_t v : group.variables) variables[v] = std::clamp(group.values[v], box[v].lower, box[v].upper);
  }
}

/// Groups of one: all at once, since none changes what another one's constraints are; from a coarse grid, then halving
/// the step.
void Relief::relieve_single(std::vector<double>& variables, std::span<const Interval> box) const {
  constexpr int grid = 8, refinements = 10;
  std::vector<const Group*> moved;
  for (const Group& group : groups_)
    if (group.variables.size() == 1 && is_free(group, box)) moved.push_back(&group);
  if (moved.empty()) return;
  std::vector<double> worst(variables.size(), std::numeric_limits<double>::infinity());
  std::vector<double> trial = variables;
  const auto look = [&](auto&& value_of) {
    for (const Group* group : moved) {
      const std::size_t v = group->variables.front();
      trial[v] = std::clamp(value_of(v), box[v].lower, box[v].upper);
    }
    design_.worst_at(trial);
    for (const Group* group : moved) {
      const std::size_t v = group->variables.front();
      double own = 0.0;
      for (const std::size_t c : group->constraints) own = std::max(own, design_.desk.number.utilisation[c]);
      if (!(own < worst[v])) continue;
      worst[v] = own;
      variables[v] = trial[v];
    }
  };
  for (int i = 0; i <= grid; ++i)
    look([&](std::size_t v) { return box[v].lower + i * (box[v].upper - box[v].lower) / grid; });
  double part = 1.0 / grid;
  for (int i = 0; i < refinements; ++i) {
    part *= 0.5;
    const std::vector<double> around = variables;
    for (const double way : {part, -part})
      look([&](std::size_t v) { return around[v] + way * (box[v].upper - box[v].lower); });
  }
}

bool Relief::settle(VariableBox& box, std::span<const double> values) const {
  std::vector<Interval> side = box.side;
  bool any_free = false;
  for (const Group& group : groups_) {
    any_free = any_free || is_free(group, box.side);
    for (const std::size_t v : group.variables) side[v] = Interval(values[v]);
  }
  if (!any_free) return false;
  const auto& utilisation = bound(side).utilisation;
  const auto is_kept = [&](std::size_t c) { return utilisation[c].upper <= 1.0; };
  bool some = false;
  for (const Group& group : groups_) {
    if (!is_free(group, box.side)) continue;
    if (!std::all_of(group.constraints.begin(), group.constraints.end(), is_kept)) continue;
    some = true;
    for (const std::size_t v : group.variables) {
      box.side[v] = side[v];
      if (!box.parts.empty()) box.parts[v].clear();
    }
  }
  return some;
}

bool Relief::sieve(VariableBox& box, std::size_t variable) const {
  std::vector<Interval>& parts = box.parts[variable];
  std::vector<Interval> side = box.side;
  const auto infeasible = [&](const Interval& part) {
    side[variable] = part;
    return worst_lower(bound(side).utilisation) > 1.0;
  };
  std::erase_if(parts, infeasible);
  if (parts.empty()) return false;
  box.side[variable] = hull_of(parts);
  return true;
}

bool Relief::sieve(VariableBox& box) const {
  for (std::size_t v = 0; v < box.parts.size(); ++v)
    if (box.parts[v].size() > 1 && !sieve(box, v)) return false;
  return true;
}

std::size_t Relief::parts(const VariableBox& box, std::size_t variable) {
  return box.parts.empty() ? 1 : std::max<std::size_t>(box.parts[variable].size(), 1);
}

double Relief::widest_part(const VariableBox& box, std::size_t variable) {
  if (box.parts.empty() || box.parts[variable].empty()) return box.side[variable].upper - box.side[variable].lower;
  double widest = 0.0;
  for (const Interval& part : box.parts[variable]) widest = std::max(widest, part.upper - part.lower);
  return widest;
}

bool Relief::refine(VariableBox& box, std::size_t variable) const {
  box.parts.resize(box.side.size());
  std::vector<Interval>& parts = box.parts[variable];
  if (parts.empty()) parts.push_back(box.side[variable]);
  std::vector<Interval> halved;
  for (const Interval& part : parts) {
    const double cut = middle(part);
    halved.emplace_back(part.lower, cut);
    halved.emplace_back(cut, part.upper);
  }
  parts = std::move(halved);
  return sieve(box, variable);
}

bool Relief::clip(VariableBox& box) const {
  for (std::size_t v = 0; v < box.parts.size(); ++v) {
    std::vector<Interval>& parts = box.parts[v];
    if (parts.empty()) continue;
    std::vector<Interval> left;
    for (const Interval& part : parts)
      if (const auto common = intersect(part, box.side[v])) left.push_back(*common);
    if (left.empty()) return false;
    parts = std::move(left);
    box.side[v] = hull_of(parts);
  }
  return true;
}

std::vector<Interval> Relief::as_given(std::span<const Interval> side) const {
  std::vector<Interval> sides(side.begin(), side.end());
  for (const Group& group : groups_)
    for (const std::size_t v : group.variables) sides[v] = design_.question.region->variables[v];
  return sides;
}

}  // namespace millwright::solver
