// SPDX-License-Identifier: Apache-2.0
#include "evaluation/unmet_checks.h"

#include <algorithm>
#include <optional>

#include "evaluation/machine_stages.h"
#include "solver/least_utilisations.h"
#include "solver/table_memory.h"

namespace millwright::evaluation {

using scalar::Interval;
using solver::LeastUtilisation;
using solver::Row;

namespace {

/// Declarations of the constraints that the search holds, in the order of a stage's utilisations.
std::vector<machine::Declaration> searched(const StageEntry& entry, const machine::Problem& problem) {
  const machine::Requirements* require = &problem.require;
  for (const machine::Axis& axis : problem.axes)
    if (axis.name == entry.axis) require = &axis.require;
  std::vector<machine::Declaration> result;
  std::visit(
      [&](const auto& stage) {
        using Kind = std::remove_cvref_t<decltype(*stage)>;
        auto collect = [&](const machine::Declaration& declaration, auto&&, auto&&, auto&&) {
          if (machine::is_searched(declaration, *require)) result.push_back(declaration);
        };
        constraints_of<Kind>()(collect);
      },
      entry.stage);
  return result;
}

/// Of every stage and every constraint with one supply voltage (and all shops), over every state that can arrive;
/// nothing where some slot has no row to choose. Constraints that `worst` has at 1 or less need not be looked at.
std::optional<std::vector<std::vector<LeastUtilisation>>> least_with(
    const MachineModel& model,
    Row voltage,
    const std::vector<std::vector<LeastUtilisation>>& worst,
    solver::TableMemory& tables,
    solver::Desk& desk) {
  std::vector<Row> shared{voltage};
  for (std::size_t i = 1; i < model.problem().shared.size(); ++i) shared.push_back(model.problem().shared[i].rows - 1);
  if (!solver::all_offered(model.problem(), shared)) return std::nullopt;
  std::vector<Interval> state;
  for (const double x : model.problem().first_state) state.emplace_back(x);
  std::vector<std::vector<LeastUtilisation>> result;
  for (std::size_t i = 0; i < model.problem().stages.size(); ++i) {
    const solver::Stage& stage = *model.problem().stages[i];
    std::vector<bool> asked(stage.constraints(), true);
    for (std::size_t c = 0; !worst.empty() && c < asked.size(); ++c) asked[c] = worst[i][c].value > 1.0;
    const solver::Region whole = tables.whole_region(stage, shared);
    result.push_back(solver::least_utilisations(stage, shared, state, whole, asked, desk));
    state = desk.bound(stage, shared, state, whole).handed_on;
  }
  return result;
}

/// The part of a slot that comes nearest; nothing of a slot without parts to choose from.
void name_nearest(const MachineModel& model, std::size_t stage, const LeastUtilisation& least, UnmetCheck& check) {
  if (!least.slot) return;
  const Candidate& candidate = model.candidate(stage, *least.slot, least.row);
  if (candidate.parts.empty()) return;
  const PartUse& part = candidate.parts.front();
  if (!part.is_named()) return;
  check.slot = part.slot;
  const catalogue::Table& table = model.catalogue().table(part.family);
  const std::string maker(part.stated.empty() ? table.manufacturer(part.row) : std::string_view());
  const std::string number(part.stated.empty() ? table.part_number(part.row) : part.stated);
  check.nearest = maker.empty() ? number : maker + " " + number;
}

}  // namespace

std::vector<UnmetCheck> unmet_checks(const MachineModel& model, const std::function<bool()>& interrupt) try {
  std::vector<std::vector<LeastUtilisation>> least;
  solver::TableMemory tables;
  solver::Desk desk;
  desk.interrupt = interrupt;
  for (Row voltage = 0; voltage < model.machine().supply_voltages.size(); ++voltage) {
    auto with = least_with(model, voltage, least, tables, desk);
    if (!with) continue;
    if (least.empty()) least = *with;
    for (std::size_t i = 0; i < least.size(); ++i)
      for (std::size_t k = 0; k < least[i].size(); ++k)
        if ((*with)[i][k].value < least[i][k].value) least[i][k] = (*with)[i][k];
  }
  std::vector<UnmetCheck> result;
  for (std::size_t i = 0; i < least.size(); ++i) {
    const StageEntry& entry = model.entries()[i];
    const std::vector<machine::Declaration> declarations = searched(entry, model.machine());
    // What is said of shops beside is no check.
    for (std::size_t k = 0; k < std::min(least[i].size(), declarations.size()); ++k)
      if (least[i][k].value > 1.0) {
        result.push_back({entry.axis,
                          entry.element,
                          std::string(declarations[k].id),
                          std::string(declarations[k].title),
                          std::string(declarations[k].requirement),
                          std::string(declarations[k].source),
                          least[i][k].value,
                          {},
                          {}});
        name_nearest(model, i, least[i][k], result.back());
      }
  }
  return result;
} catch (const solver::OutOfTime&) {
  return {};
}

}  // namespace millwright::evaluation
