// SPDX-License-Identifier: Apache-2.0
//
// The search against exhaustive enumeration (enumeration.h) on seeded random stacks: optimum by cost, optimum by mass
// and the (cost, mass) front.
#include <cstdlib>

#include "catch.h"
#include "sanitized.h"
#include "solver/enumeration.h"

namespace random_stack_test {

namespace {

using namespace zoo;

/// As many as fit into a test; MILLWRIGHT_RANDOM_STACKS=20000 tries more when the search has been changed.
const unsigned instances = [] {
  const char* asked = std::getenv("MILLWRIGHT_RANDOM_STACKS");
  return asked != nullptr        ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10))
         : millwright::sanitized ? 30U
                                 : 600U;
}();

bool same(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance * std::fabs(b); }

Options by(std::vector<std::size_t> objectives, std::vector<std::size_t> ties) {
  Options options;
  options.objectives = std::move(objectives);
  options.ties = std::move(ties);
  options.gap = 1e-7;
  options.confirm = false;  // thousands of Ipopt runs; confirmation_test.cpp tries it
  return options;
}

/// The builds are a front: feasible, none better than the exact front, and the exact front nowhere better by more than
/// the spacing (0 without a free diameter).
void check_front(const Summary& found, const std::vector<Total>& exact, double spacing) {
  if (spacing < 1e-9) REQUIRE(found.builds.size() == exact.size());
  for (const Total& point : exact) {
    REQUIRE(std::any_of(found.builds.begin(), found.builds.end(), [&](const Build& build) {
      return build.resources[0] <= point.cost * (1.0 + spacing) && build.resources[1] <= point.mass * (1.0 + spacing);
    }));
  }
  for (const Build& build : found.builds) {
    REQUIRE(std::any_of(exact.begin(), exact.end(), [&](const Total& point) {
      return point.cost <= build.resources[0] * (1.0 + 1e-9) && point.mass <= build.resources[1] * (1.0 + 1e-9);
    }));
  }
}

/// Every stage evaluated from the first state on: utilisations, totals and states as stated.
void check_build(const Stack& stack, const Build& build, bool with_fits = true) {
  std::vector<double> state = stack.problem.first_state;
  std::vector<double> total(stack.problem.resources.size(), 0.0);
  double worst = 0.0;
  Answer<double> answer;
  for (std::size_t i = 0; i < stack.axes.size(); ++i) {
    const StageChoice& choice = build.stages[i];
    REQUIRE(choice.inherited == state);
    stack.axes[i]->evaluate(Point{build.shared, state, choice.rows, choice.variables}, answer);
    for (const double u : answer.utilisation) worst = std::max(worst, u);
    for (std::size_t r = 0; r < total.size(); ++r) total[r] += answer.resources[r];
    if (with_fits) REQUIRE(stack.axes[i]->fits(build.shared, 1, choice.rows[1], 2, choice.rows[2]));
    state = answer.handed_on;
  }
  REQUIRE(worst <= 1.0);
  REQUIRE(worst == build.worst_utilisation);
  REQUIRE(total == build.resources);
  REQUIRE(total[1] <= stack.problem.resources[1].limit);
}

constexpr std::size_t never = 1000000;

/// All methods for fronts find the same points: also when shared allowances are priced at once, and when labels divide
/// regions together or never do.
void check_same_front(
    const Stack& stack, const Everything& all, const Summary& front, bool stagewise, std::size_t labels_together) {
  Options options = by({0, 1}, {});
  options.stagewise = stagewise;
  options.stage_patience = 0;
  options.labels_together = labels_together;
  if (labels_together == 1) options.patience = 10;  // then with closer curves of what is to come
  const Summary other = solve(stack.problem, options);
  REQUIRE(other.status == front.status);
  if (stack.priced) {  // points within the spacing of each other may differ
    if (!all.designs.empty()) check_front(other, all.front(), 1.001e-3);
    return;
  }
  REQUIRE(other.builds.size() == front.builds.size());
  for (std::size_t i = 0; i < front.builds.size(); ++i) {
    REQUIRE(same(front.builds[i].resources[0], other.builds[i].resources[0], 1e-11));
    REQUIRE(same(front.builds[i].resources[1], other.builds[i].resources[1], 1e-11));
  }
}

