// SPDX-License-Identifier: Apache-2.0
//
// Variables that only decide feasibility, beside others that cost, in groups: no constraint reads variables of two
// groups, though all may read those that cost. (The time of acceleration of each of several moves is a group of one.)
// Of the variables of a group some values have to exist, whatever the others are. So
//   - where values of a group keep its constraints all over a box nothing but those need be looked at there;
//   - a box is infeasible as soon as one group has no values in it: groups of one variable are divided by themselves,
//     into parts of its side, of which those are left out in which nothing is feasible.
// Divided together with the others, n variables would take the n-th power of boxes. (A single one is divided so:
// first-order enclosures in it and the others close larger boxes.)
#pragma once

#include <vector>

#include "solver/leaf_point.h"
#include "solver/variable_box.h"

namespace millwright::solver {

class Relief {
 public:
  /// Finds the groups. `design` and what it asks have to outlive it.
  explicit Relief(LeafDesign& design);

  /// Whether a variable is in a group.
  [[nodiscard]] bool has(std::size_t variable) const { return held_[variable]; }
  /// Whether a variable is divided by itself.
  [[nodiscard]] bool divides(std::size_t variable) const { return divided_[variable]; }

  /// Moves the variables, within the box, to where the worst of their group's constraints is small. `thoroughly`: those
  /// of larger groups, too, by a local solver; else to where that has been last.
  void relieve(std::vector<double>& variables, std::span<const Interval> box, bool thoroughly);

  /// Fixes those groups at these values that then keep their constraints all over the box. True: some were free.
  [[nodiscard]] bool settle(VariableBox& box, std::span<const double> values) const;

  /// Leaves out parts of the variables' sides in which nothing is feasible. False: nothing is in the box.
  [[nodiscard]] bool sieve(VariableBox& box) const;
  /// The same after the parts of one variable have been halved.
  [[nodiscard]] bool refine(VariableBox& box, std::size_t variable) const;
  /// How many parts of a variable's side are left.
  [[nodiscard]] static std::size_t parts(const VariableBox& box, std::size_t variable);
  static constexpr std::size_t most_parts = 1024;  ///< so many are not halved
  /// Of a variable's side, what its widest part is.
  [[nodiscard]] static double widest_part(const VariableBox& box, std::size_t variable);

  /// Cuts the parts to the box's sides, and the sides to what is left of them. False: nothing is.
  [[nodiscard]] bool clip(VariableBox& box) const;

  /// The sides without what has been found out about these variables.
  [[nodiscard]] std::vector<Interval> as_given(std::span<const Interval> side) const;

 private:
  struct Group {
    std::vector<std::size_t> variables, constraints;
    std::vector<double> values = {};  ///< of all variables, where a local solver has moved its own; none: not asked yet
  };
  static bool is_free(const Group& group, std::span<const Interval> side);
  void find_groups(const std::vector<std::size_t>& variables);
  void relieve_single(std::vector<double>& variables, std::span<const Interval> box) const;
  [[nodiscard]] bool sieve(VariableBox& box, std::size_t variable) const;
  [[nodiscard]] const Answer<Interval>& bound(std::span<const Interval> side) const;

  LeafDesign& design_;
  std::vector<Group> groups_;
  std::vector<bool> held_, divided_;  ///< [variable]
};

}  // namespace millwright::solver
