// SPDX-License-Identifier: Apache-2.0
// Rows that others stand in for: against every combination of rows, with constraints that are monotone in what is read
// of a row and others that are not.
#include "solver/row_dominance.h"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <tuple>

#include "catch.h"
#include "solver/model_stage.h"
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
    out.resources.push_back(in.row(0, 2) + in.row(1, 2));
    out.resources.push_back(in.row(0, 3) + mass);
    out.handed_on.push_back(carried + mass);
  };
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

}  // namespace

TEST_CASE("Leaving out rows that others stand in for changes neither optimum nor front") {
  std::size_t dominated = 0, feasible = 0, infeasible = 0;
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
    const std::size_t constraints = 4U + (asked.heavier_motor_helps ? 1U : 0U) + (asked.band_to > 0.0 ? 1U : 0U);
    const auto tool = model_stage("tool", {&catalogue.bearings, &catalogue.motors}, {}, constraints, model_of(asked));
    const auto base = model_stage("base", {&catalogue.bearings, &catalogue.motors}, {}, constraints, model_of(asked));
    Problem problem;
    problem.first_state = {1.0};
    problem.stages = {&tool, &base};
    problem.resources = {{"cost"}, {"mass"}};
    const std::vector<Total> totals = all_totals(tool, base);
    CAPTURE(seed, totals.size());

    Options options;
    options.patience = 1;  // every problem counts as one that is not easy
    options.ties = {1};
    const Summary found = solve(problem, options);
    dominated += left_out(problem, options);
    if (totals.empty()) {
      REQUIRE(found.status == Status::infeasible);
      ++infeasible;
      continue;
    }
    ++feasible;
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
  CHECK(dominated > 500);
  CHECK(feasible > 50);
  CHECK(infeasible > 5);
}

}  // namespace row_dominance_test
