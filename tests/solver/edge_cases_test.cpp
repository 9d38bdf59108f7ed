// SPDX-License-Identifier: Apache-2.0
//
// Where exactness is easily lost, against every build: labels that share an answer and differ in what it does not read,
// totals that are their limit but for rounding, totals about and below zero. (Windows: covered_fronts_test.cpp.)
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/front_of.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace edge_cases_test {

namespace {

using namespace millwright::solver;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Total {
  double cost = 0.0, mass = 0.0;
};

/// A problem and what it is made of.
struct Chain {
  Problem problem;

  template <class Model>
  void add(std::vector<Columns> tables, std::vector<Variable> variables, std::size_t utilisations, Model model) {
    std::vector<const Columns*> slots;
    for (Columns& table : tables)
      slots.push_back(tables_.emplace_back(std::make_unique<Columns>(std::move(table))).get());
    auto stage = model_stage("stage", std::move(slots), std::move(variables), utilisations, std::move(model));
    stages_.push_back(std::make_unique<decltype(stage)>(std::move(stage)));
    problem.stages.push_back(stages_.back().get());
  }
  [[nodiscard]] const Columns& table(std::size_t i) const { return *tables_[i]; }

 private:
  std::vector<std::unique_ptr<Columns>> tables_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

Options objectives(std::vector<std::size_t> which) {
  Options options;
  options.objectives = std::move(which);
  options.confirm = false;
  return options;
}

int whole(std::mt19937& random, int least, int most) {
  return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
}

// Drives of few masses, whose ramps decide how many watts they take.

enum Drive : std::size_t { drive_price, drive_mass, drive_strength, drive_power, drive_longest, drive_width };

struct Driven {
  explicit Driven(unsigned seed) {
    std::mt19937 random(seed);
    axes = static_cast<std::size_t>(whole(random, 1, 3));
    const int rows = whole(random, 2, 5);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      Columns table{"drive", drive_width, {}};
      for (int row = 0; row < rows; ++row)
        for (const double number : {1.0 * whole(random, 1, 9),
                                    0.5 * whole(random, 1, 2),
                                    1.0 * whole(random, 2, 9),
                                    whole(random, 1, 12) + 0.37,
                                    0.21 * whole(random, 1, 8)})
          table.numbers.push_back(number);
      work.push_back(0.77 * whole(random, 1, 5));
      loss.push_back(1.13 * whole(random, 1, 9));
      const auto drive = [work = work.back(), loss = loss.back()](const auto& in, auto& out) {
        using millwright::scalar::floor_of;
        const auto load = in.state(0) + in.row(0, drive_mass);
        const auto& time = in.variable(0);
        out.utilisation.push_back(0.5 * load / (time * in.row(0, drive_strength)));
        out.utilisation.push_back(time / in.row(0, drive_longest));
        out.resources.push_back(in.row(0, drive_price));
        out.resources.push_back(in.row(0, drive_mass));
        out.handed_on.push_back(load);
        out.handed_on.push_back(in.state(1) - floor_of(-(in.row(0, drive_power) + work * load / time + loss * time)));
      };
      chain.add({table}, {{"ramp", shortest, longest}}, 2, drive);
    }
    most_power = static_cast<double>(axes) * whole(random, 8, 20) + 0.5;
    chain.add({}, {}, 1, [most = most_power](const auto& in, auto& out) {
      out.utilisation.push_back(in.state(1) / most);
      for (std::size_t i = 0; i < 2; ++i) out.resources.push_back(0.0 * in.state(i));
      for (std::size_t i = 0; i < 2; ++i) out.handed_on.push_back(in.state(i));
    });
    chain.problem.first_state = {1.0 * whole(random, 1, 3), 0.0};
    chain.problem.resources = {{"cost"}, {"mass"}};
    walk(0, chain.problem.first_state[0], 0.0, {});
  }

  static constexpr double shortest = 0.05, longest = 2.0;
  std::size_t axes = 0;
  std::vector<double> work, loss;
  double most_power = 0.0;
  Chain chain;
  std::vector<Total> totals;   ///< of every build with its best ramps, which a closed formula gives
  bool is_borderline = false;  ///< rounding decides whether some build complies

 private:
  void walk(std::size_t axis, double load, double power, Total sum) {
    if (axis == axes) {
      if (power <= most_power) totals.push_back(sum);
      return;
    }
    const Columns& table = chain.table(axis);
    for (Row row = 0; row < table.rows(); ++row) {
      const double* drive = table.row(row);
      const double carried = load + drive[drive_mass];
      const double from = std::max(shortest, 0.5 * carried / drive[drive_strength]);
      const double to = std::min(longest, drive[drive_longest]);
      is_borderline = is_borderline || std::fabs(from - to) < 1e-9;
      if (from > to) continue;
      const double ramp = std::clamp(std::sqrt(work[axis] * carried / loss[axis]), from, to);
      const double watts = drive[drive_power] + work[axis] * carried / ramp + loss[axis] * ramp;
      is_borderline = is_borderline || std::fabs(watts - std::round(watts)) < 1e-7;
      walk(axis + 1, carried, power + std::ceil(watts), {sum.cost + drive[drive_price], sum.mass + drive[drive_mass]});
    }
  }
};

void require_found(const Summary& summary, const std::vector<Total>& expected) {
  REQUIRE(summary.status == (expected.empty() ? Status::infeasible : Status::optimal));
  REQUIRE(summary.builds.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(summary.builds[i].resources[0] == Approx(expected[i].cost).epsilon(1e-9).margin(1e-9));
    CHECK(summary.builds[i].resources[1] == Approx(expected[i].mass).epsilon(1e-9).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("Of builds that weigh the same and have taken different power none is lost") {
  std::size_t compared = 0, infeasible = 0;
  const auto look = [&](unsigned seed) {
    INFO("seed " << seed);
    Driven driven(seed);
    if (driven.is_borderline) return;
    const std::vector<Total> front = zoo::front_of(driven.totals);
    require_found(solve(driven.chain.problem, objectives({0, 1})), front);
    Options impatient = objectives({0, 1});
    impatient.stage_patience = 3;
    require_found(solve(driven.chain.problem, impatient), front);
    Options single = objectives({0});
    single.patience = 0;
    const Summary best = solve(driven.chain.problem, single);
    REQUIRE(best.builds.empty() == front.empty());
    if (!front.empty()) CHECK(best.builds[0].resources[0] == Approx(front[0].cost));
    (front.empty() ? infeasible : compared) += 1;
  };
  // Of some thousand seeds those at which an answer that was shared got builds lost.
  for (const unsigned seed : {1209U, 1261U, 1393U}) look(seed);
  for (unsigned seed = 0; seed < (millwright::sanitized ? 30U : 300U); ++seed) look(seed);
  CHECK(compared > 10);
  CHECK(infeasible > 3);
}

// 0.1 + 0.2 is 0.3 and a little more in binary. Two totals that count as equal keep a limit alike, or the one would
// displace the other and then be refused.
TEST_CASE("A total that is its limit but for rounding keeps it") {
  for (const bool dearer : {false, true}) {
    Chain chain;
    const double price = dearer ? 1.5 : 1.0;
    const auto pair = [](const auto& in, auto& out) {
      const auto apart = in.row(0, 2) - in.row(1, 2);  // 0: of one kind
      out.utilisation.push_back(1.0 + apart);
      out.utilisation.push_back(1.0 - apart);
      out.resources.push_back(in.row(0, 0) + in.row(1, 0));
      out.resources.push_back(in.row(0, 1) + in.row(1, 1));
      out.handed_on.push_back(in.state(0) + (in.row(0, 1) + in.row(1, 1)));
    };
    chain.add(
        {{"first", 3, {1.0, 0.1, 0.0, price, 0.3, 1.0}}, {"second", 3, {1.0, 0.2, 0.0, 1.0, 0.0, 1.0}}}, {}, 2, pair);
    chain.add({{"last", 2, {1.0, 0.0}}}, {}, 1, [](const auto& in, auto& out) {
      const auto carried = in.state(0) + in.row(0, 1);
      out.utilisation.push_back(0.0 * carried);
      out.resources.push_back(in.row(0, 0));
      out.resources.push_back(in.row(0, 1));
      out.handed_on.push_back(carried);
    });
    chain.problem.first_state = {0.0};
    chain.problem.resources = {{"cost"}, {"mass", 0.3}};
    for (const std::vector<std::size_t>& which : {std::vector<std::size_t>{0}, {1}, {0, 1}, {1, 0}})
      for (const bool stagewise : {false, true})
        for (const std::uint64_t patience : {0U, 25000U}) {
          INFO("dearer " << dearer << ", objectives " << which.size() << ", first " << which[0] << ", stage by stage "
                         << stagewise << ", patience " << patience);
          Options options = objectives(which);
          options.stagewise = stagewise;
          options.patience = patience;
          if (which.size() == 1) options.ties = {1 - which[0]};
          const Summary summary = solve(chain.problem, options);
          REQUIRE(summary.status == Status::optimal);
          REQUIRE(summary.builds.size() == 1);
          CHECK(summary.builds[0].resources[0] == Approx(3.0));
          CHECK(summary.builds[0].resources[1] == Approx(0.3));
        }
  }
}

// A balance that must not be above zero in the end, where what comes later takes off it, and an allowance that binds.
TEST_CASE("What takes off a total that is limited is counted before a design is left out") {
  std::size_t compared = 0, infeasible = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 60U : 400U); ++seed) {
    std::mt19937 random(seed);
    Chain chain;
    const std::size_t stages = 2 + random() % 2;
    const double allowance = 2.0 * static_cast<double>(stages);
    constexpr Row rows = 5;
    for (std::size_t i = 0; i < stages; ++i) {
      Columns table{"row", 3, {}};
      for (Row row = 0; row < rows; ++row)
        for (const double number : {0.25 * whole(random, 0, 8), 0.5 * whole(random, -4, 4), 0.5 * whole(random, 0, 8)})
          table.numbers.push_back(number);
      chain.add({table}, {}, 1, [allowance](const auto& in, auto& out) {
        const auto used = in.state(0) + in.row(0, 2);
        out.utilisation.push_back(used / allowance);
        out.resources.push_back(in.row(0, 0));
        out.resources.push_back(in.row(0, 1));
        out.handed_on.push_back(used);
      });
    }
    chain.problem.first_state = {0.0};
    chain.problem.resources = {{"cost"}, {"balance", 0.0}};
    double best = infinity;
    const auto walk = [&](auto&& self, std::size_t stage, double cost, double balance, double used) -> void {
      if (used > allowance) return;
      if (stage == stages) {
        if (balance <= 0.0) best = std::min(best, cost);
        return;
      }
      for (Row i = 0; i < rows; ++i) {
        const double* row = chain.table(stage).row(i);
        self(self, stage + 1, cost + row[0], balance + row[1], used + row[2]);
      }
    };
    walk(walk, 0, 0.0, 0.0, 0.0);
    for (const std::uint64_t stage_patience : {1U, 30U, 30000U}) {
      INFO("seed " << seed << ", patience " << stage_patience);
      Options options = objectives({0});
      options.patience = 0;
      options.stage_patience = stage_patience;
      const Summary summary = solve(chain.problem, options);
      REQUIRE(summary.status == (best == infinity ? Status::infeasible : Status::optimal));
      if (best < infinity) CHECK(summary.builds[0].resources[0] == Approx(best).margin(1e-9));
    }
    (best < infinity ? compared : infeasible) += 1;
  }
  CHECK(compared > 10);
  if (!millwright::sanitized) CHECK(infeasible > 0);  // the few tried there may all have a build
}

// Every part brings money in. Ended anywhere, a search must not say more than it has proved.
TEST_CASE("Of totals below zero the bound holds whenever the search is stopped") {
  std::size_t limits = 0;
  std::mt19937 random(5);
  for (int machine = 0; machine < (millwright::sanitized ? 8 : 150); ++machine) {
    INFO("machine " << machine);
    Chain chain;
    std::atomic<long> questions{1L << 60};
    std::atomic<bool> stop{false};
    for (int stage = 0; stage < 3; ++stage) {
      std::vector<Columns> tables;
      for (int slot = 0; slot < 2; ++slot) {
        Columns& table = tables.emplace_back(Columns{"row", 2, {}});
        for (int row = 0; row < 6; ++row) {
          const double use = whole(random, 1, 12);
          table.numbers.push_back(-use - 0.01 * whole(random, 0, 99));
          table.numbers.push_back(use);
        }
      }
      chain.add(std::move(tables), {}, 1, [&questions, &stop](const auto& in, auto& out) {
        if (--questions <= 0) stop = true;
        const auto left = in.state(0) - in.row(0, 1) - in.row(1, 1);
        out.utilisation.push_back(1.0 - left);
        out.resources.push_back(in.row(0, 0) + in.row(1, 0));
        out.resources.push_back(in.row(0, 1) + in.row(1, 1));
        out.handed_on.push_back(left);
      });
    }
    chain.problem.first_state = {40.0};
    chain.problem.resources = {{"cost"}, {"mass"}};
    // The least by what has been used, which is in whole numbers.
    std::vector<double> least(41, infinity);
    least[0] = 0.0;
    for (std::size_t table = 0; table < 6; ++table) {
      std::vector<double> next(41, infinity);
      for (std::size_t used = 0; used <= 40; ++used)
        for (Row row = 0; row < 6; ++row) {
          const auto use = static_cast<std::size_t>(chain.table(table).row(row)[1]);
          if (used + use <= 40)
            next[used + use] = std::min(next[used + use], least[used] + chain.table(table).row(row)[0]);
        }
      least = next;
    }
    const double best = *std::min_element(least.begin(), least.end());
    Options options = objectives({0});
    options.patience = 0;
    options.stage_patience = 30;
    const Summary full = solve(chain.problem, options);
    REQUIRE(full.builds.empty() == (best == infinity));
    if (best == infinity) continue;
    CHECK(full.builds[0].resources[0] == Approx(best).epsilon(2e-6));
    const long needed = (1L << 60) - questions;
    for (int part = 1; part < 5; ++part) {
      questions = 1 + needed * part / 5;
      stop = false;
      options.stop = &stop;
      const Summary stopped = solve(chain.problem, options);
      limits += stopped.status == Status::limit;
      CHECK(stopped.lower_bound <= best + 1e-6);
      REQUIRE(stopped.status != Status::infeasible);
      if (stopped.status == Status::optimal) CHECK(stopped.builds[0].resources[0] <= best + 1e-4);
    }
  }
  CHECK(limits > (millwright::sanitized ? 1U : 10U));
}

// What is owned costs nothing: no share of the least cost is a measure of anything then.
TEST_CASE("A front that begins at a cost of nothing is found in sections as well") {
  std::size_t compared = 0, long_fronts = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 10U : 100U); ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    Chain chain;
    constexpr std::size_t stages = 3;
    constexpr Row rows = 6;
    for (std::size_t i = 0; i < stages; ++i) {
      Columns table{"row", 3, {}};
      for (Row row = 0; row < rows; ++row) {
        const double price = std::max(0, whole(random, -6, 12));
        for (const double number : {price, 0.5 * whole(random, 1, 14), 0.5 * whole(random, 0, 8)})
          table.numbers.push_back(number);
      }
      chain.add({table}, {}, 1, [](const auto& in, auto& out) {
        const auto used = in.state(0) + in.row(0, 2);
        out.utilisation.push_back(used / 6.0);
        out.resources.push_back(in.row(0, 0));
        out.resources.push_back(in.row(0, 1));
        out.handed_on.push_back(used);
      });
    }
    chain.problem.first_state = {0.0};
    chain.problem.resources = {{"cost"}, {"mass"}};
    std::vector<Total> totals;
    const auto walk = [&](auto&& self, std::size_t stage, Total sum, double used) -> void {
      if (used > 6.0) return;
      if (stage == stages) return totals.push_back(sum);
      for (Row i = 0; i < rows; ++i) {
        const double* row = chain.table(stage).row(i);
        self(self, stage + 1, {sum.cost + row[0], sum.mass + row[1]}, used + row[2]);
      }
    };
    walk(walk, 0, {}, 0.0);
    const std::vector<Total> front = zoo::front_of(totals);
    for (const std::uint64_t stage_patience : {1U, 5U, 30000U}) {
      INFO("patience " << stage_patience);
      Options options = objectives({0, 1});
      options.stage_patience = stage_patience;
      options.time_limit_seconds = 60.0;
      require_found(solve(chain.problem, options), front);
    }
    compared += !front.empty() && front.front().cost == 0.0;
    long_fronts += front.size() > 3;
  }
  CHECK(compared > 5);
  CHECK(long_fronts > 3);
}

}  // namespace edge_cases_test
