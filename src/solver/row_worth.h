// SPDX-License-Identifier: Apache-2.0
//
// What a build of a problem is worth at least when it has a certain row: what that row's stage then adds, and what
// every other stage adds at least. Found once for a problem it holds for every part of it, and rows that are too dear
// for what is asked of a part can be left out before it is solved.
#pragma once

#include "solver/proved_directions.h"
#include "solver/solver.h"

namespace millwright::solver {

/// For one combination of shared choices.
struct RowWorth {
  std::vector<Row> shared;
  double least = 0.0;                                  ///< of all builds
  std::vector<std::vector<std::vector<double>>> rows;  ///< [stage][slot][row]; +infinity: in no feasible build
};

/// Lower bounds of the options' single objective, for every combination of shared choices that may be feasible. Long
/// tables are cut into sets of alike rows as long as the bound over a set is not above `most`: what is dearer is only
/// known to be so. Empty when there are too many combinations to be worth it, and when time is up (the options' limit,
/// from now on, or stop). `known`: what a larger problem says of its stages.
std::vector<RowWorth> row_worths(const Problem& problem,
                                 const Options& options,
                                 double most,
                                 std::uint64_t& evaluations,
                                 const DirectionsOf& known = {});

}  // namespace millwright::solver
