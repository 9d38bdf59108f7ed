// SPDX-License-Identifier: Apache-2.0
#include "evaluation/search_options.h"

#include <algorithm>
#include <stdexcept>

#include "evaluation/element_stage.h"

namespace millwright::evaluation {

namespace {

/// Cost and mass decide between equals, as far as they are not settled with the objective itself.
std::vector<std::size_t> ties(const MachineModel& model, const machine::Objective& objective) {
  const std::size_t compared_cost = model.compared(machine::Quantity::cost);
  bool more = false, cost = false;
  for (const machine::ObjectiveTerm& term : objective.terms) {
    more = more || (term.quantity != machine::Quantity::cost && term.quantity != machine::Quantity::mass);
    cost = cost || term.quantity == machine::Quantity::cost;
  }
  if (more) return {compared_cost, mass_resource};
  // Of builds of equal cost + w mass and equal mass the cost is equal too.
  return {cost ? mass_resource : compared_cost};
}

/// Whether parts that are best by this objective may have been left out.
bool is_made_for(const MachineModel& model, const machine::Objective& objective) {
  const auto& axes = model.machine().axes;
  return std::none_of(axes.begin(), axes.end(), [&](const machine::Axis& axis) {
    return (!axis.cost_counts && objective.counts(machine::Quantity::cost)) ||
           (!axis.mass_counts && objective.counts(machine::Quantity::mass));
  });
}

}  // namespace

bool is_the_same_for_all(const MachineModel& model, std::string_view objective) {
  return objective == "cycle_time" && std::ranges::none_of(model.machine().axes, machine::cycle_time_hangs_on_ramp);
}

bool is_left_out(const MachineModel& model, const SearchOptions& options, std::string_view objective) {
  return options.objectives.size() == 3 && is_the_same_for_all(model, objective);
}

solver::Options solver_options(const MachineModel& model, const SearchOptions& options) {
  solver::Options result;
  result.objectives.clear();
  for (const std::string& name : options.objectives) {
    const machine::Objective objective = machine::objective_named(name);
    if (!is_made_for(model, objective)) throw std::invalid_argument("the model was made for other objectives: " + name);
    if (is_left_out(model, options, name)) continue;
    const auto quantity = objective.single();
    if (quantity) {
      result.objectives.push_back(model.compared(*quantity));
    } else {
      if (options.objectives.size() > 1) throw std::invalid_argument("a front of a weighted sum: " + name);
      result.weights.assign(model.problem().resources.size(), 0.0);
      for (const machine::ObjectiveTerm& term : objective.terms)
        result.weights[model.compared(term.quantity)] = term.weight;
    }
    if (options.objectives.size() > 1) continue;
    result.ties = ties(model, objective);
    // Among builds of the least energy, time or error it takes longer than to find that, and prices hardly ever tie.
    result.settle_ties = quantity == machine::Quantity::mass;
  }
  result.gap = options.gap;
  result.front_tolerance = options.front_tolerance;
  result.time_limit_seconds = options.time_limit_seconds;
  result.threads = options.threads;
  result.stop = options.stop;
  result.progress = options.progress;
  result.confirm = options.confirm;
  result.price_limits = options.price_limits;
  return result;
}

}  // namespace millwright::evaluation
