// SPDX-License-Identifier: Apache-2.0
//
// A cost of which the last stage makes up what has been spent at two sellers to a minimum each (Problem::floors):
// against all designs, with floors and without. Prices are quarters, so that sums are exact and many are equal.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "sanitized.h"
#include "solver/criteria.h"
#include "solver/front_of.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace floors_test {

namespace {

using namespace millwright::solver;

enum Part : std::size_t { price, at_first, at_second, not_first, not_second, at_neither, mass, strength, part_width };
constexpr std::size_t cost_resource = 0, mass_resource = 1;

struct Total {
  double cost = 0.0, mass = 0.0;
};

/// Each stage takes a part that bears what the parts before it weigh; the one in the middle has two slots, and with
/// `free_plate` one more has a plate as thick as what it carries asks for.
class Purchases {
 public:
  Purchases(unsigned seed, bool free_plate) : random_(seed) {
    problem.resources = {{"cost"}, {"mass"}, {"without first"}, {"without second"}, {"without both"}};
    problem.first_state = {0.0, 0.0, 1.0};
    minimum_ = {quarter(0, 60), quarter(0, 60)};
    add_parts("a", 1);
    add_parts("b", 2);
    if (free_plate) add_plate();
    add_parts("c", 1);
    add_end();
  }

  /// As it would be without what the problem says of its floors.
  [[nodiscard]] Problem without_floors() const {
    Problem plain = problem;
    plain.floors.clear();
    plain.states_in_floors.clear();
    return plain;
  }

  /// All feasible designs.
  [[nodiscard]] std::vector<Total> all() const {
    std::vector<Total> found;
    descend(0, {}, 1.0, {0.0, 0.0}, found);
    return found;
  }

  Problem problem;

 private:
  double quarter(unsigned least, unsigned most) {
    return 0.25 * static_cast<double>(4 * least + random_() % (4 * (most - least) + 1));
  }

  void add_parts(const std::string& name, std::size_t slots) {
    std::vector<const Columns*> of_stage;
    for (std::size_t slot = 0; slot < slots; ++slot) {
      tables_.push_back(std::make_unique<Columns>(Columns{name + std::to_string(slot), part_width, {}}));
      for (int row = 0; row < 6; ++row) {
        const double paid = quarter(1, 12), weighs = quarter(1, 4), bears = quarter(2, 20);
        const auto seller = random_() % 3;  // 2: neither
        const double first = seller == 0 ? paid : 0.0, second = seller == 1 ? paid : 0.0;
        for (const double number :
             {paid, first, second, paid - first, paid - second, paid - first - second, weighs, bears})
          tables_.back()->numbers.push_back(number);
      }
      of_stage.push_back(tables_.back().get());
    }
    slots_.push_back(of_stage);
    add(model_stage(name, of_stage, {}, slots, [slots](const auto& in, auto& out) {
      for (const std::size_t column : {price, mass, not_first, not_second, at_neither}) {
        auto sum = in.row(0, column);
        for (std::size_t slot = 1; slot < slots; ++slot) sum = sum + in.row(slot, column);
        out.resources.push_back(sum);
      }
      for (const auto& [state, column] : {std::pair(0U, at_first), std::pair(1U, at_second), std::pair(2U, mass)}) {
        auto sum = in.state(state) + in.row(0, column);
        for (std::size_t slot = 1; slot < slots; ++slot) sum = sum + in.row(slot, column);
        out.handed_on.push_back(sum);
      }
      for (std::size_t slot = 0; slot < slots; ++slot) out.utilisation.push_back(in.state(2) / in.row(slot, strength));
    }));
  }

  void add_plate() {
    add(model_stage("plate", {}, {{"thickness", 0.1, 20.0}}, 1, [](const auto& in, auto& out) {
      const auto& thickness = in.variable(0);
      out.utilisation.push_back(0.5 * in.state(2) / thickness);
      out.resources.push_back(2.0 * thickness);
      out.resources.push_back(1.0 * thickness);
      for (int i = 0; i < 3; ++i) out.resources.push_back(2.0 * thickness);
      for (std::size_t i = 0; i < 3; ++i) out.handed_on.push_back(in.state(i));
    }));
    slots_.emplace_back();
  }

