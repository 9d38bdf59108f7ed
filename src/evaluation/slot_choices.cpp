// SPDX-License-Identifier: Apache-2.0
#include "evaluation/slot_choices.h"

#include <fmt/format.h>

#include <algorithm>

#include "evaluation/machine_stages.h"
#include "scalar/unit.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

namespace {

using solver::Row;

bool has(const Candidate& candidate, const PartUse& part) {
  return std::any_of(candidate.parts.begin(), candidate.parts.end(), [&](const PartUse& other) {
    return other.slot == part.slot && other.family == part.family && other.row == part.row &&
           other.stated == part.stated;
  });
}

std::string name_of(const Design& design, const std::string& axis, const std::string& slot) {
  for (const PartLine& part : design.parts)
    if (part.axis == axis && part.slot == slot)
      return part.manufacturer.empty() ? part.part_number : part.manufacturer + " " + part.part_number;
  return {};
}

class Choices {
 public:
  Choices(ConditionTrials& trials, Explanation& result)
      : trials_(trials),
        result_(result),
        objective_(machine::objective_named(result.objective)),
        model_(problem_of(trials, result),
               trials.catalogue_for(trials.asked()),
               {},
               {.fixed = trials.asked().fixed, .every_candidate = true}) {}

  void find() {
    const SearchOptions options = trials_.begin("which choices are free");
    solver::Restriction all = solver::unrestricted(model_.problem());
    thin(all);
    const solver::RestrictedProblem problem(model_.problem(), all);
    const solver::Summary summary = solver::solve(problem.problem(), solver_options(model_, options));
    if (summary.status != solver::Status::optimal) throw TimeIsUp{};
    best_ = problem.whole_build(summary.builds.front());
    design_ = model_.design(best_);
    for (std::size_t stage = 0; stage < model_.entries().size(); ++stage)
      for (std::size_t slot = 0; slot < model_.entries()[stage].tables().size(); ++slot) look_at(stage, slot);
    look_at_voltage();
  }

 private:
  static machine::Problem problem_of(const ConditionTrials& trials, const Explanation& result) {
    machine::Problem problem = trials.asked().problem;
    problem.counted = machine::counted_quantities({result.objective});
    return problem;
  }

  /// Without the rows that another one which is left covers: the best build needs none of them, and the search is
  /// spared them.
  void thin(solver::Restriction& left) const {
    for (std::size_t stage = 0; stage < left.stages.size(); ++stage)
      for (std::size_t slot = 0; slot < left.stages[stage].allowed.size(); ++slot) {
        std::vector<Row>& allowed = left.stages[stage].allowed[slot];
        const auto covered_by = [&](Row row) { return model_.covering_rows(stage, slot, row); };
        const auto is_left = [&](Row row) { return std::binary_search(allowed.begin(), allowed.end(), row); };
        // Of rows that cover each other the first stays.
        const auto counts = [&](Row by, Row row) {
          if (!is_left(by)) return false;
          const std::vector<Row> back = covered_by(by);
          return by < row || std::find(back.begin(), back.end(), row) == back.end();
        };
        std::vector<Row> needed;
        for (const Row row : allowed) {
          const std::vector<Row> by = covered_by(row);
          if (std::none_of(by.begin(), by.end(), [&](Row each) { return counts(each, row); })) needed.push_back(row);
        }
        allowed = std::move(needed);
      }
  }

  /// Finds out what the best build of what is left is.
  void judge(SlotChoice& choice, solver::Restriction left, const std::string& what) {
    const SearchOptions options = trials_.begin(what, false);
    thin(left);
    const solver::RestrictedProblem restricted(model_.problem(), left);
    const solver::Summary summary = solver::solve(restricted.problem(), solver_options(model_, options));
    const double base = design_.total(objective_);
    if (summary.status == solver::Status::limit) {
      trials_.check_time();
      choice.settled = false;
      choice.next_best = std::max(0.0, summary.lower_bound - base);
      return;
    }
    if (summary.builds.empty()) return;
    const Design next = model_.design(restricted.whole_build(summary.builds.front()));
    choice.next_best = std::max(0.0, next.total(objective_) - base);
    choice.instead =
        choice.slot == "supply_voltage" ? volts(next.supply_voltage) : name_of(next, choice.axis, choice.slot);
  }

  /// A row of a table may be several parts: a motor with its driver.
  void look_at(std::size_t stage, std::size_t slot) {
    const Candidate& chosen = model_.candidate(stage, slot, best_.stages[stage].rows[slot]);
    for (const PartUse& part : chosen.parts) look_at(stage, slot, part);
  }

  void look_at(std::size_t stage, std::size_t slot, const PartUse& part) {
    SlotChoice choice;
    choice.axis = model_.entries()[stage].axis;
    choice.slot = part.slot;
    choice.part = name_of(design_, choice.axis, choice.slot);
    if (choice.part.empty() || !part.is_named()) return;  // the only one, as the problem states it
    solver::Restriction left = solver::unrestricted(model_.problem());
    std::vector<Row>& allowed = left.stages[stage].allowed[slot];
    std::erase_if(allowed, [&](Row row) { return has(model_.candidate(stage, slot, row), part); });
    choice.only = allowed.empty();
    if (!choice.only) judge(choice, std::move(left), fmt::format("another {}.{}", choice.axis, choice.slot));
    result_.choices.push_back(std::move(choice));
  }

  static std::string volts(double value) { return scalar::format(value, scalar::Unit::of("V")); }

  void look_at_voltage() {
    const std::size_t count = model_.machine().supply_voltages.size();
    if (count < 2) return;
    solver::Restriction left = solver::unrestricted(model_.problem());
    std::erase(left.shared.front(), best_.shared.front());
    SlotChoice choice;
    choice.axis = "machine";
    choice.slot = "supply_voltage";
    choice.part = volts(design_.supply_voltage);
    judge(choice, std::move(left), "another supply voltage");
    result_.choices.push_back(std::move(choice));
  }

  ConditionTrials& trials_;
  Explanation& result_;
  machine::Objective objective_;
  MachineModel model_;
  solver::Build best_;
  Design design_;
};

}  // namespace

void find_choices(ConditionTrials& trials, Explanation& result) { Choices(trials, result).find(); }

}  // namespace millwright::evaluation
