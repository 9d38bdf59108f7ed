// SPDX-License-Identifier: Apache-2.0
//
// Figures in tenths have no exact binary form: 0.1 + 0.2 + 0.3 is a little more than 0.6, in another order it is not.
// What reaches a limit exactly keeps it, in whatever order it is added up. Whole tenths tell what is right.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace decimals_test {

namespace {

using namespace millwright::solver;

enum Part : std::size_t { first, second, third, price, part_width };

constexpr double of_tenths(int tenths) { return tenths / 10.0; }  // as a file that says 0.3 is read

struct Assembly {
  std::array<int, 3> tenths;
  int price;
};

/// Assemblies on each other; what they weigh together, and each with the last one alone, is limited.
class Pile {
 public:
  Pile(std::vector<std::vector<Assembly>> levels, std::vector<int> limits)
      : levels_(std::move(levels)), limits_(std::move(limits)) {
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      auto table = std::make_unique<Columns>(Columns{"assembly", part_width, {}});
      for (const Assembly& each : levels_[i]) {
        for (const int tenths : each.tenths) table->numbers.push_back(of_tenths(tenths));
        table->numbers.push_back(each.price);
      }
      keep(model_stage("level", {table.get()}, {}, 1, [limit = of_tenths(limits_[i])](const auto& in, auto& out) {
        const auto sum = in.state(0) + in.row(0, first) + in.row(0, second) + in.row(0, third);
        out.utilisation.push_back(sum / limit);
        out.resources.push_back(in.row(0, price));
        out.resources.push_back(in.row(0, first) + in.row(0, second) + in.row(0, third));
        out.handed_on.push_back(sum);
      }));
      tables_.push_back(std::move(table));
    }
    problem.first_state = {0.0};
    problem.resources = {{"cost"}, {"mass"}};
  }

  /// Price and tenths of all that keep every limit.
  [[nodiscard]] std::vector<std::pair<int, int>> totals() const {
    std::vector<std::pair<int, int>> totals;
    add_totals(0, {0, 0}, totals);
    return totals;
  }

  Problem problem;

 private:
  template <class OneStage>
  void keep(OneStage stage) {
    stages_.push_back(std::make_unique<OneStage>(std::move(stage)));
    problem.stages.push_back(stages_.back().get());
  }
  void add_totals(std::size_t level, std::pair<int, int> so_far, std::vector<std::pair<int, int>>& totals) const {
    if (level == levels_.size()) return totals.push_back(so_far);
    for (const Assembly& each : levels_[level]) {
      const int sum = so_far.second + each.tenths[0] + each.tenths[1] + each.tenths[2];
      if (sum <= limits_[level]) add_totals(level + 1, {so_far.first + each.price, sum}, totals);
    }
  }

  std::vector<std::vector<Assembly>> levels_;
  std::vector<int> limits_;
  std::vector<std::unique_ptr<Columns>> tables_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

std::pair<int, int> total_of(const Build& build) {
  return {static_cast<int>(std::lround(build.resources[0])), static_cast<int>(std::lround(10.0 * build.resources[1]))};
}

std::set<std::pair<int, int>> front_of(std::vector<std::pair<int, int>> totals) {
  std::sort(totals.begin(), totals.end());
  std::set<std::pair<int, int>> front;
  std::optional<int> least;
  for (const auto& [cost, tenths] : totals)
    if (!least || tenths < *least) front.insert({cost, *(least = tenths)});
  return front;
}

void check(const Pile& pile, const Options& how) {
  const std::vector<std::pair<int, int>> totals = pile.totals();
  const Status status = totals.empty() ? Status::infeasible : Status::optimal;
  Options single = how;
  single.objectives = {0};
  single.ties = {1};
  const Summary best = solve(pile.problem, single);
  REQUIRE(best.status == status);
  if (!totals.empty()) REQUIRE(total_of(best.builds[0]) == *std::min_element(totals.begin(), totals.end()));
  Options both = how;
  both.objectives = {0, 1};
  const Summary front = solve(pile.problem, both);
  REQUIRE(front.status == status);
  std::set<std::pair<int, int>> found;
  for (const Build& build : front.builds) found.insert(total_of(build));
  REQUIRE(found == front_of(totals));
}

/// In each way of searching.
void check(const Pile& pile) {
  check(pile, {});
  Options stages;
  stages.patience = 0;
  check(pile, stages);
  Options labels;
  labels.stagewise = false;
  check(pile, labels);
}

std::vector<Assembly> random_assemblies(std::mt19937& random, unsigned rows) {
  std::vector<Assembly> result;
  for (unsigned i = 0; i < rows; ++i) {
    const auto tenths = [&] { return static_cast<int>(1 + random() % 6); };
    result.push_back({{tenths(), tenths(), tenths()}, static_cast<int>(1 + random() % 9)});
  }
  return result;
}

}  // namespace

