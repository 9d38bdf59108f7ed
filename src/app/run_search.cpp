// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/search_watch.h"
#include "report/bom_csv.h"
#include "report/json.h"
#include "report/machine_text.h"
#include "report/page.h"
#include "text/output_file.h"

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

report::MachineResult search(const Options& options, const MachineInput& input, const evaluation::MachineModel& model) {
  report::MachineResult result = result_for(input);
  result.objectives = options.objectives;
  if (result.objectives.empty()) result.objectives = {input.problem.objective};
  const Stopwatch watch;
  evaluation::SearchOptions how = search_options(options, result.objectives);
  const StopSignal stop;
  how.stop = stop.stopped();
  how.builds = options.builds;
  how.worksheets = !options.report.empty() && options.verb == Verb::solve;
  evaluation::Synthesis synthesis;
  {
    ProgressLine line(options.quiet, report::objective_unit(result.objectives.front(), input.problem.currency));
    if (line.active()) how.progress = [&line](const solver::Progress& progress) { line.show(progress); };
    synthesis = evaluation::synthesise(model, how);
  }
  result.status = status_of(synthesis.status);
  result.missing = missing_slots(synthesis.empty_slots);
  if (result.status == report::Status::infeasible && result.missing.empty()) {
    result.unmet = evaluation::unmet_checks(model);
    how.progress = nullptr;
    how.time_limit_seconds = std::max(0.0, how.time_limit_seconds - watch.seconds());
    result.ways_out = evaluation::ways_out(model, result.unmet, how);
  }
  result.lower_bound = synthesis.lower_bound;
  result.gap = synthesis.gap;
  result.builds_asked = options.builds;
  result.proved = synthesis.proved;
  result.fixed_objective = synthesis.fixed_objective;
  result.certificate = {
      synthesis.combinations, synthesis.nodes, synthesis.evaluations, synthesis.method, synthesis.front_tolerance};
  set_designs(result, input.problem, std::move(synthesis.designs));
  result.timing.solve = watch.seconds();
  return result;
}

/// The answer is evaluated from scratch: a build that then fails a check would be a wrong answer of ours.
bool holds(const report::MachineResult& result) {
  for (const evaluation::Design& design : result.designs)
    if (!design.satisfied()) return false;
  return true;
}

/// The runners-up are found among those of one quantity that no ramp moves.
void check_alternatives(const Options& options, const MachineInput& input, text::Diagnostics& diagnostics) {
  if (options.builds <= 1) return;
  const std::string objective = options.objectives.empty() ? input.problem.objective : options.objectives.front();
  if (objective == "cost" || objective == "mass") return;
  diagnostics.error(text::SourceSpan{},
                    fmt::format("--alternatives: the best builds are known by cost or mass, not by {}", objective),
                    "add --minimise cost, or leave --alternatives out");
}

int exit_code_of(const report::MachineResult& result) {
  if (result.status == report::Status::limit) return exit_limit;
  return result.designs.empty() ? exit_failed : exit_done;
}

}  // namespace

int run_search(const Options& options) {
  const Stopwatch watch;
  text::Diagnostics diagnostics;
  const bool writable = outputs_are_writable(options, diagnostics);
  const auto input = read_machine(options, diagnostics);
  std::optional<evaluation::MachineModel> model;
  if (input) check_alternatives(options, *input, diagnostics);
  if (input) {
    model.emplace(input->problem,
                  input->catalogue,
                  evaluation::GivenSlots{},
                  evaluation::ModelOptions{.fixed = input->steering.fixed, .every_candidate = options.builds > 1});
    for (const evaluation::BomProblem& problem : model->problems())
      diagnostics.error(problem.where, problem.message, problem.hint);
  }
  print(diagnostics);
  if (!model || !writable || diagnostics.has_errors()) return exit_bad_input;
  const double read = watch.seconds();
  report::MachineResult result = search(options, *input, *model);
  result.timing.read = read;
  result.timing.total = watch.seconds();
  if (!holds(result)) throw std::logic_error("the build that the search returned fails a check");
  if (!options.bom.empty() && !result.designs.empty()) {
    text::Diagnostics failures;
    if (!text::write_file_atomically(options.bom, report::bom_csv(result.designs.front()), failures)) {
      print(failures);
      return exit_bad_input;
    }
  }
  if (!result.designs.empty() && !write_order(options, result.designs.front(), result.title)) return exit_bad_input;
  const report::Style style = output_style();
  const bool front = options.verb == Verb::pareto;
  const std::string json = front ? report::front_json(result) : report::solve_json(result);
  const std::string page = options.report.empty()
                               ? std::string()
                               : report::machine_page(result,
                                                      input->problem,
                                                      front ? report::PageKind::pareto : report::PageKind::solve,
                                                      json,
                                                      page_language(options));
  const bool delivered =
      deliver(options, front ? report::front_text(result, style) : report::solve_text(result, style), json, page);
  return delivered ? exit_code_of(result) : exit_bad_input;
}

}  // namespace millwright::app
