// SPDX-License-Identifier: Apache-2.0
#include "evaluation/synthesis.h"

#include <fmt/format.h>

#include "evaluation/element_stage.h"
#include "solver/alternatives.h"

namespace millwright::evaluation {

namespace {

std::size_t resource_of(const std::string& objective) { return objective == "mass" ? mass_resource : cost_resource; }

}  // namespace

solver::Options solver_options(const SearchOptions& options) {
  solver::Options result;
  result.objectives.clear();
  for (const std::string& objective : options.objectives) result.objectives.push_back(resource_of(objective));
  if (result.objectives.size() == 1)
    result.ties = {result.objectives.front() == cost_resource ? mass_resource : cost_resource};
  result.gap = options.gap;
  result.time_limit_seconds = options.time_limit_seconds;
  result.threads = options.threads;
  result.stop = options.stop;
  result.progress = options.progress;
  return result;
}

Synthesis synthesise(const MachineModel& model, const SearchOptions& options) {
  Synthesis synthesis;
  synthesis.empty_slots = model.empty_slots();
  if (!synthesis.empty_slots.empty()) return synthesis;
  solver::Summary summary;
  if (options.builds > 1) {
    solver::Alternatives best = solver::best_builds(
        model.problem(),
        solver_options(options),
        options.builds,
        [&](std::size_t stage, std::size_t slot, solver::Row row) { return model.covering_rows(stage, slot, row); });
    summary = std::move(best.first);
    summary.status = best.status;
    summary.builds = std::move(best.builds);
    summary.method += fmt::format(
        "; the next best by splitting what each build leaves into disjoint parts, {} of them solved", best.parts - 1);
    synthesis.proved = best.proved;
  } else {
    summary = solver::solve(model.problem(), solver_options(options));
  }
  synthesis.status = summary.status;
  for (const solver::Build& build : summary.builds) synthesis.designs.push_back(model.design(build));
  synthesis.lower_bound = summary.lower_bound;
  synthesis.gap = summary.gap;
  synthesis.combinations = summary.combinations;
  synthesis.nodes = summary.nodes;
  synthesis.evaluations = summary.evaluations;
  synthesis.front_tolerance = summary.front_tolerance;
  synthesis.method = summary.method;
  synthesis.seconds = summary.seconds;
  return synthesis;
}

}  // namespace millwright::evaluation
