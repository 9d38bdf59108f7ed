// SPDX-License-Identifier: Apache-2.0
#include "solver/relief.h"

#include <algorithm>

namespace millwright::solver {
namespace {

bool is_zero(const Interval& slope) { return slope.lower == 0.0 && slope.upper == 0.0; }

Interval hull_of(const std::vector<Interval>& parts) { return {parts.front().lower, parts.back().upper}; }

}  // namespace

Relief::Relief(LeafDesign& design) : design_(design), constraints_(design.question.region->variables.size()) {
  const LeafQuestion& question = design.question;
  const StagePlan& plan = *question.plan;
  std::vector<std::size_t> candidates;
  for (std::size_t v = 0; v < constraints_.size(); ++v)
    if (!plan.priced[v] && !question.region->variables[v].is_point()) candidates.push_back(v);
  if (candidates.size() < 2) return;
  std::vector<std::size_t> readers(plan.stage->constraints(), 0);
  std::vector<std::vector<std::size_t>> read_by(constraints_.size());
  for (const std::size_t v : candidates) {
    const Input input{Input::Kind::variable, v};
    const auto& slopes =
        design.desk.slopes(*plan.stage, plan.shared, question.label->enclosure, *question.region, input);
    for (std::size_t c = 0; c < readers.size(); ++c) {
      if (is_zero(slopes.utilisation[c])) continue;
      ++readers[c];
      read_by[v].push_back(c);
    }
  }
  for (const std::size_t v : candidates) {
    const auto is_shared = [&](std::size_t c) { return readers[c] > 1; };
    if (!read_by[v].empty() && std::none_of(read_by[v].begin(), read_by[v].end(), is_shared)) variables_.push_back(v);
  }
  for (const std::size_t v : variables_) constraints_[v] = std::move(read_by[v]);
}

template <class Value, class Utilisations>
double Relief::worst_of_own(std::size_t variable, const Utilisations& utilisation, Value&& value) const {
  double worst = 0.0;
  for (const std::size_t c : constraints_[variable]) worst = std::max(worst, value(utilisation[c]));
  return worst;
}

const Answer<Interval>& Relief::bound(std::span<const Interval> side) const {
  const LeafQuestion& question = design_.question;
  return design_.desk.bound(
      *question.plan->stage, question.plan->shared, question.label->enclosure, *question.region, side);
}

bool Relief::any_free(std::span<const Interval> side) const {
  return std::any_of(variables_.begin(), variables_.end(), [&](std::size_t v) { return !side[v].is_point(); });
}

/// All at once, since none changes what another one's constraints are: from a coarse grid, then halving the step.
void Relief::relieve(std::vector<double>& variables, std::span<const Interval> box) const {
  if (!any_free(box)) return;
  constexpr int grid = 8, refinements = 10;
  std::vector<double> worst(variables.size(), std::numeric_limits<double>::infinity());
  std::vector<double> trial = variables;
  const auto look = [&](auto&& value_of) {
    for (const std::size_t v : variables_) trial[v] = std::clamp(value_of(v), box[v].lower, box[v].upper);
    design_.worst_at(trial);
    for (const std::size_t v : variables_) {
      const double own = worst_of_own(v, design_.desk.number.utilisation, [](double u) { return u; });
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
  if (!any_free(box.side)) return false;
  std::vector<Interval> side = box.side;
  for (const std::size_t v : variables_) side[v] = Interval(values[v]);
  const auto& utilisation = bound(side).utilisation;
  bool some = false;
  for (const std::size_t v : variables_) {
    if (box.side[v].is_point()) continue;
    if (!(worst_of_own(v, utilisation, [](const Interval& u) { return u.upper; }) <= 1.0)) continue;
    box.side[v] = side[v];
    if (!box.parts.empty()) box.parts[v].clear();
    some = true;
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
  if (box.parts.empty()) return true;
  return std::all_of(
      variables_.begin(), variables_.end(), [&](std::size_t v) { return box.parts[v].size() < 2 || sieve(box, v); });
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
  if (box.parts.empty()) return true;
  for (const std::size_t v : variables_) {
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
  for (const std::size_t v : variables_) sides[v] = design_.question.region->variables[v];
  return sides;
}

}  // namespace millwright::solver
