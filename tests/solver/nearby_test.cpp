// SPDX-License-Identifier: Apache-2.0
// The best build nearby is feasible, no worse than what it began with, and not better than the proven optimum.
#include "solver/nearby.h"

#include <algorithm>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/box.h"
#include "solver/forwarding_stage.h"
#include "solver/front_spread.h"
#include "solver/model_stage.h"
#include "solver/multipliers.h"

namespace nearby_test {

namespace {

using namespace millwright::solver;

/// A bar of free diameter that bears what stands on it; rows of bars (price, strength, weight) and of feet (price,
/// capacity).
auto model_of(double load) {
  return [load](const auto& in, auto& out) {
    const auto carried = load + in.state(0);
    const auto diameter = in.variable(0);
    out.utilisation.push_back(carried / (in.row(0, 1) * diameter));
    out.utilisation.push_back(carried / in.row(1, 1));
    out.resources.push_back(in.row(0, 0) * diameter + in.row(1, 0));
    out.resources.push_back(in.row(0, 2) * diameter);
    out.handed_on.push_back(in.state(0) + in.row(0, 2) * diameter);
  };
}

/// Two of them, one on the other, with random rows and loads.
struct TwoBars {
  explicit TwoBars(std::mt19937& rng) {
    const auto between = [&](double low, double high) {
      return low + (high - low) * (static_cast<double>(rng() % 1000000) / 1e6);
    };
    for (int i = 0; i < 8; ++i)
      bars.numbers.insert(bars.numbers.end(), {between(1.0, 4.0), between(0.5, 3.0), between(0.01, 0.3)});
    for (int i = 0; i < 6; ++i) feet.numbers.insert(feet.numbers.end(), {between(1.0, 9.0), between(1.0, 6.0)});
    const std::vector<Variable> diameter{{"diameter", 0.5, 6.0}};
    for (const char* name : {"upper", "lower"}) {
      using Bar = decltype(model_stage(name, {&bars, &feet}, diameter, 2, model_of(0.0)));
      stages.push_back(
          std::make_unique<Bar>(model_stage(name, {&bars, &feet}, diameter, 2, model_of(between(0.5, 2.0)))));
      problem.stages.push_back(stages.back().get());
    }
    problem.first_state = {0.0};
    problem.resources = {{"cost"}, {"mass"}};
  }

