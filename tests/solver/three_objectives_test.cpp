// SPDX-License-Identifier: Apache-2.0
//
// Fronts in three objectives against every choice of rows: of cost, mass and play, which rows alone decide, exactly; of
// cost, mass and time, for which each choice has a shortest ramp, to the tolerance.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace three_objectives_test {

namespace {

using namespace millwright::solver;

enum MotorColumn { torque, motor_mass, motor_price, motor_power, motor_width };
enum ScrewColumn { inertia, screw_mass, screw_price, play, screw_width };

constexpr double shortest = 0.05, longest = 0.5;
constexpr std::array<double, 2> factor = {1.0, 1.6};  // of the torque, by the voltage
constexpr std::array<double, 2> surcharge = {0.0, 5.0};

/// An axis that carries what the axes before it weigh: with the ramp t its motor's torque t has to reach inertia + 0.2
/// mass, and the powers of all axes stay within a limit; what it carries also bends it.
struct Drive {
  double load = 1.0, power_limit = 0.0;
  bool timed = false;                              ///< the third resource is the ramp
  std::atomic<std::int64_t>* questions = nullptr;  ///< that are left before all is to stop
  std::atomic<bool>* stop = nullptr;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    if (questions != nullptr && --*questions <= 0) *stop = true;
    const auto mass = in.state(0) + load;
    const auto ramp = in.variable(0);
    const auto power = in.state(1) + in.row(0, motor_power);
    const auto own_mass = in.row(0, motor_mass) + in.row(1, screw_mass);
    out.utilisation.push_back((in.row(1, inertia) + 0.2 * mass) / (factor[in.shared(0)] * in.row(0, torque) * ramp));
    out.utilisation.push_back(power / power_limit);
    out.resources.push_back(in.row(0, motor_price) + in.row(1, screw_price) + surcharge[in.shared(0)]);
    out.resources.push_back(own_mass);
    out.resources.push_back(timed ? ramp : in.row(1, play) + 0.02 * mass);
    out.handed_on.push_back(mass + own_mass);
    out.handed_on.push_back(power);
  }
};

struct Axis {
  Columns motors{"motor", motor_width, {}}, screws{"screw", screw_width, {}};
  Drive drive;
  std::unique_ptr<Stage> stage;
};

struct Machine {
  Machine(unsigned seed, std::size_t axes_wanted, std::size_t rows, const Drive& like) : random(seed) {
    const double power_limit = between(0.3, 5.0) * static_cast<double>(axes_wanted);
    for (std::size_t i = 0; i < axes_wanted; ++i) {
      Axis& axis = *axes.emplace_back(std::make_unique<Axis>());
      for (std::size_t row = 0; row < rows; ++row) {
        const double strong = between(0.4, 6.0);
        axis.motors.numbers.insert(axis.motors.numbers.end(),
                                   {strong,
                                    strong * between(0.1, 0.2),
                                    std::round(20.0 + 8.0 * strong * between(0.9, 1.1)),  // whole, so that some tie
                                    std::round(strong)});
        const double fine = between(0.0, 1.0);
        axis.screws.numbers.insert(axis.screws.numbers.end(),
                                   {between(0.02, 0.3),
                                    between(0.2, 0.9),
                                    std::round(10.0 + 40.0 * fine),
                                    0.5 - 0.4 * fine * between(0.6, 1)});
      }
      axis.drive = like;
      axis.drive.load = between(0.3, 2.0);
      axis.drive.power_limit = power_limit;
      axis.stage = std::make_unique<ModelStage<Drive>>("drive",
                                                       std::vector<const Columns*>{&axis.motors, &axis.screws},
                                                       std::vector<Variable>{{"ramp", shortest, longest}},
                                                       2,
                                                       axis.drive);
    }
    problem.shared = {{"voltage", 2}};
    problem.first_state = {0.0, 0.0};
    problem.resources = {{"cost"}, {"mass"}, {like.timed ? "time" : "play"}};
    for (const auto& axis : axes) problem.stages.push_back(axis->stage.get());
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random() % 1000000) / 1e6);
  }

  std::mt19937 random;
  std::vector<std::unique_ptr<Axis>> axes;
  Problem problem;
};

using Total = std::array<double, 3>;

/// Whether one is no larger than another in the first `objectives` numbers, but for `slack`.
bool covers(const Total& one, const Total& other, double slack, std::size_t objectives = 3) {
  for (std::size_t k = 0; k < objectives; ++k)
    if (one[k] > other[k] * (1.0 + slack)) return false;
  return true;
}

