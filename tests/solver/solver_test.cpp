// SPDX-License-Identifier: Apache-2.0
//
// Small problems solved by hand, and what the search promises beside the optimum: limits, ties, time, monotonicity.
#include "solver/solver.h"

#include "catch.h"
#include "solver/large_stack.h"
#include "solver/monotonicity.h"
#include "solver/random_stack.h"
#include "solver/shaving.h"

namespace solver_test {

namespace {

using namespace millwright::solver;

/// One slot; each row has a price, a weight and a strength. Carries what it inherits: (load + weight)/strength <= 1.
class Shelf final : public Stage {
 public:
  struct Board {
    double price, weight, strength;
  };
  explicit Shelf(std::vector<Board> boards) : boards_(std::move(boards)) {
    slots_ = {{"board", static_cast<Row>(boards_.size())}};
  }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return {}; }
  [[nodiscard]] std::size_t constraints() const override { return 1; }
  void evaluate(const Point& x, Answer<double>& out) const override {
    const Board& board = boards_[x.rows[0]];
    out.utilisation.assign(1, (x.inherited[0] + board.weight) / board.strength);
    out.resources.assign({board.price, board.weight});
    out.handed_on.assign(1, x.inherited[0] + board.weight);
  }
  void bound(const Box& box, Answer<Interval>& out) const override {
    bool first = true;
    for (const Row row : box.rows[0]) {
      const Board& board = boards_[row];
      const Interval load = box.inherited[0] + Interval(board.weight);
      const Answer<Interval> one{{load / Interval(board.strength)}, {board.price, board.weight}, {load}};
      out = first ? one : hull_of(out, one);
      first = false;
    }
  }
  void slopes(const Box& box, Input, Answer<Interval>& out) const override {
    Interval slope = 1.0 / Interval(boards_[box.rows[0][0]].strength);
    for (const Row row : box.rows[0]) slope = hull(slope, 1.0 / Interval(boards_[row].strength));
    out = {{slope}, {0.0, 0.0}, {1.0}};
  }
  void gradient(const Point&, Input, Answer<double>&) const override {}

