// SPDX-License-Identifier: Apache-2.0
#include "app/search_machine.h"

#include <algorithm>
#include <stdexcept>

#include "app/machine_result.h"
#include "evaluation/incomplete_parts.h"
#include "report/machine_text.h"

namespace millwright::app {

namespace {

report::Status status_of(solver::Status status) {
  switch (status) {
    case solver::Status::optimal:
      return report::Status::optimal;
    case solver::Status::infeasible:
      return report::Status::infeasible;
    case solver::Status::limit:
      return report::Status::limit;
  }
  return report::Status::infeasible;
}

evaluation::Synthesis robust_synthesis(const MachineInput& input,
                                       const evaluation::SearchOptions& how,
                                       report::MachineResult& result) {
  evaluation::RobustSynthesis found = evaluation::synthesise_robustly(
      input.problem, input.catalogue, {.fixed = input.steering.fixed, .objectives = how.objectives}, how);
  result.robust = true;
  result.robust_scenarios = found.scenarios;
  result.robust_without = found.without;
  return std::move(found.best);
}

}  // namespace

std::vector<std::string> objectives_of(const Options& options, const MachineInput& input) {
  return options.objectives.empty() ? std::vector<std::string>{input.problem.objective} : options.objectives;
}

std::string objective_unit_of(const Options& options, const MachineInput& input) {
  return report::objective_unit(objectives_of(options, input).front(), input.problem.currency);
}

report::MachineResult search_machine(const Options& options,
                                     const MachineInput& input,
                                     const evaluation::MachineModel& model,
                                     StopSignal& stop,
                                     ProgressLine& line) {
  report::MachineResult result = result_for(input);
  result.objectives = objectives_of(options, input);
  const Stopwatch watch;
  evaluation::SearchOptions how = search_options(options, result.objectives);
  how.stop = stop.stopped();
  how.resume = [&stop] { return stop.resume(); };
  how.builds = options.builds;
  how.worksheets = !options.report.empty() && options.verb == Verb::solve;
  how.tolerances = options.verb == Verb::solve;
  if (line.active()) how.progress = [&line](const solver::Progress& progress) { line.show(progress); };
  evaluation::Synthesis synthesis =
      options.robust ? robust_synthesis(input, how, result) : evaluation::synthesise(model, how);
  line.clear();
  result.status = status_of(synthesis.status);
  result.missing = missing_slots(synthesis.empty_slots);
  if (result.status == report::Status::infeasible && result.missing.empty() && !options.robust)
    result.unmet =
        evaluation::unmet_checks(model, [&] { return how.stop->load() || watch.seconds() > how.time_limit_seconds; });
  result.lower_bound = synthesis.lower_bound;
  result.gap = synthesis.gap;
  result.builds_asked = options.builds;
  result.proved = synthesis.proved;
  result.fixed_objective = synthesis.fixed_objective;
  result.certificate = {
      synthesis.combinations, synthesis.nodes, synthesis.evaluations, synthesis.method, synthesis.front_tolerance};
  result.certificate.incomplete = evaluation::incomplete_parts(model);
  set_designs(result, input.problem, std::move(synthesis.designs));
  result.timing.solve = watch.seconds();
  if (std::any_of(result.designs.begin(), result.designs.end(), [](const auto& design) { return !design.satisfied(); }))
    throw std::logic_error("the build that the search returned fails a check");
  return result;
}

void add_ways_out(const Options& options,
                  const evaluation::MachineModel& model,
                  const StopSignal& stop,
                  report::MachineResult& result) {
  if (result.status != report::Status::infeasible || !result.missing.empty() || options.robust) return;
  const Stopwatch watch;
  evaluation::SearchOptions how = search_options(options, result.objectives);
  how.stop = stop.stopped();
  how.builds = options.builds;
  how.time_limit_seconds = std::max(0.0, how.time_limit_seconds - result.timing.solve);
  result.ways_out = evaluation::ways_out(model, result.unmet, how);
  result.timing.solve += watch.seconds();
}

}  // namespace millwright::app
