// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.h"
#include "app/lock.h"
#include "app/machine_input.h"
#include "app/machine_result.h"
#include "app/output.h"
#include "app/search_watch.h"
#include "machine/bill_of_materials.h"
#include "machine/objective.h"
#include "report/comparison.h"
#include "report/recorded_build.h"

namespace millwright::app {

namespace {

using report::ComparedBuild;
using text::Diagnostics;
using text::SourceText;

/// One word of the command line: a result begins with a brace, everything else is taken for a bill of materials.
struct Side {
  std::string file;
  std::shared_ptr<const SourceText> text;
  bool is_result = false;
  std::optional<report::RecordedBuild> recorded;
};

/// A result has some hundred kilobytes; read, it takes ten times as much memory.
constexpr std::uintmax_t largest_side = std::uintmax_t{8} << 20U;

Side read_side(const std::string& file, Diagnostics& diagnostics) {
  Side side;
  side.file = file;
  side.text = SourceText::load(file, diagnostics, largest_side);
  if (!side.text) return side;
  const std::string_view contents = side.text->contents();
  const std::size_t first = contents.find_first_not_of(" \t\r\n");
  side.is_result = first == std::string_view::npos ? file.ends_with(".json") : contents[first] == '{';
  if (side.is_result) side.recorded = report::read_recorded_build(side.text, diagnostics);
  return side;
}

/// The problem of the bill of materials: as asked for, or what the result on the other side names, seen from here or
/// from the folder of the result. Empty, with a complaint, if there is none.
std::string problem_for(const Options& options, const Side& bom, const Side& other, Diagnostics& diagnostics) {
  if (!options.problem.empty()) return options.problem;
  if (other.is_result && !other.recorded) return {};  // reported already
  const std::string hint = "name it: --problem FILE.toml";
  if (!other.recorded) {
    diagnostics.error(text::whole(bom.text), "which problem this bill of materials is for is not said", hint);
    return {};
  }
  namespace fs = std::filesystem;
  const fs::path named = other.recorded->problem_file;
  for (const fs::path& place : {named, fs::path(other.file).parent_path() / named}) {
    std::error_code failure;
    if (fs::is_regular_file(place, failure)) return place.string();
  }
  diagnostics.error(text::whole(other.text),
                    fmt::format("the problem that this result names is not there: {}", text::in_quotes(named.string())),
                    hint);
  return {};
}

/// Everything that can be counted is, so that more can be compared.
void count_all(machine::Problem& problem) {
  problem.counted.clear();
  for (const machine::QuantityDeclaration& each : machine::quantities())
    if (each.quantity != machine::Quantity::cost && each.quantity != machine::Quantity::mass &&
        !machine::uncountable(problem, each.quantity))
      problem.counted.push_back(each.quantity);
}

ComparedBuild recorded_build(Side&& side) {
  report::RecordedBuild& recorded = *side.recorded;
  ComparedBuild build;
  build.file = side.file;
  build.origin = fmt::format("as recorded by {} of {}", recorded.command, text::printable(recorded.problem_file));
  if (!recorded.bom_file.empty()) build.origin += " with " + text::printable(recorded.bom_file);
  if (!recorded.asked.empty()) {
    std::vector<std::string> words;
    for (const std::string& each : recorded.asked) words.push_back(text::printable(each));
    build.origin += fmt::format(", asked for beside it: {}", fmt::join(words, "; "));
  }
  if (!recorded.proved) build.origin += ", not proved best";
  build.title = text::printable(recorded.title.empty() ? recorded.problem_file : recorded.title);
  build.axes = std::move(recorded.axes);
  build.design = std::move(recorded.design);
  return build;
}

std::optional<ComparedBuild> evaluated_build(const Options& options,
                                             const Side& side,
                                             const MachineInput& input,
                                             Diagnostics& diagnostics) {
  const auto bom = machine::read_bill_of_materials(side.text, input.problem, diagnostics);
  if (!bom) return std::nullopt;
  const StopSignal stop(options.memory_limit);
  evaluation::SearchOptions how = search_options(options, {"cost"});
  how.stop = stop.stopped();
  evaluation::BomCheck outcome = evaluation::check(input.problem, input.catalogue, *bom, options.complete, how);
  for (const evaluation::BomProblem& problem : outcome.problems)
    diagnostics.error(problem.where, problem.message, problem.hint);
  for (const evaluation::BomProblem& remark : outcome.remarks)
    diagnostics.warning(remark.where, remark.message, remark.hint);
  if (!outcome.problems.empty()) return std::nullopt;
  ComparedBuild build;
  build.file = side.file;
  build.origin = "a bill of materials, evaluated now with " + text::printable(input.problem.file);
  if (outcome.completed) build.origin += ", completed by us";
  if (outcome.completed && outcome.completion == evaluation::Completion::compliant) build.origin += ", not proved best";
  if (outcome.completion == evaluation::Completion::open)
    build.origin += "; the search was ended before it was known whether it can comply";
  build.title = input.problem.title.empty() ? input.problem.file : input.problem.title;
  for (const machine::Axis& axis : input.problem.axes) build.axes.push_back(axis.name);
  build.design = std::move(outcome.design);
  shorten_places(build.design);
  return build;
}

/// What is asked of the evaluation, where nothing is evaluated.
void refuse_needless(const Options& options, Diagnostics& diagnostics) {
  const std::pair<const char*, bool> given[] = {{"--problem", !options.problem.empty()},
                                                {"--set", !options.settings.empty()},
                                                {"--catalogue", !options.catalogues.empty()},
                                                {"--complete", options.complete},
                                                {"--locked", !options.locked.empty()},
                                                {"--write-lock", !options.write_lock.empty()}};
  for (const auto& [name, used] : given)
    if (used)
      diagnostics.error(fmt::format("{}: both are results, whose figures are shown as they were recorded", name),
                        "leave it out, or compare a bill of materials ('solve --bom' writes one)");
}

/// Axes of both, or nothing is to be compared.
void refuse_other_machine(const ComparedBuild& a, const ComparedBuild& b, Diagnostics& diagnostics) {
  const auto sorted = [](std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return names;
  };
  const auto list = [](const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); };
  if (sorted(a.axes) != sorted(b.axes))
    diagnostics.error(fmt::format("{} and {} are of different machines: axes {} against {}",
                                  text::printable(a.file),
                                  text::printable(b.file),
                                  text::printable(list(a.axes)),
                                  text::printable(list(b.axes))),
                      "compare builds of one machine");
  if (a.design.currency != b.design.currency)
    diagnostics.error(fmt::format("{} is priced in {}, {} in {}",
                                  text::printable(a.file),
                                  text::printable(a.design.currency),
                                  text::printable(b.file),
                                  text::printable(b.design.currency)),
                      "compare builds priced in one currency");
}

BomTexts bom_texts(const Side (&sides)[2]) {
  BomTexts texts;
  for (const Side& side : sides)
    if (side.text && !side.is_result) texts.push_back(side.text);
  return texts;
}

/// Writes the lock of the builds that were evaluated now.
bool lock_evaluated(const Options& options,
                    const std::optional<MachineInput>& input,
                    const Side (&sides)[2],
                    const std::vector<ComparedBuild>& builds,
                    const BomTexts& boms) {
  if (!input) return true;
  std::vector<const evaluation::Design*> designs;
  for (std::size_t i = 0; i < 2; ++i)
    if (!sides[i].is_result) designs.push_back(&builds[i].design);
  return write_lock(options, *input, designs, boms);
}

}  // namespace

