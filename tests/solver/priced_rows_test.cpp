// SPDX-License-Identifier: Apache-2.0
//
// Stages whose rows and whose variable move the objective together, as drives do whose energy hangs on their parts and
// on the ramp: against every choice of rows, each with the best ramp worked out by hand.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/branch_and_bound.h"
#include "solver/model_stage.h"
#include "solver/solver.h"
#include "solver/variable_halves.h"

namespace priced_rows_test {

namespace {

using namespace millwright::solver;

enum MotorColumn { torque, loss, motor_mass, motor_price, motor_power, motor_width };
enum ScrewColumn { inertia, screw_mass, screw_price, screw_width };
enum SupportColumn { capacity, support_price, support_width };  // nothing that moves the energy

constexpr double shortest = 0.05, longest = 0.5, idle = 0.3;

/// An axis that carries a mass: with the ramp t it takes loss (idle + t) + (inertia + 0.1 mass)/t of energy; torque t
/// has to reach inertia + 0.2 mass, the capacity the mass, and the powers of all axes stay within a limit.
struct Drive {
  double load = 1.0, power_limit = 0.0;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    const auto mass = in.state(0) + load;
    const auto ramp = in.variable(0);
    const auto power = in.state(1) + in.row(0, motor_power);
    out.utilisation.push_back((in.row(1, inertia) + 0.2 * mass) / (in.row(0, torque) * ramp));
    out.utilisation.push_back(mass / in.row(2, capacity));
    out.utilisation.push_back(power / power_limit);
    out.resources.push_back(in.row(0, loss) * (idle + ramp) + (in.row(1, inertia) + 0.1 * mass) / ramp);
    out.resources.push_back(in.row(0, motor_price) + in.row(1, screw_price) + in.row(2, support_price));
    out.handed_on.push_back(mass + in.row(0, motor_mass) + in.row(1, screw_mass));
    out.handed_on.push_back(power);
  }
};

struct Axis {
  Columns motors{"motor", motor_width, {}}, screws{"screw", screw_width, {}}, supports{"support", support_width, {}};
  Drive drive;
  std::unique_ptr<Stage> stage;
};

struct Machine {
  Machine(unsigned seed, std::size_t axes_wanted, std::size_t rows) : random(seed) {
    const double power_limit = between(2.0, 7.0) * static_cast<double>(axes_wanted);
    for (std::size_t i = 0; i < axes_wanted; ++i) {
      Axis& axis = *axes.emplace_back(std::make_unique<Axis>());
      for (std::size_t row = 0; row < rows; ++row) {
        const double strong = between(0.4, 6.0);
        axis.motors.numbers.insert(axis.motors.numbers.end(),
                                   {strong,
                                    strong * between(0.7, 1.3),
                                    strong * between(0.1, 0.2),
                                    20.0 + 8.0 * strong * between(0.9, 1.1),
                                    std::round(strong)});
        axis.screws.numbers.insert(axis.screws.numbers.end(),
                                   {between(0.02, 0.3), between(0.2, 0.9), between(10.0, 60.0)});
        axis.supports.numbers.insert(axis.supports.numbers.end(), {between(0.5, 8.0), between(2.0, 9.0)});
      }
      axis.drive = {between(0.3, 2.0), power_limit};
      axis.stage =
          std::make_unique<ModelStage<Drive>>("drive",
                                              std::vector<const Columns*>{&axis.motors, &axis.screws, &axis.supports},
                                              std::vector<Variable>{{"ramp", shortest, longest}},
                                              3,
                                              axis.drive);
    }
    problem.first_state = {0.0, 0.0};
    problem.resources = {{"energy"}, {"cost"}};
    for (const auto& axis : axes) problem.stages.push_back(axis->stage.get());
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random() % 1000000) / 1e6);
  }

  std::mt19937 random;
  std::vector<std::unique_ptr<Axis>> axes;
  Problem problem;
};

struct Total {
  double energy = 0.0, cost = 0.0;
};