TEST_CASE("What reaches a limit exactly keeps it, in whatever order it is added up") {
  const Assembly upwards{{1, 2, 3}, 1}, downwards{{3, 2, 1}, 2}, light{{1, 1, 1}, 50};
  check(Pile({{upwards, downwards, light}, {{{0, 0, 0}, 1}}}, {6, 6}));
  check(Pile({{downwards, upwards, light}, {{{0, 0, 0}, 1}}}, {6, 6}));
  check(Pile({{upwards, downwards}, {{{0, 0, 0}, 1}}}, {7, 6}));
  check(Pile({{downwards, upwards}, {{{0, 0, 0}, 1}}}, {7, 6}));
  check(Pile({{upwards, downwards}, {{{0, 0, 0}, 1}}}, {7, 5}));
}

TEST_CASE("Random sums of tenths against limits in tenths equal what whole numbers say") {
  const unsigned seeds = millwright::sanitized ? 60 : 2000;
  unsigned at_a_limit = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const unsigned count = 2 + static_cast<unsigned>(random() % 2);
    std::vector<std::vector<Assembly>> levels;
    std::vector<int> limits;
    for (unsigned i = 1; i <= count; ++i) {
      levels.push_back(random_assemblies(random, 3 + static_cast<unsigned>(random() % 10)));
      limits.push_back(static_cast<int>(8 * i + random() % 6));
    }
    const Pile pile(levels, limits);
    const auto totals = pile.totals();
    at_a_limit += std::ranges::any_of(totals, [&](const auto& total) { return total.second == limits.back(); }) ? 1 : 0;
    check(pile);
  }
  if (!millwright::sanitized) CHECK(at_a_limit > seeds / 2);
}

TEST_CASE("A state that moves another by next to nothing, where that is all there is, is compared") {
  // A load of 100 makes the second state, in picometres, half as large again, or leaves it.
  const Columns loads{"load", 3, {100.0, 1.0, 10.0, 0.0, 100.0, 1.0}};
  const Columns parts{"part", 3, {9e-14, 0.0, 1.0, 0.0, 5e-12, 2.0}};
  const Columns feet{"foot", 1, {1.0}};
  const auto load = model_stage("load", {&loads}, {}, 1, [](const auto& in, auto& out) {
    out.utilisation.push_back(in.row(0, 0) * 0.0);
    out.resources.push_back(in.row(0, 1));
    out.resources.push_back(in.row(0, 2));
    out.handed_on.push_back(in.state(0) + in.row(0, 0));
    out.handed_on.push_back(in.state(1));
  });
  const auto part = model_stage("part", {&parts}, {}, 1, [](const auto& in, auto& out) {
    out.utilisation.push_back(in.row(0, 2) * 0.0);
    out.resources.push_back(in.row(0, 2));
    out.resources.push_back(in.row(0, 2) * 0.0);
    out.handed_on.push_back(in.state(0) * 0.0);
    out.handed_on.push_back(in.state(1) + in.row(0, 0) * in.state(0) + in.row(0, 1));
  });
  const auto foot = model_stage("foot", {&feet}, {}, 1, [](const auto& in, auto& out) {
    out.utilisation.push_back(in.state(1) / 6e-12);
    out.resources.push_back(in.row(0, 0));
    out.resources.push_back(in.row(0, 0) * 0.0);
    out.handed_on.push_back(in.state(0));
    out.handed_on.push_back(in.state(1));
  });
  Problem problem;
  problem.first_state = {0.0, 0.0};
  problem.stages = {&load, &part, &foot};
  problem.resources = {{"cost"}, {"mass"}};
  // By hand: with the load of 100 the first part comes to 9e-12, too much, the second to 5e-12: cost 4, mass 10.
  // Without it the first part, to nothing: cost 102, mass 1; the second costs one more.
  for (const bool stagewise : {true, false}) {
    Options options;
    options.objectives = {0, 1};
    options.stagewise = stagewise;
    const Summary front = solve(problem, options);
    REQUIRE(front.status == Status::optimal);
    REQUIRE(front.builds.size() == 2);
    CHECK(front.builds[0].resources == std::vector<double>{4.0, 10.0});
    CHECK(front.builds[1].resources == std::vector<double>{102.0, 1.0});
  }
}

}  // namespace decimals_test
