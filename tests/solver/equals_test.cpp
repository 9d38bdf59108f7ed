// SPDX-License-Identifier: Apache-2.0
//
// Builds as light as each other, of which the cheapest is wanted, where a free thickness moves the mass: against all
// pairs of parts and the thickness that each needs.
#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace equals_test {

namespace {

using namespace millwright::solver;

enum Part : std::size_t { price, mass, size, part_width };

double whole(std::mt19937& random, unsigned least, unsigned most) {
  return static_cast<double>(least + random() % (most - least + 1));
}

/// Two parts that have to be of the same size, so that hardly ever one alone can be changed, on a plate that has to be
/// the thicker the heavier they are.
class PartsOnPlate {
 public:
  explicit PartsOnPlate(unsigned seed) {
    std::mt19937 random(seed);
    for (Columns* table : {&first_, &second_})
      for (int row = 0; row < 8; ++row)
        for (const double number : {whole(random, 100, 999), whole(random, 2, 6), whole(random, 1, 4)})
          table->numbers.push_back(number);
    problem.resources = {{"cost"}, {"mass"}};
    problem.first_state = {0.0};
    add(model_stage("pair", {&first_, &second_}, {}, 2, [](const auto& in, auto& out) {
      out.utilisation.push_back(in.row(0, size) / in.row(1, size));
      out.utilisation.push_back(in.row(1, size) / in.row(0, size));
      out.resources.push_back(in.row(0, price) + in.row(1, price));
      out.resources.push_back(in.row(0, mass) + in.row(1, mass));
      out.handed_on.push_back(in.state(0) + in.row(0, mass) + in.row(1, mass));
    }));
    add(model_stage("plate", {}, {{"thickness", 0.5, 10.0}}, 1, [](const auto& in, auto& out) {
      const auto& thickness = in.variable(0);
      out.utilisation.push_back(0.5 * in.state(0) / thickness);
      out.resources.push_back(3.0 * thickness);
      out.resources.push_back(1.0 * thickness);
      out.handed_on.push_back(in.state(0));
    }));
  }

  /// The least cost of the lightest builds, and their mass: what a plate carries is half as thick and as heavy.
  [[nodiscard]] std::pair<double, double> cheapest_of_lightest() const {
    double least = std::numeric_limits<double>::infinity(), cost = least;
    for (Row a = 0; a < 8; ++a)
      for (Row b = 0; b < 8; ++b) {
        if (first_.row(a)[size] != second_.row(b)[size]) continue;
        const double carried = first_.row(a)[mass] + second_.row(b)[mass];
        const double its_cost = first_.row(a)[price] + second_.row(b)[price] + 3.0 * 0.5 * carried;
        if (1.5 * carried < least) cost = its_cost;
        if (1.5 * carried == least) cost = std::min(cost, its_cost);
        least = std::min(least, 1.5 * carried);
      }
    return {cost, least};
  }

  Problem problem;

 private:
  template <class S>
  void add(S stage) {
    stages_.push_back(std::make_unique<S>(std::move(stage)));
    problem.stages.push_back(stages_.back().get());
  }

  Columns first_{"first", part_width, {}}, second_{"second", part_width, {}};
  std::vector<std::unique_ptr<Stage>> stages_;
};

Options lightest(bool settle_ties, unsigned threads = 1) {
  Options options;
  options.objectives = {1};
  options.ties = {0};
  options.confirm = false;
  options.settle_ties = settle_ties;
  options.threads = threads;
  return options;
}

}  // namespace

TEST_CASE("Of builds that are as light the cheapest is taken, where a thickness that is free moves the mass") {
  int dearer = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 20U : 200U); ++seed) {
    INFO("seed " << seed);
    const PartsOnPlate parts(seed);
    const auto [cost, mass] = parts.cheapest_of_lightest();
    const Summary found = solve(parts.problem, lightest(true));
    if (mass == std::numeric_limits<double>::infinity()) {
      CHECK(found.status == Status::infeasible);
      continue;
    }
    REQUIRE(found.status == Status::optimal);
    CHECK(found.builds[0].resources[1] == Approx(mass).epsilon(1e-6));
    CHECK(found.builds[0].resources[0] == Approx(cost).epsilon(1e-6));
    CHECK(found.lower_bound <= mass * (1.0 + 1e-12));
    CHECK(solve(parts.problem, lightest(true, 2)).builds[0].stages[0].rows == found.builds[0].stages[0].rows);
    CHECK(found.method.find("no worse the best in what is compared next") != std::string::npos);
    const Summary neighbours = solve(parts.problem, lightest(false));
    CHECK(neighbours.method.find("no worse") == std::string::npos);
    CHECK(neighbours.builds[0].resources[1] == Approx(mass).epsilon(1e-6));
    dearer += neighbours.builds[0].resources[0] > cost * (1.0 + 1e-6);
  }
  if (!millwright::sanitized) CHECK(dearer > 0);  // else neighbours would do
}

