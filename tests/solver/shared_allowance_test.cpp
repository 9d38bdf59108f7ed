// SPDX-License-Identifier: Apache-2.0
//
// Allowances that bind, which all stages share: a compliance that must stay below a limit at the tool and a power that
// a supply of one of several sizes gives, while what is chosen first is a load for what comes later. Staircases and
// planes of what is left (rest_plane.h) against every chain, the solver against every build.
#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/chains.h"
#include "solver/front_of.h"
#include "solver/model_stage.h"
#include "solver/rest_curve.h"
#include "solver/rest_plane.h"
#include "solver/solver.h"

namespace shared_allowance_test {

namespace {

using namespace zoo;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double power_step = 4.0;

/// Not at all; in steps; in steps and between them, for each motor differently.
enum class Rising { no, stepped, growing };
Rising rising_of(unsigned seed) { return static_cast<Rising>(seed % 3); }

enum State : std::size_t { carried_mass, compliance, power, state_size };
enum Spring : std::size_t { spring_price, spring_mass, spring_compliance };
enum Motor : std::size_t { motor_price, motor_mass, motor_power, motor_strength, motor_noise };
enum Supply : std::size_t { supply_price, supply_mass, supply_power };

/// Guides and motors for several axes, then a supply, then the limit at the tool.
class Machine {
 public:
  /// `more`: rows of guides and of motors for each of two axes, beyond the few that they have. `rising`: how a motor's
  /// power depends on its load. Of some machines the cost depends on the load too, of some many prices are equal.
  explicit Machine(unsigned seed, std::size_t more = 0, Rising rising = Rising::no)
      : rng_(seed), more_(more), rising_(rising), cost_of_load_(seed % 5 == 2 ? 0.4 : 0.0), coarse_(seed % 4 == 1) {
    const std::size_t axes = more > 0 ? 2 : 2 + rng_() % 2;
    double soft = 0.0;
    double stiff = 0.0;
    double strong = 0.0;
    double noise = 0.0;  // of the loudest motors
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const Columns& springs = springs_table();
      const Columns& motors = motors_table();
      double least = 1e9;
      double most = 0.0;
      for (Row row = 0; row < springs.rows(); ++row) {
        least = std::min(least, springs.row(row)[spring_compliance]);
        most = std::max(most, springs.row(row)[spring_compliance]);
      }
      soft += most;
      noise += 10.0;
      stiff += least;
      for (Row row = 0; row < motors.rows(); ++row) strong = std::max(strong, motors.row(row)[motor_power]);
      add_axis(springs, motors);
    }
    add_supply(strong * static_cast<double>(axes));
    add_tool(stiff + uniform(0.05, 0.5) * (soft - stiff));
    problem.first_state = {uniform(0.0, 1.0), 0.0, 0.0};
    problem.resources = {{"cost"}, {"mass"}, {"noise", seed % 3 == 0 ? uniform(0.4, 0.9) * noise : infinity}};
  }

