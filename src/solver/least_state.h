// SPDX-License-Identifier: Apache-2.0
//
// Where variables move nothing but one component of what is handed on (a ramp that decides how many watts a drive
// takes), and that component has a direction, a design has one best value of it at each state: what can be handed on
// with the variables feasible. So nothing has to be covered within a tolerance (cover.h), and stages of that kind can
// be done stage by stage (stagewise_search.h).
//
// Branch and bound over boxes of the variables, best bound first. It ends where no box can hand on less (or more, if
// more is better) than a feasible point does. Of a figure in whole steps that is so soon; of one that changes with
// every change of a variable it is not, and then the limit of boxes is reached and the answer is a range.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "solver/stage_plan.h"

namespace millwright::solver {

struct LeastState {
  /// What is handed on, the component alone, with the sign turned where more is better. At no state in the range does
  /// a feasible design hand on less than `least`; infinity: none is feasible.
  double least = std::numeric_limits<double>::infinity();
  /// What `variables` hand on at most; infinity: there are none that are known to be feasible at every state.
  double most = std::numeric_limits<double>::infinity();
  std::vector<double> variables = {};

  [[nodiscard]] bool infeasible() const { return least == std::numeric_limits<double>::infinity(); }
  [[nodiscard]] bool universal() const { return most < std::numeric_limits<double>::infinity(); }
};

/// Of one design (`region`: one row per slot) at all these states; `plan.moved_state` says which component. `first`: a
/// point that is tried before all others, if any.
LeastState find_least_state(const StagePlan& plan,
                            std::span<const Interval> states,
                            const Region& region,
                            std::span<const double> first,
                            std::size_t most_boxes,
                            Desk& desk);

enum class LeastPoint { found, infeasible, undecided };
/// The same at one state; `variables` are set where they are found.
LeastPoint find_least_point(const StagePlan& plan,
                            std::span<const double> state,
                            const Region& region,
                            std::span<const double> first,
                            std::vector<double>& variables,
                            Desk& desk);

}  // namespace millwright::solver
