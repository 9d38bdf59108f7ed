// SPDX-License-Identifier: Apache-2.0
// The best builds of small machines against all of their builds, tried one by one.
#include <fmt/format.h>

#include <random>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/exhaustive.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"
#include "sanitized.h"

namespace synthesis_test {

using namespace millwright;
using evaluation::MachineModel;
using evaluation::SearchOptions;
using evaluation::Synthesis;

namespace {

/// A cross table: x on y. `load` on x, `force` on y.
machine::Problem cross_table(double load, double force) {
  return problem_of_text(fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "{} kg"
guide_friction = 0.05
acceleration_time = ["0.02 s", "0.5 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-supported" }}
motor = {{ microsteps = 8 }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "100 mm", rail_spacing = "200 mm" }}
[[axis.moves]]
distance = "200 mm"
time = "6 s"
force = "60 N"
[[axis]]
name = "y"
carries = ["x"]
stroke = "200 mm"
structure_mass = "4 kg"
guide_friction = 0.3
acceleration_time = ["0.02 s", "0.3 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-free" }}
motor = {{ microsteps = 8 }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "100 mm", rail_spacing = "200 mm" }}
[[axis.moves]]
distance = "150 mm"
time = "3 s"
force = "{} N"
)",
                                     load,
                                     force));
}

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

Synthesis solved(const MachineModel& model, std::vector<std::string> objectives, unsigned threads = 1) {
  SearchOptions options;
  options.objectives = std::move(objectives);
  options.threads = threads;
  return evaluation::synthesise(model, options);
}

constexpr unsigned machines = sanitized ? 5 : 8;

void require_compliant(const evaluation::Design& design) {
  CHECK(design.satisfied());
  for (const auto& check : design.checks) {
    INFO(check.axis << " " << check.id);
    // One coupling states no misalignments: soft checks may stay open, hard ones never.
    CHECK((check.verdict != evaluation::Verdict::not_evaluated || check.kind == machine::ConstraintKind::soft));
    if (check.kind != machine::ConstraintKind::soft) CHECK(check.utilisation <= 1.0 + 1e-9);
  }
  double cost = 0.0, mass = 0.0;
  for (const auto& part : design.parts) {
    cost += part.price;
    mass += part.mass;
  }
  CHECK(design.cost == Approx(cost));
  CHECK(design.mass == Approx(mass));
}

void require_same(const std::vector<evaluation::Design>& a, const std::vector<evaluation::Design>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].cost == b[i].cost);
    CHECK(a[i].mass == b[i].mass);
    REQUIRE(a[i].parts.size() == b[i].parts.size());
    for (std::size_t k = 0; k < a[i].parts.size(); ++k) CHECK(a[i].parts[k].part_number == b[i].parts[k].part_number);
    for (std::size_t k = 0; k < a[i].dimensions.size(); ++k)
      CHECK(a[i].dimensions[k].value == b[i].dimensions[k].value);
  }
}

}  // namespace

// Prices and masses of the parts are drawn for each machine; the loads run from easy to impossible. The exhaustive
// search also keeps the drivers that the model leaves out because another one covers them.
TEST_CASE("Cheapest, lightest and front of small machines equal those of all builds") {
  int infeasible = 0, fronts = 0;
  for (unsigned seed = 0; seed < machines; ++seed) {
    if (sanitized && seed != 1 && seed != 4) continue;
    const TinyCatalogue tiny(random_prices(seed));
    const machine::Problem problem =
        cross_table(4.0 + 3.0 * (seed % 7), seed % 5 == 4 ? 3000.0 : 20.0 + 45.0 * (seed % 4));
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel model(problem, tiny.parts());
    const MachineModel whole(everything, tiny.parts());
    const Exhaustive all(whole);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis mass = solved(model, {"mass"});
    const Synthesis front = solved(model, {"cost", "mass"});
    if (all.builds.empty()) {
      ++infeasible;
      CHECK(cost.status == solver::Status::infeasible);
      CHECK(mass.designs.empty());
      CHECK(front.designs.empty());
      continue;
    }
    require_best_of(all, cost, front, require_compliant);
    require_lightest_of(all, mass, require_compliant);
    fronts += front.designs.size() > 1;
    if (sanitized) continue;
    require_same(cost.designs, solved(model, {"cost"}, 2).designs);
    require_same(front.designs, solved(model, {"cost", "mass"}, 2).designs);
  }
  // The machines are of the kinds that matter.
  CHECK(infeasible >= 1);
  CHECK(fronts >= (sanitized ? 1 : 2));
}