TEST_CASE("A search ends at its most nodes as when time is up") {
  const PartsOnPlate parts(1);
  Options options = lightest(false);
  options.most_nodes = 0;
  const Summary stopped = solve(parts.problem, options);
  const Summary whole = solve(parts.problem, lightest(false));
  REQUIRE(whole.nodes > 1);
  CHECK(stopped.status == Status::limit);
  CHECK(stopped.nodes < whole.nodes);
  CHECK(stopped.lower_bound <= whole.builds[0].resources[1]);
}

TEST_CASE("A front that was ended before it was whole is not said to be covered") {
  const PartsOnPlate parts(1);
  Options options;
  options.objectives = {0, 1};
  const auto is_said_covered = [&](std::uint64_t most) {
    options.most_nodes = most;
    const Summary front = solve(parts.problem, options);
    CHECK((front.status == Status::optimal || front.status == Status::limit));
    CHECK(front.front_tolerance > 0.0);
    const bool said = front.method.find("the front is covered to its tolerance") != std::string::npos;
    CHECK(said == (front.status == Status::optimal));
    return said;
  };
  CHECK_FALSE(is_said_covered(0));
  CHECK(is_said_covered(std::numeric_limits<std::uint64_t>::max()));
}

TEST_CASE("Where a search is cut short it is told that builds as good may not have been compared") {
  int with_build = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const PartsOnPlate parts(seed);
    for (std::uint64_t most = 0; most < 40; most += 4) {
      Options options = lightest(true);
      options.most_nodes = most;
      const Summary stopped = solve(parts.problem, options);
      if (stopped.status != Status::limit || stopped.builds.empty()) continue;
      ++with_build;
      CHECK(stopped.method.find("no worse not all were compared in what comes next") != std::string::npos);
    }
  }
  CHECK(with_build > 0);
}

namespace {

/// Three pairs, each to be of one size, without anything free. What is cheapest of the lightest is so pair by pair.
class Pairs {
 public:
  explicit Pairs(unsigned seed) {
    std::mt19937 random(seed);
    tables_.resize(6, Columns{"part", part_width, {}});
    for (Columns& table : tables_)
      for (int row = 0; row < 12; ++row)
        for (const double number : {whole(random, 100, 999), whole(random, 2, 4), whole(random, 1, 3)})
          table.numbers.push_back(number);
    problem.resources = {{"cost"}, {"mass"}};
    for (std::size_t pair = 0; pair < 3; ++pair) {
      auto stage =
          model_stage("pair", {&tables_[2 * pair], &tables_[2 * pair + 1]}, {}, 2, [](const auto& in, auto& out) {
            out.utilisation.push_back(in.row(0, size) / in.row(1, size));
            out.utilisation.push_back(in.row(1, size) / in.row(0, size));
            out.resources.push_back(in.row(0, price) + in.row(1, price));
            out.resources.push_back(in.row(0, mass) + in.row(1, mass));
          });
      stages_.push_back(std::make_unique<decltype(stage)>(std::move(stage)));
      problem.stages.push_back(stages_.back().get());
    }
  }

  /// The least mass, and the least cost with it.
  [[nodiscard]] std::pair<double, double> lightest_then_cheapest() const {
    double all_mass = 0.0, all_cost = 0.0;
    for (std::size_t pair = 0; pair < 3; ++pair) {
      std::pair<double, double> best{std::numeric_limits<double>::infinity(), 0.0};
      const Columns& first = tables_[2 * pair];
      const Columns& second = tables_[2 * pair + 1];
      for (Row a = 0; a < 12; ++a)
        for (Row b = 0; b < 12; ++b)
          if (first.row(a)[size] == second.row(b)[size])
            best =
                std::min(best, {first.row(a)[mass] + second.row(b)[mass], first.row(a)[price] + second.row(b)[price]});
      all_mass += best.first;
      all_cost += best.second;
    }
    return {all_mass, all_cost};
  }

  Problem problem;

 private:
  std::vector<Columns> tables_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

}  // namespace

TEST_CASE("A build that is proved lightest is the cheapest of those, or it is told that not all were compared") {
  int dearer = 0, whole = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 10U : 100U); ++seed) {
    const Pairs pairs(seed);
    const auto [mass, cost] = pairs.lightest_then_cheapest();
    for (const std::uint64_t patience : {std::uint64_t{0}, std::uint64_t{25000}})
      for (std::uint64_t most = 0; most < 200; most += 1 + most / 8) {
        INFO("seed " << seed << ", patience " << patience << ", most nodes " << most);
        Options options = lightest(true);
        options.patience = patience;
        options.most_nodes = most;
        const Summary found = solve(pairs.problem, options);
        if (found.status == Status::limit) continue;
        REQUIRE(found.status == Status::optimal);
        CHECK(found.builds[0].resources[1] == mass);
        const bool told = found.method.find("no worse not all were compared in what comes next") != std::string::npos;
        whole += !told;
        dearer += found.builds[0].resources[0] > cost;
        CHECK((told || found.builds[0].resources[0] == cost));
      }
  }
  CHECK(whole > 0);
  if (!millwright::sanitized) CHECK(dearer > 0);
}

}  // namespace equals_test
