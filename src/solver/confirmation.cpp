// SPDX-License-Identifier: Apache-2.0
#include "solver/confirmation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/ipopt_solver.h"
#include "solver/nlopt_solver.h"
#include "solver/variable_chain.h"

namespace millwright::solver {
namespace {

constexpr double largest_violation = 1e-6;

}  // namespace

std::vector<Confirmation> confirm(const Problem& problem,
                                  const Criteria& criteria,
                                  const Build& build,
                                  const std::vector<bool>& covered,
                                  const std::function<bool()>& stop) {
  std::vector<Confirmation> result;
  VariableChain chain(problem, criteria, build);
  LocalProblem local = chain.local_problem();
  local.stop = stop;
  const std::vector<double> start = chain.start();
  const double objective = chain.objective_at(start);
  for (std::size_t i = 0; i < problem.stages.size(); ++i) {
    if (!covered[i] || problem.stages[i]->variables().empty()) continue;
    Confirmation confirmation;
    confirmation.stage = i;
    confirmation.variables = build.stages[i].variables;
    confirmation.objective = objective;
    result.push_back(std::move(confirmation));
  }
  if (result.empty()) return result;
  const auto record = [&](const std::optional<LocalSolution>& solution, auto&& store) {
    const bool found = solution && chain.worst_at(solution->x) <= largest_violation;
    const double value = found ? chain.objective_at(solution->x) : std::numeric_limits<double>::quiet_NaN();
    for (Confirmation& c : result) store(c, value, found ? chain.variables_of(c.stage) : std::vector<double>{});
  };
  record(solve_with_ipopt(local, start), [](Confirmation& c, double value, std::vector<double> variables) {
    c.objective_by_ipopt = value;
    c.variables_by_ipopt = std::move(variables);
  });
  record(solve_with_nlopt(local, start), [](Confirmation& c, double value, std::vector<double> variables) {
    c.objective_by_nlopt = value;
    c.variables_by_nlopt = std::move(variables);
  });
  if (stop()) result.clear();
  return result;
}

std::string confirmation_sentence(const std::vector<Confirmation>& confirmations) {
  if (confirmations.empty()) return {};
  const Confirmation& c = confirmations.front();
  const auto said = [&](const char* solver, double objective) {
    if (std::isnan(objective)) return std::string(solver) + " ends without a feasible point";
    char text[96];
    std::snprintf(text, sizeof text, "%s ends at %.9g", solver, objective);
    return std::string(text);
  };
  char found[64];
  std::snprintf(found, sizeof found, "%.9g", c.objective);
  return std::string("; started from the objective found, ") + found + ", " + said("Ipopt", c.objective_by_ipopt) +
         " and " + said("NLopt SLSQP", c.objective_by_nlopt);
}

}  // namespace millwright::solver
