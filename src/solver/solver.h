// SPDX-License-Identifier: Apache-2.0
//
// Exact optimum and exact Pareto front of a chain of stages. Options in, summary out.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/stage.h"

namespace millwright::solver {

struct Progress {
  double lower_bound = 0.0;
  double incumbent = 0.0;  ///< +infinity while none is known
  double elapsed_seconds = 0.0;
  std::uint64_t nodes = 0;
};

struct Options {
  std::vector<std::size_t> objectives{0};  ///< resource indices: one for an optimum, two or more for a front
  std::vector<double> weights;    ///< for a weighted single objective over all resources; empty = objectives[0] alone
  std::vector<std::size_t> ties;  ///< resources compared next when the objective is equal, in order
  double gap = 1e-6;              ///< relative gap at which the proof counts as complete
  double front_tolerance = 1e-3;  ///< of a front where continuous variables move the objectives (stagewise_search.h)
  double time_limit_seconds = std::numeric_limits<double>::infinity();
  bool stagewise = true;  ///< one or two objectives stage by stage where that applies, else always label by label
  /// Nodes that a single objective is at most searched label by label before stage by stage; and that a search label by
  /// label to the end takes before it is worked out closely what all that is to come adds (rest_curve.h). Eight times
  /// as many are spent on what little is left before a limit is priced.
  std::uint64_t patience = 25000;
  /// Designs of a stage looked at, or combined with what came before, from which on a pass stage by stage is given up
  /// and shared allowances are priced first (rest_plane.h).
  std::uint64_t stage_patience = 30000;
  /// Labels in alike states from which on they divide the regions of a stage together (shared_regions.h): of a front,
  /// and of a single objective that continuous variables move.
  std::size_t labels_together = 4, labels_together_for_one = 32;
  bool look_first = true;  ///< for good builds, before what takes long; objectives and ties do not depend on it
  bool confirm = true;     ///< ask the local solvers about variables that move the objective (confirmation.h)
  unsigned threads = 1;    ///< the answer does not depend on it
  const std::atomic<bool>* stop = nullptr;  ///< set by Ctrl-C: end as for the time limit
  std::function<void(const Progress&)> progress;
  double progress_interval_seconds = 0.1;  ///< not more often
  /// Where continuous variables move a single objective: the best in `ties` is looked for by a search of its own, of at
  /// most half as many nodes as the first took and 6000 more, and no more than four times as many and 500. Else, and
  /// without, among neighbours of the answer only.
  bool settle_ties = true;
  /// Nodes at which a search ends as for the time limit; of the two methods of a front the second gets what the first
  /// has left. Searches that a solve begins with and ends with (by other objectives, among equals) have a count of
  /// their own, and each of those that find the price of a limit may take what is left.
  std::uint64_t most_nodes = std::numeric_limits<std::uint64_t>::max();
  /// A front is searched more and more coarsely, the more of its time or its nodes is used up (cover_front).
  bool widens = false;
  /// A single objective with a limit on another total, which takes long, is searched with a price on what is limited
  /// (limit_prices.cpp). To find that takes many searches; answers do not depend on it.
  bool price_limits = true;

  /// Of a front: no finer than the gap.
  [[nodiscard]] double tolerance_of_front() const { return std::max(front_tolerance, gap); }
};

/// The choices of one stage in a build.
struct StageChoice {
  std::vector<Row> rows;
  std::vector<double> variables;
  std::vector<double> inherited;  ///< the state this stage received
};

struct Build {
  std::vector<Row> shared;
  std::vector<StageChoice> stages;
  std::vector<double> resources;  ///< totals
  double worst_utilisation = 0.0;
};

enum class Status { optimal, infeasible, limit };

/// What local solvers, started from the answer, said of its continuous variables (confirmation.h). The objectives are
/// totals of the whole build; NaN when a solver ended without a feasible point.
struct Confirmation {
  std::size_t stage = 0;          ///< whose variables move the objective
  std::vector<double> variables;  ///< of that stage, as answered
  std::vector<double> variables_by_ipopt, variables_by_nlopt;
  double objective = 0.0, objective_by_ipopt = 0.0, objective_by_nlopt = 0.0;
};

struct Summary {
  Status status = Status::infeasible;
  std::vector<Build> builds;  ///< one for an optimum; the whole front, ascending in the first objective
  double lower_bound = 0.0;   ///< of the objective (single objective)
  double gap = 0.0;           ///< (incumbent - lower_bound)/|incumbent|
  double combinations = 0.0;  ///< size of the discrete search space
  std::uint64_t nodes = 0;
  std::uint64_t evaluations = 0;
  /// To which a front is covered (Options::front_tolerance), 0 = exact: for every feasible design some build, less this
  /// part of each of its objectives, is no worse. Of one that a limit has ended, what was proved by then; infinity:
  /// nothing.
  double front_tolerance = 0.0;
  std::string method;  ///< a sentence for the certificate
  /// Of a single objective that continuous variables move; else empty, and where time was up.
  std::vector<Confirmation> confirmations;
  double seconds = 0.0;
};

/// Solves the problem exactly (see branch_and_bound.h and labels.h for how).
Summary solve(const Problem& problem, const Options& options);

/// A front of which `solve` has not come to the end in its time, from builds of it that are known, all feasible. Its
/// tolerance rises from the one asked for to a fifth while time, or Options::most_nodes, is used up, so that something
/// is proved: Summary::front_tolerance. A front that is no closer than asked for has Status::limit.
Summary cover_front(const Problem& problem, const Options& options, std::span<const Build> known);

}  // namespace millwright::solver