/// Stage by stage at once, that with priced allowances, and never, with labels that divide regions by themselves or
/// together: the same least cost, and among designs of that cost the same least mass.
void check_both_methods(const Stack& stack, const Everything& all, const Summary& cheapest) {
  double mass = std::numeric_limits<double>::infinity();
  for (const Total& total : all.designs) {
    if (same(total.cost, all.least(&Total::cost), 1e-12)) mass = std::min(mass, total.mass);
  }
  for (const int method : {0, 1, 2, 3}) {
    if (method == 3 && !stack.priced) continue;  // nothing is shared
    Options options = by({0}, {1});
    options.stagewise = method < 2;
    options.patience = 0;
    if (method == 1) options.stage_patience = 0;
    if (method == 3) options.labels_together_for_one = 1;
    const Summary other = solve(stack.problem, options);
    REQUIRE(other.status == cheapest.status);
    if (all.designs.empty()) continue;
    REQUIRE(same(other.builds[0].resources[0], all.least(&Total::cost), stack.priced ? 2e-7 : 1e-10));
    if (!stack.priced) REQUIRE(same(other.builds[0].resources[1], mass, 1e-10));
    check_build(stack, other.builds[0]);
  }
}

void check_stack(const Stack& stack, const Everything& all) {
  const Summary cheapest = solve(stack.problem, by({0}, {1}));
  const Summary lightest = solve(stack.problem, by({1}, {0}));
  const Summary front = solve(stack.problem, by({0, 1}, {}));
  const Status expected = all.designs.empty() ? Status::infeasible : Status::optimal;
  REQUIRE(cheapest.status == expected);
  REQUIRE(lightest.status == expected);
  REQUIRE(front.status == expected);
  check_same_front(stack, all, front, true, never);
  for (const std::size_t labels_together : {std::size_t{1}, never})
    check_same_front(stack, all, front, false, labels_together);
  check_both_methods(stack, all, cheapest);
  if (all.designs.empty()) return;
  const double tolerance = stack.priced ? 2e-7 : 1e-10;
  REQUIRE(same(cheapest.builds[0].resources[0], all.least(&Total::cost), tolerance));
  REQUIRE(same(lightest.builds[0].resources[1], all.least(&Total::mass), tolerance));
  REQUIRE(cheapest.lower_bound <= all.least(&Total::cost) * (1.0 + 1e-12));
  check_build(stack, cheapest.builds[0]);
  check_build(stack, lightest.builds[0]);
  check_front(front, all.front(), stack.priced ? 1.001e-3 : 1e-10);
  for (const Build& build : front.builds) check_build(stack, build);
}

TEST_CASE("A front that one method leaves open is settled by the other") {
  // Found among 10,000 random stacks: a free diameter whose stand-in is too heavy for a later stage.
  const Stack stack = random_stack(9560);
  const Everything all = Enumeration(stack).run();
  REQUIRE(all.margin > 1e-9);
  check_stack(stack, all);
}

TEST_CASE("Cost, mass and front of random stacks equal exhaustive enumeration") {
  unsigned tested = 0;
  unsigned infeasible = 0;
  unsigned greedy_fails = 0;
  unsigned priced = 0;
  unsigned not_monotone = 0;
  for (unsigned seed = 1; tested < instances; ++seed) {
    const Stack stack = random_stack(seed);
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9) continue;  // on the edge bisection to 1e-9 decides nothing
    CAPTURE(seed, stack.priced, stack.monotone);
    check_stack(stack, all);
    ++tested;
    priced += stack.priced ? 1 : 0;
    not_monotone += stack.monotone ? 0 : 1;
    if (all.designs.empty())
      ++infeasible;
    else if (!all.greedy_cost || *all.greedy_cost > all.least(&Total::cost) * (1.0 + 1e-9))
      ++greedy_fails;
  }
  CHECK(infeasible >= instances / 5);
  CHECK(greedy_fails >= instances / 4);
  CHECK(priced >= instances / 10);
  CHECK(not_monotone >= instances / 5);
}

