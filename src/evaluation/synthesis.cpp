// SPDX-License-Identifier: Apache-2.0
#include "evaluation/synthesis.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "evaluation/element_stage.h"
#include "solver/alternatives.h"
#include "solver/front_spread.h"
#include "solver/nearby.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

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

bool counts(const machine::Objective& objective, machine::Quantity quantity) {
  return std::any_of(objective.terms.begin(), objective.terms.end(), [&](const machine::ObjectiveTerm& term) {
    return term.quantity == quantity;
  });
}

/// Whether the search may be long on its way before it knows any build: by what ramps and loads move label by label.
bool starts_blind(const SearchOptions& options) {
  if (options.objectives.size() != 1) return false;
  const machine::Objective objective = machine::objective_named(options.objectives.front());
  return counts(objective, machine::Quantity::energy) || counts(objective, machine::Quantity::position_error);
}

/// Solves, with a build to fall back on when time is up before a better one is known: the cheapest, which is searched
/// for in the first quarter of the time. Where the objective is a single quantity nothing that is worse than it need be
/// looked at; a little worse is let in, since what the search finds itself keeps off the limits.
solver::Summary solve_with_start(const MachineModel& model, const SearchOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto time_left = [&] { return std::max(0.0, options.time_limit_seconds - seconds_since(begin)); };
  SearchOptions cheapest = options;
  cheapest.objectives = {"cost"};
  cheapest.time_limit_seconds = 0.25 * options.time_limit_seconds;
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
  rest.time_limit_seconds = start.builds.empty() ? time_left() : 0.9 * time_left();
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
    const auto stop = [&] { return time_left() == 0.0 || (options.stop != nullptr && options.stop->load()); };
    summary.builds = {solver::best_nearby(
        model.problem(), solver_options(model, options), (found ? summary : start).builds.front(), stop)};
    const double value = value_of(summary.builds.front());
    // A search that finds nothing where there is a build has proved nothing.
    summary.lower_bound = refuted ? 0.0 : std::min(summary.lower_bound, value);
    summary.gap = (value - summary.lower_bound) / std::max(std::abs(value), 1e-300);
    // Where nothing that is better by more than the gap exists, what is there is as good.
    summary.status = summary.gap <= options.gap ? solver::Status::optimal : solver::Status::limit;
  }
  summary.seconds = seconds_since(begin);
  return summary;
}

/// The best build by one objective.
solver::Summary solve_single(const MachineModel& model, const SearchOptions& options) {
  if (options.objectives == std::vector<std::string>{"cycle_time"}) return solve_cycle_time(model, options);
  if (starts_blind(options)) return solve_with_start(model, options);
  return solver::solve(model.problem(), solver_options(model, options));
}

/// Whether parts that are best by this objective may have been left out.
bool is_made_for(const MachineModel& model, const machine::Objective& objective) {
  const auto& axes = model.machine().axes;
  return std::none_of(axes.begin(), axes.end(), [&](const machine::Axis& axis) {
    return (!axis.cost_counts && counts(objective, machine::Quantity::cost)) ||
           (!axis.mass_counts && counts(objective, machine::Quantity::mass));
  });
}

/// Whether this is the same for every build: a cycle of moves that take a stated time, or ramps that are given.
bool is_the_same_for_all(const MachineModel& model, std::string_view objective) {
  return objective == "cycle_time" && std::ranges::none_of(model.machine().axes, machine::cycle_time_hangs_on_ramp);
}

/// Whether an objective tells none of the builds of a front in three objectives apart: those of the front in the other
/// two are those in all three.
bool is_left_out(const MachineModel& model, const SearchOptions& options, std::string_view objective) {
  return options.objectives.size() == 3 && is_the_same_for_all(model, objective);
}

/// A front that is ended by its time limit would show what was met on the way only, from one end of it or nothing at
/// all, and prove nothing: the last two fifths of the time, two seconds at least if that is no more than half of it,
/// are for the best builds by each objective and builds from all over the front, and then for proving from these what
/// can be proved in so much time.
double time_to_cover(double limit) { return std::max(0.4 * limit, std::min(2.0, 0.5 * limit)); }

