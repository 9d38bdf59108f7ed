// SPDX-License-Identifier: Apache-2.0
//
// What is kept of long tables from one combination of shared choices to the next: parts that are all rows, each once,
// with what is read of them now; and that no row that some design needs is lost by it.
#include "solver/table_memory.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <random>

#include "catch.h"
#include "solver/forwarding_stage.h"
#include "solver/model_stage.h"
#include "solver/shaving.h"
#include "solver/solver.h"

namespace table_memory_test {

namespace {

using namespace millwright::solver;

enum Column : std::size_t { price, mass, strength, columns };

Columns random_table(std::mt19937& rng, std::string name, std::size_t rows, double strongest) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Columns table{std::move(name), columns, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    const double strong = strongest * share(rng);
    table.numbers.insert(table.numbers.end(), {1.0 + 0.5 * strong + share(rng), 0.1 + 0.1 * strong, strong});
  }
  return table;
}

/// By the row chosen of the shared choice, how much of their strength motors have.
constexpr std::array<double, 3> share_of_strength{1.0, 0.7, 0.4};

/// A bar that bears what is handed to it, and a motor that moves both, with `share(in)` of its strength. Bars are not
/// to be too strong for their motors.
template <class Share>
auto arm_model(Share share) {
  return [share](const auto& in, auto& out) {
    const auto carried = in.state(0) + in.row(0, mass);
    out.utilisation.assign({(in.state(0) + in.row(1, mass)) / in.row(0, strength),
                            carried / (share(in) * in.row(1, strength)),
                            0.5 * in.row(0, strength) / in.row(1, strength)});
    out.resources.assign({in.row(0, price) + in.row(1, price), in.row(0, mass) + in.row(1, mass)});
    out.handed_on.assign({carried + in.row(1, mass)});
  };
}
auto arm_that_asks() {
  return arm_model([](const auto& in) { return share_of_strength[in.shared(0)]; });
}
auto strong_arm() {
  return arm_model([](const auto&) { return 1.0; });
}

/// For each row of the shared choice a stage of its own: what is read hangs on it, as with motors and their voltage.
class ByChoice final : public zoo::ForwardingStage {
 public:
  explicit ByChoice(std::array<const Stage*, 3> stages) : zoo::ForwardingStage(*stages[0]), stages_(stages) {}
  void read(std::span<const Row> shared,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override {
    stages_[shared[0]]->read(shared, slot, rows, readings);
  }
  void evaluate(const Point& point, Answer<double>& answer) const override {
    stages_[point.shared[0]]->evaluate(point, answer);
  }
  void bound(const Box& box, Answer<Interval>& answer) const override { stages_[box.shared[0]]->bound(box, answer); }
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override {
    stages_[box.shared[0]]->slopes(box, input, answer);
  }

 private:
  std::array<const Stage*, 3> stages_;
};

/// Bars and motors; the motors once more for each row of the shared choice, with what is left of their strength.
struct Arms {
  Arms(std::mt19937& rng, std::size_t rows)
      : bars(random_table(rng, "bar", rows, 4.0)), motors(random_table(rng, "motor", 5, 9.0)) {
    for (std::size_t choice = 0; choice < 3; ++choice) {
      weaker[choice] = motors;
      for (std::size_t at = strength; at < motors.numbers.size(); at += columns)
        weaker[choice].numbers[at] *= share_of_strength[choice];
    }
  }
  Columns bars, motors;
  std::array<Columns, 3> weaker{motors, motors, motors};

  ModelStage<decltype(arm_that_asks())> asking = model_stage("arm", {&bars, &motors}, {}, 3, arm_that_asks());
  std::array<ModelStage<decltype(strong_arm())>, 3> of_choice{
      model_stage("arm", {&bars, &weaker[0]}, {}, 3, strong_arm()),
      model_stage("arm", {&bars, &weaker[1]}, {}, 3, strong_arm()),
      model_stage("arm", {&bars, &weaker[2]}, {}, 3, strong_arm())};
  ByChoice reading{{&of_choice[0], &of_choice[1], &of_choice[2]}};
  std::array<const Stage*, 2> both{&asking, &reading};
};

bool same(std::span<const Interval> a, std::span<const Interval> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Interval& x, const Interval& y) {
    return x.lower == y.lower && x.upper == y.upper;
  });
}

/// That the parts are these rows, each once, with what is read of them.
void check_parts(TableMemory& tables, const Stage& stage, std::span<const Row> shared, const std::vector<Row>& rows) {
  const RowSet whole = make_rows(stage, shared, 0, rows);
  std::vector<Row> found;
  for (const RowSet& part : tables.parts(stage, shared, 0, *whole)) {
    REQUIRE(part->size() > 0);
    REQUIRE(std::is_sorted(part->begin(), part->end()));
    found.insert(found.end(), part->begin(), part->end());
    std::vector<Interval> readings;
    stage.read(shared, 0, part->all(), readings);
    REQUIRE(same(part->alive().readings, readings));
  }
  std::sort(found.begin(), found.end());
  REQUIRE(found == rows);
}

}  // namespace

