// SPDX-License-Identifier: Apache-2.0
#include "solver/leaf_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/ipopt_solver.h"
#include "solver/nlopt_solver.h"
#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

LocalProblem box_problem(std::span<const Interval> box) {
  LocalProblem problem;
  for (const Interval& side : box) {
    problem.lower.push_back(side.lower);
    problem.upper.push_back(side.upper);
  }
  return problem;
}

}  // namespace

LeafDesign::LeafDesign(const LeafQuestion& q, Desk& d) : question(q), desk(d) {
  for (const RowSet& set : q.region->rows) rows.push_back(set->front());
}

Point LeafDesign::point(std::span<const double> variables) const {
  return Point{question.plan->shared, question.label->state, rows, variables};
}

double LeafDesign::worst_at(std::span<const double> variables) {
  return worst_of(desk.evaluate(*question.plan->stage, point(variables)).utilisation);
}

bool LeafDesign::take(std::span<const double> variables, StagePoint& out) {
  out.utilisation = worst_at(variables);
  if (!(out.utilisation <= 1.0)) return false;
  copy_answer(variables, out);
  return true;
}

bool LeafDesign::take_infeasible(std::span<const double> variables, StagePoint& out) {
  out.utilisation = worst_at(variables);
  copy_answer(variables, out);
  out.feasible = false;
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(out.score_lower.begin(), out.score_lower.end(), finite) &&
         std::all_of(out.state.begin(), out.state.end(), finite);
}

void LeafDesign::copy_answer(std::span<const double> variables, StagePoint& out) {
  out.variables.assign(variables.begin(), variables.end());
  out.resources = desk.number.resources;
  out.state = desk.number.handed_on;
  out.score_lower.resize(question.plan->criteria->size());
  question.plan->criteria->scores<double>(out.resources, out.score_lower);
  out.enclosure.assign(out.state.begin(), out.state.end());
  out.exact = true;
}

std::optional<std::vector<double>> LeafDesign::try_points(std::span<const Interval> box) {
  std::vector<double> x = middle_of(box);
  if (worst_at(x) <= 1.0) return x;
  constexpr std::size_t most_corners = 3;  // variables up to which all corners are tried
  const std::size_t corners = box.size() <= most_corners ? std::size_t{1} << box.size() : 2;
  for (std::size_t corner = 0; corner < corners; ++corner) {
    for (std::size_t v = 0; v < box.size(); ++v) {
      const bool upper = box.size() <= most_corners ? ((corner >> v) & 1U) != 0 : corner == 1;
      x[v] = upper ? box[v].upper : box[v].lower;
    }
    if (worst_at(x) <= 1.0) return x;
  }
  return std::nullopt;
}

std::optional<std::vector<double>> LeafDesign::least_violation(std::span<const Interval> box,
                                                               std::span<const double> start) {
  std::vector<std::size_t> variables(box.size()), constraints(question.plan->stage->constraints());
  std::iota(variables.begin(), variables.end(), 0);
  std::iota(constraints.begin(), constraints.end(), 0);
  auto found = least_worst(box, start, variables, constraints);
  if (found && worst_at(*found) <= 1.0) return found;
  return std::nullopt;
}

/// min z subject to utilisation_i <= z.
std::optional<std::vector<double>> LeafDesign::least_worst(std::span<const Interval> box,
                                                           std::span<const double> start,
                                                           std::span<const std::size_t> moved,
                                                           std::span<const std::size_t> constraints) {
  const std::size_t n = moved.size();
  std::vector<double> all(start.begin(), start.end());
  std::vector<Interval> sides;
  std::vector<double> from;
  for (const std::size_t v : moved) {
    sides.push_back(box[v]);
    from.push_back(start[v]);
  }
  worst_at(start);
  double worst = 0.0;
  for (const std::size_t c : constraints) worst = std::max(worst, desk.number.utilisation[c]);
  from.push_back(std::min(worst, 1e3));
  LocalProblem problem = box_problem(sides);
  problem.lower.push_back(0.0);
  problem.upper.push_back(1e3);
  problem.constraints = constraints.size();
  problem.function = [&](auto x, auto constraint, auto gradient, auto jacobian) {
    for (std::size_t i = 0; i < n; ++i) all[moved[i]] = x[i];
    const Point at = point(all);
    const auto& value = desk.evaluate(*question.plan->stage, at);
    for (std::size_t c = 0; c < constraint.size(); ++c) {
      constraint[c] = std::min(value.utilisation[constraints[c]], 1e6) - x[n];
      jacobian[c * (n + 1) + n] = -1.0;
    }
    for (std::size_t v = 0; v < n; ++v) {
      const auto& slope = desk.gradient(*question.plan->stage, at, {Input::Kind::variable, moved[v]});
      for (std::size_t c = 0; c < constraint.size(); ++c) jacobian[c * (n + 1) + v] = slope.utilisation[constraints[c]];
      gradient[v] = 0.0;
    }
    gradient[n] = 1.0;
    return x[n];
  };
  const auto solution = solve_with_nlopt(problem, from);
  if (!solution) return std::nullopt;
  for (std::size_t i = 0; i < n; ++i) all[moved[i]] = solution->x[i];
  return all;
}