int run_compare(const Options& options) {
  Diagnostics diagnostics;
  const bool writable = outputs_are_writable(options, diagnostics);
  Side sides[] = {read_side(options.first, diagnostics), read_side(options.second, diagnostics)};
  if (sides[0].is_result && sides[1].is_result) refuse_needless(options, diagnostics);
  std::string problem;
  for (std::size_t i = 0; i < 2 && problem.empty(); ++i)
    if (sides[i].text && !sides[i].is_result && sides[1 - i].text)
      problem = problem_for(options, sides[i], sides[1 - i], diagnostics);
  std::optional<MachineInput> input;
  const BomTexts boms = bom_texts(sides);
  if (!problem.empty()) {
    Options with_problem = options;
    with_problem.problem = problem;
    input = read_machine(with_problem, diagnostics);
    if (input) count_all(input->problem);
    if (input) verify_lock(options, *input, diagnostics, boms);
  }
  std::vector<ComparedBuild> builds;
  for (Side& side : sides) {
    if (side.recorded) {
      builds.push_back(recorded_build(std::move(side)));
    } else if (side.text && !side.is_result && input) {
      if (auto build = evaluated_build(options, side, *input, diagnostics)) builds.push_back(std::move(*build));
    }
  }
  if (builds.size() == 2) refuse_other_machine(builds[0], builds[1], diagnostics);
  print(diagnostics);
  if (!writable || builds.size() < 2 || diagnostics.has_errors()) return exit_bad_input;
  const bool delivered = deliver(options,
                                 report::comparison_text(builds[0], builds[1], output_style(options)),
                                 report::comparison_json(builds[0], builds[1]));
  if (!delivered || !lock_evaluated(options, input, sides, builds, boms)) return exit_bad_input;
  return report::failed_checks(builds[0].design) + report::failed_checks(builds[1].design) > 0 ? exit_failed
                                                                                               : exit_done;
}

}  // namespace millwright::app
