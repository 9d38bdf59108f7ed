// SPDX-License-Identifier: Apache-2.0
// First-order enclosures must lose no feasible design: points of random boxes of random axes, by single evaluations.
#include "solver/box_slopes.h"

#include <algorithm>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/random_stack.h"

namespace box_slopes_test {

namespace {

using namespace zoo;

struct Tried {
  int boxes = 0, feasible = 0, narrowed = 0, empty = 0, raised = 0;
};

/// A part of an interval; often all of it.
Interval part_of(std::mt19937& rng, const Interval& whole) {
  const double a = uniform(rng, whole.lower, whole.upper), b = uniform(rng, whole.lower, whole.upper);
  return rng() % 3 == 0 ? whole : Interval(std::min(a, b), std::max(a, b));
}

/// One box of one design of a stage, and points in it.
void try_box(std::mt19937& rng, const StagePlan& plan, Desk& desk, Tried& tried) {
  const Stage& stage = *plan.stage;
  std::vector<Row> rows;
  for (const Slot& slot : stage.slots()) rows.push_back(static_cast<Row>(rng() % slot.rows));
  Label label;
  label.score_lower.assign(plan.criteria->size(), 0.0);
  for (const Interval& range : plan.inherited) {
    label.state.push_back(uniform(rng, range.lower, range.upper));
    label.enclosure.emplace_back(label.state.back());
  }
  VariableBox box;
  for (const Variable& variable : stage.variables())
    box.side.push_back(part_of(rng, Interval(variable.lower, variable.upper)));
  const Region region = region_of(stage, plan.shared, rows, box.side);
  read_bounds(plan, desk.bound(stage, plan.shared, label.enclosure, region), box.bounds);
  const LeafQuestion question{&plan, &label, &region, 1e-6, true, {}, {}};
  const BoxSlopes slopes(question, box, desk);
  std::vector<Interval> side = box.side;
  const bool some = slopes.narrow(side);
  Bounds raised = box.bounds;
  if (some) slopes.raise(side, raised);
  ++tried.boxes;
  tried.empty += some ? 0 : 1;
  tried.raised += some && raised.score[0] > box.bounds.score[0] * (1.0 + 1e-9) ? 1 : 0;
  for (std::size_t v = 0; v < side.size(); ++v)
    tried.narrowed += some && width(side[v]) < 0.999 * width(box.side[v]) ? 1 : 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<double> at;
    for (const Interval& range : box.side) at.push_back(i == 0 ? range.lower : uniform(rng, range.lower, range.upper));
    const Answer<double>& answer = desk.evaluate(stage, Point{plan.shared, label.state, rows, at});
    if (worst_of(answer.utilisation) > 1.0) continue;
    ++tried.feasible;
    REQUIRE(some);
    for (std::size_t v = 0; v < at.size(); ++v) CHECK(contains(side[v], at[v]));
    std::vector<double> score(plan.criteria->size());
    plan.criteria->scores<double>(answer.resources, score);
    for (std::size_t k = 0; k < score.size(); ++k) CHECK(raised.score[k] <= score[k] * (1.0 + 1e-12));
    for (std::size_t s = 0; s < answer.handed_on.size(); ++s)
      if (plan.after[s] != Direction::irrelevant) {
        const double slack = 1e-12 * std::fabs(answer.handed_on[s]);
        CHECK(raised.handed_on[s].lower <= answer.handed_on[s] + slack);
        CHECK(answer.handed_on[s] <= raised.handed_on[s].upper + slack);
      }
  }
}

}  // namespace

TEST_CASE("First-order enclosures hold where constraints read two variables at once") {
  Tried tried;
  std::mt19937 rng(11);
  for (int beam = 0; beam < (millwright::sanitized ? 20 : 150); ++beam) {
    // Load and price of bars; a beam's bending falls with width * height^2, its slenderness rises with height / width.
    Columns bars{"bar", 2, {}};
    for (int i = 0; i < 3; ++i)
      for (const double most : {4.0, 3.0}) bars.numbers.push_back(uniform(rng, 0.3, most));
    const double slender = uniform(rng, 1.0, 4.0);
    const auto stage =
        model_stage("beam", {&bars}, {{"width", 0.4, 2.0}, {"height", 0.4, 3.0}}, 2, [&](const auto& in, auto& out) {
          const auto &w = in.variable(0), &h = in.variable(1);
          out.utilisation.push_back(in.row(0, 0) * (1.0 + in.state(0)) / (w * h * h));
          out.utilisation.push_back(h / (w * slender));
          out.resources.push_back(in.row(0, 1) * (w * h) + w);
          out.resources.push_back(w * h);
          out.handed_on.push_back(in.state(0) + w * h);
        });
    Problem problem;
    problem.stages = {&stage};
    problem.first_state = {uniform(rng, 0.0, 1.0)};
    problem.resources = {{"cost"}, {"mass"}};
    Options options;
    options.objectives = {0, 1};
    const Criteria criteria = make_criteria(problem, options);
    Desk desk;
    for (const StagePlan& plan : make_plans(problem, {}, criteria, desk))
      for (int i = 0; i < 40; ++i) try_box(rng, plan, desk, tried);
  }
  INFO(tried.boxes << " boxes, " << tried.feasible << " feasible points, " << tried.narrowed << " sides narrower, "
                   << tried.empty << " empty, " << tried.raised << " with a higher bound");
  CHECK(tried.feasible > 5 * tried.boxes);
  CHECK(10 * tried.narrowed > tried.boxes);
  CHECK(tried.empty > 0);
  CHECK(15 * tried.raised > tried.boxes);
}

TEST_CASE("First-order enclosures of a box hold all of its feasible designs") {
  Tried tried;
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 60U : 400U); ++seed) {
    const Stack stack = random_stack(seed);
    Options options;
    options.objectives = {0, 1};
    const Criteria criteria = make_criteria(stack.problem, options);
    const std::vector<Row> shared(stack.problem.shared.size(), 0);
    Desk desk;
    std::mt19937 rng(seed);
    for (const StagePlan& plan : make_plans(stack.problem, shared, criteria, desk))
      for (int i = 0; i < 12; ++i) try_box(rng, plan, desk, tried);
  }
  INFO(tried.boxes << " boxes, " << tried.feasible << " feasible points, " << tried.narrowed << " sides narrower, "
                   << tried.empty << " empty, " << tried.raised << " with a higher bound");
  // Else nothing was tried.
  CHECK(tried.feasible > 5 * tried.boxes);
  CHECK(30 * tried.narrowed > tried.boxes);
  CHECK(tried.empty > 0);
  CHECK(100 * tried.raised > tried.boxes);
}

}  // namespace box_slopes_test
