// SPDX-License-Identifier: Apache-2.0
#include "evaluation/synthesis.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "evaluation/allowed_time.h"
#include "evaluation/best_build.h"
#include "evaluation/best_front.h"
#include "evaluation/build_identity.h"
#include "solver/alternatives.h"

namespace millwright::evaluation {

Synthesis synthesise(const MachineModel& model, const SearchOptions& asked_for) {
  const AllowedTime time(asked_for.time_limit_seconds);
  SearchOptions options = asked_for;
  // What is left is for the tolerances: a front whose builds are not asked would be worth little.
  if (options.tolerances) options.time_limit_seconds *= options.objectives.size() > 1 ? 0.9 : 0.95;
  Synthesis synthesis;
  synthesis.empty_slots = model.empty_slots();
  if (!synthesis.empty_slots.empty()) return synthesis;
  const bool fastest = options.objectives == std::vector<std::string>{"cycle_time"};
  synthesis.fixed_objective = fastest && is_the_same_for_all(model, "cycle_time");
  solver::Summary summary;
  if (options.builds > 1) {
    solver::BuildIdentity identity;
    if (!model.shops().empty() || !model.counted_parts().empty())
      identity = [&](const solver::Build& build) { return build_identity(model, build); };
    solver::Alternatives best = solver::best_builds(
        model.problem(),
        solver_options(model, options),
        options.builds,
        [&](std::size_t stage, std::size_t slot, solver::Row row) { return model.covering_rows(stage, slot, row); },
        identity);
    summary = std::move(best.first);
    summary.status = best.status;
    summary.builds = std::move(best.builds);
    summary.method += fmt::format(
        "; the next best by splitting what each build leaves into disjoint parts, {} of them solved", best.parts - 1);
    synthesis.proved = best.proved;
  } else {
    summary = options.objectives.size() > 1 ? best_front(model, options) : best_build(model, options);
  }
  for (const std::string& name : options.objectives)
    if (is_left_out(model, options, name)) summary.method += "; every build has the same " + name;
  synthesis.status = summary.status;
  for (const solver::Build& build : summary.builds)
    synthesis.designs.push_back(model.design(build, options.worksheets));
  const std::size_t asked = options.objectives.size() > 1 ? synthesis.designs.size() : 1;
  for (std::size_t i = 0; options.tolerances && i < std::min(asked, synthesis.designs.size()); ++i) {
    Design& design = synthesis.designs[i];
    ToleranceEffort effort;
    effort.seconds = time.left();
    effort.stop = options.stop;
    design.tolerances =
        std::make_shared<const ToleranceCheck>(check_tolerances(model, summary.builds[i], design, effort));
  }
  synthesis.builds = std::move(summary.builds);
  synthesis.lower_bound = summary.lower_bound;
  synthesis.gap = summary.gap;
  synthesis.combinations = summary.combinations;
  synthesis.nodes = summary.nodes;
  synthesis.evaluations = summary.evaluations;
  synthesis.front_tolerance = summary.front_tolerance;
  synthesis.method = summary.method;
  synthesis.seconds = summary.seconds;
  return synthesis;
}

}  // namespace millwright::evaluation