/// Scores and states in units of what they are here, so that none drowns.
void LeafDesign::weigh_answer(const Answer<double>& answer, double& value) const {
  const StagePlan& plan = *question.plan;
  std::vector<double> score(plan.criteria->size());
  plan.criteria->scores<double>(answer.resources, score);
  value = 0.0;
  for (std::size_t k = 0; k < plan.criteria->objectives; ++k) {
    const double scale = std::fabs(plan.least[k] + plan.rest[k]) + std::fabs(question.label->score[k]) + 1e-9;
    value += score[k] / scale;
  }
  for (std::size_t c = 0; c < plan.after.size(); ++c) {
    const double sign = plan.after[c] == Direction::smaller_is_better  ? 1.0
                        : plan.after[c] == Direction::larger_is_better ? -1.0
                                                                       : 0.0;
    value += 1e-3 * sign * answer.handed_on[c] / (std::fabs(question.label->state[c]) + 1.0);
  }
}

std::optional<std::vector<double>> LeafDesign::small_worth(std::span<const Interval> box,
                                                           std::span<const double> start,
                                                           bool with_ipopt) {
  const std::size_t n = box.size();
  // A little inside, so that the solver's own tolerance does not spoil feasibility.
  constexpr double inside = 1e-9;
  LocalProblem problem = box_problem(box);
  problem.constraints = question.plan->stage->constraints();
  problem.function = [&](auto x, auto constraint, auto gradient, auto jacobian) {
    const Point at = point(x);
    const auto& value = desk.evaluate(*question.plan->stage, at);
    for (std::size_t c = 0; c < constraint.size(); ++c) {
      constraint[c] = std::min(value.utilisation[c], 1e6) - (1.0 - inside);
    }
    double worth = 0.0;
    weigh_answer(value, worth);
    for (std::size_t v = 0; v < n; ++v) {
      const auto& slope = desk.gradient(*question.plan->stage, at, {Input::Kind::variable, v});
      for (std::size_t c = 0; c < constraint.size(); ++c) jacobian[c * n + v] = slope.utilisation[c];
      weigh_answer(slope, gradient[v]);
    }
    return worth;
  };
  const auto solution = with_ipopt ? solve_with_ipopt(problem, start) : solve_with_nlopt(problem, start);
  if (solution && worst_at(solution->x) <= 1.0) return solution->x;
  return std::nullopt;
}

/// Golden section along one variable after the other, from a coarse grid.
void LeafDesign::relieve(std::vector<double>& variables, std::span<const Interval> box) {
  double best = worst_at(variables);
  const auto improve = [&](std::size_t v, double value) {
    std::vector<double> trial = variables;
    trial[v] = value;
    const double worst = worst_at(trial);
    if (!(worst < best)) return false;
    best = worst;
    variables = std::move(trial);
    return true;
  };
  constexpr int grid = 8;
  constexpr int refinements = 12;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    if ((question.plan->moves_outcome[v] && !question.plan->moved_state) || !(box[v].upper > box[v].lower)) continue;
    double step = (box[v].upper - box[v].lower) / grid;
    for (int i = 0; i <= grid; ++i) improve(v, box[v].lower + i * step);
    for (int i = 0; i < refinements; ++i) {
      step *= 0.5;
      const double here = variables[v];
      if (!improve(v, std::min(here + step, box[v].upper))) improve(v, std::max(here - step, box[v].lower));
    }
  }
}

}  // namespace millwright::solver
