// SPDX-License-Identifier: Apache-2.0
#include "evaluation/condition_prices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/machine_stages.h"
#include "evaluation/same_parts.h"
#include "solver/neighbours.h"

namespace millwright::evaluation {

namespace {

using machine::Asked;
using machine::Condition;
using machine::ConditionKind;

class Prices {
 public:
  Prices(ConditionTrials& trials, const BestBuild& best, Explanation& result)
      : trials_(trials), best_(best), result_(result), objective_(machine::objective_named(result.objective)) {
    base_ = result.design->compared(objective_);
  }

  void find() {
    const ConditionSet dear = those_that_cost();
    result_.costless = trials_.all().size() - dear.size();
    std::vector<std::optional<Price>> prices(dear.size());
    std::vector<char> unsettled(dear.size(), 0);
    const auto keep = [&] {
      for (std::size_t k = 0; k < dear.size(); ++k) {
        if (prices[k]) result_.prices.push_back(*prices[k]);
        if (unsettled[k] != 0) result_.unsettled.push_back(dear[k]);
      }
      std::stable_sort(result_.prices.begin(), result_.prices.end(), [](const Price& a, const Price& b) {
        return a.at_most > b.at_most;
      });
    };
    try {
      trials_.at_once(dear.size(), [&](std::size_t k) {
        try {
          prices[k] = price(dear[k]);
        } catch (const Unsettled&) {
          unsettled[k] = 1;
        }
      });
    } catch (...) {
      for (std::size_t k = 0; k < dear.size(); ++k) unsettled[k] = prices[k] ? 0 : 1;
      keep();
      throw;
    }
    keep();
  }

 private:
  [[nodiscard]] const std::vector<Condition>& conditions() const { return trials_.conditions(); }
  [[nodiscard]] bool matters(double saving) const { return saving > 1e-5 * std::abs(base_); }

  /// Those with an example near the best build first, which costs no search; of the rest sets together, what is not
  /// settled for many in parts.
  ConditionSet those_that_cost() {
    const ConditionSet all = trials_.all();
    std::vector<char> seen(all.size(), 0);
    if (objective_.single())
      trials_.at_once(all.size(), [&](std::size_t i) { seen[i] = cheaper_neighbour(conditions()[i]) ? 1 : 0; });
    ConditionSet dear, rest;
    for (const std::size_t i : all) (seen[i] != 0 ? dear : rest).push_back(i);
    const ConditionSet found = those_that_matter(rest, [&](const std::vector<ConditionSet>& sets) {
      std::vector<char> matter(sets.size(), 0);
      trials_.at_once(sets.size(), [&](std::size_t k) { matter[k] = matters_without(sets[k]) ? 1 : 0; });
      return std::vector<bool>(matter.begin(), matter.end());
    });
    dear.insert(dear.end(), found.begin(), found.end());
    std::sort(dear.begin(), dear.end());
    return dear;
  }

  bool matters_without(const ConditionSet& set) {
    try {
      return matters(saving(
          [&](Asked& asked) {
            for (const std::size_t i : set) conditions()[i].lift(asked);
          },
          "what conditions cost"));
    } catch (const Unsettled&) {
      return true;
    }
  }

  /// Whether a build that differs from the best one in a single row is compliant without a condition, and cheaper.
  bool cheaper_neighbour(const Condition& condition) {
    trials_.check_time();
    Asked asked = trials_.asked();
    condition.lift(asked);
    asked.problem.counted = machine::counted_quantities({result_.objective});
    const MachineModel model(asked.problem, trials_.catalogue_for(asked), {}, {.fixed = asked.fixed});
    std::optional<solver::Build> start = same_parts_in(model, *best_.model, best_.build);
    if (!start) return false;
    const std::size_t resource = model.compared(*objective_.single());
    evaluate(model.problem(), *start);
    double least = base_ - 1e-5 * std::abs(base_);
    bool found = false;
    solver::Neighbours(model.problem()).visit(*start, resource, [&](const solver::Build& build) {
      found = found || build.resources[resource] < least;
      return least;
    });
    return found;
  }

  /// Fills in what the stages inherit and what it takes in all.
  static void evaluate(const solver::Problem& problem, solver::Build& build) {
    std::vector<double> state = problem.first_state;
    build.resources.assign(problem.resources.size(), 0.0);
    solver::Answer<double> answer;
    for (std::size_t i = 0; i < build.stages.size(); ++i) {
      solver::StageChoice& choice = build.stages[i];
      choice.inherited = state;
      problem.stages[i]->evaluate({build.shared, state, choice.rows, choice.variables}, answer);
      for (std::size_t r = 0; r < build.resources.size(); ++r) build.resources[r] += answer.resources[r];
      state = answer.handed_on;
    }
  }

  double saving(const ConditionTrials::Change& change, const std::string& what) {
    const auto design = trials_.best_soon(what, change);
    return design ? base_ - design->compared(objective_) : 0.0;
  }

  Price price(std::size_t index) {
    const Condition& condition = conditions()[index];
    const std::string what = "what it costs, " + condition.axis + ": " + condition.name;
    Price result;
    result.condition = index;
    result.at_most = saving([&](Asked& asked) { condition.lift(asked); }, what);
    if (condition.kind != ConditionKind::number) {
      result.saving = result.at_most;
      return result;
    }
    // By a fifth; where that saves nothing yet, by as much as it takes.
    double factor = std::min(1.2, condition.furthest), refused = 1.0;
    const auto eased = [&](double by) {
      return saving([&](Asked& asked) { condition.set(asked, rounded_looser(condition, condition.eased(by))); }, what);
    };
    result.saving = eased(factor);
    while (!matters(result.saving) && factor < condition.furthest) {
      refused = factor;
      factor = std::min(factor * factor, condition.furthest);
      result.saving = eased(factor);
    }
    while (refused > 1.0 && factor / refused > smallest_change) {
      const double middle = std::sqrt(factor * refused);
      const double there = eased(middle);
      if (matters(there)) result.saving = there;
      (matters(there) ? factor : refused) = middle;
    }
    result.to = rounded_looser(condition, condition.eased(factor));
    return result;
  }

  ConditionTrials& trials_;
  const BestBuild& best_;
  Explanation& result_;
  machine::Objective objective_;
  double base_ = 0.0;
};

}  // namespace

void find_prices(ConditionTrials& trials, const BestBuild& best, Explanation& result) {
  Prices(trials, best, result).find();
}

}  // namespace millwright::evaluation
