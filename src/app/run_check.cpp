// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/idle_requirements.h"
#include "app/lock.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/search_watch.h"
#include "machine/bill_of_materials.h"
#include "machine/choosing_words.h"
#include "report/json.h"
#include "report/machine_text.h"
#include "report/page.h"

namespace millwright::app {

namespace {

using machine::BillOfMaterials;
using machine::BomLine;

std::optional<BillOfMaterials> read_bom(const Options& options,
                                        const machine::Problem& problem,
                                        const std::shared_ptr<const text::SourceText>& text,
                                        text::Diagnostics& diagnostics) {
  auto bom = machine::read_bill_of_materials(text, problem, diagnostics);
  if (!bom || options.hold_origin.empty()) return bom;
  const auto& lines = bom->lines;
  if (std::any_of(lines.begin(), lines.end(), [&](const BomLine& line) { return line.origin == options.hold_origin; }))
    return bom;
  diagnostics.error(fmt::format("--hold-origin: no line of {} has the origin {}",
                                text::printable(options.bom),
                                text::in_quotes(options.hold_origin)),
                    "the column 'origin' says 'paper', 'ours', ...");
  return std::nullopt;
}

report::MachineResult check(const Options& options,
                            const MachineInput& input,
                            const BillOfMaterials& bom,
                            text::Diagnostics& diagnostics) {
  report::MachineResult result = result_for(input);
  result.bom_file = options.bom;
  result.objectives = {input.problem.objective};
  const Stopwatch watch;
  evaluation::SearchOptions how = search_options(options, result.objectives);
  how.worksheets = !options.report.empty();
  how.tolerances = true;
  const StopSignal stop(options.memory_limit);
  how.stop = stop.stopped();
  evaluation::BomCheck outcome;
  {
    ProgressLine line(options.quiet, report::objective_unit(result.objectives.front(), input.problem.currency));
    if (line.active()) how.progress = [&line](const solver::Progress& progress) { line.show(progress); };
    const bool complete = options.complete || !options.hold_origin.empty();
    outcome = evaluation::check(input.problem, input.catalogue, bom, complete, how, options.hold_origin);
  }
  result.missing = missing_slots(outcome.empty_slots);
  if (!result.missing.empty()) return result;
  for (const evaluation::BomProblem& problem : outcome.problems)
    diagnostics.error(problem.where, problem.message, problem.hint);
  for (const evaluation::BomProblem& remark : outcome.remarks)
    diagnostics.warning(remark.where, remark.message, remark.hint);
  if (!outcome.problems.empty()) return result;
  result.completed = outcome.completed;
  result.completion = outcome.completion;
  result.certificate.incomplete = std::move(outcome.incomplete);
  std::vector<evaluation::Design> designs;
  designs.push_back(std::move(outcome.design));
  set_designs(result, input.problem, std::move(designs));
  note_idle_requirements(input.problem, *input.document, result.designs.front(), diagnostics);
  result.timing.solve = watch.seconds();
  return result;
}

/// No tolerance stated is none to break.
bool is_robust(const evaluation::Design& design) {
  using enum evaluation::ToleranceVerdict;
  const auto& check = design.tolerances;
  return check && (check->verdict == compliant || check->verdict == none_stated);
}

/// A build that complies does so whether or not something better could be chosen where the bill leaves nothing open.
bool was_ended(const report::MachineResult& result) {
  using enum evaluation::Completion;
  return result.completion == open || (result.completed && result.completion == compliant);
}

}  // namespace

int run_check(const Options& options) {
  const Stopwatch watch;
  text::Diagnostics diagnostics;
  const bool writable = outputs_are_writable(options, diagnostics);
  const auto input = read_machine(options, diagnostics);
  const auto text = text::SourceText::load(options.bom, diagnostics);
  const auto bom = input && text ? read_bom(options, input->problem, text, diagnostics) : std::nullopt;
  const auto lock = input && text ? verify_lock(options, *input, diagnostics, {text}) : std::nullopt;
  if (bom) {
    machine::refuse_excluded(*bom, input->steering.without, diagnostics);
    machine::note_unwanted_lines(*bom, options.hold_origin, input->problem, input->catalogue, diagnostics);
  }
  if (!bom || !writable || diagnostics.has_errors()) {
    print(diagnostics);
    return exit_bad_input;
  }
  const double read = watch.seconds();
  report::MachineResult result = check(options, *input, *bom, diagnostics);
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  if (wants_inventory(options)) result.catalogues = inventory_of(*input);
  if (lock && !result.designs.empty()) compare_with_lock(*lock, *input, result.designs.front());
  result.timing.read = read;
  result.timing.total = watch.seconds();
  // What was found is shown, and written elsewhere, even if one of the files could not be.
  bool written = result.designs.empty() || write_order(options, result.designs.front(), result.title);
  std::vector<const evaluation::Design*> designs;
  for (const evaluation::Design& design : result.designs) designs.push_back(&design);
  written = write_lock(options, *input, designs, {text}) && written;
  const bool satisfied = !result.designs.empty() && result.designs.front().satisfied() &&
                         (!options.robust || is_robust(result.designs.front()));
  const std::string json = report::check_json(result);
  const std::string page =
      options.report.empty()
          ? std::string()
          : report::machine_page(result, input->problem, report::PageKind::check, json, page_language(options));
  const bool delivered = deliver(options, report::check_text(result, output_style(options)), json, page);
  if (!delivered || !written) return exit_bad_input;
  if (result.designs.empty()) return exit_failed;
  if (was_ended(result) && (satisfied || result.completion == evaluation::Completion::open)) return exit_limit;
  return satisfied ? exit_done : exit_failed;
}

}  // namespace millwright::app
