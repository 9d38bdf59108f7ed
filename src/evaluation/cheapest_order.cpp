// SPDX-License-Identifier: Apache-2.0
#include "evaluation/cheapest_order.h"

#include <algorithm>

#include "evaluation/allowed_time.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

namespace {

/// Everything of a build is held but who sells its parts.
solver::Restriction with_parts_of(const MachineModel& model, const solver::Build& build) {
  solver::Restriction held = solver::unrestricted(model.problem());
  for (std::size_t i = 0; i < shop_choice; ++i) held.shared[i] = {build.shared[i]};
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage) {
    const solver::StageChoice& chosen = build.stages[stage];
    for (std::size_t slot = 0; slot < chosen.rows.size(); ++slot) {
      const std::string parts = parts_name(model.catalogue(), model.candidate(stage, slot, chosen.rows[slot]));
      std::erase_if(held.stages[stage].allowed[slot], [&](solver::Row row) {
        return parts_name(model.catalogue(), model.candidate(stage, slot, row)) != parts;
      });
    }
    for (std::size_t v = 0; v < chosen.variables.size(); ++v) held.stages[stage].held[v] = chosen.variables[v];
  }
  return held;
}

}  // namespace

solver::Build ordered_cheapest(const MachineModel& model,
                               const SearchOptions& options,
                               const solver::Build& build,
                               double seconds) {
  const bool cost_counts = std::ranges::all_of(model.machine().axes, &machine::Axis::cost_counts);
  if (model.shops().empty() || !cost_counts) return build;
  SearchOptions how;
  how.objectives = {"cost"};
  how.gap = options.gap;
  how.threads = options.threads;
  how.time_limit_seconds = seconds;
  how.confirm = false;
  const solver::RestrictedProblem held(model.problem(), with_parts_of(model, build));
  const solver::Summary found = solver::solve(held.problem(), solver_options(model, how));
  const std::size_t cost = model.compared(machine::Quantity::cost);
  if (found.builds.empty() || !(found.builds.front().resources[cost] < build.resources[cost])) return build;
  return held.whole_build(found.builds.front());
}

void order_cheapest(const MachineModel& model,
                    const SearchOptions& options,
                    std::vector<solver::Build>& builds,
                    double seconds) {
  if (model.shops().empty()) return;
  const AllowedTime time(seconds);
  for (std::size_t i = 0; i < builds.size() && time.left() > 0.0; ++i)
    builds[i] = ordered_cheapest(model, options, builds[i], time.left() / static_cast<double>(builds.size() - i));
  const std::vector<std::size_t> objectives = solver_options(model, options).objectives;
  if (objectives.size() < 2) return;
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

}  // namespace millwright::evaluation