  Problem problem;

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng_); }
  /// Prices in whole numbers now and then, so that there are ties.
  double price(double value) {
    const bool is_whole = rng_() % 4 == 0;
    return coarse_ ? 4.0 * std::ceil(value / 4.0) : is_whole ? std::round(value) : value;
  }

  const Columns& springs_table() {
    Columns& table = *tables_.emplace_back(std::make_unique<Columns>());
    table = {"spring", 3, {}};
    const std::size_t rows = 3 + rng_() % 4 + more_;
    for (std::size_t row = 0; row < rows; ++row) {
      const double size = uniform(1.0, 5.0);
      const double light = uniform(0.6, 1.6);  // and dear
      for (const double number : {price(3.0 * size * light), size / light, uniform(0.8, 1.2) / size})
        table.numbers.push_back(number);
    }
    return table;
  }
  const Columns& motors_table() {
    Columns& table = *tables_.emplace_back(std::make_unique<Columns>());
    table = {"motor", 5, {}};
    const std::size_t rows = 3 + rng_() % 4 + more_;
    for (std::size_t row = 0; row < rows; ++row) {
      const double size = uniform(1.0, 6.0);
      const double light = uniform(0.6, 1.6);
      for (const double number :
           {price(2.0 * size * light), 0.5 * size / light, size * uniform(5.0, 9.0), 3.5 * size, uniform(1.0, 10.0)})
        table.numbers.push_back(number);
    }
    return table;
  }

  void add_axis(const Columns& springs, const Columns& motors) {
    const auto axis = [rising = rising_, cost_of_load = cost_of_load_](const auto& in, auto& out) {
      const auto load = in.state(carried_mass) + in.row(0, spring_mass);
      out.utilisation.push_back(load / in.row(1, motor_strength));
      out.resources.push_back(in.row(0, spring_price) + in.row(1, motor_price) + cost_of_load * load);
      out.resources.push_back(in.row(0, spring_mass) + in.row(1, motor_mass));
      out.resources.push_back(in.row(1, motor_noise));
      out.handed_on.push_back(load + in.row(1, motor_mass));
      out.handed_on.push_back(in.state(compliance) + in.row(0, spring_compliance));
      using millwright::scalar::floor_of;
      const auto demand = 0.4 * in.row(1, motor_power) + 1.5 * load;
      const auto grown = -0.02 * in.row(1, motor_power) * load * floor_of(-load / power_step);
      out.handed_on.push_back(in.state(power) + (rising == Rising::no ? in.row(1, motor_power)
                                                 : rising == Rising::stepped
                                                     ? -floor_of(-demand / power_step) * power_step
                                                     : 0.1 * in.row(1, motor_power) + grown));
    };
    add(model_stage("axis", {&springs, &motors}, {}, 1, axis));
  }
  void add_supply(double most) {
    Columns& table = *tables_.emplace_back(std::make_unique<Columns>());
    table = {"supply", 3, {}};
    const std::size_t rows = 2 + rng_() % 4;
    for (std::size_t row = 0; row < rows; ++row) {
      const double share = uniform(0.3, 1.0);
      for (const double number : {price(20.0 * share), 2.0 * share * uniform(0.8, 1.2), share * most})
        table.numbers.push_back(number);
    }
    add(model_stage("supply", {&table}, {}, 1, [](const auto& in, auto& out) {
      out.utilisation.push_back(in.state(power) / in.row(0, supply_power));
      out.resources.push_back(in.row(0, supply_price));
      out.resources.push_back(in.row(0, supply_mass));
      out.resources.push_back(0.0 * in.row(0, supply_mass));
      for (std::size_t i = 0; i < state_size; ++i) out.handed_on.push_back(in.state(i));
    }));
  }
  void add_tool(double limit) {
    add(model_stage("tool", {}, {}, 1, [limit](const auto& in, auto& out) {
      out.utilisation.push_back(in.state(compliance) / limit);
      for (int resource = 0; resource < 3; ++resource) out.resources.push_back(0.0 * in.state(compliance));
      for (std::size_t i = 0; i < state_size; ++i) out.handed_on.push_back(in.state(i));
    }));
  }
  template <class ModelStage>
  void add(ModelStage stage) {
    problem.stages.push_back(stages_.emplace_back(std::make_unique<ModelStage>(std::move(stage))).get());
  }

  std::mt19937 rng_;
  std::size_t more_;
  Rising rising_;
  double cost_of_load_;
  bool coarse_;
  std::vector<std::unique_ptr<Columns>> tables_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

constexpr std::size_t machines = millwright::sanitized ? 28 : 160;

struct Total {
  double cost = 0.0, mass = 0.0, noise = 0.0;
};

/// Of every feasible build, but only those that may be on the front where there are many.
std::vector<Total> totals_of(const Problem& problem) {
  std::vector<Total> totals;
  const auto walk = [&](auto&& self, std::size_t index, const std::vector<double>& state, Total sum) -> void {
    if (index == problem.stages.size()) {
      if (sum.noise <= problem.resources[2].limit) totals.push_back(sum);
      if (totals.size() > 100000) totals = front_of(std::move(totals));
      return;
    }
    const Stage& stage = *problem.stages[index];
    std::vector<Row> rows(stage.slots().size(), 0);
    for (;;) {
      Answer<double> answer;
      stage.evaluate(Point{{}, state, rows, {}}, answer);
      if (answer.utilisation[0] <= 1.0)
        self(self,
             index + 1,
             answer.handed_on,
             {sum.cost + answer.resources[0], sum.mass + answer.resources[1], sum.noise + answer.resources[2]});
      std::size_t slot = 0;
      while (slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows) rows[slot++] = 0;
      if (slot == rows.size()) return;
    }
  };
  walk(walk, 0, problem.first_state, {});
  return totals;
}

