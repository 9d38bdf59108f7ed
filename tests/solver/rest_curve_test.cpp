// SPDX-License-Identifier: Apache-2.0
// What the curves of rest_curve.h and the planes of rest_plane.h promise: no completion of a design costs less than
// they say, whatever was handed on.
#include "solver/rest_curve.h"
#include "solver/rest_plane.h"

#include "catch.h"
#include "sanitized.h"
#include "solver/chains.h"
#include "solver/random_stack.h"

namespace rest_curve_test {

namespace {

using namespace zoo;

/// The plans of a random stack, and how what is said of its rests compares with its chains.
struct Prepared {
  explicit Prepared(unsigned seed)
      : stack(random_stack(seed)),
        problem(stack.problem),
        shared(problem.shared.size(), 0),
        criteria(make_criteria(problem, {})),
        plans(make_plans(problem, shared, criteria, desk)) {}

  Stack stack;
  const Problem& problem;
  std::vector<Row> shared;
  Criteria criteria;
  Desk desk;
  std::vector<StagePlan> plans;
};

struct Comparisons {
  std::size_t made = 0, told_more = 0;

  /// Of a chain of stack `seed` whose stages after `plan` cost `later`.
  void add(
      unsigned seed, const StagePlan& plan, const StagePlan& plain, const std::vector<double>& state, double later) {
    const double rest = rest_after(plan, 0, std::span<const double>(state));
    ++made;
    told_more += rest > plain.rest[0] * (1.0 + 1e-9) ? 1 : 0;
    if (rest > later * (1.0 + 1e-9)) {
      INFO("seed " << seed);
      CHECK(rest <= later);
    }
  }
};

}  // namespace

TEST_CASE("A lower bound of a total is infinity where that of a part is, and else never above the sum") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(total_down(5.0, infinity) == infinity);
  CHECK(total_down(infinity, -5.0) == infinity);
  CHECK(total_down(-infinity, 5.0) == -infinity);
  CHECK(total_down(2.0, 3.0) == 5.0);
  CHECK(total_down(0.1, 0.2) <= 0.3);  // 0.1 + 0.2 is rounded up
  CHECK(total_down(0.1, 0.2) == Approx(0.3).epsilon(1e-15));
}

TEST_CASE("No completion of a design costs less than the rest curves say") {
  Comparisons comparisons;
  std::size_t curves = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 60 : 300); ++seed) {
    Prepared prepared(seed);
    std::vector<StagePlan>& plans = prepared.plans;
    if (plans.empty()) continue;
    const std::vector<StagePlan> plain = plans;
    const std::vector<double> most(prepared.criteria.size(), std::numeric_limits<double>::infinity());
    if (seed % 3 != 1) find_rest_curves(plans, most, CurveEffort{}, prepared.desk);
    const CurveEffort close = seed % 2 == 0 ? CurveEffort::thorough() : CurveEffort::closest();
    if (seed % 3 != 0) find_rest_curves(plans, most, close, prepared.desk);  // on top of them
    for (const StagePlan& plan : plans) curves += plan.curves.size();
    Chains(prepared.problem)
        .run(prepared.shared, [&](std::size_t stage, const std::vector<double>& state, double later, double) {
          comparisons.add(seed, plans[stage], plain[stage], state, later);
        });
  }
  CHECK(comparisons.made > 10000);
  CHECK(curves > (millwright::sanitized ? 5 : 20));
  CHECK(comparisons.told_more > comparisons.made / 100);
}

TEST_CASE("No completion of a design costs less than the planes say, nor is any good design left out") {
  Comparisons comparisons;
  std::size_t left_out = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 60 : 300); ++seed) {
    Prepared prepared(seed);
    std::vector<StagePlan>& plans = prepared.plans;
    if (plans.empty()) continue;
    const std::vector<StagePlan> plain = plans;
    if (seed % 2 == 0)
      find_rest_curves(plans,
                       std::vector<double>(prepared.criteria.size(), std::numeric_limits<double>::infinity()),
                       {},
                       prepared.desk);
    std::vector<StateForm> forms;
    for (const StagePlan& plan : plans) forms.push_back(find_state_form(plan, prepared.desk));
    double best = std::numeric_limits<double>::infinity();
    Chains(prepared.problem)
        .run(prepared.shared, [&](std::size_t stage, const std::vector<double>&, double later, double before) {
          if (stage == 0) best = std::min(best, before + later);
        });
    RestPlanes planes(prepared.problem, plans, forms, prepared.desk);
    planes.find(Mix::only(0), best);
    for (StagePlan& plan : plans) plan.curves.clear();
    std::size_t asked = 0;
    Chains(prepared.problem)
        .run(prepared.shared, [&](std::size_t stage, const std::vector<double>& state, double later, double) {
          if (stage + 1 < plans.size() && asked++ % 97 == 0) planes.find_from(Mix::only(0), later, stage + 1, state);
          comparisons.add(seed, plans[stage], plain[stage], state, later);
        });
    if (best == std::numeric_limits<double>::infinity()) continue;
    const double most = 1.05 * best;
    REQUIRE(planes.restrict_to({{most, std::numeric_limits<double>::infinity()}}));
    const auto rows = [](const std::vector<StagePlan>& of) {
      std::size_t sum = 0;
      for (const StagePlan& plan : of)
        for (const RowSet& set : plan.region.rows) sum += set->size();
      return sum;
    };
    left_out += rows(plain) - rows(plans);
    look_again(prepared.problem, plans, prepared.desk);
    planes.tighten_limits();
    // Every chain that costs no more can still be chosen, and later stages bear what it hands on.
    Chains chains(prepared.problem);
    chains.run(prepared.shared, [&](std::size_t stage, const std::vector<double>& state, double later, double before) {
      if (before + later > most) return;
      CHECK(bearable(plans[stage], state));
      const std::vector<Row>& chosen = chains.rows(stage);
      for (std::size_t slot = 0; slot < chosen.size(); ++slot) {
        const std::vector<Row>& left = plans[stage].region.rows[slot]->all();
        if (std::find(left.begin(), left.end(), chosen[slot]) == left.end()) {
          INFO("seed " << seed << ", stage " << stage << ", slot " << slot);
          CHECK(chosen[slot] == left.front());
        }
      }
    });
  }
  CHECK(comparisons.made > 10000);
  // Few of these stacks share an allowance that binds: none of those that are tried under the sanitizers.
  if (!millwright::sanitized) CHECK(comparisons.told_more > comparisons.made / 500);
  CHECK(left_out > 100);
}

}  // namespace rest_curve_test
