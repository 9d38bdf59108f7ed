// SPDX-License-Identifier: Apache-2.0
//
// Builds that differ from a feasible one in a single row, with the same values of the continuous variables: a cheap
// source of feasible builds, and so of upper bounds. Not all of them are looked at, and what is passed over proves
// nothing.
#pragma once

#include "solver/incumbents.h"

namespace millwright::solver {

class Neighbours {
 public:
  explicit Neighbours(const Problem& problem) : problem_(problem) {}

  /// Called with a feasible build; answers the value of the objective above which no more are wanted.
  using Visitor = std::function<double(const Build&)>;
  void visit(const Build& build, std::size_t objective, const Visitor& visitor) const;

  /// What is to be small, of the totals of a build.
  using Value = std::function<double(std::span<const double> resources)>;
  /// A feasible build that no change of a single row looked at makes better: from `build`, which must be feasible, slot
  /// by slot to the best row there. Its worst utilisation is not worked out. `stop` is asked now and then.
  [[nodiscard]] Build improved(Build build, const Value& value, const std::function<bool()>& stop) const;
  /// The same for what decides between equals, without becoming worse in an objective.
  void improve_equals(const Criteria& criteria, RankedBuild& best, const std::function<bool()>& stop) const;
  [[nodiscard]] double worst_utilisation(const Build& build) const;
  /// Works out the states and totals of a build whose rows fit; false if it is not feasible.
  bool evaluate(Build& build) const { return complete(build, 0, std::vector<double>(problem_.resources.size(), 0.0)); }

 private:
  /// The best row of one slot, if it is better than the build's own. `before`: what the stages before add.
  [[nodiscard]] bool improve_slot(
      Build& build, std::size_t stage, std::size_t slot, const std::vector<double>& before, const Value& value) const;
  [[nodiscard]] bool fits(const Build& build, std::size_t stage) const;
  /// Evaluates `build` from `stage` on, whose inherited state is known; false if it is not feasible.
  bool complete(Build& build, std::size_t stage, std::vector<double> resources) const;

  const Problem& problem_;
};

}  // namespace millwright::solver