/// Of builds that are equal in cost or mass the least noise, and how many are louder.
std::pair<double, std::size_t> quietest_of_equals(const std::vector<Total>& totals, std::size_t score) {
  const auto value = [&](const Total& total) { return score == 0 ? total.cost : total.mass; };
  const double least = value(std::ranges::min(totals, {}, value));
  std::vector<double> noise;
  for (const Total& total : totals)
    if (value(total) <= least * (1.0 + 1e-13)) noise.push_back(total.noise);
  const double best = std::ranges::min(noise);
  const auto louder = std::ranges::count_if(noise, [&](double each) { return each > best * (1.0 + 1e-9); });
  return {best, static_cast<std::size_t>(louder)};
}

}  // namespace

TEST_CASE("Nothing that is left costs less than the staircases of a binding allowance say") {
  std::size_t staircases = 0, compared = 0, told_more = 0, refused = 0, tightened = 0, kept = 0, reached = 0, cut = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(machines); ++seed) {
    INFO("seed " << seed);
    const Machine machine(seed, 0, rising_of(seed));
    const Problem& problem = machine.problem;
    for (std::size_t score = 0; score < 2; ++score) {
      Options options;
      options.objectives = {score};
      const Criteria criteria = make_criteria(problem, options);
      Desk desk;
      std::vector<StagePlan> plans = make_plans(problem, {}, criteria, desk);
      if (plans.empty()) continue;
      const std::vector<StagePlan> plain = plans;
      if (seed % 2 == 0) find_rest_curves(plans, std::vector<double>(criteria.size(), infinity), {}, desk);
      std::vector<StateForm> forms;
      for (const StagePlan& plan : plans) forms.push_back(find_state_form(plan, desk));
      double best = infinity;
      Chains(problem, score).run({}, [&](std::size_t stage, const auto&, double later, double before) {
        if (stage == 0) best = std::min(best, before + later);
      });
      RestPlanes planes(problem, plans, forms, desk);
      planes.find(Mix::only(0), best);
      const auto compare = [&](double most) {
        Chains(problem, score).run({}, [&](std::size_t stage, const auto& state, double later, double before) {
          if (before + later > most) return;
          ++compared;
          const double rest = rest_after(plans[stage], 0, std::span<const double>(state));
          const double known = rest_after(plain[stage], 0, std::span<const double>(state));
          told_more += rest > known * (1.0 + 1e-6) + 1e-6 ? 1 : 0;
          if (rest > later * (1.0 + 1e-9) + 1e-9) CHECK(rest <= later);
          if (!bearable(plans[stage], state)) CHECK(bearable(plans[stage], state));
        });
      };
      for (StagePlan& plan : plans) {
        plan.curves.clear();
        staircases += plan.stairs.size();
        for (const RestStairs& stairs : plan.stairs)
          refused += least_within(stairs.least, 0.3 * stairs.limit) == infinity ? 1 : 0;
      }
      compare(infinity);
      if (best == infinity) continue;
      // Every chain up to a cost is within what the vectors say of what is left.
      const std::vector<Pair> corners{{1.2 * best, infinity}};
      REQUIRE(planes.find_vectors(corners));
      Chains(problem, score).run({}, [&](std::size_t stage, const auto& state, double later, double before) {
        const RestVectors& rest = plans[stage].vectors;
        if (rest.add.empty()) return;
        const bool within = rest.reach(
            {before, 0.0}, [&](std::size_t c) { return state[c]; }, corners);
        (within ? reached : cut) += 1;
        if (before + later <= 1.2 * best && !within) FAIL("a chain is cut off");
      });
      // What is left out, and the staircases of what is left, are about builds that cost no more than this.
      const double most = 1.02 * best;
      REQUIRE(planes.restrict_to({{most, infinity}}));
      look_again(problem, plans, desk);
      for (std::size_t i = 0; i < plans.size(); ++i) forms[i] = find_state_form(plans[i], desk);
      planes.tighten_limits();
      planes.find(Mix::only(0), best);
      for (std::size_t i = 0; i < plans.size(); ++i)
        for (std::size_t c = 0; c < state_size; ++c)
          tightened += plans[i].most_after[c] < plain[i].most_after[c] * (1.0 - 1e-6) ? 1 : 0;
      compare(most);
      Chains chains(problem, score);
      chains.run({}, [&](std::size_t stage, const auto&, double later, double before) {
        if (before + later > most) return;
        for (std::size_t slot = 0; slot < chains.rows(stage).size(); ++slot) {
          const std::vector<Row>& left = plans[stage].region.rows[slot]->all();
          ++kept;
          if (std::find(left.begin(), left.end(), chains.rows(stage)[slot]) == left.end()) FAIL("left out");
        }
      });
    }
  }
  CHECK(staircases > 10 * machines / 3);
  CHECK(compared > 1000 * machines);
  CHECK(told_more > compared / 10);
  CHECK(refused > machines / 10);
  CHECK(tightened > machines / 3);
  CHECK(kept > machines);
  CHECK(reached > machines);
  CHECK(cut > 10 * machines);
}

