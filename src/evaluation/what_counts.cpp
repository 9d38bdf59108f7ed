// SPDX-License-Identifier: Apache-2.0
#include "evaluation/what_counts.h"

#include <algorithm>

#include "machine/objective.h"

namespace millwright::evaluation {

namespace {

using machine::Quantity;

bool is_counted_apart(Quantity quantity) { return quantity != Quantity::cost && quantity != Quantity::mass; }

void count_limited(machine::Problem& problem) {
  for (const machine::QuantityDeclaration& each : machine::quantities())
    if (problem.limits[each.quantity] && is_counted_apart(each.quantity) &&
        std::ranges::count(problem.counted, each.quantity) == 0)
      problem.counted.push_back(each.quantity);
  std::ranges::sort(problem.counted);
}

}  // namespace

void note_what_counts(const std::vector<std::string>& objectives, machine::Problem& problem) {
  count_limited(problem);
  bool by_cost = false, by_mass = false, by_more = false;
  for (const std::string& name : objectives)
    for (const machine::ObjectiveTerm& term : machine::objective_named(name).terms) {
      by_cost = by_cost || term.quantity == Quantity::cost;
      by_mass = by_mass || term.quantity == Quantity::mass;
      by_more = by_more || is_counted_apart(term.quantity);
    }
  const bool any = objectives.empty() || (objectives.size() > 1 && !by_cost && !by_mass);
  for (machine::Axis& axis : problem.axes) {
    axis.cost_counts = any || by_cost || by_more || problem.limits[Quantity::cost];
    axis.mass_counts = any || by_mass || problem.limits[Quantity::mass];
  }
}

}  // namespace millwright::evaluation