/// The stack of a seed with a stage of its own for a shaft of free diameter, without slots, after its first axis.
Stack stack_with_shaft_stage(unsigned seed) {
  const Stack stack = random_stack(seed);
  Stack result;
  result.problem = stack.problem;
  result.problem.stages.clear();
  result.monotone = stack.monotone;
  result.priced = true;
  const auto add = [&](Axis axis) {
    result.axes.push_back(std::make_unique<AxisStage>(std::move(axis)));
    result.problem.stages.push_back(result.axes.back().get());
  };
  std::mt19937 rng(seed);
  for (const auto& stage : stack.axes) {
    Axis axis = stage->axis();
    axis.deflection = 0.0;
    Axis shaft;
    shaft.only_shaft = true;
    shaft.length = axis.length;
    shaft.deflection = uniform(rng, 1e-5, 1e-4);
    add(std::move(axis));
    if (stage == stack.axes.front() || rng() % 3 == 0) add(std::move(shaft));
  }
  return result;
}

TEST_CASE("Fronts with a free shaft as a stage of its own equal exhaustive enumeration to the tolerance") {
  unsigned tested = 0;
  unsigned feasible = 0;
  for (unsigned seed = 1; tested < instances / 5; ++seed) {
    const Stack stack = stack_with_shaft_stage(seed);
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-6) continue;
    ++tested;
    CAPTURE(seed);
    // Where a heavier shaft may be wanted (ballast, gravity that helps) all of them must be covered, not the least.
    const std::vector<double> tolerances = stack.monotone ? std::vector{1e-3, 1e-7} : std::vector{1e-2};
    for (const double tolerance : tolerances) {
      Options options = by({0, 1}, {});
      options.front_tolerance = tolerance;
      const Summary front = solve(stack.problem, options);
      REQUIRE(front.status == (all.designs.empty() ? Status::infeasible : Status::optimal));
      // Within the tolerance a later stage may refuse what is a little heavier; the fine one is below every margin.
      if (tolerance < 1e-6) check_front(front, all.front(), 1.001 * tolerance);
      for (const Build& build : front.builds) check_build(stack, build, false);
    }
    feasible += all.designs.empty() ? 0 : 1;
  }
  CHECK(feasible >= tested / 2);
}

TEST_CASE("Fronts to a wide tolerance leave out nothing that is better by more") {
  // What is given up on the way adds up to the tolerance: by points for what is a little better, by labels before each
  // stage, and by builds.
  unsigned feasible = 0;
  unsigned shorter = 0;
  for (unsigned seed = 1; seed <= instances / 5; ++seed) {
    const Stack stack = seed % 2 == 0 ? stack_with_shaft_stage(seed) : random_stack(seed);
    if (!stack.priced || !stack.monotone) continue;
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-6) continue;
    CAPTURE(seed);
    for (const double tolerance : {0.5, 0.1, 0.02}) {
      Options options = by({0, 1}, {});
      options.front_tolerance = tolerance;
      options.stagewise = false;
      options.labels_together = seed % 3 == 0 ? 1 : never;
      const Summary front = solve(stack.problem, options);
      REQUIRE(front.status == (all.designs.empty() ? Status::infeasible : Status::optimal));
      check_front(front, all.front(), tolerance);
      shorter += front.builds.size() < all.front().size() ? 1 : 0;
    }
    feasible += all.designs.empty() ? 0 : 1;
  }
  if (!millwright::sanitized) CHECK(feasible >= instances / 25);
  if (!millwright::sanitized) CHECK(shorter >= instances / 25);
}

TEST_CASE("The number of threads does not change anything in the answer") {
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 20U : 60U); ++seed) {
    const Stack stack = random_stack(seed);
    for (const bool stagewise : {true, false}) {
      Options options = by({0, 1}, {});
      if (seed % (stagewise ? 2 : 4) == 0) options.objectives = {0};
      options.stagewise = stagewise;
      options.labels_together = options.labels_together_for_one = 1;
      const Summary one = solve(stack.problem, options);
      for (const unsigned threads : {2U, 3U}) {
        options.threads = threads;
        const Summary more = solve(stack.problem, options);
        CAPTURE(seed, threads);
        REQUIRE(more.status == one.status);
        REQUIRE(more.nodes == one.nodes);
        REQUIRE(more.builds.size() == one.builds.size());
        for (std::size_t b = 0; b < one.builds.size(); ++b) {
          REQUIRE(more.builds[b].resources == one.builds[b].resources);
          REQUIRE(more.builds[b].shared == one.builds[b].shared);
          for (std::size_t i = 0; i < one.builds[b].stages.size(); ++i) {
            REQUIRE(more.builds[b].stages[i].rows == one.builds[b].stages[i].rows);
            REQUIRE(more.builds[b].stages[i].variables == one.builds[b].stages[i].variables);
          }
        }
      }
    }
  }
}

