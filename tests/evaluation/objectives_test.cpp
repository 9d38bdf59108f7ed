// SPDX-License-Identifier: Apache-2.0
// Weighted sums, cycle time, energy and position error as objectives: the figures against sums and integrals worked out
// apart from them, the search against all builds tried one by one.
#include <fmt/format.h>

#include <random>

#include "catch.h"
#include "evaluation/machine_stages.h"
#include "evaluation/priced_exhaustive.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"
#include "sanitized.h"

namespace objectives_test {

using namespace millwright;
using evaluation::MachineModel;
using evaluation::Synthesis;
using machine::Quantity;

namespace {

const std::vector<Quantity> all_counted{Quantity::cycle_time, Quantity::energy, Quantity::position_error};

Vary random_prices(unsigned seed) {
  return [seed](const std::string& part, PriceAndMass usual) {
    std::seed_seq seeds(part.begin(), part.end());
    std::vector<unsigned> word(1);
    seeds.generate(word.begin(), word.end());
    std::mt19937 random(word[0] ^ (seed * 2654435761U));
    const auto factor = [&](double most) {
      return std::pow(most, 2.0 * static_cast<double>(random() >> 8U) / 16777216.0 - 1.0);
    };
    return PriceAndMass{usual.price * factor(3.0), usual.mass * factor(4.0)};
  };
}

/// x on y, or x alone. Both have a move whose ramps are chosen; `mass` on x, moved at `speed` mm/s.
machine::Problem table(double mass, double speed, bool two_axes, const char* direction = "horizontal") {
  std::string text = fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
direction = "{}"
stroke = "300 mm"
structure_mass = "{} kg"
guide_friction = 0.05
guide_drag = "3 N"
acceleration_time = ["0.01 s", "0.4 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-free" }}
motor = {{ microsteps = 8, brake_torque = "1 N.m" }}
[[axis.moves]]
distance = "40 mm"
speed = "{} mm/s"
force = "20 N"
dwell = "0.3 s"
[[axis.moves]]
distance = "200 mm"
time = "5 s"
[axis.require]
position_error = {{ limit = "0.5 mm", over = "300 mm" }}
inertia_ratio = 40
)",
                                 direction,
                                 mass,
                                 speed);
  if (two_axes)
    text += R"(
[[axis]]
name = "y"
carries = ["x"]
stroke = "200 mm"
structure_mass = "3 kg"
guide_friction = 0.3
acceleration_time = ["0.02 s", "0.3 s"]
mechanism = { kind = "belt", idler_distance = "100 mm" }
motor = { frame = ["NEMA17", "NEMA23"] }
[[axis.moves]]
distance = "150 mm"
speed = "100 mm/s"
force = "5 N"
[axis.require]
position_error = { limit = "1 mm", over = "200 mm" }
inertia_ratio = 40
)";
  machine::Problem problem = problem_of_text(text);
  problem.counted = all_counted;
  return problem;
}

Synthesis solved(const MachineModel& model, const std::vector<std::string>& objectives) {
  evaluation::SearchOptions options;
  options.objectives = objectives;
  return evaluation::synthesise(model, options);
}

std::vector<double> weights_of(const MachineModel& model, const std::string& name) {
  std::vector<double> weights(model.problem().resources.size(), 0.0);
  for (const machine::ObjectiveTerm& term : machine::objective_named(name).terms)
    weights[model.resource(term.quantity)] = term.weight;
  return weights;
}

}  // namespace

TEST_CASE("The best builds by every objective and by weighted sums are those of all builds") {
  const std::vector<std::string> objectives{"cost + 25*mass",
                                            "cycle_time",
                                            "energy",
                                            "position_error",
                                            "cost + 300*cycle_time + 0.5*energy",
                                            "0.5*mass + energy"};
  int compliant = 0;
  for (unsigned seed = 0; seed < (sanitized ? 1 : 3); ++seed) {
    const TinyCatalogue tiny(random_prices(seed));
    const machine::Problem problem =
        table(4.0 + 5.0 * (seed % 3), 20.0 + 8.0 * (seed % 4), seed == 5, seed % 3 == 1 ? "vertical" : "horizontal");
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel model(problem, tiny.parts());
    const MachineModel whole(everything, tiny.parts());
    for (std::size_t i = 0; i < objectives.size(); ++i) {
      if (sanitized && i % 3 != 2) continue;
      const std::string& objective = objectives[i];
      const PricedExhaustive all(whole, weights_of(whole, objective));
      INFO("machine " << seed << ", " << objective << ", " << all.builds.size() << " choices of rows");
      const Synthesis found = solved(model, {objective});
      if (all.builds.empty()) {
        CHECK(found.status == solver::Status::infeasible);
        continue;
      }
      ++compliant;
      REQUIRE(found.designs.size() == 1);
      CHECK(found.status == solver::Status::optimal);
      const double value = found.designs[0].total(machine::objective_named(objective));
      CHECK(value == Approx(all.least()).epsilon(5e-6));
      CHECK(found.lower_bound <= value * (1.0 + 1e-9));
      CHECK(found.lower_bound >= value * (1.0 - 3e-6));
      CHECK(found.designs[0].satisfied());
    }
  }
  CHECK(compliant >= (sanitized ? 2 : 12));
}

