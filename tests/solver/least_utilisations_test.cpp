// SPDX-License-Identifier: Apache-2.0
//
// Below what utilisations do not come, against asking about every row of every slot.
#include "solver/least_utilisations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "solver/forwarding_stage.h"
#include "solver/model_stage.h"
#include "solver/table_memory.h"

namespace least_utilisations_test {

namespace {

using namespace millwright::solver;

enum Column : std::size_t { mass, strength, speed, columns };

/// Coarse numbers, so that many rows are equal in something.
Columns random_table(std::mt19937& rng, std::string name, std::size_t rows) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Columns table{std::move(name), columns, {}};
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t column = 0; column < columns; ++column)
      table.numbers.push_back(std::ceil(40.0 * share(rng)) / 20.0);
  return table;
}

/// Constraints that one slot decides, that two decide together, that the ramp decides, and one that nothing does.
auto arm_model(double load) {
  return [load](const auto& in, auto& out) {
    const auto carried = in.state(0) + in.row(0, mass) + in.row(1, mass);
    const auto& ramp = in.variable(0);
    out.utilisation.assign({load * carried / in.row(0, strength),
                            load * carried / (ramp * in.row(1, strength)),
                            0.7 * load / in.row(0, speed) + 0.3 / in.row(0, strength),
                            load / (in.row(0, speed) * in.row(1, speed)),
                            load * in.row(1, mass) / in.row(0, strength),
                            0.5 * load * ramp + 0.0 * carried,
                            1.5 + 0.0 * carried});
    out.resources.assign({carried});
    out.handed_on.assign({carried});
  };
}

/// Tells nothing of its rows but what bounds say.
class Silent final : public zoo::ForwardingStage {
 public:
  using zoo::ForwardingStage::ForwardingStage;
  void read(std::span<const Row>, std::size_t, std::span<const Row>, std::vector<Interval>& readings) const override {
    readings.clear();
  }
};

std::vector<LeastUtilisation> by_every_row(const Stage& stage,
                                           std::span<const Interval> state,
                                           const Region& whole,
                                           Desk& desk) {
  std::vector<LeastUtilisation> result;
  for (const Interval& u : desk.bound(stage, {}, state, whole).utilisation)
    result.push_back({u.lower, std::nullopt, 0});
  for (std::size_t slot = 0; slot < whole.rows.size(); ++slot) {
    std::vector<LeastUtilisation> least(result.size(), {std::numeric_limits<double>::infinity(), slot, 0});
    for (const Row& row : *whole.rows[slot]) {
      std::vector<Interval> readings;
      stage.read({}, slot, std::span(&row, 1), readings);
      const auto& answer = desk.bound_with(stage, {}, state, whole, slot, {std::span(&row, 1), readings});
      for (std::size_t c = 0; c < least.size(); ++c)
        if (answer.utilisation[c].lower < least[c].value) least[c] = {answer.utilisation[c].lower, slot, row};
    }
    for (std::size_t c = 0; c < least.size(); ++c)
      if (least[c].value > result[c].value) result[c] = least[c];
  }
  return result;
}

}  // namespace

TEST_CASE("The least utilisations are those of asking about every row of every slot") {
  int of_slots = 0, of_all = 0, kept = 0;
  std::uint64_t asked_all = 0, asked_sets = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    std::mt19937 rng(seed);
    const Columns arms = random_table(rng, "arm", 100 + rng() % 900),
                  motors = random_table(rng, "motor", 5 + rng() % 90);
    const double load = std::array{0.02, 0.3, 1.0, 3.0, 20.0}[rng() % 5];
    const auto arm = model_stage("arm", {&arms, &motors}, {{"ramp", 0.5, 2.0}}, 7, arm_model(load));
    const Silent silent(arm);
    const std::vector<Interval> state{Interval(0.1, 0.1 + 0.2 * static_cast<double>(rng() % 3))};
    for (const Stage* stage : {static_cast<const Stage*>(&arm), static_cast<const Stage*>(&silent)}) {
      TableMemory tables;
      const Region whole = tables.whole_region(*stage, {});
      Desk one_by_one, in_sets;
      const auto expected = by_every_row(*stage, state, whole, one_by_one);
      std::vector<bool> asked(expected.size(), true);
      const auto found = least_utilisations(*stage, {}, state, whole, asked, in_sets);
      REQUIRE(found.size() == expected.size());
      for (std::size_t c = 0; c < found.size(); ++c) {
        CAPTURE(c);
        if (expected[c].value <= 1.0) {
          ++kept;
          REQUIRE(found[c].value <= 1.0);
          continue;
        }
        REQUIRE(found[c].value == expected[c].value);
        REQUIRE(found[c].slot == expected[c].slot);
        REQUIRE(found[c].row == expected[c].row);
        ++(found[c].slot ? of_slots : of_all);
      }
      if (stage == &arm) {
        asked_all += one_by_one.bounds;
        asked_sets += in_sets.bounds;
      }
      // Constraints that nobody asked about change nothing of the others.
      asked[3] = false;
      const auto without = least_utilisations(*stage, {}, state, whole, asked, in_sets);
      for (std::size_t c = 0; c < found.size(); ++c)
        if (c != 3) REQUIRE(without[c].value == found[c].value);
      REQUIRE(without[3].value <= found[3].value);
    }
  }
  CHECK(of_slots > 100);
  CHECK(of_all > 100);
  CHECK(kept > 100);
  INFO(asked_all << " questions row by row, " << asked_sets << " in sets");
  CHECK(2 * asked_sets < asked_all);
}

TEST_CASE("Looking for least utilisations can be interrupted") {
  std::mt19937 rng(1);
  const Columns arms = random_table(rng, "arm", 3000), motors = random_table(rng, "motor", 300);
  const auto arm = model_stage("arm", {&arms, &motors}, {{"ramp", 0.5, 2.0}}, 7, arm_model(20.0));
  const Silent silent(arm);
  TableMemory tables;
  const Region whole = tables.whole_region(silent, {});
  const std::vector<Interval> state{Interval(0.1)};
  Desk desk;
  desk.interrupt = [] { return true; };
  CHECK_THROWS_AS(least_utilisations(silent, {}, state, whole, std::vector<bool>(7, true), desk), OutOfTime);
  CHECK(desk.bounds <= 256);
}

}  // namespace least_utilisations_test
