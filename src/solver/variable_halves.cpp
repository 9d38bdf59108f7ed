// SPDX-License-Identifier: Apache-2.0
#include "solver/variable_halves.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

constexpr double narrow = 1.0 / 1024.0;  // of a variable's range

/// Of each variable's range, so that all of them together make some ten parts.
double wide(const StagePlan& plan) {
  constexpr double parts = 8.0;
  return std::pow(parts,
                  -1.0 / static_cast<double>(std::count(plan.moves_outcome.begin(), plan.moves_outcome.end(), true)));
}

/// Whether there is anything between its ends that bounds can tell apart.
bool can_be_halved(const Interval& side, const Variable& variable) {
  const double cut = middle(side);
  return side.lower < cut && cut < side.upper &&
         side.upper - side.lower > narrowest * (variable.upper - variable.lower);
}

std::optional<std::size_t> widest_above(double share, const StagePlan& plan, const Region& region) {
  std::optional<std::size_t> widest;
  for (std::size_t v = 0; v < region.variables.size(); ++v) {
    const Interval& side = region.variables[v];
    const Interval& whole = plan.region.variables[v];
    const double left = (side.upper - side.lower) / (whole.upper - whole.lower);
    if (!plan.moves_outcome[v] || !(left > share) || !can_be_halved(side, plan.stage->variables()[v])) continue;
    share = left;
    widest = v;
  }
  return widest;
}

}  // namespace

std::optional<std::size_t> wide_variable(const StagePlan& plan, const Region& region) {
  if (!is_covered(plan) || region.rows.empty()) return std::nullopt;
  return widest_above(wide(plan), plan, region);
}

std::optional<std::size_t> variable_to_halve(const StagePlan& plan,
                                             std::span<const Interval> inherited,
                                             const Region& region,
                                             std::span<const double> least,
                                             Desk& desk) {
  if (!is_covered(plan) || region.rows.empty()) return std::nullopt;
  if (const auto variable = wide_variable(plan, region)) return variable;
  const auto widest = widest_above(narrow, plan, region);
  if (!widest) return std::nullopt;
  desk.trial = region.variables;
  for (std::size_t v = 0; v < desk.trial.size(); ++v)
    if (plan.moves_outcome[v]) desk.trial[v] = middle(desk.trial[v]);
  const auto& at_middle = desk.bound(*plan.stage, plan.shared, inherited, region, desk.trial);
  std::vector<Interval> score(plan.criteria->size());
  plan.criteria->scores<Interval>(at_middle.resources, score);
  double by_variable = 0.0, by_rows = 0.0;
  for (std::size_t k = 0; k < plan.criteria->objectives; ++k) {
    const double unit = std::fabs(plan.least[k]) + 1e-9;
    by_variable += (score[k].lower - least[k]) / unit;
    by_rows += (score[k].upper - score[k].lower) / unit;
  }
  return by_variable > by_rows ? widest : std::nullopt;
}

std::pair<Region, Region> halved(const Region& region, std::size_t variable) {
  std::pair<Region, Region> parts{region, region};
  std::tie(parts.first.variables, parts.second.variables) = halves(region.variables, variable);
  return parts;
}

}  // namespace millwright::solver
