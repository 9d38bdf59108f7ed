// SPDX-License-Identifier: Apache-2.0
//
// Labels at the end of all stages as builds: their choices, and variables moved to where nothing is near its limit.
#include <algorithm>

#include "solver/easing.h"
#include "solver/leaf_point.h"
#include "solver/neighbours.h"
#include "solver/stagewise_search.h"

namespace millwright::solver {

void StagewiseSearch::finish(const Label& label) {
  RankedBuild ranked;
  ranked.score = label.score;
  ranked.build = build_of(label);
  incumbents_.offer(std::move(ranked));
}

/// The choices of a label from the tool on. Variables that only decide feasibility are moved to where the worst
/// utilisation is small; that changes neither scores nor states.
Build StagewiseSearch::build_of(const Label& last) {
  Build build;
  build.shared.assign(plans_.front().shared.begin(), plans_.front().shared.end());
  build.stages.resize(plans_.size());
  build.resources = last.resources;
  const Label* label = &last;
  for (std::size_t stage = plans_.size(); stage-- > 0;) {
    const Label& before = labels_[stage][label->parent];
    build.stages[stage] = StageChoice{label->rows, label->variables, before.state};
    relieve(stage, before, build.stages[stage], build.worst_utilisation);
    label = &before;
  }
  take_stock(build);
  ease(problem_, criteria_, plans_, build, control_.desk(0));
  return build;
}

/// Totals that are no scores may hang on what has been moved. (That only makes the worst utilisation smaller, so what
/// was feasible is.)
void StagewiseSearch::take_stock(Build& build) const {
  Build moved = build;
  if (Neighbours(problem_).evaluate(moved)) build = std::move(moved);
}

void StagewiseSearch::relieve(std::size_t stage, const Label& before, StageChoice& choice, double& utilisation) {
  const StagePlan& plan = plans_[stage];
  const Region region = region_of(*plan.stage, plan.shared, choice.rows, plan.region.variables);
  const LeafQuestion question{&plan, &before, &region, 0.0, true, {}};
  LeafDesign design(question, control_.desk(0));
  if (!plan.moved_state) design.relieve(choice.variables, region.variables);  // else see easing.h
  utilisation = std::max(utilisation, design.worst_at(choice.variables));
}

}  // namespace millwright::solver
