// SPDX-License-Identifier: Apache-2.0
//
// What holds a build's continuous variables back, and what that is worth: with its rows held, the multipliers of Kuhn
// and Tucker at the optimum. They say how the least objective moves when a number of the problem moves a little: as
// the objective plus the multipliers times the constraints does, at the same variables (the envelope theorem).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solver/solver.h"

namespace millwright::solver {

/// The build with its variables moved to where the local solvers find the least objective for its rows: to about 1e-8,
/// where a proof ends at its gap. Never worse than the build by more than that; nothing is proved about it. `stop`, if
/// it is set, is asked now and then: what they have reached by then counts.
Build settled(const Problem& problem,
              const Options& options,
              const Build& build,
              const std::function<bool()>& stop = {});

class Multipliers {
 public:
  /// Of a single objective. `build` must be settled. Nothing where the build is no such point, or the constraints that
  /// hold it depend on each other, so that what each is worth is not determined.
  static std::optional<Multipliers> find(const Problem& problem, const Options& options, const Build& build);

  /// Whether continuous variables move the objective at all.
  [[nodiscard]] bool any_moves() const { return any_moves_; }

  /// A constraint that holds the build back.
  struct Holding {
    std::size_t stage = 0, constraint = 0;  ///< the stage after the last: of the resources that have a limit
    double worth = 0.0;                     ///< of the objective, for its utilisation
  };
  [[nodiscard]] const std::vector<Holding>& holding() const { return holding_; }
  /// (stage, variable): those that move the objective.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& moving() const { return moving_; }

  /// Objective plus multipliers times constraints of a problem of the same form, for these rows in it and the variables
  /// that the multipliers were found at. NaN where the form is another one.
  [[nodiscard]] double lagrangian(const Problem& problem, const Options& options, const Build& build) const;

 private:
  /// Those constraints whose multiplier, by the size of their gradient, is more than `least`.
  void find_holding(const Problem& problem, double least, const std::function<double(std::size_t)>& size);

  std::vector<double> multiplier_;              ///< of the constraints, as in VariableChain
  std::vector<double> at_lower_, at_upper_;     ///< of the variables' bounds
  std::vector<std::vector<double>> variables_;  ///< [stage]
  std::vector<std::pair<std::size_t, std::size_t>> moving_;
  std::vector<Holding> holding_;
  bool any_moves_ = false;
};

}  // namespace millwright::solver
