// SPDX-License-Identifier: Apache-2.0
// Rows that others stand in for: against every combination of rows, with constraints that are monotone in what is read
// of a row and others that are not.
#include "solver/row_dominance.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <random>
#include <tuple>

#include "catch.h"
#include "solver/forwarding_stage.h"
#include "solver/model_stage.h"
#include "solver/restricted_problem.h"
#include "solver/solver.h"

namespace row_dominance_test {

namespace {

using namespace millwright::solver;
using millwright::scalar::smaller;

/// Bearings (capacity, stiffness, price, mass) and motors (torque, inertia, price, mass): few values each, so that rows
/// are often equal in some columns.
struct Catalogue {
  Columns bearings{"bearing", 4, {}}, motors{"motor", 4, {}};
};

Catalogue random_catalogue(std::mt19937& rng, std::size_t rows) {
  Catalogue catalogue;
  const auto some = [&](unsigned values) { return 1.0 + static_cast<double>(rng() % values); };
  for (std::size_t i = 0; i < rows; ++i) {
    for (const unsigned values : {4U, 3U, 5U, 3U}) catalogue.bearings.numbers.push_back(some(values));
    for (const unsigned values : {4U, 4U, 5U, 3U}) catalogue.motors.numbers.push_back(some(values));
  }
  return catalogue;
}

/// What is asked of a design; a least ratio of inertias and a band of frequencies are not monotone in what they read.
struct Asked {
  double load = 1.0, least_ratio = 0.0, largest_ratio = 1e9;
  double band_from = 0.0, band_to = 0.0;  ///< of stiffness / mass
  bool heavier_motor_helps = false;       ///< the motor is the counterweight
  double least_stiffness = -1.0;          ///< of a bearing, per mass carried; below 0: not asked
};

auto model_of(const Asked& asked) {
  return [asked](const auto& in, auto& out) {
    const auto capacity = in.row(0, 0), stiffness = in.row(0, 1), torque = in.row(1, 0), inertia = in.row(1, 1);
    const auto carried = in.state(0) + in.row(0, 3);
    const auto mass = in.row(1, 3);
    out.utilisation.push_back(asked.load * carried / capacity);
    out.utilisation.push_back(carried * (1.0 + 0.2 * inertia) / (2.0 * torque));
    out.utilisation.push_back(asked.least_ratio * inertia / carried);
    out.utilisation.push_back(carried / (asked.largest_ratio * inertia));
    if (asked.heavier_motor_helps) out.utilisation.push_back(carried / (3.0 * mass));
    if (asked.band_to > 0.0) {
      // Outside of the band on either side: 1 at its ends.
      const auto ratio = stiffness / carried;
      out.utilisation.push_back(smaller(ratio / asked.band_from, asked.band_to / ratio));
    }
    if (asked.least_stiffness >= 0.0) out.utilisation.push_back(asked.least_stiffness * carried / stiffness);
    out.resources.push_back(in.row(0, 2) + in.row(1, 2));
    out.resources.push_back(in.row(0, 3) + mass);
    out.handed_on.push_back(carried + mass);
  };
}

auto stage_of(const std::string& name, const Catalogue& catalogue, const Asked& asked) {
  const std::size_t constraints = 4U + (asked.heavier_motor_helps ? 1U : 0U) + (asked.band_to > 0.0 ? 1U : 0U) +
                                  (asked.least_stiffness >= 0.0 ? 1U : 0U);
  return model_stage(name, {&catalogue.bearings, &catalogue.motors}, {}, constraints, model_of(asked));
}

struct Total {
  double cost, mass, worst_utilisation;
};

/// Totals of all feasible combinations of two stages.
template <class StageType>
std::vector<Total> all_totals(const StageType& tool, const StageType& base) {
  std::vector<Total> totals;
  Answer<double> answer;
  const auto ask = [&](const Stage& stage, double carried, auto&& taken) {
    for (Row a = 0; a < stage.slots()[0].rows; ++a)
      for (Row b = 0; b < stage.slots()[1].rows; ++b) {
        const std::array<Row, 2> rows{a, b};
        const std::array<double, 1> state{carried};
        stage.evaluate({{}, state, rows, {}}, answer);
        const double worst = *std::max_element(answer.utilisation.begin(), answer.utilisation.end());
        if (worst <= 1.0) taken(Total{answer.resources[0], answer.resources[1], worst}, answer.handed_on[0]);
      }
  };
  ask(tool, 1.0, [&](const Total& above, double carried) {
    ask(base, carried, [&](const Total& below, double) {
      totals.push_back({above.cost + below.cost,
                        above.mass + below.mass,
                        std::max(above.worst_utilisation, below.worst_utilisation)});
    });
  });
  return totals;
}

/// How many rows are left out of the slots of all plans.
std::size_t left_out(const Problem& problem, const Options& options) {
  const Criteria criteria = make_criteria(problem, options);
  Desk desk;
  std::vector<StagePlan> plans = make_plans(problem, {}, criteria, desk);
  const auto rows = [&] {
    std::size_t sum = 0;
    for (const StagePlan& plan : plans)
      for (const RowSet& set : plan.region.rows) sum += set->size();
    return sum;
  };
  const std::size_t before = rows();
  leave_out_dominated_rows(plans, desk);
  return before - rows();
}

struct Tally {
  std::size_t dominated = 0, feasible = 0, infeasible = 0;
};

/// That optimum and front of two stages are those of all their combinations.
template <class StageType>
void check_answers(const StageType& tool, const StageType& base, Tally& tally) {
  Problem problem;
  problem.first_state = {1.0};
  problem.stages = {&tool, &base};
  problem.resources = {{"cost"}, {"mass"}};
  const std::vector<Total> totals = all_totals(tool, base);
  CAPTURE(totals.size());

  Options options;
  options.patience = 1;  // every problem counts as one that is not easy
  options.ties = {1};
  const Summary found = solve(problem, options);
  tally.dominated += left_out(problem, options);
  if (totals.empty()) {
    REQUIRE(found.status == Status::infeasible);
    ++tally.infeasible;
    return;
  }
  ++tally.feasible;
  const auto least = std::min_element(totals.begin(), totals.end(), [](const Total& a, const Total& b) {
    return std::tuple(a.cost, a.mass, a.worst_utilisation) < std::tuple(b.cost, b.mass, b.worst_utilisation);
  });
  REQUIRE(found.status == Status::optimal);
  REQUIRE(found.builds.front().resources[0] == least->cost);
  REQUIRE(found.builds.front().resources[1] == least->mass);
  REQUIRE(found.builds.front().worst_utilisation == Approx(least->worst_utilisation).epsilon(1e-12));

  Options both;
  both.objectives = {0, 1};
  const Summary front = solve(problem, both);
  REQUIRE(front.status == Status::optimal);
  std::vector<std::pair<double, double>> points, expected;
  for (const Build& build : front.builds) points.emplace_back(build.resources[0], build.resources[1]);
  for (const Total& total : totals) {
    const bool beaten = std::any_of(totals.begin(), totals.end(), [&](const Total& other) {
      return other.cost <= total.cost && other.mass <= total.mass &&
             (other.cost < total.cost || other.mass < total.mass);
    });
    if (!beaten) expected.emplace_back(total.cost, total.mass);
  }
  for (auto* list : {&points, &expected}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  REQUIRE(points == expected);
}

/// Bearings of odd rows are of a second kind, of which one constraint more has to hold. Of both kinds together it can
/// only be said that it may hold or not.
class TwoKinds final : public zoo::ForwardingStage {
 public:
  TwoKinds(const Stage& first, const Stage& second) : zoo::ForwardingStage(first), kinds_{&first, &second} {}

  [[nodiscard]] std::size_t row_kind(std::size_t slot, Row row) const override { return slot == 0 ? row % 2 : 0; }
  void evaluate(const Point& point, Answer<double>& answer) const override {
    kinds_[point.rows[0] % 2]->evaluate(point, answer);
  }
  void bound(const Box& box, Answer<Interval>& answer) const override {
    kinds_[box.rows[0].front() % 2]->bound(box, answer);
    if (is_mixed(box)) answer.utilisation.back() = {0.0, std::numeric_limits<double>::infinity()};
  }
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override {
    kinds_[box.rows[0].front() % 2]->slopes(box, input, answer);
    if (is_mixed(box)) answer.utilisation.back() = Interval::entire();
  }

 private:
  static bool is_mixed(const Box& box) {
    return std::ranges::any_of(box.rows[0], [&](Row row) { return row % 2 != box.rows[0].front() % 2; });
  }
  std::array<const Stage*, 2> kinds_;
};

}  // namespace

TEST_CASE("Leaving out rows that others stand in for changes neither optimum nor front") {
  Tally tally;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    std::mt19937 rng(seed);
    const Catalogue catalogue = random_catalogue(rng, 12);
    Asked asked;
    asked.load = 0.5 + 0.25 * static_cast<double>(rng() % 4);
    if (seed % 2 == 0) asked.least_ratio = 0.5 + static_cast<double>(rng() % 3);
    if (seed % 3 == 0) asked.largest_ratio = 1.0 + static_cast<double>(rng() % 3);
    if (seed % 5 == 0) {
      asked.band_from = 0.4;
      asked.band_to = 0.9;
    }
    asked.heavier_motor_helps = seed % 4 == 0;
    const auto tool = stage_of("tool", catalogue, asked);
    const auto base = stage_of("base", catalogue, asked);
    CAPTURE(seed);
    check_answers(tool, base, tally);
  }
  CHECK(tally.dominated > 500);
  CHECK(tally.feasible > 50);
  CHECK(tally.infeasible > 5);
}

/// Two kinds of bearings in both stages; `check` is told the two.
template <class Check>
void with_two_kinds(unsigned seed, std::mt19937& rng, const Check& check) {
  const Catalogue catalogue = random_catalogue(rng, 12);
  Asked asked;
  asked.load = 0.5 + 0.25 * static_cast<double>(rng() % 4);
  asked.least_stiffness = 0.0;
  const auto tool = stage_of("tool", catalogue, asked), base = stage_of("base", catalogue, asked);
  asked.least_stiffness = 0.2 * static_cast<double>(1U + rng() % 4);
  const auto other_tool = stage_of("tool", catalogue, asked), other_base = stage_of("base", catalogue, asked);
  CAPTURE(seed);
  check(TwoKinds(tool, other_tool), TwoKinds(base, other_base));
}

TEST_CASE("Rows of one kind stand in for each other where a constraint holds for one kind only") {
  Tally tally;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 rng(seed);
    with_two_kinds(seed, rng, [&](const TwoKinds& tool, const TwoKinds& base) { check_answers(tool, base, tally); });
  }
  CHECK(tally.dominated > 250);
  CHECK(tally.feasible > 50);
  CHECK(tally.infeasible > 1);
}

