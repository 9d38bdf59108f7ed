// SPDX-License-Identifier: Apache-2.0
//
// Free dimensions before stages that need what they carry to lie between two limits (a resonance band, a least load):
// neither less nor more is better, so no design stands for others. Against the answer worked out by hand, and with
// tables in place of free dimensions against every build.
#include <algorithm>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace windows_test {

namespace {

using namespace millwright::solver;

constexpr double infinity = std::numeric_limits<double>::infinity();
enum Window : std::size_t { least_load, largest_load, own_mass, price, window_columns };

/// The load must lie in the window of the row.
constexpr auto window = [](const auto& in, auto& out) {
  const auto load = in.state(0);
  out.utilisation.push_back(load / in.row(0, largest_load));
  out.utilisation.push_back(in.row(0, least_load) / load);
  out.resources.push_back(in.row(0, price));
  out.resources.push_back(in.row(0, own_mass));
  out.handed_on.push_back(load + in.row(0, own_mass));
};

double best_of(const Summary& found, double of_cost, double of_mass) {
  const std::vector<double>& resources = found.builds.front().resources;
  return of_cost * resources[0] + of_mass * resources[1];
}

/// Stages that hand on a load, drawn from a seed.
class LoadChain {
 public:
  explicit LoadChain(unsigned seed) : rng_(seed) {
    problem.resources = {{"cost", infinity}, {"mass", infinity}};
    problem.first_state = {0.0};
  }
  Problem problem;

 protected:
  template <class S>
  void add(S stage) {
    stages_.push_back(std::make_unique<S>(std::move(stage)));
    problem.stages.push_back(stages_.back().get());
  }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(rng_); }
  std::size_t draw(std::size_t from, std::size_t to) { return from + rng_() % (to - from + 1); }

 private:
  std::mt19937 rng_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

/// A bar of free size, a stage with a window, another bar, another window. The bars cost by their mass.
class Windows : public LoadChain {
 public:
  /// Bars of nearly the same price make everything along a line nearly as good, which takes long: they are not drawn.
  explicit Windows(unsigned seed) : LoadChain(seed) {
    first_price_ = uniform(5.0, 20.0);
    second_price_ = first_price_ * (draw(0, 1) == 0 ? uniform(0.2, 0.5) : uniform(2.0, 5.0));
    least_ = uniform(1.0, 3.0);
    most_ = least_ + uniform(1.0, 5.0);
    upper_ = table("upper", 4.0);
    lower_ = table("lower", 8.0);
    const auto bar = [](double by_mass) {
      return [by_mass](const auto& in, auto& out) {
        const auto mass = in.variable(0);
        out.resources.push_back(by_mass * mass);
        out.resources.push_back(mass);
        out.handed_on.push_back(in.state(0) + mass);
      };
    };
    add(model_stage("first bar", {}, {{"mass", least_, most_}}, 0, bar(first_price_)));
    add(model_stage("upper", {&upper_}, {}, 2, window));
    add(model_stage("second bar", {}, {{"mass", shortest, longest}}, 0, bar(second_price_)));
    add(model_stage("lower", {&lower_}, {}, 2, window));
  }

  /// For each pair of rows as little of either bar as its window allows; what the lower window lacks is filled up with
  /// what costs least.
  [[nodiscard]] double least_cost(double of_cost, double of_mass) const {
    const double first = of_cost * first_price_ + of_mass;
    const double second = of_cost * second_price_ + of_mass;
    double least = infinity;
    for (Row i = 0; i < upper_.rows(); ++i) {
      for (Row j = 0; j < lower_.rows(); ++j) {
        const double* a = upper_.row(i);
        const double* b = lower_.row(j);
        double x = std::max(least_, a[least_load]);
        const double largest = std::min(most_, a[largest_load]);
        double y = shortest;
        double missing = std::max(b[least_load] - a[own_mass] - x - y, 0.0);
        const auto fill = [&](double& size, double most) {
          const double more = std::clamp(most - size, 0.0, missing);
          size += more;
          missing -= more;
        };
        if (first < second) fill(x, largest);
        fill(y, longest);
        fill(x, largest);
        if (x > largest || missing > 1e-12 || x + y + a[own_mass] > b[largest_load]) continue;
        least = std::min(
            least, first * x + second * y + of_cost * (a[price] + b[price]) + of_mass * (a[own_mass] + b[own_mass]));
      }
    }
    return least;
  }

 private:
  static constexpr double shortest = 0.5, longest = 2.0;

  Columns table(const char* name, double load) {
    Columns columns{name, window_columns, {}};
    const std::size_t rows = draw(2, 6);
    for (std::size_t row = 0; row < rows; ++row) {
      const double from = load * uniform(0.3, 1.3);
      for (const double number : {from, from * uniform(1.01, 1.3), uniform(0.2, 2.0), uniform(1.0, 60.0)})
        columns.numbers.push_back(number);
    }
    return columns;
  }