/// Every feasible choice of rows at one voltage, each with its shortest ramps.
void add_builds(const Machine& machine,
                Row voltage,
                std::size_t index,
                double carried,
                double power,
                Total so_far,
                std::vector<Total>& builds) {
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
      const double ramp = std::max(shortest, (screw[inertia] + 0.2 * mass) / (factor[voltage] * motor[torque]));
      if (ramp > longest) continue;
      const double own_mass = motor[motor_mass] + screw[screw_mass];
      const Total total{so_far[0] + motor[motor_price] + screw[screw_price] + surcharge[voltage],
                        so_far[1] + own_mass,
                        so_far[2] + (axis.drive.timed ? ramp : screw[play] + 0.02 * mass)};
      add_builds(machine, voltage, index + 1, mass + own_mass, power + motor[motor_power], total, builds);
    }
  }
}

std::vector<Total> all_builds(const Machine& machine) {
  std::vector<Total> builds;
  for (const Row voltage : {Row{0}, Row{1}}) add_builds(machine, voltage, 0, 0.0, 0.0, {}, builds);
  return builds;
}

/// Those that no other covers in the first `objectives` numbers; of equals one.
std::vector<Total> front_of(std::vector<Total> builds, std::size_t objectives) {
  std::sort(builds.begin(), builds.end());
  std::vector<Total> front;
  for (const Total& build : builds) {
    const auto covered_by = [&](const Total& other) { return covers(other, build, 1e-11, objectives); };
    if (std::none_of(front.begin(), front.end(), covered_by)) front.push_back(build);
  }
  return front;  // in ascending order nothing covers what comes before it
}

std::vector<Total> totals_of(const Summary& found) {
  std::vector<Total> totals;
  for (const Build& build : found.builds)
    totals.push_back({build.resources[0], build.resources[1], build.resources[2]});
  return totals;
}

bool any_covers(const std::vector<Total>& some, const Total& point, double slack, std::size_t objectives = 3) {
  return std::any_of(some.begin(), some.end(), [&](const Total& one) { return covers(one, point, slack, objectives); });
}

Summary front_in_three(const Machine& machine, unsigned seed) {
  Options options;
  options.objectives = {0, 1, 2};
  std::rotate(options.objectives.begin(), options.objectives.begin() + seed % 3, options.objectives.end());
  options.threads = 1 + seed % 2;
  options.stagewise = seed % 5 != 0;
  options.look_first = seed % 7 != 0;
  if (seed % 3 != 0) options.labels_together = 1;
  if (seed % 4 == 0) options.patience = 20;  // closer curves of what is to come in the middle of the search
  return solve(machine.problem, options);
}

}  // namespace

// Few rows make fewer combinations than are worth looking at two objectives at a time first, more make more.
TEST_CASE("A front in three objectives that rows alone decide is that of all builds") {
  const unsigned machines = millwright::sanitized ? 30 : 200;
  unsigned empty = 0, large = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CAPTURE(seed);
    const Machine machine(seed, 2, seed % 2 == 0 ? 4 : 7, {});
    const std::vector<Total> exact = front_of(all_builds(machine), 3);
    const Summary found = front_in_three(machine, seed);
    CHECK(found.status == (exact.empty() ? Status::infeasible : Status::optimal));
    const std::vector<Total> totals = totals_of(found);
    REQUIRE(totals.size() == exact.size());
    for (const Total& point : exact) CHECK(any_covers(totals, point, 1e-10));
    empty += exact.empty() ? 1 : 0;
    large += exact.size() > 20 ? 1 : 0;
  }
  CHECK(20 * empty > machines);
  CHECK(4 * large > machines);
}

TEST_CASE("A front in three objectives of which a variable moves one is that of all builds to the tolerance") {
  const unsigned machines = millwright::sanitized ? 10 : 60;
  unsigned large = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CAPTURE(seed);
    const Machine machine(1000 + seed, 2, seed % 2 == 0 ? 4 : 6, {.timed = true});
    const std::vector<Total> builds = all_builds(machine);
    const Summary found = front_in_three(machine, seed);
    CHECK(found.status == (builds.empty() ? Status::infeasible : Status::optimal));
    const std::vector<Total> totals = totals_of(found);
    for (const Total& build : builds) REQUIRE(any_covers(totals, build, 1.001e-3));
    for (const Total& total : totals) {
      // Real builds: of these rows, at best with the shortest ramps.
      CHECK(std::any_of(builds.begin(), builds.end(), [&](const Total& build) {
        return std::fabs(build[0] - total[0]) <= 1e-10 * total[0] &&
               std::fabs(build[1] - total[1]) <= 1e-10 * total[1] && build[2] <= total[2] * (1.0 + 1e-12);
      }));
    }
    large += totals.size() > 20 ? 1 : 0;
  }
  CHECK(4 * large > machines);
}