/// Every feasible choice of rows with its least energy: loss t + b/t is least at sqrt(b/loss), or at the end of the
/// ramps that the torque allows.
void add_builds(const Machine& machine, std::size_t index, double carried, double power, Total so_far, auto& builds) {
  if (index == machine.axes.size()) {
    builds.push_back(so_far);
    return;
  }
  const Axis& axis = *machine.axes[index];
  const double mass = carried + axis.drive.load;
  for (Row m = 0; m < axis.motors.rows(); ++m) {
    const double* motor = axis.motors.row(m);
    if (power + motor[motor_power] > axis.drive.power_limit) continue;
    for (Row s = 0; s < axis.screws.rows(); ++s) {
      const double* screw = axis.screws.row(s);
      const double from = std::max(shortest, (screw[inertia] + 0.2 * mass) / motor[torque]);
      if (from > longest) continue;
      const double gain = screw[inertia] + 0.1 * mass;
      const double ramp = std::clamp(std::sqrt(gain / motor[loss]), from, longest);
      const double energy = motor[loss] * (idle + ramp) + gain / ramp;
      for (Row f = 0; f < axis.supports.rows(); ++f) {
        const double* support = axis.supports.row(f);
        if (mass > support[capacity]) continue;
        add_builds(
            machine,
            index + 1,
            mass + motor[motor_mass] + screw[screw_mass],
            power + motor[motor_power],
            {so_far.energy + energy, so_far.cost + motor[motor_price] + screw[screw_price] + support[support_price]},
            builds);
      }
    }
  }
}

std::vector<Total> all_builds(const Machine& machine) {
  std::vector<Total> builds;
  add_builds(machine, 0, 0.0, 0.0, {}, builds);
  return builds;
}

double least_energy(const std::vector<Total>& builds) {
  double least = std::numeric_limits<double>::infinity();
  for (const Total& build : builds) least = std::min(least, build.energy);
  return least;
}

Total total_of(const Build& build) { return {build.resources[0], build.resources[1]}; }

}  // namespace

TEST_CASE("Where rows and a variable move the objective the best of all choices of rows is found") {
  const unsigned machines = millwright::sanitized ? 10 : 120;
  unsigned infeasible = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CAPTURE(seed);
    const Machine machine(seed, 2 + seed % 2, seed % 2 == 0 ? 6 : 4);
    const std::vector<Total> builds = all_builds(machine);
    Options options;
    options.ties = {1};
    options.settle_ties = false;  // neighbours do here
    options.threads = 1 + seed % 3;
    const Summary found = solve(machine.problem, options);
    if (builds.empty()) {
      CHECK(found.status == Status::infeasible);
      ++infeasible;
      continue;
    }
    const double least = least_energy(builds);
    REQUIRE(found.builds.size() == 1);
    CHECK(found.status == Status::optimal);
    CHECK(found.gap <= 1e-6);
    const Total best = total_of(found.builds[0]);
    CHECK(best.energy >= least * (1.0 - 1e-12));
    CHECK(best.energy <= least * (1.0 + 1e-6));
    CHECK(found.lower_bound <= least * (1.0 + 1e-12));
    // Supports move the cost only: no dearer one than has to be.
    double cheapest = std::numeric_limits<double>::infinity();
    for (const Total& build : builds)
      if (build.energy <= least * (1.0 + 1e-12)) cheapest = std::min(cheapest, build.cost);
    CHECK(best.cost <= cheapest * (1.0 + 1e-12));
  }
  CHECK(10 * infeasible >= machines);
  CHECK(10 * infeasible <= 5 * machines);
}

TEST_CASE("Where rows and a variable move the objective fronts match all choices of rows to their tolerance") {
  const unsigned machines = millwright::sanitized ? 6 : 60;
  unsigned fronts = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CAPTURE(seed);
    const Machine machine(1000 + seed, 2, 5);
    const std::vector<Total> builds = all_builds(machine);
    Options options;
    options.objectives = {1, 0};
    const Summary found = solve(machine.problem, options);
    CHECK(found.status == (builds.empty() ? Status::infeasible : Status::optimal));
    CHECK(found.builds.empty() == builds.empty());
    fronts += found.builds.size() > 2;
    for (const Total& build : builds) {
      const bool matched = std::any_of(found.builds.begin(), found.builds.end(), [&](const Build& known) {
        const Total total = total_of(known);
        return total.cost <= build.cost * (1.0 + 1.001e-3) && total.energy <= build.energy * (1.0 + 1.001e-3);
      });
      INFO("cost " << build.cost << ", energy " << build.energy);
      REQUIRE(matched);
    }
    for (const Build& known : found.builds) {
      const Total total = total_of(known);
      CHECK(std::any_of(builds.begin(), builds.end(), [&](const Total& build) {
        return std::fabs(build.cost - total.cost) <= 1e-9 * total.cost && build.energy <= total.energy * (1.0 + 1e-12);
      }));
    }
  }
  CHECK(2 * fronts > machines);
}

