// SPDX-License-Identifier: Apache-2.0
//
// Directions (monotonicity.h) that were proved with everything that can be chosen hold for every part of it: who solves
// many parts of one problem (alternatives.h) need not have them proved anew for each. Finding a proof is what most of
// a small solve goes into.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "solver/monotonicity.h"
#include "solver/solver.h"

namespace millwright::solver {

/// Of one stage, with the ranges of states and variables that they were proved for, and what later stages can bear
/// (StagePlan::most_after).
struct StageDirections {
  std::vector<Interval> inherited, variables;
  std::vector<Direction> before, after;
  std::vector<double> most_after;
};

/// What is known of all stages at a combination of shared choices; empty: nothing. What is returned stays where it is.
using DirectionsOf = std::function<std::span<const StageDirections>(std::span<const Row> shared, Desk& desk)>;

/// Proves them when they are asked for the first time. Problem and options have to outlive it.
class ProvedDirections {
 public:
  ProvedDirections(const Problem& problem, const Options& options) : problem_(problem), options_(options) {}

  std::span<const StageDirections> of(std::span<const Row> shared, Desk& desk);

 private:
  const Problem& problem_;
  const Options& options_;
  std::map<std::vector<Row>, std::vector<StageDirections>> known_;
};

}  // namespace millwright::solver
