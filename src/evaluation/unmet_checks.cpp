// SPDX-License-Identifier: Apache-2.0
#include "evaluation/unmet_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "evaluation/machine_stages.h"

namespace millwright::evaluation {

using scalar::Interval;
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

/// Below which a utilisation does not come, and the row that comes nearest in the slot that says so.
struct Least {
  double utilisation = 0.0;
  std::optional<std::size_t> slot;
  Row row = 0;
};

/// All that one stage can be, with one supply voltage (and all shops) and every state that can reach it.
class StageBounds {
 public:
  StageBounds(const solver::Stage& stage, std::vector<Row> shared, const std::vector<Interval>& inherited)
      : stage_(stage), shared_(std::move(shared)), inherited_(inherited) {
    for (const solver::Slot& slot : stage.slots()) {
      all_.emplace_back(slot.rows);
      std::iota(all_.back().begin(), all_.back().end(), Row{0});
    }
    for (const std::vector<Row>& rows : all_) alive_.emplace_back(rows);
    for (const solver::Variable& variable : stage.variables()) variables_.emplace_back(variable.lower, variable.upper);
    stage.bound(box(), whole_);
  }

  [[nodiscard]] const std::vector<Interval>& handed_on() const { return whole_.handed_on; }

  /// Below which no utilisation comes: of all rows together, or of every row of the slot that says most.
  [[nodiscard]] std::vector<Least> least() {
    std::vector<Least> result;
    for (const Interval& u : whole_.utilisation) result.push_back({known(u.lower), std::nullopt, 0});
    solver::Answer<Interval> answer;
    for (std::size_t slot = 0; slot < all_.size(); ++slot) {
      std::vector<Least> of_slot(result.size(), {scalar::rounding::infinity, slot, 0});
      for (const Row& row : all_[slot]) {
        alive_[slot] = std::span<const Row>(&row, 1);
        stage_.bound(box(), answer);
        for (std::size_t i = 0; i < of_slot.size(); ++i)
          if (const double u = known(answer.utilisation[i].lower); u < of_slot[i].utilisation)
            of_slot[i] = {u, slot, row};
      }
      alive_[slot] = all_[slot];
      for (std::size_t i = 0; i < result.size(); ++i)
        if (of_slot[i].utilisation > result[i].utilisation) result[i] = of_slot[i];
    }
    return result;
  }

 private:
  /// What is not a number proves nothing.
  static double known(double lower) { return std::isnan(lower) ? 0.0 : lower; }
  [[nodiscard]] solver::Box box() const { return {shared_, inherited_, alive_, variables_}; }

  const solver::Stage& stage_;
  std::vector<Row> shared_;
  std::vector<Interval> inherited_;
  std::vector<std::vector<Row>> all_;
  std::vector<solver::RowsAlive> alive_;
  std::vector<Interval> variables_;
  solver::Answer<Interval> whole_;
};

/// The least utilisations of every stage with one supply voltage.
std::vector<std::vector<Least>> least_with(const MachineModel& model, Row voltage) {
  std::vector<Interval> state;
  for (const double x : model.problem().first_state) state.emplace_back(x);
  std::vector<Row> shared{voltage};
  for (std::size_t i = 1; i < model.problem().shared.size(); ++i) shared.push_back(model.problem().shared[i].rows - 1);
  std::vector<std::vector<Least>> result;
  for (const solver::Stage* stage : model.problem().stages) {
    StageBounds bounds(*stage, shared, state);
    result.push_back(bounds.least());
    state = bounds.handed_on();
  }
  return result;
}

/// The part of a slot that comes nearest; nothing of a slot without parts to choose from.
void name_nearest(const MachineModel& model, std::size_t stage, const Least& least, UnmetCheck& check) {
  if (!least.slot) return;
  const Candidate& candidate = model.candidate(stage, *least.slot, least.row);
  if (candidate.parts.empty()) return;
  const PartUse& part = candidate.parts.front();
  if (!part.is_named()) return;
  check.slot = part.slot;
  const catalogue::Table& table = model.catalogue().table(part.family);
  const std::string maker(part.stated.empty() ? table.manufacturer(part.row) : std::string_view());
  const std::string number(part.stated.empty() ? std::string(table.part_number(part.row)) : part.stated);
  check.nearest = maker.empty() ? number : maker + " " + number;
}

}  // namespace

std::vector<UnmetCheck> unmet_checks(const MachineModel& model) {
  std::vector<std::vector<Least>> least;
  for (Row voltage = 0; voltage < model.machine().supply_voltages.size(); ++voltage) {
    std::vector<std::vector<Least>> with = least_with(model, voltage);
    if (least.empty()) least = with;
    for (std::size_t i = 0; i < least.size(); ++i)
      for (std::size_t k = 0; k < least[i].size(); ++k)
        if (with[i][k].utilisation < least[i][k].utilisation) least[i][k] = with[i][k];
  }
  std::vector<UnmetCheck> result;
  for (std::size_t i = 0; i < least.size(); ++i) {
    const StageEntry& entry = model.entries()[i];
    const std::vector<machine::Declaration> declarations = searched(entry, model.machine());
    // What is said of shops beside is no check.
    for (std::size_t k = 0; k < std::min(least[i].size(), declarations.size()); ++k)
      if (least[i][k].utilisation > 1.0) {
        result.push_back({entry.axis,
                          entry.element,
                          std::string(declarations[k].id),
                          std::string(declarations[k].title),
                          std::string(declarations[k].requirement),
                          std::string(declarations[k].source),
                          least[i][k].utilisation,
                          {},
                          {}});
        name_nearest(model, i, least[i][k], result.back());
      }
  }
  return result;
}

}  // namespace millwright::evaluation
