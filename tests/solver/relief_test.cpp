// SPDX-License-Identifier: Apache-2.0
// Several variables that decide feasibility only beside one that costs: each has its window, whose ends are known by
// hand, and so is the least of the one that costs.
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace relief_test {

namespace {

using namespace millwright::solver;

constexpr double shortest = 0.2, longest = 3.0;         // of a time
constexpr double thinnest = 0.5, thickest = 40.0;       // of the diameter
constexpr std::size_t price = 0, weight = 1, ease = 2;  // columns of a row

/// What a time asks of the diameter: it is at least need * load / diameter, and at most room * diameter.
struct Window {
  double need = 1.0, room = 1.0;
  bool flat = false;  ///< need * load / diameter <= 1 instead, and hardly anything of the time
  [[nodiscard]] double least_diameter(double load) const {
    if (flat) return need * load * (1.0 + flatness * shortest);
    return std::max({std::sqrt(need * load / room), need * load / longest, shortest / room});
  }
  static constexpr double flatness = 1e-6;
};

struct Model {
  std::vector<Window> windows;
  double two_together = 0.0;  ///< if positive, the most that the first two times may be in sum

  [[nodiscard]] std::size_t constraints() const { return 2 * windows.size() + (two_together > 0.0 ? 1 : 0); }
  [[nodiscard]] double least_diameter(double load) const {
    double least = thinnest;
    for (const Window& window : windows) least = std::max(least, window.least_diameter(load));
    if (two_together > 0.0) {
      // Both are as short as they may be.
      const auto sum = [&](double diameter) {
        return std::max(windows[0].need * load / diameter, shortest) +
               std::max(windows[1].need * load / diameter, shortest);
      };
      if (sum(thickest) > two_together) return 2.0 * thickest;
      double low = thinnest, high = thickest;
      for (int i = 0; i < 100; ++i) (sum(0.5 * (low + high)) > two_together ? low : high) = 0.5 * (low + high);
      least = std::max(least, high);
    }
    return least;
  }
  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    const auto load = (1.0 + in.state(0)) / in.row(0, ease);
    const auto diameter = in.variable(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const auto time = in.variable(i);
      if (windows[i].flat) {
        out.utilisation.push_back(windows[i].need * load * (1.0 + Window::flatness * time) / diameter);
        out.utilisation.push_back(0.5 * time / longest);
      } else {
        out.utilisation.push_back(windows[i].need * load / (diameter * time));
        out.utilisation.push_back(time / (windows[i].room * diameter));
      }
    }
    if (two_together > 0.0) out.utilisation.push_back((in.variable(0) + in.variable(1)) / two_together);
    out.resources.push_back(in.row(0, price) * diameter);
    out.resources.push_back(in.row(0, weight) * diameter);
    out.handed_on.push_back(in.state(0) + in.row(0, weight) * diameter);
  }
};

struct Total {
  double cost, mass;
};

class Trial {
 public:
  explicit Trial(unsigned seed) : rng_(seed) {
    for (int i = 0; i < 5; ++i) {
      const double good = between(0.0, 1.0);
      table_.numbers.insert(table_.numbers.end(),
                            {1.0 + 2.0 * good, between(0.02, 0.1), 0.7 + 0.8 * good + between(0.0, 0.3)});
    }
    const std::size_t times = 2 + seed % 4;
    for (const double stage : {1.0, 2.0}) {
      Model model;
      for (std::size_t i = 0; i < times; ++i)
        model.windows.push_back({stage * between(1.0, 6.0), between(0.1, 0.6), seed % 3 == 0 && i + 1 == times});
      if (seed % 4 == 1) model.two_together = between(0.5, 2.0);
      if (seed % 9 == 0) model.windows[0].need *= 60.0;
      models_.push_back(model);
    }
    std::vector<Variable> variables(times, {"time", shortest, longest});
    variables.push_back({"diameter", thinnest, thickest});
    for (const Model& model : models_)
      stages_.push_back(std::make_unique<ModelStage<Model>>(
          "stage", std::vector<const Columns*>{&table_}, variables, model.constraints(), model));
    problem.first_state = {0.0};
    for (const auto& stage : stages_) problem.stages.push_back(stage.get());
    problem.resources = {{"cost"}, {"mass"}};
  }

  /// For every two rows the thinnest diameters: they are cheapest and lightest, and what is heavier asks for more
  /// below.
  [[nodiscard]] std::vector<Total> totals() const {
    std::vector<Total> all;
    for (std::uint32_t a = 0; a < table_.rows(); ++a)
      for (std::uint32_t b = 0; b < table_.rows(); ++b) {
        const double* above = table_.row(a);
        const double* below = table_.row(b);
        const double first = models_[0].least_diameter(1.0 / above[ease]);
        const double carried = above[weight] * first;
        const double second = models_[1].least_diameter((1.0 + carried) / below[ease]);
        if (first > thickest || second > thickest) continue;
        all.push_back({above[price] * first + below[price] * second, carried + below[weight] * second});
      }
    return all;
  }

  Problem problem;

 private:
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(rng_() % 1000000) / 1e6); }

  std::mt19937 rng_;
  Columns table_{"bar", 3, {}};
  std::vector<Model> models_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

}  // namespace

TEST_CASE(
    "Times that decide feasibility only, each with its own window, leave the least diameter that is known by hand") {
  constexpr double front_tolerance = 1e-3;
  const int seeds = millwright::sanitized ? 8 : 60;
  int feasible = 0, infeasible = 0;
  for (int n = 1; n <= seeds; ++n) {
    const auto seed = static_cast<unsigned>(n);
    const Trial trial(seed);
    const std::vector<Total> totals = trial.totals();
    CAPTURE(seed, totals.size());
    const Summary found = solve(trial.problem, {});
    if (totals.empty()) {
      ++infeasible;
      CHECK(found.status == Status::infeasible);
      continue;
    }
    ++feasible;
    const double least = std::min_element(totals.begin(), totals.end(), [](const Total& a, const Total& b) {
                           return a.cost < b.cost;
                         })->cost;
    REQUIRE(found.status == Status::optimal);
    CHECK(found.builds[0].resources[0] >= least * (1.0 - 1e-9));
    CHECK(found.builds[0].resources[0] <= least * (1.0 + 1e-6));
    CHECK(found.lower_bound <= least * (1.0 + 1e-9));

    Options both;
    both.objectives = {0, 1};
    const Summary front = solve(trial.problem, both);
    REQUIRE(front.status == Status::optimal);
    for (const Build& build : front.builds) {
      // Nothing known is better in both.
      for (const Total& total : totals)
        CHECK((total.cost >= build.resources[0] * (1.0 - front_tolerance - 1e-9) ||
               total.mass >= build.resources[1] * (1.0 - front_tolerance - 1e-9)));
      CHECK(build.worst_utilisation <= 1.0);
    }
    for (const Total& total : totals)
      CHECK(std::any_of(front.builds.begin(), front.builds.end(), [&](const Build& build) {
        return build.resources[0] <= total.cost * (1.0 + front_tolerance + 1e-9) &&
               build.resources[1] <= total.mass * (1.0 + front_tolerance + 1e-9);
      }));
  }
  CHECK(2 * feasible > seeds);
  if (!millwright::sanitized) CHECK(20 * infeasible > seeds);
}

}  // namespace relief_test
