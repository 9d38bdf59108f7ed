// SPDX-License-Identifier: Apache-2.0
//
// Good builds before any proof: where there are so many nearly equal parts that nothing is proved for long, something
// is found early; and a build is improved part by part.
#include <atomic>
#include <random>

#include "catch.h"
#include "solver/model_stage.h"
#include "solver/neighbours.h"
#include "solver/solver.h"

namespace look_first_test {

namespace {

using namespace millwright::solver;

enum PartColumn { strength, price, part_width };

/// Parts that get dearer with their strength, up to a few percent.
Columns random_parts(std::size_t rows, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  Columns parts{"part", part_width, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    const double strong = 1.0 + uniform();
    parts.numbers.push_back(strong);
    parts.numbers.push_back(10.0 * strong * strong * (0.97 + 0.06 * uniform()));
  }
  return parts;
}

/// Four parts of which the product of the strengths, times the voltage's factor, has to reach a demand.
struct Product {
  double demand = 0.0;
  std::atomic<bool>* stop = nullptr;
  std::atomic<std::int64_t>* left = nullptr;  ///< questions before it is stopped
  static constexpr double factor[2] = {0.3, 1.0};

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    if (left != nullptr && --*left <= 0) *stop = true;
    const double by_voltage = factor[in.shared(0)];
    out.utilisation.push_back(
        demand / (by_voltage * in.row(0, strength) * in.row(1, strength) * in.row(2, strength) * in.row(3, strength)));
    out.resources.push_back(in.row(0, price) + in.row(1, price) + in.row(2, price) + in.row(3, price));
  }
};

struct Products {
  Products(std::size_t rows, Product model, unsigned seed) {
    for (unsigned i = 0; i < 4; ++i) tables.push_back(random_parts(rows, seed + i));
    stage = std::make_unique<ModelStage<Product>>(
        "product",
        std::vector<const Columns*>{&tables[0], &tables[1], &tables[2], &tables[3]},
        std::vector<Variable>{},
        1,
        model);
    problem.shared = {{"voltage", 2}};
    problem.stages = {stage.get()};
    problem.resources = {{"cost"}};
  }
  std::vector<Columns> tables;
  std::unique_ptr<Stage> stage;
  Problem problem;
};

}  // namespace

TEST_CASE("A build is found early where proofs are long") {
  for (const double demand : {6.0, 8.0, 12.0}) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
      std::atomic<bool> stop = false;
      std::atomic<std::int64_t> left = 150000;
      Products products(400, {demand, &stop, &left}, seed);
      Options options;
      options.stop = &stop;
      const Summary summary = solve(products.problem, options);
      INFO("demand " << demand << ", seed " << seed);
      REQUIRE(summary.builds.size() == 1);
      CHECK(summary.gap < 0.05);
      CHECK(summary.lower_bound <= summary.builds[0].resources[0]);
    }
  }
}

TEST_CASE("A build improved part by part is feasible, and no other single part makes it better") {
  std::size_t improved = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Products products(30, {6.0}, 100 + seed);
    const Stage& stage = *products.problem.stages[0];
    const auto answer_of = [&](const std::vector<Row>& rows) {
      const std::vector<Row> shared{1};
      Answer<double> answer;
      stage.evaluate({shared, {}, rows, {}}, answer);
      return answer;
    };
    Build build;
    build.shared = {1};
    build.stages.resize(1);
    std::mt19937_64 random(seed);
    do {
      build.stages[0].rows.clear();
      for (int i = 0; i < 4; ++i) build.stages[0].rows.push_back(static_cast<Row>(random() % 30));
    } while (answer_of(build.stages[0].rows).utilisation[0] > 1.0);
    build.resources = answer_of(build.stages[0].rows).resources;
    const Build better =
        Neighbours(products.problem)
            .improved(
                build, [](std::span<const double> resources) { return resources[0]; }, [] { return false; });
    const Answer<double> answer = answer_of(better.stages[0].rows);
    REQUIRE(answer.utilisation[0] <= 1.0);
    REQUIRE(answer.resources[0] == better.resources[0]);
    REQUIRE(better.resources[0] <= build.resources[0]);
    improved += better.resources[0] < build.resources[0] ? 1 : 0;
    for (std::size_t slot = 0; slot < 4; ++slot) {
      for (Row row = 0; row < 30; ++row) {
        std::vector<Row> rows = better.stages[0].rows;
        rows[slot] = row;
        const Answer<double> other = answer_of(rows);
        REQUIRE((other.utilisation[0] > 1.0 || other.resources[0] >= better.resources[0]));
      }
    }
  }
  CHECK(improved > 20);
}

}  // namespace look_first_test