TEST_CASE("Fronts of cost against time, energy and error are those of all builds, as exact as they say") {
  for (const char* objective : {"cycle_time", "position_error", "energy"}) {
    if (sanitized && objective[0] != 'c') continue;
    const TinyCatalogue tiny(random_prices(3));
    const machine::Problem problem = table(9.0, 30.0, false);
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel model(problem, tiny.parts());
    const MachineModel whole(everything, tiny.parts());
    const auto expected = PricedExhaustive(whole, weights_of(whole, objective)).front();
    const Synthesis front = solved(model, {"cost", objective});
    INFO(objective << ", " << expected.size() << " points, " << front.designs.size() << " found");
    CHECK(front.status == solver::Status::optimal);
    REQUIRE(expected.size() > 1);
    const double slack = 1.0 + std::max(front.front_tolerance, 1e-9);
    const machine::Objective second = machine::objective_named(objective);
    // Every point of the front is covered, and no point found is better than what all builds can be.
    for (const auto& point : expected)
      CHECK(std::any_of(front.designs.begin(), front.designs.end(), [&](const evaluation::Design& d) {
        return d.cost <= point.cost * slack && d.total(second) <= point.weighted * slack;
      }));
    for (const evaluation::Design& d : front.designs) {
      CHECK(d.satisfied());
      CHECK(std::none_of(expected.begin(), expected.end(), [&](const auto& point) {
        return point.cost < d.cost / slack && point.weighted < d.total(second) / slack;
      }));
      CHECK(std::any_of(expected.begin(), expected.end(), [&](const auto& point) {
        return point.cost <= d.cost * (1.0 + 1e-9) && point.weighted <= d.total(second) * (1.0 + 1e-6);
      }));
    }
  }
}

// With every ramp at its shortest a build is as fast as can be, so the cheapest of them is the cheapest of a machine
// whose ramps are fixed there.
TEST_CASE("Of builds that are as fast the cheapest is taken") {
  int shortest = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 4); ++seed) {
    const TinyCatalogue tiny(random_prices(seed));
    machine::Problem problem = table(3.0, 10.0, seed % 2 == 1);
    for (machine::Axis& axis : problem.axes) axis.acceleration_time.lower = 0.15;
    const Synthesis fastest = solved(MachineModel(problem, tiny.parts()), {"cycle_time"});
    REQUIRE(fastest.designs.size() == 1);
    CHECK(fastest.designs[0].satisfied());
    const auto& dimensions = fastest.designs[0].dimensions;
    if (std::any_of(dimensions.begin(), dimensions.end(), [](const evaluation::DimensionLine& line) {
          return line.name == "acceleration_time" && line.value > 0.15 * (1.0 + 1e-6);
        }))
      continue;
    ++shortest;
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel whole(everything, tiny.parts());
    // Of all builds: a second of the cycle is dearer than every part.
    const PricedExhaustive all(whole, weights_of(whole, "cost + 1e6*cycle_time"));
    CHECK(fastest.designs[0].total(machine::objective_named("cost + 1e6*cycle_time")) ==
          Approx(all.least()).epsilon(1e-7).margin(0.5));
    const double time = fastest.designs[0].total(Quantity::cycle_time);
    double cheapest = std::numeric_limits<double>::infinity();
    for (const auto& build : all.builds)
      if (build.weighted - build.cost <= 1e6 * time * (1.0 + 1e-9)) cheapest = std::min(cheapest, build.cost);
    CHECK(fastest.designs[0].cost == Approx(cheapest).epsilon(1e-9));
  }
  CHECK(shortest >= 1);
}