TEST_CASE("Of a restricted problem those rows stand in for others that are left") {
  Tally tally;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 rng(seed);
    with_two_kinds(seed, rng, [&](const TwoKinds& tool, const TwoKinds& base) {
      StageRestriction left;
      for (std::size_t slot = 0; slot < 2; ++slot) {
        left.allowed.emplace_back();
        for (Row row = 0; row < 12; ++row)
          if (rng() % 4 != 0) left.allowed.back().push_back(row);
      }
      check_answers(RestrictedStage(tool, left, {}), RestrictedStage(base, left, {}), tally);
    });
  }
  CHECK(tally.dominated > 150);
  CHECK(tally.feasible > 50);
  CHECK(tally.infeasible > 1);
}

TEST_CASE("Very long tables lose the rows that others stand in for before anything else is asked") {
  constexpr std::size_t rows = 24000;
  std::size_t infeasible = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> share(0.5, 1.5);
    Catalogue catalogue;
    for (std::size_t i = 0; i < rows; ++i)
      for (const double usual : {1.0, 1.0, 3.0, 1.0}) catalogue.bearings.numbers.push_back(usual * share(rng));
    for (std::size_t i = 0; i < 3; ++i)
      for (const double usual : {2.5, 2.0, 3.0, 1.0}) catalogue.motors.numbers.push_back(usual * share(rng));
    Asked asked;
    asked.load = seed == 4 ? 5.0 : 0.22;
    asked.least_stiffness = 0.1;
    const auto plain = stage_of("tool", catalogue, asked);
    asked.least_stiffness = 0.25;
    const auto stiffer = stage_of("tool", catalogue, asked);
    const TwoKinds tool(plain, stiffer);
    CAPTURE(seed);

    std::vector<std::pair<double, double>> totals;
    Answer<double> answer;
    const std::array<double, 1> state{1.0};
    for (Row a = 0; a < rows; ++a)
      for (Row b = 0; b < 3; ++b) {
        const std::array<Row, 2> chosen{a, b};
        tool.evaluate({{}, state, chosen, {}}, answer);
        if (*std::max_element(answer.utilisation.begin(), answer.utilisation.end()) <= 1.0)
          totals.emplace_back(answer.resources[0], answer.resources[1]);
      }
    std::sort(totals.begin(), totals.end());
    std::vector<std::pair<double, double>> expected;
    for (const auto& total : totals)
      if (expected.empty() || total.second < expected.back().second) expected.push_back(total);

    Problem problem;
    problem.first_state = {1.0};
    problem.stages = {&tool};
    problem.resources = {{"cost"}, {"mass"}};
    Options both;
    both.objectives = {0, 1};
    const Summary front = solve(problem, both), cheapest = solve(problem, {});
    if (totals.empty()) {
      REQUIRE(front.status == Status::infeasible);
      REQUIRE(cheapest.status == Status::infeasible);
      ++infeasible;
      continue;
    }
    REQUIRE(cheapest.builds.front().resources[0] == totals.front().first);
    std::vector<std::pair<double, double>> points;
    for (const Build& build : front.builds) points.emplace_back(build.resources[0], build.resources[1]);
    std::sort(points.begin(), points.end());
    REQUIRE(points == expected);

    const Criteria criteria = make_criteria(problem, both);
    Desk desk;
    TableMemory tables;
    const auto planned = [&](PlannedRows which) {
      return make_plans(problem, {}, criteria, desk, tables, which).front().region.rows[0]->size();
    };
    const std::size_t all = planned(PlannedRows::all);
    REQUIRE(all > 20000);
    REQUIRE(planned(PlannedRows::best_of_very_long) < all / 5);
  }
  CHECK(infeasible == 1);
}

}  // namespace row_dominance_test
