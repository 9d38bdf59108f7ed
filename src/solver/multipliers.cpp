// SPDX-License-Identifier: Apache-2.0
#include "solver/multipliers.h"

#include <Eigen/Dense>
#include <cmath>

#include "solver/ipopt_solver.h"
#include "solver/nlopt_solver.h"
#include "solver/variable_chain.h"

namespace millwright::solver {
namespace {

constexpr double active = 1e-5;      ///< a constraint so near to its limit holds
constexpr double at_bound = 1e-7;    ///< of a variable's range
constexpr double stationary = 1e-4;  ///< of the objective's gradient may be left over
constexpr double at_rest = 1e-6;     ///< a gradient below it is that of an optimum inside its bounds
constexpr double no_slope = 1e-12;   ///< a slope below it, of what is of the order of 1

/// A column of the conditions: the gradient of something that holds.
struct Column {
  enum class Kind { constraint, lower, upper } kind = Kind::constraint;
  std::size_t index = 0;
};

/// What keeps the objective from falling: constraints at their limit, variables at an end of their range.
std::vector<Column> columns_that_hold(const std::vector<double>& x,
                                      const std::vector<double>& constraint,
                                      const std::vector<double>& jacobian) {
  const std::size_t n = x.size();
  std::vector<Column> columns;
  for (std::size_t c = 0; c < constraint.size(); ++c) {
    const Eigen::Map<const Eigen::VectorXd> row(jacobian.data() + c * n, static_cast<Eigen::Index>(n));
    if (constraint[c] > -active && row.norm() > no_slope) columns.push_back({Column::Kind::constraint, c});
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (x[j] < at_bound) columns.push_back({Column::Kind::lower, j});
    if (x[j] > 1.0 - at_bound) columns.push_back({Column::Kind::upper, j});
  }
  return columns;
}

/// Of what holds, one a column; `n` variables.
Eigen::MatrixXd gradients_of(const std::vector<Column>& columns, const std::vector<double>& jacobian, std::size_t n) {
  const auto rows = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd held(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    auto column = held.col(static_cast<Eigen::Index>(k));
    const auto unit = Eigen::VectorXd::Unit(rows, static_cast<Eigen::Index>(columns[k].index));
    if (columns[k].kind == Column::Kind::constraint)
      column = Eigen::Map<const Eigen::VectorXd>(jacobian.data() + columns[k].index * n, rows);
    if (columns[k].kind == Column::Kind::lower) column = -unit;
    if (columns[k].kind == Column::Kind::upper) column = unit;
  }
  return held;
}

}  // namespace

Build settled(const Problem& problem, const Options& options, const Build& build, const std::function<bool()>& stop) {
  constexpr double violation = 1e-7;
  const Criteria criteria = make_criteria(problem, options);
  VariableChain chain(problem, criteria, build);
  if (chain.free().empty()) return build;
  LocalProblem local = chain.local_problem();
  local.stop = stop;
  std::vector<double> best = chain.start();
  double least = chain.objective_at(best);
  // Each goes on from where the other ended: SLSQP ends sharply, Ipopt gets away from where SLSQP is stuck.
  for (const auto& solver : {solve_with_nlopt, solve_with_ipopt, solve_with_nlopt}) {
    const auto solution = solver(local, best);
    if (!solution || chain.worst_at(solution->x) > violation) continue;
    const double objective = chain.objective_at(solution->x);
    if (objective < least) {
      least = objective;
      best = solution->x;
    }
  }
  chain.objective_at(best);
  Build result = build;
  std::vector<double> state = problem.first_state;
  std::fill(result.resources.begin(), result.resources.end(), 0.0);
  Answer<double> answer;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    result.stages[i].variables = chain.variables_of(i);
    result.stages[i].inherited = state;
    problem.stages[i]->evaluate({result.shared, state, result.stages[i].rows, result.stages[i].variables}, answer);
    for (std::size_t r = 0; r < result.resources.size(); ++r) result.resources[r] += answer.resources[r];
    state = answer.handed_on;
  }
  return result;
}

void Multipliers::find_holding(const Problem& problem, double least, const std::function<double(std::size_t)>& size) {
  std::size_t first = 0;
  for (std::size_t i = 0; i <= problem.stages.size(); ++i) {
    const std::size_t count = i < problem.stages.size() ? problem.stages[i]->constraints() : multiplier_.size() - first;
    for (std::size_t c = 0; c < count; ++c)
      if (multiplier_[first + c] > least / size(first + c)) holding_.push_back({i, c, multiplier_[first + c]});
    first += count;
  }
}