TEST_CASE("A front of three objectives has the best of each") {
  const TinyCatalogue tiny(random_prices(1));
  const MachineModel model(table(6.0, 30.0, false), tiny.parts());
  const Synthesis front = solved(model, {"cost", "mass", "cycle_time"});
  REQUIRE_FALSE(front.designs.empty());
  CHECK(front.status == solver::Status::optimal);
  for (const char* objective : {"cost", "mass", "cycle_time"}) {
    const machine::Objective one = machine::objective_named(objective);
    const double best = PricedExhaustive(model, weights_of(model, objective)).least();
    double least = std::numeric_limits<double>::infinity();
    for (const evaluation::Design& d : front.designs) least = std::min(least, d.total(one));
    INFO(objective);
    CHECK(least <= best * (1.0 + std::max(front.front_tolerance, 1e-6)));
  }
}

// Every move takes the time it is stated to take: nothing is faster, and the front is that of cost and mass.
TEST_CASE("A front in three objectives of which one is the same for all builds is that in the other two") {
  for (unsigned seed = 0; seed < (sanitized ? 1 : 3); ++seed) {
    const TinyCatalogue tiny(random_prices(seed));
    machine::Problem problem = table(3.0, 10.0, true);
    double time = 0.3;  // s, the dwell
    for (machine::Axis& axis : problem.axes) {
      axis.keep_every_candidate = true;
      for (machine::Move& move : axis.moves) {
        if (move.speed) move.time = 6.0;
        move.speed.reset();
        time += *move.time;
      }
    }
    const MachineModel model(problem, tiny.parts());
    const Synthesis front = solved(model, {"mass", "cycle_time", "cost"});
    CAPTURE(seed, front.method);
    CHECK(front.status == solver::Status::optimal);
    CHECK(front.method.find("every build has the same cycle_time") != std::string::npos);
    if (sanitized) continue;  // to try all builds takes twice as long as to find them
    const PricedExhaustive all(model, weights_of(model, "mass"));
    std::vector<std::pair<double, double>> expected, found;
    for (const auto& build : all.builds)
      if (std::none_of(all.builds.begin(), all.builds.end(), [&](const auto& other) {
            return other.cost <= build.cost && other.weighted <= build.weighted &&
                   (other.cost < build.cost || other.weighted < build.weighted);
          }))
        expected.emplace_back(build.cost, build.weighted);
    for (const evaluation::Design& d : front.designs) {
      CHECK(d.satisfied());
      CHECK(d.total(Quantity::cycle_time) == Approx(time).epsilon(1e-12));
      found.emplace_back(d.cost, d.total(Quantity::mass));
    }
    REQUIRE(expected.size() > 1);
    const auto same = [](const auto& a, const auto& b) {
      return a.first == Approx(b.first).epsilon(1e-9) && a.second == Approx(b.second).epsilon(1e-9);
    };
    for (const auto& point : expected)
      CHECK(std::any_of(found.begin(), found.end(), [&](const auto& other) { return same(point, other); }));
    for (const auto& point : found)
      CHECK(std::any_of(expected.begin(), expected.end(), [&](const auto& other) { return same(point, other); }));
  }
}

// By hand. x: 200 mm at 50 mm/s with ramps of t, 4 s + t, dwell 1 s. z goes up and down: twice 2 s and twice a dwell of
// 0.5 s, 5 s. The diagonal of 50 mm at 25 mm/s with ramps of 0.2 s takes 2.2 s, up and down 4.4 s, and 2 * 0.1 s of
// dwell. The table turns 90 deg in 0.7 s. Sum 15.3 s + t, 0.1 s <= t.
TEST_CASE("The machine's cycle is the moves of its axes, those done together counted once") {
  const char* const text = R"(
[currency]
USD = 1.0
[supply]
voltage = ["36 V"]
[[moves]]
name = "diagonal"
axes = { x = "40 mm", z = "30 mm" }
speed = "25 mm/s"
acceleration_time = "0.2 s"
dwell = "0.1 s"
[[axis]]
name = "x"
carries = ["z"]
stroke = "300 mm"
structure_mass = "2 kg"
acceleration_time = ["0.1 s", "0.4 s"]
mechanism = { kind = "belt" }
[[axis.moves]]
distance = "200 mm"
speed = "50 mm/s"
dwell = "1 s"
[[axis]]
name = "z"
carries = ["table"]
direction = "vertical"
stroke = "100 mm"
structure_mass = "0.5 kg"
mechanism = { kind = "screw", screw = ["lead_screws"], ends = "fixed-free" }
acceleration_time = ["0.1 s", "0.4 s"]
[[axis.moves]]
distance = "10 mm"
time = "2 s"
dwell = "0.5 s"
[[axis]]
name = "table"
stroke = "360 deg"
structure_mass = "0.2 kg"
structure_inertia = "1e-5 kg.m2"
mechanism = { kind = "rotary" }
acceleration_time = ["0.1 s", "0.3 s"]
[[axis.moves]]
distance = "90 deg"
time = "0.7 s"
)";
  machine::Problem problem = problem_of_text(text);
  problem.counted = {Quantity::cycle_time};
  const MachineModel model(problem, TinyCatalogue().parts());
  double sum = 0.0;
  for (const evaluation::StageEntry& entry : model.entries()) {
    const solver::Stage& stage = entry.as_stage();
    const std::vector<solver::Row> rows(stage.slots().size(), 0);
    std::vector<double> ramps;
    if (!stage.variables().empty()) ramps = {entry.axis == "x" ? 0.25 : 0.3};
    const std::vector<double> state(model.problem().first_state.size(), 1.0);
    const std::vector<solver::Row> shared{0};
    solver::Answer<double> answer;
    stage.evaluate({shared, state, rows, ramps}, answer);
    sum += answer.resources[model.resource(Quantity::cycle_time)];
  }
  CHECK(sum == Approx(15.3 + 0.25).epsilon(1e-12));
}

