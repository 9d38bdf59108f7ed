// SPDX-License-Identifier: Apache-2.0
#include "evaluation/rates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "evaluation/machine_stages.h"
#include "evaluation/same_parts.h"
#include "solver/multipliers.h"

namespace millwright::evaluation {

namespace {

using machine::Asked;
using machine::Condition;
using machine::ConditionKind;

constexpr double settled_to = 1e-8;  ///< relative, what local solvers leave
constexpr double small_step = 1e-4;  ///< of a condition's value, for the slope of the constraints
constexpr double trial_step = 1e-3;  ///< of a condition's value, to try what was found
constexpr double trial_accuracy = 0.02;

/// Of the families that it has any part of, only the parts of the design; but of materials all: parts are made of them.
catalogue::Catalogue parts_of(const Design& design, const catalogue::Catalogue& all) {
  std::set<std::string> families;
  std::set<std::pair<std::string, std::string>> kept;
  for (const PartLine& part : design.parts) {
    families.insert(part.family);
    kept.emplace(part.manufacturer, part.part_number);
  }
  std::vector<catalogue::Part> others;
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    if (families.count(std::string(family.name)) == 0 || family.priced_per_mass) continue;
    const catalogue::Table& table = all.table(family.family);
    for (int row = 0; row < table.rows(); ++row)
      if (kept.count({std::string(table.text("manufacturer", row)), std::string(table.text("part_number", row))}) == 0)
        others.push_back({family.family, row});
  }
  catalogue::Catalogue result = all;
  result.drop(others);
  return result;
}

class Rates {
 public:
  Rates(ConditionTrials& trials, Explanation& result)
      : trials_(trials),
        result_(result),
        parts_(parts_of(*result.design, trials.catalogue_for(trials.asked()))),
        objective_(machine::objective_named(result.objective)) {}

  void find() {
    SearchOptions options = trials_.begin("what moves with the dimensions");
    base_ = model_of(trials_.asked());
    if (!base_->problems().empty() || !base_->empty_slots().empty()) return;
    const solver::Summary first = solver::solve(base_->problem(), how(*base_, options));
    if (first.status != solver::Status::optimal) return;
    build_ = solver::settled(base_->problem(), how(*base_, options), first.builds.front());
    least_ = total(build_);
    // The proof says that this is the least, to its gap.
    if (std::abs(least_ - result_.design->compared(objective_)) > 1e-5 * std::abs(least_)) return;
    const auto multipliers = solver::Multipliers::find(base_->problem(), how(*base_, options), build_);
    if (!multipliers) {
      result_.rates_undetermined = true;
      return;
    }
    if (!multipliers->any_moves()) return;
    describe(*multipliers);
    for (std::size_t i = 0; i < trials_.conditions().size(); ++i) {
      const Condition& condition = trials_.conditions()[i];
      if (condition.kind == ConditionKind::choice || !(std::abs(condition.value) > 0.0)) continue;
      trials_.check_time();
      const double rate = rate_of(condition, *multipliers);
      if (std::isfinite(rate) && std::abs(rate * condition.value) > 1e-7 * std::abs(least_)) offer(i, rate);
    }
    std::stable_sort(result_.rates.begin(), result_.rates.end(), [&](const Rate& a, const Rate& b) {
      const auto weight = [&](const Rate& r) { return std::abs(r.slope * trials_.conditions()[r.condition].value); };
      return weight(a) > weight(b);
    });
  }

 private:
  std::unique_ptr<MachineModel> model_of(const Asked& asked) const {
    Asked counted = asked;
    counted.problem.counted = machine::counted_quantities({result_.objective});
    return std::make_unique<MachineModel>(
        counted.problem, parts_, GivenSlots{}, ModelOptions{.fixed = asked.fixed, .every_candidate = true});
  }

  solver::Options how(const MachineModel& model, SearchOptions options) const {
    options.objectives = {result_.objective};
    solver::Options result = solver_options(model, options);
    result.confirm = false;
    return result;
  }

  [[nodiscard]] double total(const solver::Build& build) const {
    double sum = 0.0;
    for (const machine::ObjectiveTerm& term : objective_.terms)
      sum += term.weight * build.resources[base_->compared(term.quantity)];
    return sum;
  }

  /// To a value, everything else as asked.
  std::unique_ptr<MachineModel> with(const Condition& condition, double value) const {
    Asked asked = trials_.asked();
    condition.set(asked, value);
    return model_of(asked);
  }

  /// d objective / d value on the looser side, by one-sided differences of the Lagrangian at two steps.
  double rate_of(const Condition& condition, const solver::Multipliers& multipliers) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const solver::Options options = how(*base_, {});
    const double here = multipliers.lagrangian(base_->problem(), options, build_);
    const auto slope = [&](double step) {
      const double value = condition.eased(1.0 + step);
      const auto model = with(condition, value);
      const auto there = same_parts_in(*model, *base_, build_);
      if (!there) return none;
      return (multipliers.lagrangian(model->problem(), options, *there) - here) / (value - condition.value);
    };
    const double coarse = slope(small_step);
    if (!std::isfinite(coarse) || coarse == 0.0) return coarse;
    const double fine = slope(0.5 * small_step);
    return std::abs(fine - coarse) <= 0.01 * std::abs(fine) ? 2.0 * fine - coarse : none;
  }

  /// Keeps a rate that solving the same parts again bears out.
  void offer(std::size_t index, double slope) {
    const Condition& condition = trials_.conditions()[index];
    const double value = condition.eased(1.0 + trial_step);
    const auto model = with(condition, value);
    const auto there = same_parts_in(*model, *base_, build_);
    const double said = slope * (value - condition.value);
    const bool borne_out =
        there && std::abs(total(solver::settled(model->problem(), how(*model, {}), *there)) - least_ - said) <=
                     trial_accuracy * std::abs(said) + settled_to * std::abs(least_);
    if (borne_out)
      result_.rates.push_back({index, slope});
    else
      result_.rough.push_back(index);
  }

  void describe(const solver::Multipliers& multipliers) {
    const Design design = base_->design(build_);
    for (const auto& [stage, variable] : multipliers.moving()) {
      const StageEntry& entry = base_->entries()[stage];
      const std::string& name = base_->problem().stages[stage]->variables()[variable].name;
      for (const DimensionLine& line : design.dimensions)
        if (line.axis == entry.axis && line.name == (entry.element == "drive" ? name : entry.element + "." + name))
          result_.moving.push_back(line);
    }
    constexpr double close = 1e-4;
    for (const solver::Multipliers::Holding& holding : multipliers.holding())
      for (const Check& check : design.checks) {
        const bool of_stage = holding.stage < base_->entries().size()
                                  ? check.axis == base_->entries()[holding.stage].axis &&
                                        check.element == base_->entries()[holding.stage].element
                                  : machine::is_limit_of_machine(check.id);
        const bool known = std::any_of(result_.holding.begin(), result_.holding.end(), [&](const Check& each) {
          return each.axis == check.axis && each.element == check.element && each.id == check.id;
        });
        if (of_stage && !known && check.kind == machine::ConstraintKind::hard &&
            std::abs(check.utilisation - 1.0) < close)
          result_.holding.push_back(check);
      }
  }

  ConditionTrials& trials_;
  Explanation& result_;
  catalogue::Catalogue parts_;
  machine::Objective objective_;
  std::unique_ptr<MachineModel> base_;
  solver::Build build_;
  double least_ = 0.0;
};

}  // namespace

void find_rates(ConditionTrials& trials, Explanation& result) {
  if (result.design) Rates(trials, result).find();
}

}  // namespace millwright::evaluation
