// SPDX-License-Identifier: Apache-2.0
#include "evaluation/synthesis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "evaluation/allowed_time.h"
#include "evaluation/best_build.h"
#include "evaluation/best_front.h"
#include "evaluation/build_identity.h"
#include "evaluation/cheapest_order.h"
#include "solver/alternatives.h"

namespace millwright::evaluation {

namespace {

/// How far the objective of the build found is above the bound, relative. It may order from fewer suppliers than the
/// set that the search had open, and costs less then than the search counted.
double gap_of(const MachineModel& model,
              const SearchOptions& options,
              const solver::Summary& summary,
              const Design& design) {
  const double cost = design.preference ? design.preference->compared_cost : design.cost;
  double value = 0.0;
  for (const machine::ObjectiveTerm& term : machine::objective_named(options.objectives.front()).terms) {
    const double counted = summary.builds.front().resources[model.compared(term.quantity)];
    value += term.weight * (term.quantity == machine::Quantity::cost ? std::min(counted, cost) : counted);
  }
  return std::min(summary.gap, std::max(0.0, value - summary.lower_bound) / std::max(std::abs(value), 1e-300));
}

}  // namespace

Synthesis synthesise(const MachineModel& model, const SearchOptions& asked_for) {
  const AllowedTime time(asked_for.time_limit_seconds);
  SearchOptions options = asked_for;
  // What is left is for the tolerances: a front whose builds are not asked would be worth little. One build is asked
  // in a few seconds.
  if (options.tolerances && options.objectives.size() > 1)
    options.time_limit_seconds *= 0.9;
  else if (options.tolerances)
    options.time_limit_seconds -= std::min(0.05 * options.time_limit_seconds, 10.0);
  const double to_order = model.shops().empty() ? 0.0 : std::min(1.0, 0.05 * options.time_limit_seconds);
  options.time_limit_seconds -= to_order;
  Synthesis synthesis;
  synthesis.empty_slots = model.empty_slots();
  if (!synthesis.empty_slots.empty()) return synthesis;
  const bool fastest = options.objectives == std::vector<std::string>{"cycle_time"};
  synthesis.fixed_objective = fastest && is_the_same_for_all(model, "cycle_time");
  solver::Summary summary;
  if (options.builds > 1) {
    solver::BuildIdentity identity;
    if (!model.shops().empty() || !model.counted_parts().empty())
      identity = [&](const solver::Build& build) { return build_identity(model, build); };
    solver::Alternatives best = solver::best_builds(
        model.problem(),
        solver_options(model, options),
        options.builds,
        [&](std::size_t stage, std::size_t slot, solver::Row row) { return model.covering_rows(stage, slot, row); },
        identity);
    summary = std::move(best.first);
    summary.status = best.status;
    summary.builds = std::move(best.builds);
    summary.method += fmt::format(
        "; the next best by splitting what each build leaves into disjoint parts, {} of them solved", best.parts - 1);
    synthesis.proved = best.proved;
  } else {
    summary = options.objectives.size() > 1 ? best_front(model, options) : best_build(model, options);
    // (Whoever stopped the search wants to see what it found: in an order that makes sense.)
    if (summary.status == solver::Status::limit) order_cheapest(model, options, summary.builds, to_order);
  }
  for (const std::string& name : options.objectives)
    if (is_left_out(model, options, name)) summary.method += "; every build has the same " + name;
  synthesis.status = summary.status;
  for (const solver::Build& build : summary.builds)
    synthesis.designs.push_back(model.design(build, options.worksheets));
  const std::size_t asked = options.objectives.size() > 1 ? synthesis.designs.size() : 1;
  for (std::size_t i = 0; options.tolerances && i < std::min(asked, synthesis.designs.size()); ++i) {
    Design& design = synthesis.designs[i];
    ToleranceEffort effort;
    effort.seconds = time.left();
    effort.stop = options.stop;
    design.tolerances =
        std::make_shared<const ToleranceCheck>(check_tolerances(model, summary.builds[i], design, effort));
  }
  if (summary.status == solver::Status::limit && options.objectives.size() == 1 && !synthesis.designs.empty()) {
    summary.gap = gap_of(model, options, summary, synthesis.designs.front());
    if (options.builds == 1 && summary.gap <= options.gap) synthesis.status = solver::Status::optimal;
  }
  synthesis.builds = std::move(summary.builds);
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