  double first_price_ = 0.0, second_price_ = 0.0, least_ = 0.0, most_ = 0.0;
  Columns upper_, lower_;
};

void require_proved(const Windows& windows, double of_cost, double of_mass, int& infeasible) {
  Options options;
  options.weights = {of_cost, of_mass};
  options.confirm = false;
  const double truth = windows.least_cost(of_cost, of_mass);
  const Summary found = solve(windows.problem, options);
  if (truth == infinity) {
    CHECK(found.status == Status::infeasible);
    ++infeasible;
    return;
  }
  REQUIRE(found.status == Status::optimal);
  const double best = best_of(found, of_cost, of_mass);
  CHECK(found.lower_bound <= truth * (1.0 + 1e-12));
  CHECK(best >= truth * (1.0 - 1e-12));
  CHECK(best <= truth * (1.0 + 1.001e-6));
}

TEST_CASE("A free dimension before windows that what it hands on must lie in, as by hand") {
  int infeasible = 0;
  const unsigned problems = millwright::sanitized ? 4 : 20;
  for (unsigned seed = 1; seed <= problems; ++seed) {
    INFO("seed " << seed);
    const Windows windows(seed);
    require_proved(windows, 1.0, 0.0, infeasible);
    require_proved(windows, 1.0, 10.0, infeasible);
  }
  CHECK(infeasible >= static_cast<int>(problems) / 10);
  CHECK(infeasible <= static_cast<int>(problems));
}

/// The same with tables of bars, three times: cost and mass of every build.
class BarsAndWindows : public LoadChain {
 public:
  explicit BarsAndWindows(unsigned seed) : LoadChain(seed) {
    double load = 0.0;
    for (std::size_t i = 0; i < levels; ++i) {
      load += 3.0;
      add_level(load);
    }
    const auto bar = [](const auto& in, auto& out) {
      out.resources.push_back(in.row(0, price));
      out.resources.push_back(in.row(0, own_mass));
      out.handed_on.push_back(in.state(0) + in.row(0, own_mass));
    };
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      const bool has_window = i % 2 == 1;
      if (has_window)
        add(model_stage("window", {&tables_[i]}, {}, 2, window));
      else
        add(model_stage("bar", {&tables_[i]}, {}, 0, bar));
    }
    try_all(0, 0.0, 0.0);
  }

  [[nodiscard]] double least(double of_cost, double of_mass) const {
    double least = infinity;
    for (const auto& [cost, mass] : builds_) least = std::min(least, of_cost * cost + of_mass * mass);
    return least;
  }
  /// Builds that no other one is as cheap and as light as.
  [[nodiscard]] std::size_t front() {
    std::sort(builds_.begin(), builds_.end());
    std::size_t points = 0;
    double lightest = infinity;
    for (const auto& [cost, mass] : builds_) {
      if (mass > lightest - 1e-9) continue;
      lightest = mass;
      ++points;
    }
    return points;
  }

 private:
  static constexpr std::size_t levels = 3;

  void add_level(double load) {
    Columns bars{"bar", window_columns, {}};
    for (std::size_t row = 0, rows = draw(2, 10); row < rows; ++row)
      for (const double number : {0.0, 0.0, uniform(0.5, 3.0), uniform(1.0, 60.0)}) bars.numbers.push_back(number);
    Columns windows{"window", window_columns, {}};
    for (std::size_t row = 0, rows = draw(2, 7); row < rows; ++row) {
      const double from = load * uniform(0.4, 1.1);
      for (const double number : {from, from * uniform(1.05, 1.6), uniform(0.2, 2.0), uniform(1.0, 60.0)})
        windows.numbers.push_back(number);
    }
    tables_.push_back(std::move(bars));
    tables_.push_back(std::move(windows));
  }
  void try_all(std::size_t stage, double load, double cost) {
    if (stage == tables_.size()) {
      builds_.emplace_back(cost, load);
      return;
    }
    for (Row row = 0; row < tables_[stage].rows(); ++row) {
      const double* numbers = tables_[stage].row(row);
      if (stage % 2 == 1 && (load > numbers[largest_load] || load < numbers[least_load])) continue;
      try_all(stage + 1, load + numbers[own_mass], cost + numbers[price]);
    }
  }

  std::vector<Columns> tables_;
  std::vector<std::pair<double, double>> builds_;
};

TEST_CASE("Windows of load with tables of bars equal every build") {
  int infeasible = 0;
  const unsigned problems = millwright::sanitized ? 50 : 2000;
  for (unsigned seed = 1; seed <= problems; ++seed) {
    BarsAndWindows bars(seed);
    INFO("seed " << seed);
    for (const auto& [of_cost, of_mass] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 10.0}}) {
      Options options;
      options.weights = {of_cost, of_mass};
      if (seed % 2 == 0) options.patience = 1;  // then it is searched as what is hard
      const Summary found = solve(bars.problem, options);
      const double truth = bars.least(of_cost, of_mass);
      if (truth == infinity) {
        CHECK(found.status == Status::infeasible);
        ++infeasible;
        continue;
      }
      REQUIRE(found.status == Status::optimal);
      CHECK(best_of(found, of_cost, of_mass) == Approx(truth).epsilon(1e-12));
    }
    Options both;
    both.objectives = {0, 1};
    const Summary found = solve(bars.problem, both);
    CHECK(found.status == (bars.front() == 0 ? Status::infeasible : Status::optimal));
    CHECK(found.builds.size() == bars.front());
  }
  CHECK(infeasible >= static_cast<int>(problems) / 10);
  CHECK(infeasible <= 2 * static_cast<int>(problems));
}

}  // namespace

}  // namespace windows_test