  void add_end() {
    add(model_stage("order", {}, {}, 0, [minimum = minimum_](const auto& in, auto& out) {
      using T = std::decay_t<decltype(in.state(0))>;
      using millwright::scalar::larger;
      T missing(0.0);
      for (std::size_t i = 0; i < 2; ++i) missing = missing + larger(T(0.0), T(minimum[i]) - in.state(i));
      out.resources.push_back(missing);
      for (const double paid : {0.0, minimum[0], minimum[1], minimum[0] + minimum[1]}) out.resources.push_back(T(paid));
      for (std::size_t i = 0; i < 3; ++i) out.handed_on.push_back(in.state(i));
    }));
    problem.floors = {{cost_resource, 2}, {cost_resource, 3}, {cost_resource, 4}};
    problem.states_in_floors = {0, 1};
  }

  template <class S>
  void add(S stage) {
    stages_.push_back(std::make_unique<S>(std::move(stage)));
    problem.stages.push_back(stages_.back().get());
  }

  void descend(
      std::size_t stage, Total so_far, double weight, std::array<double, 2> spent, std::vector<Total>& found) const {
    if (stage == slots_.size()) {
      for (std::size_t i = 0; i < 2; ++i) so_far.cost += std::max(0.0, minimum_[i] - spent[i]);
      found.push_back(so_far);
      return;
    }
    const std::vector<const Columns*>& slots = slots_[stage];
    if (slots.empty()) {
      const double thickness = std::max(0.1, 0.5 * weight);
      return descend(stage + 1, {so_far.cost + 2.0 * thickness, so_far.mass + thickness}, weight, spent, found);
    }
    std::vector<Row> rows(slots.size(), 0);
    do {
      Total total = so_far;
      double carried = weight;
      std::array<double, 2> there = spent;
      bool bears = true;
      for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const double* const part = slots[slot]->row(rows[slot]);
        total.cost += part[price];
        total.mass += part[mass];
        carried += part[mass];
        there[0] += part[at_first];
        there[1] += part[at_second];
        bears = bears && weight <= part[strength];
      }
      if (bears) descend(stage + 1, total, carried, there, found);
    } while (next(rows, slots));
  }

  static bool next(std::vector<Row>& rows, const std::vector<const Columns*>& slots) {
    for (std::size_t slot = 0; slot < rows.size(); ++slot) {
      if (++rows[slot] < slots[slot]->rows()) return true;
      rows[slot] = 0;
    }
    return false;
  }

  std::mt19937 random_;
  std::array<double, 2> minimum_{};
  std::vector<std::unique_ptr<Columns>> tables_;
  std::vector<std::vector<const Columns*>> slots_;  ///< [stage but the last]
  std::vector<std::unique_ptr<Stage>> stages_;
};

double least_mass(const std::vector<Total>& all, double most) {
  double least = std::numeric_limits<double>::infinity();
  for (const Total& total : all)
    if (total.cost <= most * (1.0 + 1e-9)) least = std::min(least, total.mass);
  return least;
}

Options minimise(std::vector<std::size_t> objectives, std::vector<std::size_t> ties) {
  Options options;
  options.objectives = std::move(objectives);
  options.ties = std::move(ties);
  return options;
}

}  // namespace

