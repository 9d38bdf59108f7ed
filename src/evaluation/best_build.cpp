// SPDX-License-Identifier: Apache-2.0
#include "evaluation/best_build.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/allowed_time.h"
#include "solver/nearby.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

namespace {

/// The same machine with all ramps held on which its cycle time hangs: at those of a build, or at the shortest.
solver::Restriction with_ramps(const MachineModel& model, const solver::Build* build) {
  const auto& axes = model.machine().axes;
  const auto matters = [&](const std::string& axis) {
    return std::any_of(axes.begin(), axes.end(), [&](const machine::Axis& each) {
      return each.name == axis && machine::cycle_time_hangs_on_ramp(each);
    });
  };
  solver::Restriction restriction = solver::unrestricted(model.problem());
  for (std::size_t i = 0; i < restriction.stages.size(); ++i) {
    const auto variables = model.problem().stages[i]->variables();
    for (std::size_t v = 0; v < variables.size(); ++v)
      if (variables[v].name == "acceleration_time" && matters(model.entries()[i].axis))
        restriction.stages[i].held[v] = build != nullptr ? build->stages[i].variables[v] : variables[v].lower;
  }
  return restriction;
}

/// The cheapest build with held ramps; all such builds take the same time.
solver::Summary cheapest_with(const MachineModel& model, const SearchOptions& options, const solver::Build* ramps) {
  SearchOptions cheapest = options;
  cheapest.objectives = {"cost"};
  const solver::RestrictedProblem held(model.problem(), with_ramps(model, ramps));
  solver::Summary found = solver::solve(held.problem(), solver_options(model, cheapest));
  for (solver::Build& build : found.builds) build = held.whole_build(std::move(build));
  return found;
}

/// The fastest build. With every ramp at its shortest, if some build can have that, nothing is faster, and of those the
/// cheapest is found as fast as ever. Else ramps are searched too; among the fastest builds many may differ in price
/// only, which a search to a tolerance does not tell apart: of those with the same ramps the cheapest is taken.
solver::Summary solve_cycle_time(const MachineModel& model, const SearchOptions& options) {
  solver::Summary shortest = cheapest_with(model, options, nullptr);
  if (!shortest.builds.empty()) {
    shortest.lower_bound = shortest.builds.front().resources[model.resource(machine::Quantity::cycle_time)];
    shortest.gap = 0.0;
    if (shortest.status == solver::Status::optimal)
      shortest.method += "; no ramp can be shorter, and of the builds with these ramps it is the cheapest";
    return shortest;
  }
  SearchOptions rest = options;
  rest.time_limit_seconds = std::max(0.0, options.time_limit_seconds - shortest.seconds);
  solver::Summary fastest = solver::solve(model.problem(), solver_options(model, rest));
  const auto add_effort = [&](const solver::Summary& other) {
    fastest.nodes += other.nodes;
    fastest.evaluations += other.evaluations;
    fastest.seconds += other.seconds;
  };
  add_effort(shortest);
  if (fastest.status != solver::Status::optimal) return fastest;
  rest.time_limit_seconds = std::max(0.0, options.time_limit_seconds - fastest.seconds);
  solver::Summary cheapest = cheapest_with(model, rest, &fastest.builds.front());
  add_effort(cheapest);
  const auto cost = [&](const solver::Summary& of) {
    return of.builds.front().resources[model.compared(machine::Quantity::cost)];
  };
  if (cheapest.builds.empty() || cost(cheapest) > cost(fastest)) return fastest;
  fastest.builds = std::move(cheapest.builds);
  if (cheapest.status == solver::Status::optimal) fastest.method += "; of the builds with these ramps the cheapest";
  return fastest;
}

/// Whether the search may be long on its way before it knows any build: by what ramps and loads move label by label.
bool starts_blind(const SearchOptions& options) {
  if (options.objectives.size() != 1) return false;
  const machine::Objective objective = machine::objective_named(options.objectives.front());
  return objective.counts(machine::Quantity::energy) || objective.counts(machine::Quantity::position_error);
}

/// Solves, with a build to fall back on when time is up before a better one is known: the cheapest, which is searched
/// for in the first quarter of the time. Where the objective is a single quantity nothing that is worse than it need be
/// looked at; a little worse is let in, since what the search finds itself keeps off the limits.
solver::Summary solve_with_start(const MachineModel& model, const SearchOptions& options) {
  const AllowedTime time(options.time_limit_seconds);
  SearchOptions cheapest = options;
  cheapest.objectives = {"cost"};
  cheapest.time_limit_seconds = 0.25 * options.time_limit_seconds;
  cheapest.confirm = false;
  if (options.progress) {
    // Its bound and its builds are of another objective; no quantity is less than nothing.
    cheapest.progress = [&](solver::Progress progress) {
      progress.lower_bound = 0.0;
      progress.incumbent = std::numeric_limits<double>::infinity();
      options.progress(progress);
    };
  }
  const solver::Summary start = solver::solve(model.problem(), solver_options(model, cheapest));
  if (start.builds.empty() && start.status == solver::Status::infeasible) return start;
  const machine::Objective objective = machine::objective_named(options.objectives.front());
  const auto value_of = [&](const solver::Build& build) {
    double value = 0.0;
    for (const machine::ObjectiveTerm& term : objective.terms)
      value += term.weight * build.resources[model.compared(term.quantity)];
    return value;
  };
  SearchOptions rest = options;
  constexpr double share_for_nearby = 0.1, most_for_nearby = 5.0;
  rest.time_limit_seconds =
      time.left() - (start.builds.empty() ? 0.0 : std::min(share_for_nearby * time.left(), most_for_nearby));
  solver::Problem problem = model.problem();
  if (const auto single = objective.single(); single && !start.builds.empty()) {
    const std::size_t resource = model.resource(*single);
    problem.resources[resource].limit =
        std::min(problem.resources[resource].limit,
                 start.builds.front().resources[resource] * (1.0 + std::max(1e-9, 0.25 * options.gap)));
  }
  solver::Summary summary = solver::solve(problem, solver_options(model, rest));
  summary.nodes += start.nodes;
  summary.evaluations += start.evaluations;
  const bool refuted = summary.status == solver::Status::infeasible && !start.builds.empty();
  if (summary.status != solver::Status::optimal && !start.builds.empty()) {
    const bool found = !summary.builds.empty() && value_of(summary.builds.front()) < value_of(start.builds.front());
    const auto stop = [&] { return time.left() == 0.0 || (options.stop != nullptr && options.stop->load()); };
    summary.builds = {solver::best_nearby(
        model.problem(), solver_options(model, options), (found ? summary : start).builds.front(), stop)};
    const double value = value_of(summary.builds.front());
    // A search that finds nothing where there is a build has proved nothing; nor has one that was ended at once.
    summary.lower_bound = refuted ? 0.0 : std::min(std::max(summary.lower_bound, 0.0), value);
    summary.gap = (value - summary.lower_bound) / std::max(std::abs(value), 1e-300);
    // Where nothing that is better by more than the gap exists, what is there is as good.
    summary.status = summary.gap <= options.gap ? solver::Status::optimal : solver::Status::limit;
  }
  summary.seconds = time.used();
  return summary;
}

}  // namespace

solver::Summary best_build(const MachineModel& model, const SearchOptions& options) {
  if (options.objectives == std::vector<std::string>{"cycle_time"}) return solve_cycle_time(model, options);
  if (starts_blind(options)) return solve_with_start(model, options);
  return solver::solve(model.problem(), solver_options(model, options));
}

}  // namespace millwright::evaluation