  Columns bars{"bar", 3, {}}, feet{"foot", 2, {}};
  std::vector<std::unique_ptr<Stage>> stages;
  Problem problem;
};

Options lightest() {
  Options options;
  options.objectives = {1};
  return options;
}

/// Totals from single evaluations; nothing if it is not feasible.
std::optional<std::vector<double>> totals_of(const Problem& problem, const Build& build) {
  std::vector<double> totals(problem.resources.size(), 0.0);
  std::vector<double> state = problem.first_state;
  Answer<double> answer;
  for (std::size_t i = 0; i < problem.stages.size(); ++i) {
    problem.stages[i]->evaluate({{}, state, build.stages[i].rows, build.stages[i].variables}, answer);
    if (worst_of(answer.utilisation) > 1.0) return std::nullopt;
    for (std::size_t r = 0; r < totals.size(); ++r) totals[r] += answer.resources[r];
    state = answer.handed_on;
  }
  return totals;
}

}  // namespace

TEST_CASE("The best build nearby is feasible, and no row nor diameter alone makes it better") {
  std::mt19937 rng(7);
  const int problems = millwright::sanitized ? 4 : 60;
  int trials = 0, better = 0, best = 0;
  for (int n = 0; n < problems; ++n) {
    const TwoBars two(rng);
    const Problem& problem = two.problem;
    const Summary start = solve(problem, lightest());
    const Summary proved = solve(problem, {});
    REQUIRE((start.builds.empty() == proved.builds.empty()));
    if (start.builds.empty()) continue;
    ++trials;
    CAPTURE(n);
    const Build& from = start.builds.front();
    const Build found = best_nearby(problem, {}, from, [] { return false; });
    const auto totals = totals_of(problem, found);
    REQUIRE(totals);
    CHECK(found.resources == *totals);
    const double cost = (*totals)[0];
    CHECK(cost <= from.resources[0]);
    CHECK(cost >= proved.lower_bound * (1.0 - 1e-9));
    better += cost < 0.99 * from.resources[0];
    best += cost <= proved.builds[0].resources[0] * (1.0 + 1e-5);
    for (std::size_t stage = 0; stage < 2; ++stage) {
      for (std::size_t slot = 0; slot < 2; ++slot)
        for (Row row = 0; row < problem.stages[stage]->slots()[slot].rows; ++row) {
          Build other = found;
          other.stages[stage].rows[slot] = row;
          const auto its = totals_of(problem, other);
          CHECK((!its || (*its)[0] >= cost * (1.0 - 1e-8)));
        }
      for (const double part : {0.9, 0.99, 0.9999, 1.0001, 1.01}) {
        Build other = found;
        other.stages[stage].variables[0] = std::clamp(part * other.stages[stage].variables[0], 0.5, 6.0);
        const auto its = totals_of(problem, other);
        CHECK((!its || (*its)[0] >= cost * (1.0 - 1e-6)));
      }
    }
    // Who is not given the time gets what he had.
    CHECK(best_nearby(problem, {}, from, [] { return true; }).resources == from.resources);
  }
  CHECK(3 * trials > 2 * problems);
  if (millwright::sanitized) return;  // too few to say how often
  CHECK(3 * better > problems);
  CHECK(3 * best > problems);
}

TEST_CASE("A front that is spread from its lightest build is feasible, ordered, and nowhere beyond the proved front") {
  std::mt19937 rng(8);
  const int problems = millwright::sanitized ? 1 : 12;
  int trials = 0, wide = 0, cheapest = 0;
  for (int n = 0; n < problems; ++n) {
    const TwoBars two(rng);
    const Problem& problem = two.problem;
    const Summary start = solve(problem, lightest());
    if (start.builds.empty()) continue;
    ++trials;
    CAPTURE(n);
    Options front;
    front.objectives = {0, 1};
    const Summary proved = solve(problem, front);
    REQUIRE(proved.status == Status::optimal);
    const std::vector<Build> found = spread_front(problem, front, start.builds, [] { return false; });
    REQUIRE_FALSE(found.empty());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto totals = totals_of(problem, found[i]);
      REQUIRE(totals);
      CHECK(found[i].resources == *totals);
      if (i > 0) CHECK((found[i - 1].resources[0] < (*totals)[0] && found[i - 1].resources[1] > (*totals)[1]));
      // None that another stands for within the gap.
      for (std::size_t j = 0; j < i; ++j) CHECK(found[j].resources[1] > (1.0 + front.gap) * (*totals)[1]);
      CHECK(std::ranges::any_of(proved.builds, [&](const Build& each) {
        return each.resources[0] <= 1.001 * (*totals)[0] && each.resources[1] <= 1.001 * (*totals)[1];
      }));
    }
    CHECK(found.back().resources[1] <= (1.0 + front.gap) * start.builds.front().resources[1]);
    wide += found.size() > 1;
    cheapest += found.front().resources[0] <= 1.001 * proved.builds.front().resources[0];
    // Who is not given the time gets what he had.
    const std::vector<Build> same = spread_front(problem, front, start.builds, [] { return true; });
    REQUIRE(same.size() == 1);
    CHECK(same.front().resources == start.builds.front().resources);
    CHECK(spread_front(problem, front, {}, [] { return false; }).empty());
  }
  CHECK(3 * trials > 2 * problems);
  if (millwright::sanitized) return;  // too few to say how often
  CHECK(2 * wide > trials);
  CHECK(3 * cheapest > trials);
}

TEST_CASE("Local solvers that are told to stop ask no more, and leave a build that is no worse") {
  class Counted : public zoo::ForwardingStage {
   public:
    using ForwardingStage::ForwardingStage;
    void gradient(const Point& point, Input input, Answer<double>& answer) const override {
      ++gradients;
      inner_.gradient(point, input, answer);
    }
    mutable int gradients = 0;
  };
  std::mt19937 rng(7);
  const TwoBars bars(rng);
  const Counted upper(*bars.problem.stages[0]), lower(*bars.problem.stages[1]);
  Problem problem = bars.problem;
  problem.stages = {&upper, &lower};
  Build thick = solve(bars.problem, lightest()).builds.at(0);
  for (StageChoice& stage : thick.stages) stage.variables = {5.0};
  thick.resources = totals_of(bars.problem, thick).value();
  const auto settled_until = [&](const std::function<bool()>& stop) {
    upper.gradients = lower.gradients = 0;
    const Build result = settled(problem, lightest(), thick, stop);
    CHECK(result.resources[1] <= thick.resources[1] * (1.0 + 1e-12));
    return std::pair(upper.gradients + lower.gradients, result.resources[1]);
  };
  const auto [asked, mass] = settled_until({});
  CHECK(mass < 0.9 * thick.resources[1]);
  const auto [asked_at_once, mass_at_once] = settled_until([] { return true; });
  CHECK(mass_at_once == Approx(thick.resources[1]));
  CHECK(4 * asked_at_once < asked);
}

}  // namespace nearby_test
