// SPDX-License-Identifier: Apache-2.0
//
// Designs that a ramp has no value for: a short one asks for much torque, a long one for a high speed at which there is
// little. The logarithm of the utilisation is convex in the ramp, so the least of it is found by a ternary search, and
// the best design by taking all of them in the order of their prices. A search that came to all that are cheaper, one
// by one, would look at as many nodes.
#include "solver/set_proofs.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <random>

#include "catch.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace set_proofs_test {

namespace {

using namespace millwright::solver;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_ramp = 0.05, longest_ramp = 0.6, whole_time = 1.0;
enum Column : std::size_t { price, inertia, own, columns };  ///< own: a motor's torque, a support's friction

/// The torque that is needed, over that which there is at the speed.
template <class T, class Ramp>
T utilisation(const T& friction, const T& whole_inertia, const T& torque, const Ramp& ramp) {
  constexpr double falls = 0.5;
  return (friction + whole_inertia / ramp) * (1.0 + falls / (whole_time - ramp)) / torque;
}

/// Motors decide nearly all; couplings and supports are much alike.
class Drives {
 public:
  explicit Drives(unsigned seed) : rng_(seed) {
    constexpr std::size_t rows = 100;
    for (std::size_t row = 0; row < rows; ++row) {
      const double size = uniform(2.2, 2.4);
      // In braces numbers are drawn from the left to the right.
      add_row(0, {10.0 * size * uniform(0.9, 1.1), 0.05 * size * uniform(0.9, 1.1), size * uniform(0.95, 1.05)});
      add_row(1, {uniform(5.0, 5.5), uniform(0.005, 0.007), 0.0});
      add_row(2, {uniform(8.0, 8.5), 0.0, uniform(1.0, 1.01)});
    }
    problem.resources = {{"cost", infinity}};
    problem.first_state = {0.0};
    add(model_stage("drive",
                    {&tables_[0], &tables_[1], &tables_[2]},
                    {{"ramp", least_ramp, longest_ramp}},
                    1,
                    [](const auto& in, auto& out) {
                      const auto turned = in.row(0, inertia) + in.row(1, inertia);
                      out.utilisation.push_back(utilisation(in.row(2, own), turned, in.row(0, own), in.variable(0)));
                      out.resources.push_back(in.row(0, price) + in.row(1, price) + in.row(2, price));
                      out.handed_on.push_back(in.state(0));
                    }));
    add(model_stage("end", {}, {}, 0, [](const auto& in, auto& out) {
      out.resources.push_back(0.0 * in.state(0));
      out.handed_on.push_back(in.state(0));
    }));
  }

  /// Of all feasible designs, and how many are cheaper than that.
  struct Best {
    double cost = infinity;
    std::size_t cheaper = 0;
  };
  [[nodiscard]] Best best() const {
    std::vector<Design> designs = all();
    std::ranges::sort(designs, {}, &Design::cost);
    const auto first =
        std::ranges::find_if(designs, [](const Design& design) { return least_utilisation(design) <= 1.0; });
    if (first == designs.end()) return {infinity, designs.size()};
    return {first->cost, static_cast<std::size_t>(first - designs.begin())};
  }

  Problem problem;

 private:
  struct Design {
    double cost = 0.0, friction = 0.0, whole_inertia = 0.0, torque = 0.0;
  };
  static double least_utilisation(const Design& d) {
    const auto at = [&](double ramp) { return utilisation(d.friction, d.whole_inertia, d.torque, ramp); };
    double low = least_ramp, high = longest_ramp;
    for (int i = 0; i < 60; ++i) {
      const double third = (high - low) / 3.0;
      (at(low + third) > at(high - third) ? low : high) =
          at(low + third) > at(high - third) ? low + third : high - third;
    }
    return at(0.5 * (low + high));
  }
  [[nodiscard]] std::vector<Design> all() const {
    const auto& [motors, couplings, supports] = tables_;
    std::vector<Design> designs;
    for (Row m = 0; m < motors.rows(); ++m)
      for (Row c = 0; c < couplings.rows(); ++c)
        for (Row s = 0; s < supports.rows(); ++s)
          designs.push_back({motors.row(m)[price] + couplings.row(c)[price] + supports.row(s)[price],
                             supports.row(s)[own],
                             motors.row(m)[inertia] + couplings.row(c)[inertia],
                             motors.row(m)[own]});
    return designs;
  }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(rng_); }
  void add_row(std::size_t table, std::initializer_list<double> numbers) {
    tables_[table].numbers.insert(tables_[table].numbers.end(), numbers);
  }
  template <class S>
  void add(S stage) {
    problem.stages.push_back(stages_.emplace_back(std::make_unique<S>(std::move(stage))).get());
  }

  std::mt19937 rng_;
  std::array<Columns, 3> tables_{
      Columns{"motor", columns, {}}, Columns{"coupling", columns, {}}, Columns{"support", columns, {}}};
  std::vector<std::unique_ptr<Stage>> stages_;
};

}  // namespace

TEST_CASE("Designs that a variable has no value for are left out in sets") {
  for (const unsigned seed : {7U, 8U}) {
    const Drives drives(seed);
    const Drives::Best best = drives.best();
    REQUIRE(best.cheaper > 50000);
    for (const bool stagewise : {true, false}) {
      CAPTURE(stagewise, seed);
      Options options;
      options.stagewise = stagewise;
      const Summary found = solve(drives.problem, options);
      REQUIRE(found.status == Status::optimal);
      CHECK(found.builds.front().resources[0] == Approx(best.cost).epsilon(1e-9));
      CHECK(60 * found.nodes < best.cheaper);
    }
  }
}

TEST_CASE("Proofs about sets that find nothing are given up until the search has gone on") {
  SetProofs proofs;
  CHECK(proofs.worth_asking(0));
  proofs.count({1000, false});
  CHECK_FALSE(proofs.worth_asking(0));
  CHECK(proofs.worth_asking(10000));
  SECTION("those that find something allow for more") {
    proofs.count({1000, true});
    CHECK(proofs.worth_asking(0));
  }
}

}  // namespace set_proofs_test
