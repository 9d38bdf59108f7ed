// SPDX-License-Identifier: Apache-2.0
//
// The designs of one stage that can matter to any of many labels, found once for all of them.
//
// The labels come in groups of alike states; H is the range of states of a group. Branch and bound over row sets, with
// bounds over H:
//   - a region is dropped when it is infeasible at every state in H, or when what it adds to the first two scores is
//     too much for every label (`useful`; `corners`, with what must follow on what it hands on: rest_curve.h);
//   - a design is *universal* when some fixed values of its variables (or all of them) keep every utilisation <= 1 over
//     all of H: it is feasible for every label. A region is dropped when a universal design is at least as good in
//     every coordinate of the comparison. Regions are taken in ascending order of a sum of all coordinates, so that
//     what dominates is found before what it dominates, but for equal sums (and in quick passes, which prove nothing);
//   - where variables move one component handed on and nothing else, of a design the least of it counts: bounds of that
//     over all of H, and the values of the variables that are best at its worst (least_state.h);
//   - a set of designs for which no value of the variables is left, or none that is of use, is dropped as a whole
//     (set_proofs.h);
//   - a design that is neither infeasible nor universal is kept: whether it is feasible is decided label by label.
// Nothing about feasibility is assumed between one state and another; the wider H, the more designs are not universal.
//
// What is true of a region at the states of several groups is found once for all of them: a region is bounded over the
// hull of the ranges of those groups that it may still matter to, and dropped group by group. Only a single design that
// is not proved feasible over all of that, or any region after very many, is looked at for fewer groups.
// (candidate_groups.h carries bounds over a hull to each of its groups.)
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "solver/staircase.h"
#include "solver/state_form.h"

namespace millwright::solver {

struct CandidateQuestion {
  const StagePlan* plan = nullptr;
  const StateForm* form = nullptr;
  const Comparison* comparison = nullptr;
  std::vector<Interval> states;  ///< H
  std::vector<Pair> useful;      ///< upper staircase of own shares of the first two scores
  Pair least = {};               ///< of the labels' first two scores
  std::vector<Pair> corners;     ///< upper staircase of totals: with `least`, and what must follow, below some of it
  /// What must be added to own shares of score and state for a total: the least of all labels with what must follow
  /// (planes and staircases of rest_plane.h), as if they arrived with a state of nothing but zeros.
  std::vector<RestPlane> totals = {};
  std::vector<RestStairs> total_stairs = {};
  RestVectors total_vectors = {};  ///< the same of vectors: of labels with what must follow
  std::function<bool()> stop;      ///< asked now and then
  std::size_t patience = std::numeric_limits<std::size_t>::max();  ///< nodes after which it is given up: incomplete
  /// For quick first answers, not for a proof: so many nodes at most, and what a handed-on component weighs in the
  /// order in which they are taken (empty: next to nothing).
  std::size_t node_limit = std::numeric_limits<std::size_t>::max();
  std::vector<double> state_weight = {};
  std::optional<Mix> mix = std::nullopt;  ///< what they are taken in the order of, where there are two objectives
};

struct Candidate {
  std::vector<Row> rows;
  std::vector<double> variables;   ///< feasible at every state of H when universal
  std::vector<double> score;       ///< own share, the least in H
  std::vector<double> most_score;  ///< the same at most; no more where no score depends on the state
  std::vector<double> least;       ///< handed on from the reference state, wherever in H what is not linear is
  std::vector<double> most;        ///< the same at most; no more where the form is exact
  std::vector<double> key;         ///< of score and state: the best
  bool universal = false;
  bool is_least = true;  ///< at no state in H other variables hand on less of what they move (least_state.h)
};

struct CandidateSet {
  std::vector<double> reference;  ///< the state in H at which states are compared
  std::vector<Candidate> candidates;
  std::uint64_t nodes = 0;
  bool complete = true;
};

/// One set for each question. The questions are about one stage; they differ in the labels (their states, scores, and
/// what must follow on them), neighbours least. Patience, node limit (of one question; twice that for several), mix and
/// order are those of the first. The first set says how many nodes were looked at for all.
std::vector<CandidateSet> find_candidates(std::span<const CandidateQuestion* const> questions, Desk& desk);

}  // namespace millwright::solver
