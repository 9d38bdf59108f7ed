// SPDX-License-Identifier: Apache-2.0
// Versions of a problem that a build has to satisfy all, against every build tried in every version.
#include "solver/scenario_problem.h"

#include <random>

#include "catch.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace scenario_problem_test {

using namespace millwright::solver;

namespace {

constexpr Row rows = 6;
constexpr std::size_t width = 5;  // price, mass, strength, and of the second slot a and b of a ramp

double uniform(std::mt19937& random, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random()) / 4294967296.0;
}

/// Tables of one version: figures of the first, off by up to a fifth.
struct Tables {
  Columns first{"beam", width, {}}, second{"motor", width, {}};
};

Tables drawn(std::mt19937& random) {
  Tables tables;
  for (Columns* table : {&tables.first, &tables.second})
    for (Row row = 0; row < rows; ++row) {
      table->numbers.push_back(uniform(random, 1.0, 10.0));
      table->numbers.push_back(uniform(random, 0.2, 3.0));
      table->numbers.push_back(uniform(random, 1.0, 12.0));
      table->numbers.push_back(uniform(random, 1.0, 4.0));
      table->numbers.push_back(uniform(random, 0.8, 2.0));
    }
  return tables;
}

Tables varied(std::mt19937& random, const Tables& from) {
  Tables tables = from;
  for (Columns* table : {&tables.first, &tables.second})
    for (std::size_t i = 0; i < table->numbers.size(); ++i)
      if (i % width != 0) table->numbers[i] *= uniform(random, 0.8, 1.2);
  return tables;
}

/// What is carried must not exceed the strength of the beam, nor the motor's share of it; a ramp x in [0, 1] must keep
/// x a <= 1 and (1 - x) b <= 1.
auto stage_of(const Tables& tables) {
  return model_stage("axis", {&tables.first, &tables.second}, {{"x", 0.0, 1.0}}, 4, [](const auto& in, auto& out) {
    const auto load = in.state(0) + in.row(1, 1);
    out.utilisation.push_back(load / in.row(0, 2));
    out.utilisation.push_back((load + in.row(0, 1)) / (1.5 * in.row(1, 2)));
    out.utilisation.push_back(in.variable(0) * in.row(1, 3));
    out.utilisation.push_back((1.0 - in.variable(0)) * in.row(1, 4));
    out.resources.push_back(in.row(0, 0) + in.row(1, 0));
    out.resources.push_back(in.row(0, 1) + in.row(1, 1));
    out.handed_on.push_back(load + in.row(0, 1));
  });
}
using AxisStage = decltype(stage_of(std::declval<const Tables&>()));

struct Version {
  std::vector<Tables> tables;
  std::vector<AxisStage> stages;
  Problem problem;
};

/// The cheapest build that every version takes; none: infinite. There is a ramp if the largest 1 - 1/b is
/// not above the smallest 1/a.
double cheapest(const std::vector<Version>& versions, double mass_limit) {
  double best = std::numeric_limits<double>::infinity();
  const std::size_t stages = versions.front().tables.size();
  std::vector<Row> choice(2 * stages, 0);
  for (;;) {
    bool good = true;
    double cost = 0.0;
    std::vector<double> least(stages, 0.0), most(stages, 1.0);
    for (const Version& version : versions) {
      double load = 1.0, mass = 0.0;
      for (std::size_t i = 0; i < stages; ++i) {
        const double* beam = version.tables[i].first.row(choice[2 * i]);
        const double* motor = version.tables[i].second.row(choice[2 * i + 1]);
        load += motor[1];
        good = good && load <= beam[2] && load + beam[1] <= 1.5 * motor[2];
        load += beam[1];
        mass += beam[1] + motor[1];
        least[i] = std::max(least[i], 1.0 - 1.0 / motor[4]);
        most[i] = std::min(most[i], 1.0 / motor[3]);
        if (&version == &versions.front()) cost += beam[0] + motor[0];
      }
      good = good && mass <= mass_limit;
    }
    for (std::size_t i = 0; i < stages; ++i) good = good && least[i] <= most[i];
    if (good) best = std::min(best, cost);
    std::size_t at = 0;
    while (at < choice.size() && ++choice[at] == rows) choice[at++] = 0;
    if (at == choice.size()) return best;
  }
}

}  // namespace

TEST_CASE("The cheapest build of several versions is the cheapest that every version takes") {
  int feasible = 0, dearer = 0, impossible = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const double limit = seed % 3 == 0 ? uniform(random, 3.0, 9.0) : std::numeric_limits<double>::infinity();
    const std::size_t stages = 2;
    std::vector<Version> versions(1 + seed % 3);
    for (std::size_t i = 0; i < stages; ++i) versions.front().tables.push_back(drawn(random));
    for (std::size_t v = 1; v < versions.size(); ++v)
      for (const Tables& tables : versions.front().tables) versions[v].tables.push_back(varied(random, tables));
    std::vector<const Problem*> problems;
    for (Version& version : versions) {
      for (const Tables& tables : version.tables) version.stages.push_back(stage_of(tables));
      for (const AxisStage& stage : version.stages) version.problem.stages.push_back(&stage);
      version.problem.first_state = {1.0};
      version.problem.resources = {{"cost"}, {"mass", limit}};
      problems.push_back(&version.problem);
    }
    const ScenarioProblem all(problems);
    Options options;
    options.objectives = {0};
    const Summary found = solve(all.problem(), options);
    const double expected = cheapest(versions, limit);
    CAPTURE(seed, versions.size(), limit);
    REQUIRE(found.builds.empty() == std::isinf(expected));
    if (found.builds.empty()) {
      ++impossible;
      continue;
    }
    ++feasible;
    CHECK(found.builds.front().resources[0] == Approx(expected).epsilon(1e-6));
    dearer += expected > cheapest({versions.front()}, limit) * (1.0 + 1e-6);
  }
  CHECK(feasible > 10);
  CHECK(dearer > 3);
  CHECK(impossible > 0);
}

TEST_CASE("Versions with different rows are refused") {
  std::mt19937 random(1);
  Version a, b;
  for (Version* version : {&a, &b}) version->tables.push_back(drawn(random));
  b.tables.front().first.numbers.resize(width * (rows - 1));
  for (Version* version : {&a, &b}) {
    version->stages.push_back(stage_of(version->tables.front()));
    version->problem.stages = {&version->stages.front()};
    version->problem.first_state = {1.0};
    version->problem.resources = {{"cost"}, {"mass"}};
  }
  CHECK_THROWS_AS(ScenarioProblem({&a.problem, &b.problem}), std::invalid_argument);
}

}  // namespace scenario_problem_test