namespace {

/// Whether it keeps all constraints, and its totals are those of its parts.
void check_build(const Machine& machine, const Build& build) {
  std::vector<double> state = machine.problem.first_state;
  std::vector<double> total(3, 0.0);
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    Answer<double> answer;
    machine.axes[i]->stage->evaluate({build.shared, state, build.stages[i].rows, build.stages[i].variables}, answer);
    CHECK(std::ranges::max(answer.utilisation) <= 1.0);
    for (std::size_t r = 0; r < total.size(); ++r) total[r] += answer.resources[r];
    state = answer.handed_on;
  }
  CHECK(total == build.resources);
}

}  // namespace

TEST_CASE("What a build adds up to is what its own parts and ramps do, asked for or not") {
  unsigned builds = 0;
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 20 : 200); ++seed) {
    CAPTURE(seed);
    const Machine machine(3000 + seed, 2, 6, {.timed = true});
    for (const std::vector<std::size_t>& objectives : std::vector<std::vector<std::size_t>>{{0}, {1}, {0, 1}, {1, 0}}) {
      Options options;
      options.objectives = objectives;
      options.patience = seed % 2 == 0 ? 0 : options.patience;
      options.stage_patience = seed % 4 == 0 ? 0 : options.stage_patience;
      const Summary found = solve(machine.problem, options);
      for (const Build& build : found.builds) check_build(machine, build);
      builds += static_cast<unsigned>(found.builds.size());
    }
  }
  CHECK(builds > (millwright::sanitized ? 100 : 1000));
}

TEST_CASE("Of a search in three objectives that is cut short the front in two of them is whole") {
  const unsigned machines = millwright::sanitized ? 3 : 8;
  unsigned cut_short = 0;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    for (const std::int64_t patience : {10, 300, 2000, 16000}) {
      CAPTURE(seed, patience);
      std::atomic<std::int64_t> questions = patience;
      std::atomic<bool> stop = false;
      const Machine machine(2000 + seed, 3, 10, {.timed = true, .questions = &questions, .stop = &stop});
      Options options;
      options.objectives = {0, 1, 2};
      options.stop = &stop;
      const Summary found = solve(machine.problem, options);
      for (const Build& build : found.builds) check_build(machine, build);
      if (found.status == Status::limit) CHECK(stop);
      if (patience < 10000) continue;
      cut_short += found.status == Status::limit ? 1 : 0;
      const std::vector<Total> totals = totals_of(found);
      for (const Total& point : front_of(all_builds(machine), 2)) CHECK(any_covers(totals, point, 1e-10, 2));
    }
  }
  CHECK(3 * cut_short >= machines);
}

TEST_CASE("A front in three objectives that is cut short is covered to the tolerance that it states") {
  unsigned stated = 0, closer = 0;
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 4 : 40); ++seed) {
    for (const std::int64_t patience : {100, 1000, 3000, 10000, 30000}) {
      CAPTURE(seed, patience);
      std::atomic<std::int64_t> questions = patience;
      std::atomic<bool> stop = false;
      const Machine machine(4000 + seed, 2, 7, {.timed = seed % 3 != 0, .questions = &questions, .stop = &stop});
      const std::vector<Total> builds = all_builds(machine);
      const auto check = [&](const Summary& found) {
        const double slack = 1.0 / (1.0 - found.front_tolerance) - 1.0 + 1e-9;
        const std::vector<Total> totals = totals_of(found);
        for (const Total& build : builds) REQUIRE(any_covers(totals, build, slack));
      };
      Options options;
      options.objectives = {0, 1, 2};
      options.stop = &stop;
      options.look_first = seed % 2 == 0;
      const Summary found = solve(machine.problem, options);
      if (found.status != Status::limit || !std::isfinite(found.front_tolerance)) continue;
      ++stated;
      check(found);
      options.stop = nullptr;
      options.most_nodes = static_cast<std::uint64_t>(patience);
      const Summary widened = cover_front(machine.problem, options, found.builds);
      REQUIRE(std::isfinite(widened.front_tolerance));
      check(widened);
      closer += widened.front_tolerance < 0.5 * found.front_tolerance ? 1 : 0;
    }
  }
  if (millwright::sanitized) return;
  CHECK(stated >= 30);
  CHECK(closer >= 10);
}

}  // namespace three_objectives_test
