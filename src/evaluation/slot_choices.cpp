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

/// Whoever sells it.
bool has(const catalogue::Catalogue& catalogue, const Candidate& candidate, const PartUse& part) {
  const auto same_part = [&](int row, int other) {
    const catalogue::Table& table = catalogue.table(part.family);
    return row == other ||
           (table.part_number(row) == table.part_number(other) && table.manufacturer(row) == table.manufacturer(other));
  };
  return std::any_of(candidate.parts.begin(), candidate.parts.end(), [&](const PartUse& other) {
    return other.slot == part.slot && other.family == part.family && other.stated == part.stated &&
           (!part.stated.empty() || same_part(other.row, part.row));
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
  Choices(ConditionTrials& trials, const BestBuild& best, Explanation& result)
      : trials_(trials),
        best_(best.build),
        model_(*best.model),
        result_(result),
        objective_(machine::objective_named(result.objective)) {}

  void find() {
    design_ = model_.design(best_);
    for (std::size_t stage = 0; stage < model_.entries().size(); ++stage)
      for (std::size_t slot = 0; slot < model_.entries()[stage].tables().size(); ++slot)
        // A row of a table may be several parts: a motor with its driver.
        for (const PartUse& part : model_.candidate(stage, slot, best_.stages[stage].rows[slot]).parts)
          look_at(stage, slot, part);
    look_at_voltage();
    // What was found stays when time is up meanwhile.
    std::vector<char> found(questions_.size(), 0);
    const auto keep = [&] {
      for (std::size_t i = 0; i < questions_.size(); ++i)
        if (found[i] != 0) result_.choices.push_back(std::move(questions_[i].choice));
    };
    try {
      trials_.at_once(questions_.size(), [&](std::size_t i) {
        if (!questions_[i].choice.only) judge(questions_[i]);
        found[i] = 1;
      });
    } catch (...) {
      keep();
      throw;
    }
    keep();
  }

 private:
  /// With the drivers too that the model leaves out because another one is never worse: without that one they count.
  const MachineModel& model_of_drivers() {
    if (!with_covered_)
      with_covered_.emplace(model_.machine(),
                            trials_.catalogue_for(trials_.asked()),
                            GivenSlots{},
                            ModelOptions{.fixed = trials_.asked().fixed, .every_candidate = true});
    return *with_covered_;
  }

  /// What the best build is of what is left without a choice.
  struct Question {
    SlotChoice choice;
    const MachineModel* model = nullptr;
    solver::Restriction left;
    std::string what;
  };

  void judge(Question& question) {
    SlotChoice& choice = question.choice;
    const MachineModel& model = *question.model;
    const SearchOptions options = trials_.begin(question.what, false);
    const solver::RestrictedProblem restricted(model.problem(), question.left);
    const solver::Summary summary = solver::solve(restricted.problem(), solver_options(model, options));
    const double base = design_.compared(objective_);
    const bool settled = summary.status != solver::Status::limit;
    if (!settled) trials_.check_time();
    choice.settled = settled;
    if (!settled) choice.next_best = std::max(0.0, summary.lower_bound - base);
    if (summary.builds.empty()) return;
    const Design next = model.design(restricted.whole_build(summary.builds.front()));
    choice.at_most = std::max(0.0, next.compared(objective_) - base);
    if (settled) choice.next_best = choice.at_most;
    choice.instead =
        choice.slot == "supply_voltage" ? volts(next.supply_voltage) : name_of(next, choice.axis, choice.slot);
  }

  void look_at(std::size_t stage, std::size_t slot, const PartUse& part) {
    SlotChoice choice;
    choice.axis = model_.entries()[stage].axis;
    choice.slot = part.slot;
    choice.part = name_of(design_, choice.axis, choice.slot);
    if (choice.part.empty() || !part.is_named()) return;  // the only one, as the problem states it
    const bool driver = part.slot == "driver";
    const MachineModel& model = driver ? model_of_drivers() : model_;
    solver::Restriction left = solver::unrestricted(model.problem());
    std::vector<Row>& allowed = left.stages[stage].allowed[slot];
    std::erase_if(allowed, [&](Row row) { return has(model.catalogue(), model.candidate(stage, slot, row), part); });
    choice.only = allowed.empty();
    if (driver) thin(model, left);
    const std::string what = fmt::format("another {}.{}", choice.axis, choice.slot);
    questions_.push_back({std::move(choice), &model, std::move(left), what});
  }

  static std::string volts(double value) { return scalar::format(value, scalar::Unit::of("V")); }

  void look_at_voltage() {
    if (model_.machine().supply_voltages.size() < 2) return;
    solver::Restriction left = solver::unrestricted(model_.problem());
    std::erase(left.shared.front(), best_.shared.front());
    SlotChoice choice;
    choice.axis = "machine";
    choice.slot = "supply_voltage";
    choice.part = volts(design_.supply_voltage);
    questions_.push_back({std::move(choice), &model_, std::move(left), "another supply voltage"});
  }

  ConditionTrials& trials_;
  const solver::Build& best_;
  const MachineModel& model_;
  Explanation& result_;
  machine::Objective objective_;
  std::optional<MachineModel> with_covered_;
  std::vector<Question> questions_;
  Design design_;
};

}  // namespace

BestBuild find_best(ConditionTrials& trials, const std::string& objective) {
  BestBuild best;
  machine::Problem problem = trials.asked().problem;
  problem.counted = machine::counted_quantities({objective});
  best.model = std::make_unique<MachineModel>(
      problem, trials.catalogue_for(trials.asked()), GivenSlots{}, ModelOptions{.fixed = trials.asked().fixed});
  const SearchOptions options = trials.begin("which choices are free");
  solver::Summary summary = solver::solve(best.model->problem(), solver_options(*best.model, options));
  if (summary.status != solver::Status::optimal) throw TimeIsUp{};
  best.build = std::move(summary.builds.front());
  return best;
}

void find_choices(ConditionTrials& trials, const BestBuild& best, Explanation& result) {
  Choices(trials, best, result).find();
}

}  // namespace millwright::evaluation