TEST_CASE("With floors of the cost the best design, the front and a budget are those of all designs") {
  std::size_t feasible = 0, made_up = 0, several = 0;
  constexpr unsigned seeds = millwright::sanitized ? 12 : 150;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const bool free_plate = seed % 2 == 1;
    const Purchases purchases(seed, free_plate);
    const std::vector<Total> all = purchases.all();
    INFO("seed " << seed << ", " << all.size() << " feasible designs");
    double least = std::numeric_limits<double>::infinity();
    for (const Total& total : all) least = std::min(least, total.cost);
    for (const bool with_floors : {true, false}) {
      CAPTURE(with_floors);
      Problem problem = with_floors ? purchases.problem : purchases.without_floors();
      const Summary cheapest = solve(problem, minimise({cost_resource}, {mass_resource}));
      if (all.empty()) {
        CHECK(cheapest.status == Status::infeasible);
        continue;
      }
      REQUIRE(cheapest.status == Status::optimal);
      CHECK(cheapest.builds[0].resources[cost_resource] == Approx(least).epsilon(1e-6));
      CHECK(cheapest.lower_bound <= least * (1.0 + 1e-9));
      if (!free_plate)
        CHECK(cheapest.builds[0].resources[mass_resource] == Approx(least_mass(all, least)).epsilon(1e-9));

      problem.resources[cost_resource].limit = 1.05 * least;
      const Summary lightest = solve(problem, minimise({mass_resource}, {cost_resource}));
      REQUIRE(lightest.status == Status::optimal);
      CHECK(lightest.builds[0].resources[mass_resource] == Approx(least_mass(all, 1.05 * least)).epsilon(1e-6));
      problem.resources[cost_resource].limit = 0.99 * least;
      CHECK(solve(problem, minimise({mass_resource}, {cost_resource})).status == Status::infeasible);

      problem.resources[cost_resource].limit = infinity;
      if (!free_plate) {  // of equal sums the cheapest
        double sum = std::numeric_limits<double>::infinity(), cost = sum;
        for (const Total& total : all) sum = std::min(sum, total.cost + 0.5 * total.mass);
        for (const Total& total : all)
          if (total.cost + 0.5 * total.mass == sum) cost = std::min(cost, total.cost);
        Options weighted = minimise({}, {cost_resource, mass_resource});
        weighted.weights = {1.0, 0.5, 0.0, 0.0, 0.0};
        const Summary best = solve(problem, weighted);
        REQUIRE(best.status == Status::optimal);
        const std::vector<double>& found = best.builds[0].resources;
        CHECK(found[cost_resource] + 0.5 * found[mass_resource] == Approx(sum).epsilon(1e-12));
        CHECK(found[cost_resource] == Approx(cost).epsilon(1e-12));
      }
      if (free_plate) continue;  // the front is found to a tolerance then
      const std::vector<Total> expected = zoo::front_of(all);
      for (const bool turned : {false, true}) {
        const Summary front =
            solve(problem,
                  turned ? minimise({mass_resource, cost_resource}, {}) : minimise({cost_resource, mass_resource}, {}));
        REQUIRE(front.status == Status::optimal);
        REQUIRE(front.builds.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
          const Total& total = expected[turned ? expected.size() - 1 - i : i];
          CHECK(front.builds[i].resources[cost_resource] == Approx(total.cost).epsilon(1e-12));
          CHECK(front.builds[i].resources[mass_resource] == Approx(total.mass).epsilon(1e-12));
        }
      }
    }
    if (all.empty()) continue;
    ++feasible;
    several += std::count_if(all.begin(), all.end(), [&](const Total& total) { return total.cost == least; }) > 1;
    made_up += solve(purchases.problem, minimise({4}, {})).builds[0].resources[4] == Approx(least).epsilon(1e-9);
  }
  CHECK(feasible >= seeds / 4);
  CHECK(several >= seeds / 12);
  CHECK(made_up >= seeds / 12);
}

TEST_CASE("Floors are scores of every objective and limit that reads the resource, and decide between equals late") {
  const Purchases purchases(1, false);
  Problem problem = purchases.problem;
  problem.resources[cost_resource].limit = 50.0;
  Options sum = minimise({}, {});
  sum.weights = {1.0, 2.0, 0.0, 0.0, 0.0};
  const Criteria criteria = make_criteria(problem, sum);
  // The sum, the limited cost, and three floors of each.
  REQUIRE(criteria.size() == 8);
  REQUIRE(criteria.floors.size() == 6);
  CHECK(criteria.weight[criteria.floors[0].bound] == std::vector<double>{0.0, 2.0, 1.0, 0.0, 0.0});
  CHECK(criteria.weight[criteria.floors[5].bound] == std::vector<double>{0.0, 0.0, 0.0, 0.0, 1.0});
  CHECK(criteria.limit[criteria.floors[0].bound] == infinity);
  CHECK(criteria.limit[criteria.floors[5].bound] == 50.0);
  CHECK(make_criteria(problem, minimise({mass_resource}, {})).floors.size() == 3);
  problem.resources[cost_resource].limit = infinity;
  CHECK(make_criteria(problem, minimise({mass_resource}, {cost_resource})).floors.empty());
  sum.ties = {cost_resource};  // without a limit, too
  CHECK(make_criteria(problem, sum).floors.size() == 6);
  CHECK(criteria.has_to_be_kept_low(criteria.floors[0].bound));
  CHECK(criteria.is_in_floors(0));
  CHECK_FALSE(criteria.is_in_floors(2));

  std::vector<double> total{10.0, 4.0, 12.0, 9.0, 8.0, 3.0, 7.0, 5.0};
  criteria.raise(total);
  CHECK(total[0] == 12.0);
  CHECK(total[1] == 7.0);

  const std::vector<double> less{10.0, 4.0, 6.0, 6.0, 6.0, 0.0, 0.0, 0.0};
  std::vector<double> more{11.0, 5.0, 7.0, 7.0, 7.0, 0.0, 0.0, 0.0};
  CHECK(criteria.is_less_by_floors(0, less, more));
  more[3] = 6.0;  // both may come to what this floor says
  CHECK_FALSE(criteria.is_less_by_floors(0, less, more));
}

}  // namespace floors_test
