// SPDX-License-Identifier: Apache-2.0
//
// What is left when every slot of a stage has one row: the continuous variables.
//
// 1. Variables that only decide feasibility (the acceleration time of an axis): one feasible point is enough, or the
//    proof that there is none. Points are tried first (the middle, ends), then boxes are bisected, most promising
//    first; a box is closed when `bound` proves a violation in it. Of the feasible points one with small worst
//    utilisation is taken (a local search: a choice between equals, nothing is claimed about it).
// 2. Variables that move one component handed on and nothing else (a ramp that decides how many watts a drive takes):
//    one best point (least_state.h). What that leaves undecided is covered like the rest:
// 3. Variables that move scores or state (the diameter of a shaft): branch and bound on the box until every design in
//    it is proved infeasible, hopeless, or covered: a known feasible point is, in every score and every state component
//    with a direction, at most `tolerance` (relative) worse than the box can be; of an inexact label also by some
//    tolerances more, where that leaves open what is feasible, or by what it leaves open itself, where that is refined
//    later. What a point covers becomes the enclosure of its label. Points come from SLSQP (and Ipopt where SLSQP finds
//    none), so few boxes are needed. Several variables beside them that only decide feasibility are settled, and
//    divided, in groups that share no constraint (relief.h).
//
// Guarantee: a point counts as feasible only if `evaluate` in double gives every utilisation <= 1. A feasible set
// narrower than 1e-12 of a variable's range may be overlooked. What the box limit leaves undecided is returned as
// `undecided`, with its lower bound, and ends up in the reported gap.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "solver/labels.h"
#include "solver/stage_plan.h"

namespace millwright::solver {

struct LeafQuestion {
  const StagePlan* plan = nullptr;
  const Label* label = nullptr;
  const Region* region = nullptr;  ///< one row per slot
  double tolerance = 1e-6;         ///< for variables that move scores or state
  bool relieve = true;             ///< move variables that only decide feasibility to a small worst utilisation
  /// Whether designs of this stage with at least these scores (own share), this state and utilisation are of no use.
  std::function<bool(const Worth&)> hopeless = {};
  std::function<bool()> stop = {};      ///< asked now and then; what is left then counts as undecided
  std::span<const OpenBox> among = {};  ///< of variables that move scores or state: nothing else is looked at, if any
  /// What is left open a search with a finer tolerance decides: it is told in which boxes that is, and what an inexact
  /// label stands for is handed on where its point breaks a constraint.
  bool refined_later = false;
  /// Tried first, where one best point is looked for (least_state.h); none: nothing is known.
  std::span<const double> start = {};
};

/// A point of a stage, feasible but for those of `refined_later`, and what it stands for.
struct StagePoint {
  std::vector<double> variables;
  std::vector<double> resources;    ///< own share
  std::vector<double> score_lower;  ///< own share, of everything it stands for
  std::vector<double> state;
  std::vector<Interval> enclosure;
  std::vector<OpenBox> boxes = {};  ///< that it stands for, itself among them, if that is refined later
  double utilisation = 0.0;
  bool exact = true;
  bool feasible = true;  ///< false: of an inexact label, and only designs that it stands for may be feasible
};

struct LeafAnswer {
  std::vector<StagePoint> points;
  bool undecided = false;
  std::vector<double> undecided_score;        ///< least own share of what is undecided
  std::vector<OpenBox> undecided_boxes = {};  ///< where it is, if that is refined later

  /// Adds something of at least these scores to what is undecided.
  void leave_undecided(std::span<const double> score);
};

LeafAnswer solve_leaf(const LeafQuestion& question, Desk& desk);

}  // namespace millwright::solver
