// SPDX-License-Identifier: Apache-2.0
// solve with a value of the problem that goes over a range: the best build at each value.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>

#include "app/commands.h"
#include "app/lock.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/output_target.h"
#include "app/search_machine.h"
#include "evaluation/cycle_time.h"
#include "machine/setting_range.h"
#include "report/sweep.h"

namespace millwright::app {

namespace {

using machine::SettingRange;

/// What one build has and a range of them has not.
void refuse_single_outputs(const Options& options, text::Diagnostics& diagnostics) {
  const auto refuse = [&](const char* option) {
    diagnostics.error(fmt::format("{}: of a range there is no single build", option),
                      "give --set one value for that; a range has --csv, --json and --report");
  };
  if (!options.bom.empty()) refuse("--bom");
  if (!options.order.empty()) refuse("--order");
  if (options.builds > 1) refuse("--alternatives");
  if (!options.write_lock.empty()) refuse("--write-lock");
}

/// The range among the settings, and its place there. Reported: more than one.
std::optional<SettingRange> find_range(const Options& options, std::size_t& place, text::Diagnostics& diagnostics) {
  std::optional<SettingRange> range;
  std::size_t found = 0;
  for (std::size_t i = 0; i < options.settings.size(); ++i) {
    if (!machine::is_setting_range(options.settings[i])) continue;
    if (++found == 1) {
      place = i;
      range = machine::read_setting_range(options.settings[i], diagnostics);
    } else if (found == 2) {
      diagnostics.error(
          fmt::format("--set {}: only one value can go over a range", text::printable(options.settings[i])),
          "give the other one a single value, and start again for the next");
    }
  }
  return range;
}

/// Reads the problem at every value. The first value with which something is wrong is reported, and ends it.
std::list<MachineInput> read_all(const Options& options,
                                 std::size_t place,
                                 const SettingRange& range,
                                 text::Diagnostics& diagnostics) {
  std::list<MachineInput> inputs;
  for (const std::string& text : range.texts) {
    Options at = options;
    at.settings[place] = range.path + "=" + text;
    text::Diagnostics found;
    auto input = read_machine(at, found);
    if (inputs.empty() || found.has_errors())  // warnings of the catalogues once
      for (const text::Diagnostic& each : found.all()) diagnostics.add(each);
    if (!input) return inputs;
    // The value that goes over the range is in the table.
    input->steering.settings.erase(input->steering.settings.begin() + static_cast<std::ptrdiff_t>(place));
    inputs.push_back(std::move(*input));
  }
  return inputs;
}

class Sweeper {
 public:
  Sweeper(const Options& options, const SettingRange& range) : options_(options), range_(range) {
    options_.report.clear();  // no worksheets
  }

  /// Nothing, after complaints, if what is fixed cannot be.
  std::optional<report::Sweep> solve(const std::list<MachineInput>& inputs, text::Diagnostics& diagnostics) {
    report::Sweep sweep;
    sweep.path = range_.path;
    sweep.unit = range_.unit;
    const machine::Problem& problem = inputs.front().problem;
    const machine::Objective objective = machine::objective_named(objectives_of(options_, inputs.front()).front());
    for (const machine::QuantityDeclaration& each : machine::quantities())
      if (problem.limits[each.quantity] || objective.counts(each.quantity)) sweep.counted.push_back(each.quantity);
    ProgressLine line(options_.quiet, objective_unit_of(options_, inputs.front()));
    for (const MachineInput& input : inputs) {
      const std::size_t i = sweep.points.size();
      report::SweepPoint point;
      point.value = range_.values[i];
      point.text = range_.texts[i];
      point.cycle_time = std::numeric_limits<double>::quiet_NaN();
      line.begin_with(fmt::format("{}/{} ", i + 1, inputs.size()));
      if (!solve_point(input, inputs.size() - i, line, point, diagnostics)) return std::nullopt;
      sweep.points.push_back(std::move(point));
    }
    sweep.timing.solve = watch_.seconds();
    return sweep;
  }

 private:
  /// With its share of the time that is left.
  bool solve_point(const MachineInput& input,
                   std::size_t points_left,
                   ProgressLine& line,
                   report::SweepPoint& point,
                   text::Diagnostics& diagnostics) {
    const evaluation::MachineModel model(
        input.problem,
        input.catalogue,
        evaluation::GivenSlots{},
        evaluation::ModelOptions{.fixed = input.steering.fixed, .objectives = objectives_of(options_, input)});
    for (const evaluation::BomProblem& problem : model.problems())
      diagnostics.error(problem.where, problem.message, problem.hint);
    if (diagnostics.has_errors()) return false;
    Options at = options_;
    at.time_limit = (options_.time_limit - watch_.seconds()) / static_cast<double>(points_left);
    point.solved = !stop_.stopped()->load() && at.time_limit > 0.0;
    if (!point.solved) {
      point.result = result_for(input);
      point.result.objectives = objectives_of(options_, input);
      point.result.status = report::Status::limit;
      return true;
    }
    point.result = search_machine(at, input, model, stop_, line);
    if (const auto* design = point.design()) point.cycle_time = evaluation::cycle_time(input.problem, *design);
    return true;
  }

  Options options_;
  const SettingRange& range_;
  StopSignal stop_{options_.memory_limit};
  Stopwatch watch_;
};

int exit_code_of(const report::Sweep& sweep) {
  const auto& points = sweep.points;
  if (!std::all_of(points.begin(), points.end(), [](const auto& point) { return point.proved(); })) return exit_limit;
  const bool any =
      std::any_of(points.begin(), points.end(), [](const auto& point) { return point.design() != nullptr; });
  return any ? exit_done : exit_failed;
}

}  // namespace

bool has_range(const Options& options) {
  return std::any_of(options.settings.begin(), options.settings.end(), machine::is_setting_range);
}

int run_sweep(const Options& options) {
  const Stopwatch watch;
  text::Diagnostics diagnostics;
  refuse_single_outputs(options, diagnostics);
  outputs_are_writable(options, diagnostics);
  std::size_t place = 0;
  const auto range = find_range(options, place, diagnostics);
  std::list<MachineInput> inputs;
  if (range && !diagnostics.has_errors()) inputs = read_all(options, place, *range, diagnostics);
  if (!inputs.empty() && !diagnostics.has_errors()) verify_lock(options, inputs.front(), diagnostics);
  print(diagnostics);
  if (diagnostics.has_errors() || inputs.empty()) return exit_bad_input;
  const double read = watch.seconds();
  text::Diagnostics unfit;
  auto sweep = Sweeper(options, *range).solve(inputs, unfit);
  print(unfit);
  if (!sweep) return exit_bad_input;
  sweep->timing.read = read;
  sweep->timing.total = watch.seconds();
  text::Diagnostics failures;
  const bool written =
      options.csv.empty() ||
      write_target({options.csv, OutputKind::edited, options.force}, report::sweep_csv(*sweep), failures);
  print(failures);
  const std::string json = report::sweep_json(*sweep);
  const std::string page =
      options.report.empty() ? std::string() : report::sweep_page(*sweep, json, page_language(options));
  const bool delivered = deliver(options, report::sweep_text(*sweep, output_style(options)), json, page);
  return delivered && written ? exit_code_of(*sweep) : exit_bad_input;
}

}  // namespace millwright::app
