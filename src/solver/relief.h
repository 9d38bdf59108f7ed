// SPDX-License-Identifier: Apache-2.0
//
// Variables that only decide feasibility, each with constraints of its own: no constraint reads two of them, though all
// may read the variables that are priced. (The time of acceleration of each of several moves is one.) Of such a
// variable some value has to exist, whatever the others are; so a box of the priced variables is infeasible as soon as
// one of them has none, and where a value of it keeps its constraints all over the box nothing but that value need be
// looked at. Divided together, like the others, n of them would take the n-th power of boxes. (A single one is divided
// so: first-order enclosures in it and the others close larger boxes.)
#pragma once

#include <vector>

#include "solver/leaf_point.h"
#include "solver/variable_box.h"

namespace millwright::solver {

class Relief {
 public:
  /// Finds the variables. `design` and what it asks have to outlive it.
  explicit Relief(LeafDesign& design);

  /// Whether a variable is one of them.
  [[nodiscard]] bool has(std::size_t variable) const { return !constraints_[variable].empty(); }

  /// Moves its variables, within the box, to where the worst of their own constraints is small.
  void relieve(std::vector<double>& variables, std::span<const Interval> box) const;

  /// Fixes those variables at these values that then keep their constraints all over the box. True: some were free.
  [[nodiscard]] bool settle(VariableBox& box, std::span<const double> values) const;

  /// Leaves out parts of the variables' sides in which nothing is feasible. False: nothing is in the box.
  [[nodiscard]] bool sieve(VariableBox& box) const;
  /// The same after the parts of one variable have been halved.
  [[nodiscard]] bool refine(VariableBox& box, std::size_t variable) const;
  /// How many parts of a variable's side are left.
  [[nodiscard]] static std::size_t parts(const VariableBox& box, std::size_t variable);
  static constexpr std::size_t most_parts = 4096;  ///< no more are halved
  /// Of a variable's side, what its widest part is.
  [[nodiscard]] static double widest_part(const VariableBox& box, std::size_t variable);

  /// Cuts the parts to the box's sides, and the sides to what is left of them. False: nothing is.
  [[nodiscard]] bool clip(VariableBox& box) const;

  /// The sides without what has been found out about its variables.
  [[nodiscard]] std::vector<Interval> as_given(std::span<const Interval> side) const;

 private:
  [[nodiscard]] bool any_free(std::span<const Interval> side) const;
  [[nodiscard]] bool sieve(VariableBox& box, std::size_t variable) const;
  /// The worst of a variable's constraints.
  template <class Value, class Utilisations>
  [[nodiscard]] double worst_of_own(std::size_t variable, const Utilisations& utilisation, Value&& value) const;
  [[nodiscard]] const Answer<Interval>& bound(std::span<const Interval> side) const;

  LeafDesign& design_;
  std::vector<std::size_t> variables_;
  std::vector<std::vector<std::size_t>> constraints_;  ///< [variable]: that read it, if it is one of them
};

}  // namespace millwright::solver
