// SPDX-License-Identifier: Apache-2.0
//
// A second opinion on the continuous part of an answer. With the rows of a build fixed, all its continuous variables
// are one smooth problem through the whole chain of stages: the objective's total, every utilisation <= 1, derivatives
// by the chain rule from Stage::gradient. Ipopt and NLopt's SLSQP both start from the build; where the proof is right,
// neither finds anything better than the lower bound allows. Nothing of this enters the proof.
#pragma once

#include <functional>
#include <vector>

#include "solver/criteria.h"
#include "solver/solver.h"

namespace millwright::solver {

/// `covered`: per stage, whether its variables move the objective. One entry for each such stage that has variables.
/// A local solver that ends with a violation above 1e-6 has found nothing: its objective is NaN. Where `stop`, which is
/// asked now and then, ends it nothing is said at all.
std::vector<Confirmation> confirm(const Problem& problem,
                                  const Criteria& criteria,
                                  const Build& build,
                                  const std::vector<bool>& covered,
                                  const std::function<bool()>& stop);

/// For the certificate: what the local solvers said of the build; empty without confirmations.
std::string confirmation_sentence(const std::vector<Confirmation>& confirmations);

}  // namespace millwright::solver
