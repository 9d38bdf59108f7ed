// SPDX-License-Identifier: Apache-2.0
//
// The rows of a build with its continuous variables free: one smooth problem through the whole chain of stages. The
// objective's total, every utilisation and every limit of a resource <= 1, derivatives by the chain rule from
// Stage::gradient. The local solvers see the variables on a scale from 0 to 1.
#pragma once

#include <span>
#include <vector>

#include "solver/box.h"
#include "solver/criteria.h"
#include "solver/local_problem.h"
#include "solver/solver.h"

namespace millwright::solver {

/// One continuous variable of the chain that has a range.
struct FreeVariable {
  std::size_t stage = 0, index = 0;
  double lower = 0.0, range = 0.0;
};

class VariableChain {
 public:
  /// All three must outlive the chain.
  VariableChain(const Problem& problem, const Criteria& criteria, const Build& build);

  [[nodiscard]] const std::vector<FreeVariable>& free() const { return free_; }
  /// Of the stages, one after the other, then of the resources that have a limit.
  [[nodiscard]] std::size_t constraints() const { return constraints_; }
  /// The build's own variables, from 0 to 1.
  [[nodiscard]] std::vector<double> start() const;
  /// For the local solvers; the objective in units of what it is at the start.
  LocalProblem local_problem();
  double objective_at(std::span<const double> x);
  double worst_at(std::span<const double> x);
  /// As of the latest point that was asked about.
  [[nodiscard]] std::vector<double> variables_of(std::size_t stage) const { return values_[stage]; }
  /// Writes every constraint less 1 and, where the spans are not empty, the gradients (constraint by constraint);
  /// returns the objective in units of `scale`.
  double evaluate(std::span<const double> x,
                  std::span<double> constraint,
                  std::span<double> gradient,
                  std::span<double> jacobian);
  [[nodiscard]] double scale() const { return scale_; }

 private:
  void differentiate(std::size_t stage, const Point& at, std::size_t row);
  void add_slopes(const Answer<double>& slope, std::size_t column, double factor, std::size_t row);

  const Problem& problem_;
  const Criteria& criteria_;
  const Build& build_;
  std::vector<FreeVariable> free_;
  std::vector<std::vector<double>> values_;  ///< [stage][variable]
  std::vector<std::size_t> limited_;         ///< resources that have a limit
  std::size_t constraints_ = 0;
  double scale_ = 1.0;
  Desk desk_;
  std::span<double> gradient_, jacobian_;
  std::vector<std::vector<double>> state_slope_, next_slope_;  ///< [component][free variable]
};

}  // namespace millwright::solver
