// SPDX-License-Identifier: Apache-2.0
//
// Collects which formulas with stated limits were evaluated, and where that was outside of them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "mechanics/formula.h"
#include "mechanics/validity_watch.h"

namespace millwright::mechanics {

/// A stated limit of a formula that the arguments break.
struct LeftRange {
  const Formula* formula = nullptr;
  BrokenLimit limit;
  std::vector<ArgumentValue<double>> arguments;
};

/// Each limit of each formula is kept once, with the arguments that break it most (relations between arguments: with
/// the first that break it). Calls in which an argument is not a number are passed over: there data are missing, which
/// the checks say themselves.
class ValidityWatch final : public FormulaWatch {
 public:
  void called(const char* formula, std::initializer_list<WatchedArgument> arguments) override;

  [[nodiscard]] const std::vector<LeftRange>& left() const { return left_; }
  /// Every formula that announced itself.
  [[nodiscard]] const std::set<const Formula*>& formulas() const { return formulas_; }

 private:
  std::vector<LeftRange> left_;
  std::set<const Formula*> formulas_;
};

/// The values as the register takes them.
std::vector<ArgumentValue<double>> argument_values(std::initializer_list<WatchedArgument> arguments);

}  // namespace millwright::mechanics
