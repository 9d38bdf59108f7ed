// SPDX-License-Identifier: Apache-2.0
#include "evaluation/cheapest_order.h"

#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>
#include <variant>

#include "evaluation/allowed_time.h"
#include "evaluation/machine_stages.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

AlikeRows::AlikeRows(const MachineModel& model) {
  std::map<std::string, std::size_t> number;
  for (std::size_t stage = 0; stage < model.problem().stages.size(); ++stage) {
    const std::span<const solver::Slot> slots = model.problem().stages[stage]->slots();
    parts_.emplace_back(slots.size());
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
      for (solver::Row row = 0; row < slots[slot].rows; ++row)
        parts_[stage][slot].push_back(
            number.try_emplace(parts_name(model.catalogue(), model.candidate(stage, slot, row)), number.size())
                .first->second);
  }
}

std::vector<std::size_t> AlikeRows::parts_of(const solver::Build& build) const {
  std::vector<std::size_t> parts;
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < parts_[stage].size(); ++slot)
      parts.push_back(parts_[stage][slot][build.stages[stage].rows[slot]]);
  return parts;
}

solver::Restriction AlikeRows::with_parts_of(const MachineModel& model, const solver::Build& build) const {
  solver::Restriction held = solver::unrestricted(model.problem());
  for (std::size_t i = 0; i < shop_choice; ++i) held.shared[i] = {build.shared[i]};
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage) {
    const solver::StageChoice& chosen = build.stages[stage];
    for (std::size_t slot = 0; slot < chosen.rows.size(); ++slot) {
      const std::vector<std::size_t>& parts = parts_[stage][slot];
      std::erase_if(held.stages[stage].allowed[slot],
                    [&](solver::Row row) { return parts[row] != parts[chosen.rows[slot]]; });
    }
    for (std::size_t v = 0; v < chosen.variables.size(); ++v) held.stages[stage].held[v] = chosen.variables[v];
  }
  return held;
}

namespace {

/// Without those that another one beats; ascending in the first objective.
void keep_best(const std::vector<std::size_t>& objectives, std::vector<solver::Build>& builds) {
  const auto totals = [&](const solver::Build& build) {
    std::vector<double> result;
    for (const std::size_t objective : objectives) result.push_back(build.resources[objective]);
    return result;
  };
  std::ranges::stable_sort(builds, {}, totals);
  std::vector<solver::Build> left;
  for (solver::Build& build : builds) {
    const auto is_no_worse = [&](const solver::Build& other) {
      return std::ranges::all_of(objectives, [&](std::size_t k) { return other.resources[k] <= build.resources[k]; });
    };
    if (std::ranges::none_of(left, is_no_worse)) left.push_back(std::move(build));
  }
  builds = std::move(left);
}

/// How an order is made.
SearchOptions ordering(const SearchOptions& options) {
  SearchOptions how;
  how.objectives = {"cost"};
  how.gap = options.gap;
  how.threads = options.threads;
  how.confirm = false;
  return how;
}

}  // namespace

solver::Build ordered_cheapest_though_failing(const MachineModel& model,
                                              const AlikeRows& alike,
                                              const SearchOptions& options,
                                              const solver::Build& build,
                                              double seconds) {
  constexpr double exact = 1e-6;
  const AllowedTime time(seconds);
  solver::Restriction restriction = alike.with_parts_of(model, build);
  for (std::size_t i = 0; i < restriction.stages.size(); ++i)
    restriction.stages[i].waived = std::visit(
        [](const auto& stage) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(*stage)>, WholeStage>)
            return stage->declared_constraints();
          else
            return stage->constraints();
        },
        model.entries()[i].stage);
  solver::RestrictedProblem held(model.problem(), restriction);
  const double limit = held.problem().resources[cost_resource].limit;
  for (solver::Resource& resource : held.problem().resources) resource.limit = std::numeric_limits<double>::infinity();
  SearchOptions how = ordering(options);
  how.gap = std::min(options.gap, exact);
  for (const bool within_limit : {true, false}) {
    held.problem().resources[cost_resource].limit =
        within_limit ? std::min(limit, 0.5 * beyond_reach) : 0.5 * beyond_reach;
    how.time_limit_seconds = time.left();
    solver::Options asked = solver_options(model, how);
    asked.price_limits = false;
    if (!within_limit) asked.objectives = {cost_resource};
    const solver::Summary found = solver::solve(held.problem(), asked);
    if (!found.builds.empty()) return held.whole_build(found.builds.front());
  }
  return build;
}

void order_cheapest(const MachineModel& model,
                    const SearchOptions& options,
                    std::vector<solver::Build>& builds,
                    double seconds) {
  const AllowedTime time(seconds);
  const bool cost_counts = std::ranges::all_of(model.machine().axes, &machine::Axis::cost_counts);
  if (model.shops().empty() || !cost_counts || builds.empty()) return;
  const AlikeRows alike(model);
  const std::size_t cost = model.compared(machine::Quantity::cost);
  SearchOptions how = ordering(options);
  for (solver::Build& build : builds) {
    how.time_limit_seconds = time.left();
    if (!(how.time_limit_seconds > 0.0)) break;
    const solver::RestrictedProblem held(model.problem(), alike.with_parts_of(model, build));
    const solver::Summary found = solver::solve(held.problem(), solver_options(model, how));
    if (!found.builds.empty() && found.builds.front().resources[cost] < build.resources[cost])
      build = held.whole_build(found.builds.front());
  }
  const std::vector<std::size_t> objectives = solver_options(model, options).objectives;
  if (objectives.size() > 1) keep_best(objectives, builds);
}

}  // namespace millwright::evaluation