TEST_CASE("The order of rows in the tables does not change what the answer is worth") {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Stack stack = random_stack(seed);
    Stack turned;
    turned.problem = stack.problem;
    turned.problem.stages.clear();
    for (const auto& stage : stack.axes) {
      Axis axis = stage->axis();
      std::reverse(axis.screws.begin(), axis.screws.end());
      std::rotate(axis.motors.begin(), axis.motors.begin() + 1, axis.motors.end());
      std::rotate(axis.motor_bore.begin(), axis.motor_bore.begin() + 1, axis.motor_bore.end());
      std::reverse(axis.couplings.begin(), axis.couplings.end());
      turned.axes.push_back(std::make_unique<AxisStage>(std::move(axis)));
      turned.problem.stages.push_back(turned.axes.back().get());
    }
    const Summary a = solve(stack.problem, by({0}, {1}));
    const Summary b = solve(turned.problem, by({0}, {1}));
    CAPTURE(seed);
    REQUIRE(a.status == b.status);
    if (a.builds.empty()) continue;
    const double tolerance = stack.priced ? 1e-7 : 1e-12;
    REQUIRE(same(a.builds[0].resources[0], b.builds[0].resources[0], tolerance));
    if (!stack.priced) REQUIRE(same(a.builds[0].resources[1], b.builds[0].resources[1], tolerance));
  }
}

TEST_CASE("The zoo's own bounds and slopes enclose what they claim") {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Stack stack = random_stack(seed);
    std::mt19937 rng(seed);
    for (const auto& stage : stack.axes) {
      std::vector<std::vector<Row>> all;
      std::vector<RowsAlive> spans;
      for (const Slot& slot : stage->slots()) {
        all.emplace_back();
        for (Row row = 0; row < slot.rows; ++row) all.back().push_back(row);
      }
      for (const auto& rows : all) spans.emplace_back(rows);
      std::vector<Interval> variables;
      for (const Variable& v : stage->variables()) variables.emplace_back(v.lower, v.upper);
      const std::vector<Interval> inherited{Interval(0.0, 5.0), Interval(0.0, 100.0)};
      const std::vector<Row> shared(stack.problem.shared.size(), 1);
      Answer<Interval> box;
      Answer<double> point;
      const Box question{shared, inherited, spans, variables};
      const auto inside = [&](const auto& outer, const auto& inner) {
        REQUIRE(outer.size() == inner.size());
        for (std::size_t i = 0; i < outer.size(); ++i) REQUIRE(contains(outer[i], inner[i]));
      };
      for (int sample = 0; sample < 10; ++sample) {
        std::vector<Row> rows;
        for (const auto& slot : all) rows.push_back(slot[rng() % slot.size()]);
        std::vector<double> x;
        for (const Interval& v : variables) x.push_back(uniform(rng, v.lower, v.upper));
        const std::vector<double> state{uniform(rng, 0.0, 5.0), uniform(rng, 0.0, 100.0)};
        stage->bound(question, box);
        stage->evaluate(Point{shared, state, rows, x}, point);
        inside(box.utilisation, point.utilisation);
        inside(box.resources, point.resources);
        inside(box.handed_on, point.handed_on);
        for (const Input input : {Input{Input::Kind::variable, 0}, Input{Input::Kind::inherited, 0}}) {
          stage->slopes(question, input, box);
          stage->gradient(Point{shared, state, rows, x}, input, point);
          inside(box.utilisation, point.utilisation);
          inside(box.handed_on, point.handed_on);
        }
      }
    }
  }
}

}  // namespace

}  // namespace random_stack_test
