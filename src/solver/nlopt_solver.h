// SPDX-License-Identifier: Apache-2.0
//
// Sequential quadratic programming (SLSQP) of NLopt: microseconds for a few variables, so it is asked first.
#pragma once

#include "solver/local_problem.h"

namespace millwright::solver {

/// The best point found from `start`; nothing when the solver fails. Never throws.
std::optional<LocalSolution> solve_with_nlopt(const LocalProblem& problem, std::span<const double> start);

}  // namespace millwright::solver
