// SPDX-License-Identifier: Apache-2.0
#include "solver/solver.h"

#include <algorithm>
#include <memory>

#include "solver/solve_run.h"

namespace millwright::solver {

Summary solve(const Problem& problem, const Options& options) {
  const auto tables = std::make_shared<TableMemory>();
  Summary first = SolveRun(problem, options, SolveRun::Scope::all, tables).run();
  const bool time_is_up = first.seconds >= options.time_limit_seconds || first.nodes >= options.most_nodes ||
                          (options.stop != nullptr && options.stop->load());
  if (first.status != Status::limit || time_is_up || !options.stagewise || options.objectives.size() != 2) return first;
  // What stage by stage is undecided, or may be missing where points stand for slightly better ones, the other method
  // settles. It starts from the builds known: what they settle is not looked at again.
  Options other = options;
  other.stagewise = false;
  other.time_limit_seconds -= first.seconds;
  other.most_nodes -= std::min(other.most_nodes, first.nodes);
  Summary both = SolveRun(problem, other, SolveRun::Scope::all, tables, first.builds).run();
  both.nodes += first.nodes;
  both.evaluations += first.evaluations;
  both.seconds += first.seconds;
  return both;
}

Summary cover_front(const Problem& problem, const Options& options, std::span<const Build> known) {
  Options widening = options;
  widening.widens = true;
  widening.stagewise = false;  // that method knows nothing of what it has not come to
  return SolveRun(problem, widening, SolveRun::Scope::all, nullptr, known).run();
}

}  // namespace millwright::solver