TEST_CASE("The position error of a machine is the sum of the checks of its axes, or of its tool") {
  for (const char* name : {"torch-table", "inserter"}) {
    machine::Problem problem = shipped_problem(name);
    problem.counted = {Quantity::position_error};
    const MachineModel model(problem, shipped_catalogue());
    const Synthesis found = solved(model, {"cost"});
    REQUIRE(found.designs.size() == 1);
    double sum = 0.0;
    for (const evaluation::Check& check : found.designs[0].checks)
      if (check.id.rfind(problem.tool ? "C-TOOL-ERROR" : "C-ACC-TOTAL", 0) == 0) sum += check.value;
    INFO(name);
    CHECK(found.designs[0].total(Quantity::position_error) == Approx(1e-6 * sum).epsilon(1e-9));
  }
}

TEST_CASE("The cheapest build within a limit of time, energy or error is that of all builds") {
  for (const char* name : {"cycle_time", "position_error", "energy"}) {
    if (sanitized && name[0] != 'c') continue;
    const Quantity quantity = *machine::quantity_named(name);
    const TinyCatalogue tiny(random_prices(3));
    machine::Problem problem = table(9.0, 30.0, false);
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel whole(everything, tiny.parts());
    const auto expected = PricedExhaustive(whole, weights_of(whole, name)).front();
    REQUIRE(expected.size() > 1);
    problem.counted.clear();  // what is limited is counted without being asked for
    const auto best_within = [&](double limit) {
      problem.limits[quantity] = limit;
      return solved(MachineModel(problem, tiny.parts(), {}, {.objectives = {"cost"}}), {"cost"});
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double limit = expected[i].weighted * (1.0 + 1e-5);
      const Synthesis found = best_within(limit);
      INFO(name << " at most " << limit << ", build " << i << " of " << expected.size());
      REQUIRE(found.designs.size() == 1);
      const evaluation::Design& design = found.designs[0];
      CHECK(found.status == solver::Status::optimal);
      CHECK(design.cost == Approx(expected[i].cost).epsilon(1e-9));
      CHECK(design.satisfied());
      const auto check = std::ranges::find(design.checks, declaration(quantity).limit_id, &evaluation::Check::id);
      REQUIRE(check != design.checks.end());
      CHECK(check->utilisation == Approx(design.total(quantity) / limit).epsilon(1e-12));
      CHECK(check->utilisation <= 1.0 + 2e-9);
    }
    CHECK(best_within(expected.back().weighted * 0.999).status == solver::Status::infeasible);
  }
}

TEST_CASE("What the model does not count cannot be an objective, and no front is of weighted sums") {
  const TinyCatalogue tiny;
  machine::Problem problem = table(5.0, 20.0, false);
  problem.counted = {Quantity::energy};
  const MachineModel model(problem, tiny.parts());
  CHECK(model.problem().resources.size() == 3);
  CHECK_THROWS_AS(solved(model, {"cycle_time"}), std::invalid_argument);
  CHECK_THROWS_AS(solved(model, {"cost", "cost + mass"}), std::invalid_argument);
  CHECK_NOTHROW(solved(model, {"energy"}));
}

}  // namespace objectives_test