std::optional<Multipliers> Multipliers::find(const Problem& problem, const Options& options, const Build& build) {
  const Criteria criteria = make_criteria(problem, options);
  VariableChain chain(problem, criteria, build);
  chain.local_problem();  // sets the scale
  const std::size_t n = chain.free().size(), m = chain.constraints();
  const std::vector<double> x = chain.start();
  std::vector<double> constraint(m), gradient(n), jacobian(n * m);
  Multipliers result;
  if (n > 0) chain.evaluate(x, constraint, gradient, jacobian);
  const auto row = [&](std::size_t c) {
    return Eigen::Map<const Eigen::VectorXd>(jacobian.data() + c * n, static_cast<Eigen::Index>(n));
  };
  const Eigen::Map<const Eigen::VectorXd> slope(gradient.data(), static_cast<Eigen::Index>(n));
  result.multiplier_.assign(m, 0.0);
  result.at_lower_.assign(n, 0.0);
  result.at_upper_.assign(n, 0.0);
  for (const StageChoice& stage : build.stages) result.variables_.push_back(stage.variables);
  for (std::size_t j = 0; j < n; ++j)
    if (std::fabs(gradient[j]) > no_slope) result.moving_.emplace_back(chain.free()[j].stage, chain.free()[j].index);
  result.any_moves_ = !result.moving_.empty();
  if (!result.any_moves_) return result;

  if (std::any_of(constraint.begin(), constraint.end(), [](double g) { return g > active; })) return std::nullopt;
  const std::vector<Column> columns = columns_that_hold(x, constraint, jacobian);
  if (columns.empty()) return slope.norm() <= at_rest ? std::optional(result) : std::nullopt;
  // What is left over of a gradient is compared with the objective, which is of the order of 1, where it is small.
  const double left_over = std::max(stationary * slope.norm(), at_rest);
  const Eigen::MatrixXd held = gradients_of(columns, jacobian, n);
  // Their sizes differ by what units they come from; which of them depend on each other does not hang on that.
  const Eigen::VectorXd size = held.colwise().norm();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(held * size.cwiseInverse().asDiagonal());
  if (factors.rank() < held.cols()) return std::nullopt;
  const Eigen::VectorXd worth = factors.solve(-slope).cwiseQuotient(size);
  if ((held * worth + slope).norm() > left_over) return std::nullopt;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    if (worth[at] * size[at] < -left_over) return std::nullopt;  // moving away from it would be better
    const double value = std::max(0.0, worth[at]) * chain.scale();
    auto& of_kind = columns[k].kind == Column::Kind::constraint ? result.multiplier_
                    : columns[k].kind == Column::Kind::lower    ? result.at_lower_
                                                                : result.at_upper_;
    of_kind[columns[k].index] = value;
  }
  result.find_holding(problem, stationary * slope.norm() * chain.scale(), [&](std::size_t c) { return row(c).norm(); });
  return result;
}

double Multipliers::lagrangian(const Problem& problem, const Options& options, const Build& build) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (problem.stages.size() != variables_.size()) return none;
  Build there = build;
  for (std::size_t i = 0; i < there.stages.size(); ++i) {
    if (problem.stages[i]->variables().size() != variables_[i].size()) return none;
    there.stages[i].variables = variables_[i];
  }
  const Criteria criteria = make_criteria(problem, options);
  VariableChain chain(problem, criteria, there);
  if (chain.constraints() != multiplier_.size() || chain.free().size() != at_lower_.size()) return none;
  const std::vector<double> x = chain.start();
  std::vector<double> constraint(chain.constraints());
  double sum = chain.evaluate(x, constraint, {}, {});
  for (std::size_t c = 0; c < constraint.size(); ++c)
    if (multiplier_[c] != 0.0) sum += multiplier_[c] * constraint[c];
  // Bounds that have moved, on the scale of the range that they make.
  for (std::size_t j = 0; j < x.size(); ++j) sum += at_lower_[j] * -x[j] + at_upper_[j] * (x[j] - 1.0);
  return sum;
}

}  // namespace millwright::solver
