// SPDX-License-Identifier: Apache-2.0
//
// What there is to choose: the combinations of the choices that all stages share, each searched by itself, and the
// number of everything.
#pragma once

#include <vector>

#include "solver/box.h"
#include "solver/criteria.h"
#include "solver/table_memory.h"

namespace millwright::solver {

/// One combination of shared choices with a cheap lower bound of the scores.
struct Combination {
  std::vector<Row> shared;
  std::vector<double> score;
};

/// All combinations that are not infeasible at first sight, cheapest first.
std::vector<Combination> combinations_of(const Problem& problem,
                                         const Criteria& criteria,
                                         Desk& desk,
                                         TableMemory& tables);

/// Counts the rows of the shared choices up from all zeros, the last choice fastest; false after the last combination,
/// when they are all zeros again.
bool next_combination(const Problem& problem, std::vector<Row>& shared);

/// How many designs there are, continuous variables aside.
double search_space(const Problem& problem);

/// Whether some slot, shared or of a stage, has nothing to choose from.
bool has_empty_slot(const Problem& problem);

}  // namespace millwright::solver