TEST_CASE("Where allowances bind, optima and front equal those of all builds") {
  std::size_t priced = 0, points = 0, infeasible = 0, louder_equals = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(machines); ++seed) {
    const Machine machine(seed, 0, rising_of(seed));
    const std::vector<Total> totals = totals_of(machine.problem);
    const std::vector<Total> front = front_of(totals);
    for (const std::uint64_t patience : {std::uint64_t{0}, std::uint64_t{50}, std::uint64_t{30000}}) {
      INFO("seed " << seed << ", patience " << patience);
      if (patience == 50 && seed % 4 > 0) continue;  // cut in sections, which takes longer
      Options options;
      options.patience = patience == 0 ? 0 : options.patience;
      options.stage_patience = patience;
      options.look_first = patience != 0;  // what is looked for first is good in what decides between equals, too
      for (std::size_t score = 0; score < 2; ++score) {
        options.objectives = {score};
        options.ties = {2};
        const Summary summary = solve(machine.problem, options);
        priced += summary.method.find("Lagrangian") != std::string::npos ? 1 : 0;
        REQUIRE(summary.builds.empty() == totals.empty());
        REQUIRE(summary.status == (totals.empty() ? Status::infeasible : Status::optimal));
        if (totals.empty()) {
          ++infeasible;
          continue;
        }
        CHECK(summary.builds[0].resources[score] ==
              Approx(score == 0 ? front.front().cost : front.back().mass).epsilon(1e-9));
        const auto [noise, louder] = quietest_of_equals(totals, score);
        CHECK(summary.builds[0].resources[2] == Approx(noise).epsilon(1e-9));
        louder_equals += louder;
      }
      options.objectives = {0, 1};
      options.ties = {};
      const Summary summary = solve(machine.problem, options);
      priced += summary.method.find("Lagrangian") != std::string::npos ? 1 : 0;
      REQUIRE(summary.builds.size() == front.size());
      for (std::size_t i = 0; i < front.size(); ++i) {
        ++points;
        CHECK(summary.builds[i].resources[0] == Approx(front[i].cost).epsilon(1e-9));
        CHECK(summary.builds[i].resources[1] == Approx(front[i].mass).epsilon(1e-9));
      }
    }
  }
  CHECK(priced > machines);
  CHECK(points > 4 * machines);
  CHECK(infeasible < machines);
  CHECK(louder_equals > machines / 4);
}

