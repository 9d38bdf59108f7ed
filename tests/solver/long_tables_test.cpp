// SPDX-License-Identifier: Apache-2.0
//
// Tables so long that their rows are not asked about one by one, against every design; and what tells rows apart.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/row_profile.h"
#include "solver/solver.h"
#include "solver/split_worth.h"
#include "solver/table_memory.h"

namespace long_tables_test {

namespace {

using namespace millwright::solver;

enum Column : std::size_t { price, mass, strength, columns };

struct Total {
  double price = 0.0, mass = 0.0;
};

/// Utilisations of a bar and its motor under what they carry. Not monotone where bars shake that are too strong for it.
template <class T>
std::array<T, 3> utilisations(
    const T& carried, const T& bar_strength, const T& motor_mass, const T& torque, double shaking) {
  return {
      (carried + motor_mass) / bar_strength, (carried + 0.5 * motor_mass) / torque, shaking * bar_strength / carried};
}

/// A hand and the arm that carries it: a bar and a motor each. The table of the hand's bars is long. Of every other
/// robot many of them are too weak or too strong for any motor. Of the others only five are, next to free, and stand
/// where an even sample of every eighth or ninth row does not meet them.
struct Robot {
  explicit Robot(unsigned seed) : rng(seed), shaking(seed % 2 == 0 ? 0.2 : 0.0) {
    bars = {table(1100, seed % 2 == 0 ? 2.0 : 20.0), table(6, 2.0)};
    motors = {table(4, 5.0), table(4, 5.0)};
    constexpr std::array<Row, 5> between{3, 204, 511, 702, 1099};  // sampled: 0, 8, 17, 25, 34, ...
    for (const Row weak : between) {
      double* row = bars[0].numbers.data() + weak * columns;
      row[price] = 0.1;
      row[strength] = 1e-3;
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
      const auto model = [shakes = shaking](const auto& in, auto& out) {
        for (const auto& u :
             utilisations(in.state(0), in.row(0, strength), in.row(1, mass), in.row(1, strength), shakes))
          out.utilisation.push_back(u);
        const auto own = in.row(0, mass) + in.row(1, mass);
        out.resources.assign({in.row(0, price) + in.row(1, price), own});
        out.handed_on.push_back(in.state(0) + own);
      };
      auto stage = model_stage(i == 0 ? "hand" : "arm", {&bars[i], &motors[i]}, {}, 3, model);
      stages.push_back(std::make_unique<decltype(stage)>(std::move(stage)));
      problem.stages.push_back(stages.back().get());
    }
    problem.first_state = {2.0};
    problem.resources = {{"price"}, {"mass"}};
  }

  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(rng()) / 4294967296.0; }
  Columns table(std::size_t rows, double factor) {
    Columns made{"table", columns, {}};
    for (std::size_t row = 0; row < rows; ++row) {
      const double size = uniform(1.0, 5.0);
      for (const double x : {uniform(2.0, 4.0) * size, size, uniform(0.8, 1.2) * factor * size})
        made.numbers.push_back(x);
    }
    return made;
  }

  /// Totals of all feasible designs, by a recursion over all rows.
  void try_everything(std::size_t stage, double carried, const Total& so_far, std::vector<Total>& totals) const {
    if (stage == bars.size()) return totals.push_back(so_far);
    for (Row b = 0; b < bars[stage].rows(); ++b)
      for (Row m = 0; m < motors[stage].rows(); ++m) {
        const double* bar = bars[stage].row(b);
        const double* motor = motors[stage].row(m);
        const auto all = utilisations(carried, bar[strength], motor[mass], motor[strength], shaking);
        if (*std::max_element(all.begin(), all.end()) > 1.0) continue;
        const double own = bar[mass] + motor[mass];
        try_everything(stage + 1, carried + own, {so_far.price + bar[price] + motor[price], so_far.mass + own}, totals);
      }
  }

  std::mt19937 rng;
  double shaking;
  std::vector<Columns> bars, motors;
  std::vector<std::unique_ptr<Stage>> stages;
  Problem problem;
};

TEST_CASE("The best design and the front of a long table are those of trying everything") {
  std::size_t points = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 3U : 20U); ++seed) {
    const Robot robot(seed);
    std::vector<Total> totals;
    robot.try_everything(0, robot.problem.first_state[0], {}, totals);
    std::sort(totals.begin(), totals.end(), [](const Total& a, const Total& b) {
      return a.price != b.price ? a.price < b.price : a.mass < b.mass;
    });
    std::vector<Total> front;
    for (const Total& total : totals)
      if (front.empty() || total.mass < front.back().mass * (1.0 - 1e-11)) front.push_back(total);
    INFO("seed " << seed);
    const Summary best = solve(robot.problem, {});
    REQUIRE(best.status == (totals.empty() ? Status::infeasible : Status::optimal));
    if (totals.empty()) continue;
    REQUIRE(best.builds.front().resources[0] == Approx(front.front().price).epsilon(1e-11));
    Options options;
    options.objectives = {0, 1};
    const Summary found = solve(robot.problem, options);
    REQUIRE(found.status == Status::optimal);
    REQUIRE(found.builds.size() == front.size());
    for (std::size_t i = 0; i < front.size(); ++i) {
      REQUIRE(found.builds[i].resources[0] == Approx(front[i].price).epsilon(1e-11));
      REQUIRE(found.builds[i].resources[1] == Approx(front[i].mass).epsilon(1e-11));
    }
    points += front.size();
  }
  CHECK(points > (millwright::sanitized ? 3U : 40U));  // there was something to find
}

