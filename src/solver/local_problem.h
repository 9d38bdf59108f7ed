// SPDX-License-Identifier: Apache-2.0
//
// A smooth problem in a few variables for the local solvers: minimise f(x) subject to g(x) <= 0 and bounds on x, with
// exact gradients. Local solvers only propose points; whether a point counts is decided by evaluating it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace millwright::solver {

struct LocalProblem {
  std::vector<double> lower, upper;
  std::size_t constraints = 0;
  /// Writes the constraint values, and the gradients when the spans are not empty (constraint by constraint), and
  /// returns the objective.
  std::function<double(std::span<const double> x,
                       std::span<double> constraint,
                       std::span<double> objective_gradient,
                       std::span<double> constraint_gradient)>
      function;
  std::function<bool()> stop = {};  ///< asked now and then, if it is set: what is reached by then is the answer
};

struct LocalSolution {
  std::vector<double> x;
  double objective = 0.0;
};

}  // namespace millwright::solver
