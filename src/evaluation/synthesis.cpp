// SPDX-License-Identifier: Apache-2.0
#include "evaluation/synthesis.h"

#include <stdexcept>

#include "evaluation/element_stage.h"

namespace millwright::evaluation {

namespace {

/// Cost and mass decide between equals, as far as they are not the objective themselves.
std::vector<std::size_t> ties(const machine::Objective& objective) {
  if (objective.single() == machine::Quantity::cost) return {mass_resource};
  if (objective.single() == machine::Quantity::mass) return {cost_resource};
  return {cost_resource, mass_resource};
}

}  // namespace

solver::Options solver_options(const MachineModel& model, const SearchOptions& options) {
  solver::Options result;
  result.objectives.clear();
  for (const std::string& name : options.objectives) {
    const machine::Objective objective = machine::objective_named(name);
    const auto quantity = objective.single();
    if (quantity) {
      result.objectives.push_back(model.resource(*quantity));
    } else {
      if (options.objectives.size() > 1) throw std::invalid_argument("a front of a weighted sum: " + name);
      result.weights.assign(model.problem().resources.size(), 0.0);
      for (const machine::ObjectiveTerm& term : objective.terms)
        result.weights[model.resource(term.quantity)] = term.weight;
    }
    if (options.objectives.size() == 1) result.ties = ties(objective);
  }
  result.gap = options.gap;
  result.time_limit_seconds = options.time_limit_seconds;
  result.threads = options.threads;
  result.stop = options.stop;
  result.progress = options.progress;
  return result;
}

Synthesis synthesise(const MachineModel& model, const SearchOptions& options) {
  Synthesis synthesis;
  synthesis.empty_slots = model.empty_slots();
  if (!synthesis.empty_slots.empty()) return synthesis;
  const solver::Summary summary = solver::solve(model.problem(), solver_options(model, options));
  synthesis.status = summary.status;
  for (const solver::Build& build : summary.builds) synthesis.designs.push_back(model.design(build));
  synthesis.lower_bound = summary.lower_bound;
  synthesis.gap = summary.gap;
  synthesis.combinations = summary.combinations;
  synthesis.nodes = summary.nodes;
  synthesis.evaluations = summary.evaluations;
  synthesis.front_tolerance = summary.front_tolerance;
  synthesis.method = summary.method;
  synthesis.seconds = summary.seconds;
  return synthesis;
}

}  // namespace millwright::evaluation
