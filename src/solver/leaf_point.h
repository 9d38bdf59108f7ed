// SPDX-License-Identifier: Apache-2.0
//
// One design of one stage for one label, with the variables still free: evaluate it, propose points for it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/continuous.h"

namespace millwright::solver {

class LeafDesign {
 public:
  LeafDesign(const LeafQuestion& question, Desk& desk);

  /// Worst utilisation at these variables; the whole answer is in desk.number.
  double worst_at(std::span<const double> variables);
  [[nodiscard]] Point point(std::span<const double> variables) const;

  /// A feasible point inside the box, if one is found by trying or by a local solver.
  std::optional<std::vector<double>> try_points(std::span<const Interval> box);
  std::optional<std::vector<double>> least_violation(std::span<const Interval> box, std::span<const double> start);
  /// From this point on only these variables are moved, to where the worst of these constraints is least. Nothing if
  /// the local solver fails.
  std::optional<std::vector<double>> least_worst(std::span<const Interval> box,
                                                 std::span<const double> start,
                                                 std::span<const std::size_t> moved,
                                                 std::span<const std::size_t> constraints);
  /// A feasible point that makes the weighted sum of scores and good-direction states small.
  std::optional<std::vector<double>> small_worth(std::span<const Interval> box,
                                                 std::span<const double> start,
                                                 bool with_ipopt);
  /// Moves the variables that only decide feasibility, or move one component handed on and nothing else, to a smaller
  /// worst utilisation.
  void relieve(std::vector<double>& variables, std::span<const Interval> box);
  /// The point as an answer of the leaf; false when it is not feasible.
  bool take(std::span<const double> variables, StagePoint& out);
  /// The same whether it is feasible or not, and marked as infeasible; false where it cannot be computed.
  bool take_infeasible(std::span<const double> variables, StagePoint& out);

  const LeafQuestion& question;
  Desk& desk;
  std::vector<Row> rows;

 private:
  void copy_answer(std::span<const double> variables, StagePoint& out);
  void weigh_answer(const Answer<double>& answer, double& value) const;
};

}  // namespace millwright::solver