// The cheap motor of x is a lump of 15 kg; carrying it, y needs a motor that costs more than a light one for x.
TEST_CASE("Choosing axis by axis fails where mass couples the axes, and the search does not") {
  const TinyCatalogue tiny([](const std::string& part, PriceAndMass usual) {
    return part == "M17" ? PriceAndMass{usual.price, 15.0} : usual;
  });
  machine::Problem problem = cross_table(4.0, 60.0);
  problem.axes[1].guide_friction = 0.9;
  problem.axes[1].motor.frames = {"NEMA23"};
  const MachineModel model(problem, tiny.parts());
  const Exhaustive all(model);
  REQUIRE_FALSE(all.builds.empty());
  REQUIRE(all.greedy_cost.has_value());
  const double best = all.least(&BuildValue::cost);
  CHECK(*all.greedy_cost > best * 1.01);
  const Synthesis result = solved(model, {"cost"});
  REQUIRE(result.designs.size() == 1);
  CHECK(result.designs[0].cost == Approx(best).epsilon(2e-6));
  require_compliant(result.designs[0]);
}

TEST_CASE("A complete machine has every slot of every axis and a supply") {
  const TinyCatalogue tiny;
  const MachineModel model(cross_table(5.0, 60.0), tiny.parts());
  const Synthesis result = solved(model, {"cost"});
  REQUIRE(result.designs.size() == 1);
  const auto has = [&](const std::string& axis, const std::string& slot) {
    return std::count_if(result.designs[0].parts.begin(), result.designs[0].parts.end(), [&](const auto& line) {
      return line.axis == axis && line.slot == slot;
    });
  };
  for (const char* slot : {"screw", "nut", "motor", "driver", "coupling", "support_fixed", "guide"}) {
    CHECK(has("x", slot) == 1);
    CHECK(has("y", slot) == 1);
  }
  CHECK(has("x", "support_free") == 1);
  CHECK(has("y", "support_free") == 0);  // its end is free
  CHECK(has("machine", "supply") == 1);
}

namespace {

/// The cross table, moved in every way: y jerk-limited, both along a diagonal, x as it was measured. `effort` scales
/// the measured force.
machine::Problem moved_table(double effort) {
  const TemporaryFolder folder;
  folder.write(
      "x.csv",
      fmt::format("time [s],speed [mm/s],force [N]\n0,0,0\n0.15,32,{0}\n1.2,32,{0}\n1.3,24,{1}\n2,24,{1}\n2.1,0,0\n"
                  "3,0,0\n3.2,-36,0\n4.2,-36,0\n4.4,0,0\n",
                  effort,
                  -0.5 * effort));
  machine::Problem measured = problem_of_text(fmt::format(R"(
[supply]
voltage = ["24 V"]
[[moves]]
name = "diagonal"
axes = {{ x = "150 mm", y = "80 mm" }}
speed = "34 mm/s"
acceleration_time = "0.12 s"
jerk = "40 m/s^3"
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "1 kg"
mechanism = {{ kind = "belt" }}
[[axis.moves]]
profile = "{}/x.csv"
[[axis]]
name = "y"
stroke = "200 mm"
structure_mass = "1 kg"
mechanism = {{ kind = "belt" }}
[[axis.moves]]
distance = "150 mm"
time = "3 s"
jerk = "8 m/s^3"
force = "50 N"
)",
                                                          folder.path().string()));
  machine::Problem problem = cross_table(6.0, 50.0);
  for (std::size_t i = 0; i < 2; ++i) {
    problem.axes[i].moves = measured.axes[i].moves;
    problem.axes[i].inclination = i == 1 ? 0.4 : 0.0;
  }
  problem.axes[0].acceleration_time = measured.axes[0].acceleration_time;
  return problem;
}

}  // namespace

TEST_CASE("The search equals all builds where moves are coordinated, jerk-limited and measured") {
  std::size_t builds_before = std::numeric_limits<std::size_t>::max();
  for (const double effort : {10.0, 250.0, 700.0}) {
    if (sanitized && effort != 700.0) continue;
    const TinyCatalogue tiny(random_prices(static_cast<unsigned>(effort)));
    const machine::Problem problem = moved_table(effort);
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel model(problem, tiny.parts());
    const Exhaustive all{MachineModel(everything, tiny.parts())};
    INFO("effort " << effort << " N, " << all.builds.size() << " compliant builds");
    REQUIRE_FALSE(all.builds.empty());
    CHECK(all.builds.size() < builds_before);  // what was measured decides
    builds_before = all.builds.size();
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis mass = solved(model, {"mass"});
    REQUIRE(cost.designs.size() == 1);
    REQUIRE(mass.designs.size() == 1);
    CHECK(cost.designs[0].cost == Approx(all.least(&BuildValue::cost)).epsilon(2e-6));
    CHECK(mass.designs[0].mass == Approx(all.least(&BuildValue::mass)).epsilon(2e-6));
    require_compliant(cost.designs[0]);
    require_compliant(mass.designs[0]);
    for (const auto& dimension : cost.designs[0].dimensions) CHECK(dimension.axis != "x");  // no ramp to choose
  }
}

}  // namespace synthesis_test
