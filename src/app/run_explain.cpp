// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/commands.h"
#include "app/lock.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/search_machine.h"
#include "evaluation/explanation.h"
#include "evaluation/incomplete_parts.h"
#include "report/explanation_text.h"

namespace millwright::app {

namespace {

/// A line on standard error that is written over, with what is being solved; silent unless that is a terminal.
class TrialsLine {
 public:
  explicit TrialsLine(bool quiet) : active_(!quiet && isatty(STDERR_FILENO) != 0) {}
  ~TrialsLine() {
    if (shown_) fmt::print(stderr, "\r\x1B[K");
    std::fflush(stderr);
  }
  TrialsLine(const TrialsLine&) = delete;
  TrialsLine& operator=(const TrialsLine&) = delete;

  void show(std::size_t solves, const std::string& what) {
    if (!active_) return;
    shown_ = true;
    fmt::print(stderr, "\r\x1B[K{} solved; {}", solves, text::printable(what, 60));
    std::fflush(stderr);
  }

 private:
  bool active_;
  bool shown_ = false;
};

}  // namespace

int run_explain(const Options& options) {
  text::Diagnostics diagnostics;
  const bool writable = outputs_are_writable(options, diagnostics);
  const auto input = read_machine(options, diagnostics);
  std::vector<evaluation::IncompleteParts> incomplete;
  if (input) {
    const evaluation::MachineModel model(input->problem, input->catalogue, {}, {.fixed = input->steering.fixed});
    for (const evaluation::BomProblem& problem : model.problems())
      diagnostics.error(problem.where, problem.message, problem.hint);
    incomplete = evaluation::incomplete_parts(model);
  }
  if (input) verify_lock(options, *input, diagnostics);
  print(diagnostics);
  if (!input || !writable || diagnostics.has_errors()) return exit_bad_input;
  const machine::Asked asked{input->problem, input->steering.fixed, input->steering.without, input->steering.limits};
  const catalogue::Catalogue& parts = input->whole_catalogue ? *input->whole_catalogue : input->catalogue;
  evaluation::SearchOptions how = search_options(options, objectives_of(options, *input));
  evaluation::Explanation explanation;
  {
    const StopSignal stop(options.memory_limit);
    how.stop = stop.stopped();
    TrialsLine line(options.quiet);
    explanation = evaluation::explain(asked,
                                      parts,
                                      machine::conditions_of(asked, *input->document, parts),
                                      how,
                                      [&](std::size_t solves, const std::string& what) { line.show(solves, what); });
  }
  report::MachineResult result = result_for(*input);
  result.certificate.incomplete = std::move(incomplete);
  if (wants_inventory(options)) result.catalogues = inventory_of(*input);
  std::vector<const evaluation::Design*> designs;
  if (explanation.design) designs.push_back(&*explanation.design);
  if (!write_lock(options, *input, designs)) return exit_bad_input;
  const bool delivered = deliver(options,
                                 report::explanation_text(result, explanation, output_style(options)),
                                 report::explanation_json(result, explanation));
  if (!delivered) return exit_bad_input;
  if (explanation.status == solver::Status::limit) return exit_limit;
  return explanation.design ? exit_done : exit_failed;
}

}  // namespace millwright::app
