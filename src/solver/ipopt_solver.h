// SPDX-License-Identifier: Apache-2.0
//
// The interior point method of Ipopt with exact gradients (its quasi-Newton approximation for second derivatives).
// Milliseconds, but it gets out of places where SLSQP gives up. Ipopt's linear solver is not thread-safe: one mutex
// around every call.
#pragma once

#include "solver/local_problem.h"

namespace millwright::solver {

/// The best point found from `start`; nothing when the solver fails. Never throws.
std::optional<LocalSolution> solve_with_ipopt(const LocalProblem& problem, std::span<const double> start);

}  // namespace millwright::solver