TEST_CASE("A long table that is sieved in vain is divided by all that matters afterwards") {
  // The first of 1100 rods is a little too long, and nothing tells it from rods like it. While sockets that hold
  // anything and sockets that hold nothing are among the choices, five figures of a rod do not matter; then they do.
  Columns rods{"rod", 7, {}};
  std::mt19937 rng(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(rng()) / 4294967296.0;
  };
  for (int row = 0; row < 1100; ++row) {
    rods.numbers.push_back(uniform(1.0, 2.0));                              // price
    rods.numbers.push_back(row == 0 ? 1.0001 : uniform(0.9, 1.0));          // length
    for (int i = 0; i < 5; ++i) rods.numbers.push_back(uniform(0.1, 1.0));  // loads
  }
  const Columns sockets{"socket", 2, {1e9, 2.0, 1e-9, 2.0, 0.35, 0.5, 0.45, 0.5, 0.55, 0.5, 0.4, 0.5}};
  const auto stage = model_stage("joint", {&rods, &sockets}, {}, 7, [](const auto& in, auto& out) {
    out.utilisation.push_back(in.row(0, 1));
    out.utilisation.push_back(in.row(1, 1));
    for (std::size_t i = 2; i < 7; ++i) out.utilisation.push_back(in.row(0, i) / in.row(1, 0));
    out.resources.push_back(in.row(0, 0));
    out.handed_on.push_back(in.state(0));
  });
  Problem problem;
  problem.first_state = {0.0};
  problem.stages = {&stage};
  problem.resources = {{"price"}};
  double least = std::numeric_limits<double>::infinity();
  for (Row row = 1; row < rods.rows(); ++row) {
    const double* rod = rods.row(row);
    if (*std::max_element(rod + 2, rod + 7) <= 0.55) least = std::min(least, rod[0]);  // the largest of usable sockets
  }
  REQUIRE(std::isfinite(least));
  const Summary found = solve(problem, {});
  REQUIRE(found.status == Status::optimal);
  CHECK(found.builds.front().resources[0] == least);
}

TEST_CASE("Rows are divided by what matters, however much they differ in what does not") {
  // Serial numbers that nobody reads, prices that differ by a hundredth, strengths that differ by a half.
  Columns rods{"rod", columns, {}};
  std::mt19937 rng(7);
  for (int row = 0; row < 64; ++row) {
    const bool strong = rng() % 2 == 0;
    for (const double x : {1.0 + 0.01 * (row % 2), 1e6 * static_cast<double>(rng()), strong ? 150.0 : 100.0})
      rods.numbers.push_back(x);
  }
  const auto stage = model_stage("rod", {&rods}, {}, 1, [](const auto& in, auto& out) {
    out.utilisation.push_back(120.0 / in.row(0, strength));
    out.resources.push_back(in.row(0, price));
    out.handed_on.push_back(in.state(0));
  });
  const Region region = TableMemory().whole_region(stage, {});
  const std::vector<Interval> state{Interval(0.0)};
  Desk desk;
  RowProfile profile(stage, {});
  profile.find(region,
               0,
               std::vector<double>{1.0},
               [&](const RowsAlive& rows, std::span<double> score) -> const Answer<Interval>& {
                 const auto& answer = desk.bound_with(stage, {}, state, region, 0, rows);
                 score[0] = answer.resources[0].lower;
                 return answer;
               });
  const std::vector<double> worth{1.0};
  const auto differ_in = [&](const RowSet& rows, std::size_t column) {
    return std::any_of(
        rows->begin(), rows->end(), [&](Row row) { return rods.row(row)[column] != rods.row(rows->front())[column]; });
  };
  // While the constraint is open its column tells them apart; when it is settled, the price does.
  const RowProfile::Split by_strength = profile.split(region, 1, worth);
  CHECK(by_strength.left->size() + by_strength.right->size() == rods.rows());
  CHECK_FALSE(differ_in(by_strength.left, strength));
  CHECK_FALSE(differ_in(by_strength.right, strength));
  CHECK(differ_in(by_strength.left, price));
  Region known = region;
  known.rows[0] = by_strength.left;
  const RowProfile::Split by_price = profile.split(known, 0, worth);
  CHECK_FALSE(differ_in(by_price.left, price));
  CHECK_FALSE(differ_in(by_price.right, price));
}

TEST_CASE("A slot that gets nowhere is divided after others, and never given up") {
  SplitWorth worth(2);
  const Reached whole{0.5, 10.0};
  CHECK(worth.of_slots()[0] == worth.of_slots()[1]);
  for (int i = 0; i < 1000; ++i) {
    worth.count(0, whole, whole);                // as it was
    worth.count(1, whole, Reached{0.75, 10.0});  // half of the way to being infeasible
  }
  CHECK(worth.of_slots()[0] > 0.01);  // of 1000 divisions in vain alone nothing would be left
  CHECK(worth.of_slots()[1] > 10.0 * worth.of_slots()[0]);
  for (int i = 0; i < 10000; ++i) worth.count(0, whole, std::nullopt);  // left out
  CHECK(worth.of_slots()[0] > worth.of_slots()[1]);
}

}  // namespace

}  // namespace long_tables_test
