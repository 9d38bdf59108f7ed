// SPDX-License-Identifier: Apache-2.0
//
// Both local solvers on problem 71 of Hock and Schittkowski (1981): optimum 17.0140173.
#include "catch.h"
#include "solver/ipopt_solver.h"
#include "solver/nlopt_solver.h"

namespace local_solver_test {

namespace {

using namespace millwright::solver;

/// min x0 x3 (x0 + x1 + x2) + x2, product >= 25, sum of squares = 40 (as two inequalities), 1 <= x <= 5.
LocalProblem hock_schittkowski_71() {
  LocalProblem problem;
  problem.lower.assign(4, 1.0);
  problem.upper.assign(4, 5.0);
  problem.constraints = 2;
  problem.function = [](auto x, auto constraint, auto gradient, auto jacobian) {
    const double sum = x[0] + x[1] + x[2];
    constraint[0] = 25.0 - x[0] * x[1] * x[2] * x[3];
    // At the optimum the sphere presses from outside: >= 40 would be free, <= 40 is active.
    constraint[1] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3] - 40.0;
    gradient[0] = x[3] * (sum + x[0]);
    gradient[1] = x[0] * x[3];
    gradient[2] = x[0] * x[3] + 1.0;
    gradient[3] = x[0] * sum;
    for (std::size_t i = 0; i < 4; ++i) {
      jacobian[i] = -x[0] * x[1] * x[2] * x[3] / x[i];
      jacobian[4 + i] = 2.0 * x[i];
    }
    return x[0] * x[3] * sum + x[2];
  };
  return problem;
}

TEST_CASE("SLSQP and Ipopt solve Hock-Schittkowski 71") {
  const LocalProblem problem = hock_schittkowski_71();
  const std::vector<double> start{1.0, 5.0, 5.0, 1.0};
  for (const auto& solution : {solve_with_nlopt(problem, start), solve_with_ipopt(problem, start)}) {
    REQUIRE(solution.has_value());
    CHECK(solution->objective == Approx(17.0140173).epsilon(1e-7));
    CHECK(solution->x[1] == Approx(4.7429994).epsilon(1e-5));
    CHECK(solution->x[2] == Approx(3.8211503).epsilon(1e-5));
  }
}

TEST_CASE("A function that cannot be computed does not bring a local solver down") {
  LocalProblem problem;
  problem.lower = {0.0};
  problem.upper = {1.0};
  problem.function = [](auto, auto, auto gradient, auto) {
    gradient[0] = std::numeric_limits<double>::quiet_NaN();
    return std::numeric_limits<double>::quiet_NaN();
  };
  const std::vector<double> start{0.5};
  CHECK_NOTHROW(solve_with_nlopt(problem, start));
  CHECK_NOTHROW(solve_with_ipopt(problem, start));
}

}  // namespace

}  // namespace local_solver_test
