// SPDX-License-Identifier: Apache-2.0
#include "solver/solver.h"

#include "solver/solve_run.h"

namespace millwright::solver {

Summary solve(const Problem& problem, const Options& options) {
  Summary summary = SolveRun(problem, options).run();
  const bool time_is_up =
      summary.seconds >= options.time_limit_seconds || (options.stop != nullptr && options.stop->load());
  if (summary.status != Status::limit || time_is_up || !options.stagewise || options.objectives.size() != 2)
    return summary;
  // What is undecided stage by stage (a point that stands for slightly better ones is refused later on) the other
  // method may settle: it knows the ends of the front first.
  Options other = options;
  other.stagewise = false;
  other.time_limit_seconds -= summary.seconds;
  Summary settled = SolveRun(problem, other).run();
  settled.nodes += summary.nodes;
  settled.evaluations += summary.evaluations;
  settled.seconds += summary.seconds;
  const bool tells_no_more = settled.status == Status::limit && settled.builds.size() <= summary.builds.size();
  return tells_no_more ? summary : settled;
}

}  // namespace millwright::solver
