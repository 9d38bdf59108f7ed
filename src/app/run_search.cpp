// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/idle_requirements.h"
#include "app/lock.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/output_target.h"
#include "app/search_machine.h"
#include "app/search_watch.h"
#include "report/bom_csv.h"
#include "report/json.h"
#include "report/machine_text.h"
#include "report/page.h"

namespace millwright::app {

namespace {

/// The runners-up are found among those of one quantity that no ramp moves.
void check_alternatives(const Options& options, const MachineInput& input, text::Diagnostics& diagnostics) {
  if (options.builds <= 1) return;
  const std::string objective = objectives_of(options, input).front();
  if (objective == "cost" || objective == "mass") return;
  diagnostics.error(text::SourceSpan{},
                    fmt::format("--alternatives: the best builds are known by cost or mass, not by {}", objective),
                    "add --minimise cost, or leave --alternatives out");
}

/// What was asked for: the best build, without the alternatives, or the whole front.
std::vector<const evaluation::Design*> designs_of(const Options& options, const report::MachineResult& result) {
  std::vector<const evaluation::Design*> designs;
  for (const evaluation::Design& design : result.designs)
    if (designs.empty() || options.verb == Verb::pareto) designs.push_back(&design);
  return designs;
}

/// `--bom`. False, with a complaint on standard error, if it could not be written.
bool write_bom(const Options& options, const report::MachineResult& result) {
  if (options.bom.empty() || result.designs.empty()) return true;
  text::Diagnostics failures;
  const bool written =
      write_target({options.bom, OutputKind::edited, options.force}, report::bom_csv(result.designs.front()), failures);
  print(failures);
  return written;
}

/// What is asked in vain; and that a file of an earlier run, which stays where there is no build, is not this one's.
void print_remarks(const Options& options, const MachineInput& input, const report::MachineResult& result) {
  text::Diagnostics remarks;
  if (!result.designs.empty())
    note_idle_requirements(input.problem, *input.document, result.designs.front(), remarks);
  else
    for (const std::string& file : {options.bom, options.order})
      if (!file.empty()) remarks.warning({}, text::printable(file) + ": not written, as there is no build", "");
  print(remarks);
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
  const double read = watch.seconds();
  double tables = 0.0;  // s, to make them of what was read
  std::optional<evaluation::MachineModel> model;
  if (input) check_alternatives(options, *input, diagnostics);
  if (options.robust && options.builds > 1)
    diagnostics.error("--robust: there is one best build, and no next best", "leave --alternatives or --robust out");
  if (!options.csv.empty())
    diagnostics.error("--csv: the table is of a range", "give --set a range, e.g. axis.x.moves[0].time='0.2:0.5:7 s'");
  if (input) {
    const Stopwatch made;
    model.emplace(input->problem,
                  input->catalogue,
                  evaluation::GivenSlots{},
                  evaluation::ModelOptions{.fixed = input->steering.fixed,
                                           .every_candidate = options.builds > 1,
                                           .builds = options.builds,
                                           .objectives = objectives_of(options, *input)});
    tables = made.seconds();
    for (const evaluation::BomProblem& problem : model->problems())
      diagnostics.error(problem.where, problem.message, problem.hint);
  }
  const auto lock = input ? verify_lock(options, *input, diagnostics) : std::nullopt;
  print(diagnostics);
  if (!model || !writable || diagnostics.has_errors()) return exit_bad_input;
  report::MachineResult result;
  {
    StopSignal stop(options.memory_limit);
    ProgressLine line(options.quiet, objective_unit_of(options, *input));
    result = search_machine(options, *input, *model, stop, line);
    add_ways_out(options, *model, stop, result);
  }
  if (wants_inventory(options)) result.catalogues = inventory_of(*input);
  if (lock && options.verb == Verb::solve && !result.designs.empty())
    compare_with_lock(*lock, *input, result.designs.front());
  result.timing.read = read;
  result.timing.solve += tables;
  result.timing.total = watch.seconds();
  // What was found is shown, and written elsewhere, even if one of the files could not be.
  bool written = write_bom(options, result);
  if (!result.designs.empty()) written = write_order(options, result.designs.front(), result.title) && written;
  print_remarks(options, *input, result);
  written = write_lock(options, *input, designs_of(options, result)) && written;
  const report::Style style = output_style(options);
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
  return delivered && written ? exit_code_of(result) : exit_bad_input;
}

}  // namespace millwright::app
