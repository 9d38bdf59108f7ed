// SPDX-License-Identifier: Apache-2.0
#include "solver/nlopt_solver.h"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

namespace millwright::solver {
namespace {

/// NLopt asks for objective and constraints in separate calls; both come from one evaluation, kept for the point.
struct NloptProblem {
  const LocalProblem& problem;
  std::vector<double> x, constraint, objective_gradient, constraint_gradient;
  double objective = 0.0;

  explicit NloptProblem(const LocalProblem& p)
      : problem(p),
        constraint(p.constraints),
        objective_gradient(p.lower.size()),
        constraint_gradient(p.constraints * p.lower.size()) {}

  void at(const double* point) {
    const std::size_t n = problem.lower.size();
    if (x.size() == n && std::equal(x.begin(), x.end(), point)) return;
    if (problem.stop && problem.stop()) throw nlopt::forced_stop();
    x.assign(point, point + n);
    objective = problem.function(x, constraint, objective_gradient, constraint_gradient);
    // NLopt runs on with NaN for ever; a large number makes it turn back.
    const auto tame = [](double& value) { value = std::isfinite(value) ? value : 1e9; };
    tame(objective);
    std::for_each(constraint.begin(), constraint.end(), tame);
    std::for_each(objective_gradient.begin(), objective_gradient.end(), tame);
    std::for_each(constraint_gradient.begin(), constraint_gradient.end(), tame);
  }
};

double objective_of(unsigned n, const double* x, double* gradient, void* data) {
  auto& adapter = *static_cast<NloptProblem*>(data);
  adapter.at(x);
  if (gradient != nullptr) std::copy_n(adapter.objective_gradient.begin(), n, gradient);
  return adapter.objective;
}

void constraints_of(unsigned, double* result, unsigned, const double* x, double* gradient, void* data) {
  auto& adapter = *static_cast<NloptProblem*>(data);
  adapter.at(x);
  std::copy(adapter.constraint.begin(), adapter.constraint.end(), result);
  if (gradient != nullptr) {
    std::copy(adapter.constraint_gradient.begin(), adapter.constraint_gradient.end(), gradient);
  }
}

}  // namespace

std::optional<LocalSolution> solve_with_nlopt(const LocalProblem& problem, std::span<const double> start) {
  NloptProblem adapter(problem);
  try {
    nlopt::opt solver(nlopt::LD_SLSQP, static_cast<unsigned>(problem.lower.size()));
    solver.set_lower_bounds(problem.lower);
    solver.set_upper_bounds(problem.upper);
    solver.set_min_objective(objective_of, &adapter);
    if (problem.constraints > 0) {
      solver.add_inequality_mconstraint(constraints_of, &adapter, std::vector<double>(problem.constraints, 1e-10));
    }
    solver.set_ftol_rel(1e-13);
    solver.set_xtol_rel(1e-13);
    solver.set_maxeval(200);
    LocalSolution solution{{start.begin(), start.end()}, 0.0};
    for (std::size_t i = 0; i < solution.x.size(); ++i) {
      solution.x[i] = std::clamp(solution.x[i], problem.lower[i], problem.upper[i]);
    }
    solver.optimize(solution.x, solution.objective);
    return solution;
  } catch (const std::exception&) {
    // Rounding stopped it, usually at the optimum: the latest point is still a proposal.
    if (adapter.x.empty()) return std::nullopt;
    return LocalSolution{adapter.x, adapter.objective};
  }
}

}  // namespace millwright::solver