TEST_CASE("Where a limit leaves no build in sight, the best is that of all builds within it") {
  std::size_t by_front = 0, otherwise = 0, ties = 0, nothing = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(machines); seed += millwright::sanitized ? 14 : 4) {
    const Machine machine(seed, 0, rising_of(seed));
    const std::vector<Total> totals = totals_of(machine.problem);
    const std::vector<Total> front = front_of(totals);
    for (std::size_t i = 0; i < front.size(); i += 1 + front.size() / 3)
      for (std::size_t score = 0; score < 2; ++score)
        for (const double share : {1.0 + 1e-9, 1.0 - 1e-6}) {
          INFO("seed " << seed << ", point " << i << ", score " << score << ", share " << share);
          const auto value = [&](const Total& total) { return score == 0 ? total.cost : total.mass; };
          const auto other = [&](const Total& total) { return score == 0 ? total.mass : total.cost; };
          Problem problem = machine.problem;
          const double limit = share * other(front[i]);
          problem.resources[1 - score].limit = limit;
          Options options;
          options.objectives = {score};
          options.ties = {1 - score, 2};
          options.patience = options.stage_patience = 0;
          options.look_first = false;
          std::vector<Total> within;
          std::ranges::copy_if(totals, std::back_inserter(within), [&](const Total& t) { return other(t) <= limit; });
          const Summary summary = solve(problem, options);
          const bool used = summary.method.find("as the end of a front") != std::string::npos;
          (used ? by_front : otherwise) += 1;
          REQUIRE(summary.status == (within.empty() ? Status::infeasible : Status::optimal));
          if (within.empty()) {
            ++nothing;
            continue;
          }
          const auto keep_least = [&](const auto& of) {
            const double least = std::invoke(of, std::ranges::min(within, {}, of));
            ties += std::erase_if(within, [&](const Total& t) { return std::invoke(of, t) > least * (1.0 + 1e-12); });
            return least;
          };
          const std::vector<double>& found = summary.builds.front().resources;
          CHECK(found[score] == Approx(keep_least(value)).epsilon(1e-9));
          CHECK(found[1 - score] == Approx(keep_least(other)).epsilon(1e-9));
          CHECK(found[2] == Approx(keep_least(&Total::noise)).epsilon(1e-9));
        }
  }
  INFO(by_front << " " << otherwise << " " << ties << " " << nothing);
  if (millwright::sanitized) return;  // too few are tried there
  CHECK(by_front > machines / 4);
  CHECK(otherwise > 0);
  CHECK(nothing > machines / 20);
  CHECK(ties > machines / 10);
}

TEST_CASE("A front of many parts is complete where allowances bind, cut in sections or not") {
  std::size_t points = 0, quick = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 2 : 25); ++seed) {
    const Machine machine(seed, 14, rising_of(seed));
    const std::vector<Total> front = front_of(totals_of(machine.problem));
    for (const int way : {0, 1, 2, 3}) {
      INFO("seed " << seed << ", way " << way);
      const std::uint64_t patience = way % 2 == 0 ? 0 : 200;
      Options options;
      options.look_first = way < 2;
      if (way % 2 == 0) options.ties = {2};
      options.objectives = {0, 1};
      options.stage_patience = patience;
      options.patience = patience;
      for (std::size_t score = 0; score < 2 && !front.empty(); ++score) {
        options.objectives = {score};
        const Summary summary = solve(machine.problem, options);
        REQUIRE(summary.builds.size() == 1);
        const double least = score == 0 ? front.front().cost : front.back().mass;
        CHECK(summary.builds[0].resources[score] == Approx(least).epsilon(1e-9));
      }
      options.objectives = {0, 1};
      const Summary summary = solve(machine.problem, options);
      quick += summary.method.find("Lagrangian") == std::string::npos ? 1 : 0;
      REQUIRE(summary.builds.size() == front.size());
      for (std::size_t i = 0; i < front.size(); ++i) {
        ++points;
        CHECK(summary.builds[i].resources[0] == Approx(front[i].cost).epsilon(1e-9));
        CHECK(summary.builds[i].resources[1] == Approx(front[i].mass).epsilon(1e-9));
      }
    }
  }
  CHECK(points > (millwright::sanitized ? 20 : 500));
  CHECK(quick < 60);
}

TEST_CASE("A front that is cut wherever it is too much does not take many times what it takes uncut") {
  constexpr std::uint64_t most = 15;  // what is begun again after each cut with the same patience comes to 45 times
  for (unsigned seed = 30; seed < (millwright::sanitized ? 33 : 60); ++seed) {
    const Machine machine(seed, 14, rising_of(seed));
    Options options;
    options.objectives = {0, 1};
    options.look_first = seed % 2 == 0;
    const auto nodes_with = [&](std::uint64_t patience) {
      options.patience = options.stage_patience = patience;
      return solve(machine.problem, options).nodes;
    };
    INFO("seed " << seed);
    CHECK(nodes_with(20) <= most * nodes_with(1'000'000));
  }
}

}  // namespace shared_allowance_test