 private:
  static Answer<Interval> hull_of(const Answer<Interval>& a, const Answer<Interval>& b) {
    return {{hull(a.utilisation[0], b.utilisation[0])},
            {hull(a.resources[0], b.resources[0]), hull(a.resources[1], b.resources[1])},
            {hull(a.handed_on[0], b.handed_on[0])}};
  }
  std::string name_ = "shelf";
  std::vector<Board> boards_;
  std::vector<Slot> slots_;
};

constexpr double unlimited = std::numeric_limits<double>::infinity();

Problem shelves(const std::vector<const Stage*>& stages) {
  Problem problem;
  problem.first_state = {10.0};
  problem.stages = stages;
  problem.resources = {{"cost", unlimited}, {"mass", unlimited}};
  return problem;
}

// Upper board: 1 (heavy 5 kg) or 2 (light 1 kg). Lower board: carries 13 for 3, or 20 for 9.
// Greedy takes the heavy board (1) and then needs the strong shelf (9): 10. Best is 2 + 3 = 5.
const Shelf upper({{1.0, 5.0, 100.0}, {2.0, 1.0, 100.0}});
const Shelf lower({{3.0, 1.0, 13.0}, {9.0, 1.0, 20.0}});

TEST_CASE("The cheapest first choice is not always part of the cheapest build") {
  const Summary summary = solve(shelves({&upper, &lower}), {});
  REQUIRE(summary.status == Status::optimal);
  CHECK(summary.builds[0].resources == std::vector<double>{5.0, 2.0});
  CHECK(summary.builds[0].stages[0].rows == std::vector<Row>{1});
  CHECK(summary.builds[0].stages[1].rows == std::vector<Row>{0});
  CHECK(summary.builds[0].stages[1].inherited == std::vector<double>{11.0});
  CHECK(summary.combinations == 4.0);
  CHECK(summary.gap <= 1e-9);
}

TEST_CASE("A limit on a resource is kept to the rounding of a sum, also at equality") {
  Problem problem = shelves({&upper, &lower});
  // The same sum in another order may come out a little different, and counts as equal (criteria.h).
  for (const double limit : {5.0, std::nextafter(5.0, 0.0)}) {
    problem.resources[0].limit = limit;
    CHECK(solve(problem, {}).status == Status::optimal);
  }
  problem.resources[0].limit = 5.0 * (1.0 - 1e-11);
  CHECK(solve(problem, {}).status == Status::infeasible);
}

TEST_CASE("A utilisation of exactly 1 is feasible, the next number is not") {
  const Shelf exact({{1.0, 1.0, 11.0}});
  const Shelf beyond({{1.0, 1.0, std::nextafter(11.0, 0.0)}});
  CHECK(solve(shelves({&exact}), {}).status == Status::optimal);
  CHECK(solve(shelves({&beyond}), {}).status == Status::infeasible);
}

TEST_CASE("Among equal costs the lighter is taken, then the one with more reserve, then the first row") {
  const Shelf ties({{4.0, 3.0, 100.0}, {4.0, 2.0, 50.0}, {4.0, 2.0, 60.0}, {4.0, 2.0, 60.0}});
  Options options;
  options.ties = {1};
  const Summary summary = solve(shelves({&ties}), options);
  CHECK(summary.builds[0].stages[0].rows == std::vector<Row>{2});
}

TEST_CASE("Costs that are equal but for the order of additions count as equal") {
  // 0.1 + 0.2 is not 0.3 in binary.
  const Shelf first({{0.1, 3.0, 100.0}, {0.3, 1.0, 100.0}});
  const Shelf second({{0.2, 1.0, 13.9}, {0.2, 5.0, 100.0}, {0.0, 1.0, 12.0}});
  Options options;
  options.ties = {1};
  const Summary summary = solve(shelves({&first, &second}), options);  // 0.1 + 0.2 with 8 kg, 0.3 + 0 with 2 kg
  CHECK(summary.builds[0].resources[1] == 2.0);
}

TEST_CASE("The front of the shelves, by hand") {
  Options options;
  options.objectives = {0, 1};
  const Shelf top({{1.0, 5.0, 100.0}, {2.0, 1.0, 100.0}, {8.0, 0.5, 100.0}, {9.0, 0.6, 100.0}});
  const Summary summary = solve(shelves({&top, &lower}), options);
  REQUIRE(summary.builds.size() == 2);
  CHECK(summary.builds[0].resources == std::vector<double>{5.0, 2.0});
  CHECK(summary.builds[1].resources == std::vector<double>{11.0, 1.5});
}

TEST_CASE("Weights make one objective") {
  Options options;
  options.weights = {1.0, 100.0};
  const Shelf top({{1.0, 5.0, 100.0}, {2.0, 1.0, 100.0}, {8.0, 0.5, 100.0}});
  const Summary summary = solve(shelves({&top, &lower}), options);
  CHECK(summary.builds[0].resources == std::vector<double>{11.0, 1.5});  // 161 against 205
  CHECK(summary.lower_bound == Approx(161.0));
}

TEST_CASE("A slot without rows is infeasible and options that make no sense are refused") {
  const Shelf nothing({});
  CHECK(solve(shelves({&upper, &nothing}), {}).status == Status::infeasible);
  Options options;
  options.objectives = {7};
  CHECK_THROWS_AS(solve(shelves({&upper}), options), std::invalid_argument);
  options = {};
  options.weights = {1.0};
  CHECK_THROWS_AS(solve(shelves({&upper}), options), std::invalid_argument);
  options.weights = {1.0, -1.0};
  CHECK_THROWS_AS(solve(shelves({&upper}), options), std::invalid_argument);
}

TEST_CASE("When time is up or the user stops the bound is valid and the status says so") {
  const auto machine = zoo::large::random_machine(1);
  Options options;
  const double optimum = solve(machine.problem, options).lower_bound;
  options.time_limit_seconds = 0.0;
  const Summary none = solve(machine.problem, options);
  CHECK(none.status == Status::limit);
  CHECK(none.builds.empty());
  CHECK(none.lower_bound <= optimum);
  CHECK(none.lower_bound > 0.0);
  const std::atomic<bool> stop = true;
  options = {};
  options.stop = &stop;
  CHECK(solve(machine.problem, options).status == Status::limit);
}

TEST_CASE("A machine with 1e38 combinations is solved to the proven optimum") {
  const auto machine = zoo::large::random_machine(2);
  Options options;
  options.ties = {1};
  const Summary summary = solve(machine.problem, options);
  REQUIRE(summary.status == Status::optimal);
  CHECK(summary.combinations > 1e38);
  // No other screw and motor of the last axis make it cheaper: tried by brute force at the same acceleration time.
  const StageChoice& choice = summary.builds[0].stages[2];
  const Stage& stage = *machine.stages[2];
  Answer<double> answer;
  stage.evaluate(Point{{}, choice.inherited, choice.rows, choice.variables}, answer);
  const double known = answer.resources[0];
  const double drawn = answer.handed_on.back();
  std::vector<Row> rows = choice.rows;
  for (Row screw = 0; screw < 250; ++screw) {
    for (Row motor = 0; motor < 174; ++motor) {
      rows[0] = screw;
      rows[2] = motor;
      if (!stage.fits({}, 0, screw, 1, rows[1]) || !stage.fits({}, 0, screw, 4, rows[4]) ||
          !stage.fits({}, 2, motor, 4, rows[4]) || !stage.fits({}, 0, screw, 5, rows[5]) ||
          !stage.fits({}, 0, screw, 6, rows[6])) {
        continue;
      }
      stage.evaluate(Point{{}, choice.inherited, rows, choice.variables}, answer);
      const bool feasible = *std::max_element(answer.utilisation.begin(), answer.utilisation.end()) <= 1.0;
      // One that draws more could need a dearer supply: compare those that draw no more.
      if (feasible && answer.handed_on.back() <= drawn) {
        CHECK(answer.resources[0] >= known - 1e-9);
      }
    }
  }
}

RowHalves halves_at(const Stage& stage, const Criteria& criteria, std::span<const Interval> inherited, Desk& desk) {
  TableMemory tables;
  const auto plan = std::make_shared<const StagePlan>(stage, std::span<const Row>(), criteria, tables);
  return {RowProfile(stage, {}), [plan, inherited, &desk](std::size_t slot, RowProfile& profile) {
            find_profile(*plan, inherited, slot, profile, desk);
          }};
}

TEST_CASE("Directions are proved where they hold and refused where they do not") {
  std::mt19937 rng(5);
  zoo::Axis axis = zoo::random_axis(rng, {}, false);
  const auto direction = [&](std::size_t component) {
    const zoo::AxisStage stage(axis);
    const Region region = TableMemory().whole_region(stage, {});
    const std::vector<Interval> inherited{Interval(0.1, 3.0), Interval(0.0, 100.0)};
    const std::vector<Direction> next(2, Direction::irrelevant);
    Options options;
    Problem problem;
    problem.resources = {{"cost", unlimited}, {"mass", unlimited}, {"power", unlimited}};
    const Criteria criteria = make_criteria(problem, options);
    Desk desk;
    RowHalves halves = halves_at(stage, criteria, inherited, desk);
    return prove_direction({&stage, {}, &criteria, &region, inherited, next, &halves}, component, desk);
  };
  CHECK(direction(0) == Direction::smaller_is_better);
  CHECK(direction(1) == Direction::irrelevant);  // the power limit is far away
  axis.power_limit = 100.0;
  CHECK(direction(1) == Direction::smaller_is_better);
}

/// Whether some of a thousand random designs contradicts a direction of the carried mass.
bool contradicted(const zoo::AxisStage& stage, Direction direction, std::mt19937& rng) {
  Answer<double> answer;
  const auto feasible = [&](const std::vector<Row>& rows, const std::vector<double>& x, double mass) {
    const std::vector<double> state{mass, 10.0};
    stage.evaluate(Point{{}, state, rows, x}, answer);
    return *std::max_element(answer.utilisation.begin(), answer.utilisation.end()) <= 1.0;
  };
  for (int sample = 0; sample < 1000; ++sample) {
    std::vector<Row> rows;
    for (const Slot& slot : stage.slots()) rows.push_back(static_cast<Row>(rng() % slot.rows));
    std::vector<double> x;
    for (const Variable& v : stage.variables()) x.push_back(zoo::uniform(rng, v.lower, v.upper));
    const double a = zoo::uniform(rng, 0.1, 3.0);
    const double b = zoo::uniform(rng, 0.1, 3.0);
    const bool at_less = feasible(rows, x, std::min(a, b));
    const bool at_more = feasible(rows, x, std::max(a, b));
    if (direction == Direction::smaller_is_better && at_more && !at_less) return true;
    if (direction == Direction::larger_is_better && at_less && !at_more) return true;
    if (direction == Direction::irrelevant && at_less != at_more) return true;
  }
  return false;
}

TEST_CASE("No random design contradicts a proved direction, with structure that is monotone or not") {
  int proved = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 rng(seed);
    zoo::Axis axis = zoo::random_axis(rng, {}, false);
    if (seed % 3 == 1) axis.least_ratio = zoo::uniform(rng, 0.05, 1.0);
    if (seed % 3 == 2) axis.gravity = -zoo::uniform(rng, 0.2, 1.0);
    const zoo::AxisStage stage(axis);
    const Region region = TableMemory().whole_region(stage, {});
    const std::vector<Interval> inherited{Interval(0.1, 3.0), Interval(0.0, 100.0)};
    const std::vector<Direction> next(2, Direction::irrelevant);
    Problem problem;
    problem.resources = {{"cost", unlimited}, {"mass", unlimited}, {"power", unlimited}};
    const Criteria criteria = make_criteria(problem, {});
    Desk desk;
    RowHalves halves = halves_at(stage, criteria, inherited, desk);
    const Direction direction = prove_direction({&stage, {}, &criteria, &region, inherited, next, &halves}, 0, desk);
    (direction == Direction::equal_only ? refused : proved) += 1;
    CAPTURE(seed);
    REQUIRE_FALSE(contradicted(stage, direction, rng));
  }
  CHECK(proved >= 60);   // the plain axes at least
  CHECK(refused >= 10);  // and not by refusing or accepting everything
}

}  // namespace

}  // namespace solver_test
