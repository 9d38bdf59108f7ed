// SPDX-License-Identifier: Apache-2.0
#include "solver/variable_chain.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {

VariableChain::VariableChain(const Problem& problem, const Criteria& criteria, const Build& build)
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
  for (std::size_t r = 0; r < problem.resources.size(); ++r)
    if (std::isfinite(problem.resources[r].limit)) limited_.push_back(r);
  constraints_ += limited_.size();
}

std::vector<double> VariableChain::start() const {
  std::vector<double> x;
  for (const FreeVariable& f : free_) x.push_back((build_.stages[f.stage].variables[f.index] - f.lower) / f.range);
  return x;
}

LocalProblem VariableChain::local_problem() {
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

double VariableChain::objective_at(std::span<const double> x) {
  std::vector<double> constraint(constraints_);
  return scale_ * evaluate(x, constraint, {}, {});
}

double VariableChain::worst_at(std::span<const double> x) {
  std::vector<double> constraint(constraints_);
  evaluate(x, constraint, {}, {});
  return constraint.empty() ? 0.0 : *std::max_element(constraint.begin(), constraint.end());
}

double VariableChain::evaluate(std::span<const double> x,
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
  const std::size_t first_limit = constraints_ - limited_.size();
  for (std::size_t k = 0; k < limited_.size(); ++k) constraint[first_limit + k] = -1.0;
  for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
    const Point at{build_.shared, state, build_.stages[i].rows, values_[i]};
    const Answer<double> answer = desk_.evaluate(*problem_.stages[i], at);
    for (std::size_t r = 0; r < answer.resources.size(); ++r) objective += criteria_.weight[0][r] * answer.resources[r];
    for (std::size_t c = 0; c < answer.utilisation.size(); ++c) {
      constraint[row + c] = std::min(answer.utilisation[c], 1e6) - 1.0;
    }
    for (std::size_t k = 0; k < limited_.size(); ++k)
      constraint[first_limit + k] += answer.resources[limited_[k]] / problem_.resources[limited_[k]].limit;
    if (!gradient.empty()) differentiate(i, at, row);
    row += answer.utilisation.size();
    state = answer.handed_on;
  }
  return objective / scale_;
}

/// Adds what one stage contributes to the derivatives, directly and through the state it inherits.
void VariableChain::differentiate(std::size_t stage, const Point& at, std::size_t row) {
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

void VariableChain::add_slopes(const Answer<double>& slope, std::size_t column, double factor, std::size_t row) {
  for (std::size_t r = 0; r < slope.resources.size(); ++r) {
    gradient_[column] += criteria_.weight[0][r] * slope.resources[r] * factor / scale_;
  }
  for (std::size_t k = 0; k < limited_.size(); ++k)
    jacobian_[(constraints_ - limited_.size() + k) * free_.size() + column] +=
        slope.resources[limited_[k]] / problem_.resources[limited_[k]].limit * factor;
  for (std::size_t c = 0; c < slope.utilisation.size(); ++c) {
    jacobian_[(row + c) * free_.size() + column] += slope.utilisation[c] * factor;
  }
  for (std::size_t h = 0; h < next_slope_.size(); ++h) next_slope_[h][column] += slope.handed_on[h] * factor;
}

}  // namespace millwright::solver
