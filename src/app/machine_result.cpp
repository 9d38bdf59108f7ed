// SPDX-License-Identifier: Apache-2.0
#include "app/machine_result.h"

#include <algorithm>
#include <thread>

namespace millwright::app {

report::MachineResult result_for(const MachineInput& input) {
  const machine::Problem& problem = input.problem;
  report::MachineResult result;
  result.steering = input.steering;
  result.currency = problem.currency;
  result.title = problem.title;
  result.file = problem.file;
  result.has_budget = problem.limits.any();
  for (const machine::Axis& axis : problem.axes) result.axes.push_back(axis.name);
  return result;
}

std::vector<report::MissingSlot> missing_slots(const std::vector<evaluation::EmptySlot>& slots) {
  std::vector<report::MissingSlot> missing;
  for (const evaluation::EmptySlot& slot : slots) missing.push_back({slot.axis, slot.slot, slot.reason});
  return missing;
}

evaluation::SearchOptions search_options(const Options& options, const std::vector<std::string>& objectives) {
  evaluation::SearchOptions search;
  search.objectives = objectives;
  constexpr double least_gap = 1e-10;  // rounding leaves about as much of what free dimensions move
  search.gap = std::max(options.gap, least_gap);
  search.front_tolerance = options.front_tolerance;
  search.time_limit_seconds = options.time_limit;
  search.threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  return search;
}

void set_designs(report::MachineResult& result,
                 const machine::Problem& problem,
                 std::vector<evaluation::Design> designs) {
  result.designs = std::move(designs);
  for (evaluation::Design& design : result.designs) shorten_places(design);
  if (!result.designs.empty()) result.requirements = report::used_requirements(problem, result.designs.front());
}

}  // namespace millwright::app