solver::Summary solve_front(const MachineModel& model, const SearchOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  solver::Options front = solver_options(model, options);
  if (std::isfinite(options.time_limit_seconds))
    front.time_limit_seconds = options.time_limit_seconds - time_to_cover(options.time_limit_seconds);
  solver::Summary summary = solver::solve(model.problem(), front);
  const auto is_stopped = [&] { return options.stop != nullptr && options.stop->load(); };
  const double left = options.time_limit_seconds - seconds_since(begin);
  if (summary.status != solver::Status::limit || is_stopped() || !(left > 0.0)) return summary;
  const double to_cover = std::isfinite(left) ? 0.5 * left : 0.0;
  const auto time_left = [&] { return std::max(0.0, options.time_limit_seconds - to_cover - seconds_since(begin)); };
  const auto stop = [&] { return time_left() == 0.0 || is_stopped(); };
  for (std::size_t k = 0; k < options.objectives.size() && !stop(); ++k) {
    if (is_left_out(model, options, options.objectives[k])) continue;
    SearchOptions single = options;
    single.objectives = {options.objectives[k]};
    // As much is left for the spreading as each of them gets, or a little if there is no build yet to go on from.
    const double share = summary.builds.empty() ? 0.8 : 1.0 / static_cast<double>(options.objectives.size() - k + 1);
    single.time_limit_seconds = share * time_left();
    single.progress = nullptr;  // it would tell of another objective
    solver::Summary found = solve_single(model, single);
    summary.nodes += found.nodes;
    summary.evaluations += found.evaluations;
    std::move(found.builds.begin(), found.builds.end(), std::back_inserter(summary.builds));
    if (found.status == solver::Status::infeasible && summary.builds.empty()) {  // of any front, then
      summary.status = found.status;
      summary.front_tolerance = 0.0;
      summary.seconds = seconds_since(begin);
      return summary;
    }
  }
  summary.builds = solver::spread_front(model.problem(), front, std::move(summary.builds), stop);
  summary.method += "; when time was nearly up, the best by each objective, and from those builds all over the front";
  summary.front_tolerance += options.gap;  // builds as good but for the gap are left out of it
  front.time_limit_seconds = options.time_limit_seconds - seconds_since(begin);
  if (!is_stopped() && to_cover > 0.0 && front.time_limit_seconds > 0.0) {
    solver::Summary covered = solver::cover_front(model.problem(), front, summary.builds);
    summary.nodes += covered.nodes;
    summary.evaluations += covered.evaluations;
    summary.builds = std::move(covered.builds);
    summary.front_tolerance = std::min(summary.front_tolerance + options.gap, covered.front_tolerance);
    summary.status = covered.status;
    summary.method += "; then label by label, to a tolerance that rose with the time";
    if (covered.status == solver::Status::optimal && covered.front_tolerance > 0.0)
      summary.method += "; where continuous variables move the objectives the front is covered to its tolerance";
  }
  summary.seconds = seconds_since(begin);
  return summary;
}

}  // namespace

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
  return result;
}

Synthesis synthesise(const MachineModel& model, const SearchOptions& asked_for) {
  const auto begin = std::chrono::steady_clock::now();
  SearchOptions options = asked_for;
  // What is left is for the tolerances: a front whose builds are not asked would be worth little.
  if (options.tolerances) options.time_limit_seconds *= options.objectives.size() > 1 ? 0.9 : 0.95;
  Synthesis synthesis;
  synthesis.empty_slots = model.empty_slots();
  if (!synthesis.empty_slots.empty()) return synthesis;
  const bool fastest = options.objectives == std::vector<std::string>{"cycle_time"};
  synthesis.fixed_objective = fastest && is_the_same_for_all(model, "cycle_time");
  solver::Summary summary;
  if (options.builds > 1) {
    solver::Alternatives best = solver::best_builds(
        model.problem(),
        solver_options(model, options),
        options.builds,
        [&](std::size_t stage, std::size_t slot, solver::Row row) { return model.covering_rows(stage, slot, row); });
    summary = std::move(best.first);
    summary.status = best.status;
    summary.builds = std::move(best.builds);
    summary.method += fmt::format(
        "; the next best by splitting what each build leaves into disjoint parts, {} of them solved", best.parts - 1);
    synthesis.proved = best.proved;
  } else {
    summary = options.objectives.size() > 1 ? solve_front(model, options) : solve_single(model, options);
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
    effort.seconds = asked_for.time_limit_seconds - seconds_since(begin);
    effort.stop = options.stop;
    design.tolerances =
        std::make_shared<const ToleranceCheck>(check_tolerances(model, summary.builds[i], design, effort));
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