TEST_CASE("A beam search finds a build that is feasible, and mostly nearly the best") {
  const unsigned machines = millwright::sanitized ? 40 : 200;
  unsigned feasible = 0, found = 0, good = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CAPTURE(seed);
    const Machine machine(2000 + seed, 2 + seed % 2, 4);
    const std::vector<Total> builds = all_builds(machine);
    const Options options;
    const Criteria criteria = make_criteria(machine.problem, options);
    SearchControl control(options);
    std::vector<StagePlan> plans = make_plans(machine.problem, {}, criteria, control.desk(0));
    Incumbents incumbents(criteria);
    if (!plans.empty())
      BranchAndBound(machine.problem, criteria, plans, incumbents, control, {.tolerance = 1e-4}).look(4, 1000);
    if (builds.empty()) {
      CHECK(incumbents.builds().empty());
      continue;
    }
    ++feasible;
    if (incumbents.builds().empty()) continue;
    ++found;
    const Total best = total_of(incumbents.builds()[0].build);
    const double least = least_energy(builds);
    CHECK(best.energy >= least * (1.0 - 1e-12));
    // A real build: these rows, with a ramp that need not be the best one.
    CHECK(std::any_of(builds.begin(), builds.end(), [&](const Total& build) {
      return std::fabs(build.cost - best.cost) <= 1e-9 * best.cost && build.energy <= best.energy * (1.0 + 1e-12);
    }));
    good += best.energy <= 1.01 * least;
  }
  CHECK(3 * feasible > machines);
  CHECK(10 * found >= 9 * feasible);
  CHECK(10 * good >= 6 * feasible);
}

TEST_CASE("A variable is halved where it loosens bounds more than the rows do") {
  const Machine machine(1, 2, 6);
  const Stage& stage = *machine.problem.stages[0];
  Options options;
  const Criteria criteria = make_criteria(machine.problem, options);
  Desk desk;
  const std::vector<StagePlan> plans = make_plans(machine.problem, {}, criteria, desk);
  REQUIRE(plans.size() == 2);
  const StagePlan& plan = plans[0];
  REQUIRE(plan.any_moves_outcome);
  Region region = plan.region;
  REQUIRE(wide_variable(plan, region) == std::optional<std::size_t>(0));
  const auto [lower, upper] = halved(region, 0);
  CHECK(lower.variables[0].lower == region.variables[0].lower);
  CHECK(lower.variables[0].upper == upper.variables[0].lower);
  CHECK(upper.variables[0].upper == region.variables[0].upper);
  CHECK(lower.rows == region.rows);
  // Little of its range left, and rows that differ much: those first. One motor and one screw: it, down to the
  // narrowest.
  const auto chosen = [&](const Region& of) {
    std::vector<double> least(1, desk.bound(stage, {}, plan.best_inherited, of).resources[0].lower);
    return variable_to_halve(plan, plan.best_inherited, of, least, desk);
  };
  const double low = region.variables[0].lower, range = region.variables[0].upper - low;
  region.variables[0] = {low, low + range / 100.0};
  CHECK_FALSE(wide_variable(plan, region));
  CHECK_FALSE(chosen(region));
  for (std::size_t slot : {std::size_t{0}, std::size_t{1}})
    region.rows[slot] = make_rows(stage, {}, slot, {region.rows[slot]->front()});
  CHECK(chosen(region) == std::optional<std::size_t>(0));
  region.variables[0] = {low, low + range / 2000.0};
  CHECK_FALSE(chosen(region));
  // Two neighbouring numbers have nothing between them, whatever part of the range they are.
  StagePlan narrow = plan;
  narrow.region.variables[0] = {1.0, std::nextafter(1.0, 2.0)};
  CHECK_FALSE(wide_variable(narrow, narrow.region));
}

}  // namespace priced_rows_test
