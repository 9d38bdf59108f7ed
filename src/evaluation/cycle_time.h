// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "evaluation/ledger.h"
#include "machine/problem.h"

namespace millwright::evaluation {

/// How long the machine's cycle takes with the ramps of a design [s]: what objectives count as cycle_time, whether they
/// do or not.
double cycle_time(const machine::Problem& problem, const Design& design);

}  // namespace millwright::evaluation
