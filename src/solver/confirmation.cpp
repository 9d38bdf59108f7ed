// SPDX-License-Identifier: Apache-2.0
#include "solver/confirmation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/box.h"
#include "solver/ipopt_solver.h"
#include "solver/nlopt_solver.h"

namespace millwright::solver {
namespace {

constexpr double largest_violation = 1e-6;

/// One continuous variable of the chain; the local solvers see it on a scale from 0 to 1.
struct FreeVariable {
  std::size_t stage = 0, index = 0;
  double lower = 0.0, range = 0.0;
};

/// The rows of a build with its variables free.
class Chain {
 public:
  Chain(const Problem& problem, const Criteria& criteria, const Build& build)
      : problem_(problem), criteria_(criteria), build_(build) {
    for (std::size_t i = 0; i < problem.stages.size(); ++i) {
      const auto variables = problem.stages[i]->variables();
      values_.push_back(build.stages[i].variables);
      for (std::size_t v = 0; v < variables.size(); ++v) {
        const double range = variables[v].upper - variables[v].lower;
        if (range > 0.0) free_.push_back({i, v, variables[v].lower, range});
      }
      constraints_ += problem.stages[i]->constraints();
    }
  }

  [[nodiscard]] std::vector<double> start() const {
    std::vector<double> x;
    for (const FreeVariable& f : free_) x.push_back((build_.stages[f.stage].variables[f.index] - f.lower) / f.range);
    return x;
  }

  LocalProblem local_problem() {
    LocalProblem local;
    local.lower.assign(free_.size(), 0.0);
    local.upper.assign(free_.size(), 1.0);
    local.constraints = constraints_;
    scale_ = 1.0;
    scale_ = std::max(std::fabs(objective_at(start())), 1e-9);
    local.function = [this](auto x, auto constraint, auto gradient, auto jacobian) {
      return evaluate(x, constraint, gradient, jacobian);
    };
    return local;
  }

  double objective_at(std::span<const double> x) {
    std::vector<double> constraint(constraints_);
    return scale_ * evaluate(x, constraint, {}, {});
  }
  double worst_at(std::span<const double> x) {
    std::vector<double> constraint(constraints_);
    evaluate(x, constraint, {}, {});
    return constraint.empty() ? 0.0 : *std::max_element(constraint.begin(), constraint.end());
  }
  [[nodiscard]] std::vector<double> variables_of(std::size_t stage) const { return values_[stage]; }

 private:
  double evaluate(std::span<const double> x,
                  std::span<double> constraint,
                  std::span<double> gradient,
                  std::span<double> jacobian);
  void differentiate(std::size_t stage, const Point& at, std::size_t row);
  void add_slopes(const Answer<double>& slope, std::size_t column, double factor, std::size_t row);

  const Problem& problem_;
  const Criteria& criteria_;
  const Build& build_;
  std::vector<FreeVariable> free_;
  std::vector<std::vector<double>> values_;  ///< [stage][variable]
  std::size_t constraints_ = 0;
  double scale_ = 1.0;
  Desk desk_;
  std::span<double> gradient_, jacobian_;
  std::vector<std::vector<double>> state_slope_, next_slope_;  ///< [component][free variable]
};

double Chain::evaluate(std::span<const double> x,
                       std::span<double> constraint,
                       std::span<double> gradient,
                       std::span<double> jacobian) {
  for (std::size_t j = 0; j < free_.size(); ++j) {
    const FreeVariable& f = free_[j];
    values_[f.stage][f.index] = f.lower + x[j] * f.range;
  }
  gradient_ = gradient;
  jacobian_ = jacobian;
  std::fill(gradient.begin(), gradient.end(), 0.0);
  std::fill(jacobian.begin(), jacobian.end(), 0.0);
  std::vector<double> state = problem_.first_state;
  state_slope_.assign(state.size(), std::vector<double>(free_.size(), 0.0));
  double objective = 0.0;
  std::size_t row = 0;
  for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
    const Point at{build_.shared, state, build_.stages[i].rows, values_[i]};
    const Answer<double> answer = desk_.evaluate(*problem_.stages[i], at);
    for (std::size_t r = 0; r < answer.resources.size(); ++r) objective += criteria_.weight[0][r] * answer.resources[r];
    for (std::size_t c = 0; c < answer.utilisation.size(); ++c) {
      constraint[row + c] = std::min(answer.utilisation[c], 1e6) - 1.0;
    }
    if (!gradient.empty()) differentiate(i, at, row);
    row += answer.utilisation.size();
    state = answer.handed_on;
  }
  return objective / scale_;
}

/// Adds what one stage contributes to the derivatives, directly and through the state it inherits.
void Chain::differentiate(std::size_t stage, const Point& at, std::size_t row) {
  next_slope_.assign(state_slope_.size(), std::vector<double>(free_.size(), 0.0));
  for (std::size_t j = 0; j < free_.size(); ++j) {
    if (free_[j].stage != stage) continue;
    add_slopes(
        desk_.gradient(*problem_.stages[stage], at, {Input::Kind::variable, free_[j].index}), j, free_[j].range, row);
  }
  for (std::size_t c = 0; c < state_slope_.size(); ++c) {
    const auto& through = state_slope_[c];
    if (std::all_of(through.begin(), through.end(), [](double s) { return s == 0.0; })) continue;
    const auto& slope = desk_.gradient(*problem_.stages[stage], at, {Input::Kind::inherited, c});
    for (std::size_t j = 0; j < free_.size(); ++j) {
      if (through[j] != 0.0) add_slopes(slope, j, through[j], row);
    }
  }
  state_slope_.swap(next_slope_);
}

void Chain::add_slopes(const Answer<double>& slope, std::size_t column, double factor, std::size_t row) {
  for (std::size_t r = 0; r < slope.resources.size(); ++r) {
    gradient_[column] += criteria_.weight[0][r] * slope.resources[r] * factor / scale_;
  }
  for (std::size_t c = 0; c < slope.utilisation.size(); ++c) {
    jacobian_[(row + c) * free_.size() + column] += slope.utilisation[c] * factor;
  }
  for (std::size_t h = 0; h < next_slope_.size(); ++h) next_slope_[h][column] += slope.handed_on[h] * factor;
}

}  // namespace

std::vector<Confirmation> confirm(const Problem& problem,
                                  const Criteria& criteria,
                                  const Build& build,
                                  const std::vector<bool>& priced) {
  std::vector<Confirmation> result;
  Chain chain(problem, criteria, build);
  const LocalProblem local = chain.local_problem();
  const std::vector<double> start = chain.start();
  const double objective = chain.objective_at(start);
  for (std::size_t i = 0; i < problem.stages.size(); ++i) {
    if (!priced[i] || problem.stages[i]->variables().empty()) continue;
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
