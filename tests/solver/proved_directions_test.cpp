// SPDX-License-Identifier: Apache-2.0
//
// Directions that were proved of random stacks, taken over by parts of them: designs sampled there change as they say.
#include "solver/proved_directions.h"

#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/random_stack.h"
#include "solver/restricted_problem.h"
#include "solver/stage_plan.h"

namespace proved_directions_test {

namespace {

using namespace zoo;

Options by_cost() {
  Options options;
  options.objectives = {0};
  options.ties = {1};
  return options;
}

/// Each row with even chances, of every slot at least one.
Restriction random_part(const Problem& problem, std::mt19937& random) {
  Restriction part = unrestricted(problem);
  const auto thin_out = [&](std::vector<Row>& rows) {
    const Row kept = rows[random() % rows.size()];
    std::erase_if(rows, [&](Row row) { return row != kept && random() % 2 == 0; });
  };
  for (std::vector<Row>& rows : part.shared) thin_out(rows);
  for (StageRestriction& stage : part.stages)
    for (std::vector<Row>& rows : stage.allowed) thin_out(rows);
  return part;
}

double between(std::mt19937& random, const Interval& range) {
  if (!(range.upper > range.lower)) return range.lower;
  return range.lower + (range.upper - range.lower) * static_cast<double>(random() >> 8U) / 16777216.0;
}

/// Whether `to` is as good as `from`, in this direction.
bool is_as_good(Direction direction, double to, double from) {
  const double rounding = 1e-9 * std::fabs(from);
  switch (direction) {
    case Direction::smaller_is_better:
      return to <= from + rounding;
    case Direction::larger_is_better:
      return to >= from - rounding;
    case Direction::equal_only:
      return std::fabs(to - from) <= rounding;
    default:
      return true;
  }
}

bool is_feasible(const Answer<double>& answer) {
  return std::all_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u <= 1.0 + 1e-9; });
}

/// Designs of a stage that are feasible with one state, and with a better one.
class Samples {
 public:
  Samples(const StagePlan& plan, std::mt19937& random) : plan_(plan), random_(random) {}

  /// Compares one; whether it is feasible with the worse state.
  bool compare(std::size_t component) {
    std::vector<Row> rows;
    std::vector<double> variables, worse;
    for (const RowSet& set : plan_.region.rows)
      rows.push_back(*(set->begin() + static_cast<int>(random_() % set->size())));
    for (const Interval& range : plan_.region.variables) variables.push_back(between(random_, range));
    for (const Interval& range : plan_.inherited) worse.push_back(between(random_, range));
    std::vector<double> better = worse;
    better[component] = between(random_, plan_.inherited[component]);
    if (!is_as_good(plan_.before[component], better[component], worse[component]))
      std::swap(better[component], worse[component]);
    Answer<double> with_worse, with_better;
    plan_.stage->evaluate(Point{plan_.shared, worse, rows, variables}, with_worse);
    if (!is_feasible(with_worse)) return false;
    plan_.stage->evaluate(Point{plan_.shared, better, rows, variables}, with_better);
    CAPTURE(plan_.stage->name(), component, worse[component], better[component]);
    CHECK(is_feasible(with_better));
    for (std::size_t r = 0; r < with_worse.resources.size(); ++r)
      if (plan_.criteria->reads(r))
        CHECK(is_as_good(Direction::smaller_is_better, with_better.resources[r], with_worse.resources[r]));
    for (std::size_t s = 0; s < with_worse.handed_on.size(); ++s)
      CHECK(is_as_good(plan_.after[s], with_better.handed_on[s], with_worse.handed_on[s]));
    return true;
  }

 private:
  const StagePlan& plan_;
  std::mt19937& random_;
};

}  // namespace

TEST_CASE("Directions of a problem hold for its parts, which ask for less") {
  std::size_t compared = 0, asked = 0, asked_alone = 0;
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 20U : 400U); ++seed) {
    const Stack stack = random_stack(seed);
    const Options options = by_cost();
    ProvedDirections proved(stack.problem, options);
    std::mt19937 random(seed);
    for (int i = 0; i < 3; ++i) {
      const Restriction restriction = random_part(stack.problem, random);
      const RestrictedProblem part(stack.problem, restriction);
      const Criteria criteria = make_criteria(part.problem(), options);
      std::vector<Row> shared(part.problem().shared.size(), 0);
      Desk alone, together;
      make_plans(part.problem(), shared, criteria, alone);
      TableMemory tables;
      std::vector<Row> in_whole;
      for (const std::vector<Row>& rows : restriction.shared) in_whole.push_back(rows.front());
      Desk first;
      proved.of(in_whole, first);
      tables.known_directions = [&](std::span<const Row>, Desk& desk) { return proved.of(in_whole, desk); };
      const std::vector<StagePlan> plans = make_plans(part.problem(), shared, criteria, together, tables);
      asked += together.bounds;
      asked_alone += alone.bounds;
      CAPTURE(seed, i);
      for (const StagePlan& plan : plans)
        for (std::size_t c = 0; c < plan.before.size(); ++c) {
          if (plan.before[c] == Direction::equal_only) continue;
          Samples samples(plan, random);
          for (int sample = 0; sample < 100; ++sample) compared += samples.compare(c) ? 1 : 0;
        }
    }
  }
  CHECK(compared > (millwright::sanitized ? 100U : 10000U));
  if (!millwright::sanitized) CHECK(asked < asked_alone);
}

TEST_CASE("Directions that are known are not proved again") {
  const Stack stack = random_stack(1);
  const Options options = by_cost();
  ProvedDirections proved(stack.problem, options);
  const std::vector<Row> shared(stack.problem.shared.size(), 0);
  Desk first, second;
  const auto found = proved.of(shared, first);
  CHECK(found.size() == stack.problem.stages.size());
  CHECK(first.bounds > 0);
  CHECK(proved.of(shared, second).data() == found.data());
  CHECK(second.bounds == 0);
}

}  // namespace proved_directions_test
