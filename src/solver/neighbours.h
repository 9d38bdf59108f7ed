// SPDX-License-Identifier: Apache-2.0
//
// Builds that differ from a feasible one in a single row, with the same values of the continuous variables: a cheap
// source of feasible builds, and so of upper bounds. Not all of them are looked at, and what is passed over proves
// nothing.
#pragma once

#include "solver/solver.h"

namespace millwright::solver {

class Neighbours {
 public:
  explicit Neighbours(const Problem& problem) : problem_(problem) {}

  /// Called with a feasible build; answers the value of the objective above which no more are wanted.
  using Visitor = std::function<double(const Build&)>;
  void visit(const Build& build, std::size_t objective, const Visitor& visitor) const;

 private:
  [[nodiscard]] bool fits(const Build& build, std::size_t stage) const;
  /// Evaluates `build` from `stage` on, whose inherited state is known; false if it is not feasible.
  bool complete(Build& build, std::size_t stage, std::vector<double> resources) const;

  const Problem& problem_;
};

}  // namespace millwright::solver