TEST_CASE("Parts of a table are its rows, each once, as they are read with the shared choices of now") {
  std::mt19937 rng(3);
  const Arms arms(rng, 500);
  REQUIRE_FALSE(arms.asking.reads_shared(0));
  REQUIRE(arms.reading.reads_shared(0));
  for (const Stage* stage : arms.both) {
    TableMemory tables;
    std::vector<Row> all(500);
    std::iota(all.begin(), all.end(), Row{0});
    const std::array<Row, 1> first{0}, other{2};
    REQUIRE(tables.parts(*stage, first, 0, *make_rows(*stage, first, 0, all)).empty());
    std::vector<RowSet> parts;
    for (Row remainder = 0; remainder < 7; ++remainder) {
      std::vector<Row> part;
      for (Row row = remainder; row < 500; row += 7) part.push_back(row);
      parts.push_back(make_rows(*stage, first, 0, std::move(part)));
    }
    tables.keep_parts(*stage, first, 0, std::move(parts));
    tables.keep_parts(*stage, first, 0, {make_rows(*stage, first, 0, {1, 2, 3})});  // of fewer rows: not kept
    for (const auto& shared : {first, other}) {
      REQUIRE(tables.parts(*stage, shared, 0, *make_rows(*stage, shared, 0, all)).size() == 7);
      check_parts(tables, *stage, shared, all);
      std::vector<Row> some;
      for (const Row row : all)
        if (row % 7 != 3 && rng() % 3 != 0) some.push_back(row);
      REQUIRE(tables.parts(*stage, shared, 0, *make_rows(*stage, shared, 0, some)).size() == 6);
      check_parts(tables, *stage, shared, some);
      check_parts(tables, *stage, shared, {499});
    }
    // Rows that no part has are one more.
    TableMemory of_some;
    of_some.keep_parts(*stage, first, 0, {make_rows(*stage, first, 0, {0, 1, 2}), make_rows(*stage, first, 0, {7, 9})});
    REQUIRE(of_some.parts(*stage, other, 0, *make_rows(*stage, other, 0, all)).size() == 3);
    check_parts(of_some, *stage, other, all);
  }
}

TEST_CASE("Whole tables are as a stage reads them, whatever has been asked before") {
  std::mt19937 rng(4);
  const Arms arms(rng, 50);
  const auto arm = model_stage("arm", {&arms.bars, &arms.motors}, {{"ramp", 0.5, 2.0}}, 3, arm_that_asks());
  /// Offers every third row, by the shared choice.
  class Shop final : public zoo::ForwardingStage {
   public:
    using zoo::ForwardingStage::ForwardingStage;
    [[nodiscard]] bool offered(std::span<const Row> shared, std::size_t slot, Row row) const override {
      return slot == 1 || row % 3 == shared[0];
    }
    [[nodiscard]] bool reads_shared(std::size_t) const override { return false; }
  };
  const Shop shop(arm);
  TableMemory tables;
  for (const Row choice : {0U, 2U, 0U, 1U, 2U}) {
    const std::array<Row, 1> shared{choice};
    const Region of_shop = tables.whole_region(shop, shared);
    REQUIRE(of_shop.variables.size() == 1);
    REQUIRE((of_shop.variables[0].lower == 0.5 && of_shop.variables[0].upper == 2.0));
    for (const Stage* stage : {static_cast<const Stage*>(&shop), static_cast<const Stage*>(&arms.reading)}) {
      const Region region = tables.whole_region(*stage, shared);
      REQUIRE(region.rows.size() == 2);
      for (std::size_t slot = 0; slot < 2; ++slot) {
        REQUIRE(region.rows[slot]->all() == offered_rows(*stage, shared, slot));
        std::vector<Interval> readings;
        stage->read(shared, slot, region.rows[slot]->all(), readings);
        REQUIRE(same(region.rows[slot]->alive().readings, readings));
      }
    }
  }
}

TEST_CASE("Long tables that were cut for one shared choice lose no row that another one needs") {
  std::size_t dropped = 0, lost = 0, builds = 0, infeasible = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 rng(seed);
    const Arms arms(rng, 1500);
    const Stage& stage = *arms.both[seed % 2];
    Problem problem;
    problem.shared = {{"strength", 3}};
    problem.first_state = {0.2 + 0.7 * static_cast<double>(rng() % 8)};
    problem.stages = {&stage};
    problem.resources = {{"cost"}, {"mass"}};
    Options options;
    const Criteria criteria = make_criteria(problem, options);
    const std::vector<Interval> state{Interval(problem.first_state[0])};
    Desk desk;
    TableMemory tables;
    double least = std::numeric_limits<double>::infinity();
    CAPTURE(seed);
    for (const Row choice : {0U, 1U, 2U, 1U, 0U}) {
      const std::array<Row, 1> shared{choice};
      StagePlan plan(stage, shared, criteria, tables);
      const bool left = shave(plan, state, desk, tables);
      Answer<double> answer;
      for (Row bar = 0; bar < 1500; ++bar) {
        const bool kept = left && std::binary_search(plan.region.rows[0]->begin(), plan.region.rows[0]->end(), bar);
        dropped += kept ? 0 : 1;
        for (Row motor = 0; motor < 5; ++motor) {
          const std::array<Row, 2> rows{bar, motor};
          stage.evaluate({shared, problem.first_state, rows, {}}, answer);
          if (*std::max_element(answer.utilisation.begin(), answer.utilisation.end()) > 1.0) continue;
          least = std::min(least, answer.resources[0]);
          lost += kept ? 0 : 1;
        }
      }
    }
    REQUIRE(lost == 0);
    const Summary found = solve(problem, options);
    if (std::isinf(least)) {
      ++infeasible;
      REQUIRE(found.status == Status::infeasible);
      continue;
    }
    ++builds;
    REQUIRE(found.status == Status::optimal);
    REQUIRE(found.builds.front().resources[0] == least);
  }
  CHECK(dropped > 10000);
  CHECK(builds > 3);
  CHECK(infeasible > 0);
}

}  // namespace table_memory_test
