// SPDX-License-Identifier: Apache-2.0
#include "evaluation/slot_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

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

/// Without the rows that another one which is left covers: the best build needs none of them, and the search is spared
/// them.
void thin(const MachineModel& model, solver::Restriction& left) {
  for (std::size_t stage = 0; stage < left.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < left.stages[stage].allowed.size(); ++slot) {
      std::vector<Row>& allowed = left.stages[stage].allowed[slot];
      const auto covered_by = [&](Row row) { return model.covering_rows(stage, slot, row); };
      // Of rows that cover each other the first stays.
      const auto counts = [&](Row by, Row row) {
        if (!std::binary_search(allowed.begin(), allowed.end(), by)) return false;
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

class Choices {
 public:
  Choices(ConditionTrials& trials, Explanation& result)
      : trials_(trials),
        result_(result),
        objective_(machine::objective_named(result.objective)),
        problem_(trials.asked().problem) {
    problem_.counted = machine::counted_quantities({result.objective});
    model_.emplace(
        problem_, trials.catalogue_for(trials.asked()), GivenSlots{}, ModelOptions{.fixed = trials.asked().fixed});
  }

  void find() {
    const SearchOptions options = trials_.begin("which choices are free");
    const solver::Summary summary = solver::solve(model_->problem(), solver_options(*model_, options));
    if (summary.status != solver::Status::optimal) throw TimeIsUp{};
    const solver::Build& best = summary.builds.front();
    design_ = model_->design(best);
    for (std::size_t stage = 0; stage < model_->entries().size(); ++stage)
      for (std::size_t slot = 0; slot < model_->entries()[stage].tables().size(); ++slot)
        // A row of a table may be several parts: a motor with its driver.
        for (const PartUse& part : model_->candidate(stage, slot, best.stages[stage].rows[slot]).parts)
          look_at(stage, slot, part);
    look_at_voltage(best);
  }

 private:
  /// With the drivers too that the model leaves out because another one is never worse: without that one they count.
  const MachineModel& model_of_drivers() {
    if (!with_covered_)
      with_covered_.emplace(problem_,
                            trials_.catalogue_for(trials_.asked()),
                            GivenSlots{},
                            ModelOptions{.fixed = trials_.asked().fixed, .every_candidate = true});
    return *with_covered_;
  }

  /// Finds out what the best build of what is left is.
  void judge(SlotChoice& choice, const MachineModel& model, const solver::Restriction& left, const std::string& what) {
    const SearchOptions options = trials_.begin(what, false);
    const solver::RestrictedProblem restricted(model.problem(), left);
    const solver::Summary summary = solver::solve(restricted.problem(), solver_options(model, options));
    const double base = design_.total(objective_);
    const bool settled = summary.status != solver::Status::limit;
    if (!settled) trials_.check_time();
    choice.settled = settled;
    if (!settled) choice.next_best = std::max(0.0, summary.lower_bound - base);
    if (summary.builds.empty()) return;
    const Design next = model.design(restricted.whole_build(summary.builds.front()));
    choice.at_most = std::max(0.0, next.total(objective_) - base);
    if (settled) choice.next_best = choice.at_most;
    choice.instead =
        choice.slot == "supply_voltage" ? volts(next.supply_voltage) : name_of(next, choice.axis, choice.slot);
  }

  void look_at(std::size_t stage, std::size_t slot, const PartUse& part) {
    SlotChoice choice;
    choice.axis = model_->entries()[stage].axis;
    choice.slot = part.slot;
    choice.part = name_of(design_, choice.axis, choice.slot);
    if (choice.part.empty() || !part.is_named()) return;  // the only one, as the problem states it
    const bool driver = part.slot == "driver";
    const MachineModel& model = driver ? model_of_drivers() : *model_;
    solver::Restriction left = solver::unrestricted(model.problem());
    std::vector<Row>& allowed = left.stages[stage].allowed[slot];
    std::erase_if(allowed, [&](Row row) { return has(model.candidate(stage, slot, row), part); });
    choice.only = allowed.empty();
    if (driver) thin(model, left);
    if (!choice.only) judge(choice, model, left, fmt::format("another {}.{}", choice.axis, choice.slot));
    result_.choices.push_back(std::move(choice));
  }

  static std::string volts(double value) { return scalar::format(value, scalar::Unit::of("V")); }

  void look_at_voltage(const solver::Build& best) {
    if (model_->machine().supply_voltages.size() < 2) return;
    solver::Restriction left = solver::unrestricted(model_->problem());
    std::erase(left.shared.front(), best.shared.front());
    SlotChoice choice;
    choice.axis = "machine";
    choice.slot = "supply_voltage";
    choice.part = volts(design_.supply_voltage);
    judge(choice, *model_, left, "another supply voltage");
    result_.choices.push_back(std::move(choice));
  }

  ConditionTrials& trials_;
  Explanation& result_;
  machine::Objective objective_;
  machine::Problem problem_;
  std::optional<MachineModel> model_, with_covered_;
  Design design_;
};

}  // namespace

void find_choices(ConditionTrials& trials, Explanation& result) { Choices(trials, result).find(); }

}  // namespace millwright::evaluation
