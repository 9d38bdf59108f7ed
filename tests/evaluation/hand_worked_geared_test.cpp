// SPDX-License-Identifier: Apache-2.0
// Rack axes and rotary tables worked by hand, on the figures of tiny_catalogue.h. The right-hand sides use <cmath> and
// nothing of the project.
#include <fmt/format.h>

#include <cmath>

#include "evaluation/exhaustive.h"
#include "evaluation/hand_worked.h"
#include "evaluation/synthesis.h"

namespace hand_worked_geared_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Check;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

std::string rack_axis(const std::string& mechanism) {
  return R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "900 mm"
structure_mass = "6 kg"
guide_friction = 0.02
guide_drag = "2 N"
acceleration_time = ["0.2 s", "0.3 s"]
motor = { microsteps = 16 }
mechanism = { kind = "rack", efficiency = 0.9, backlash = "0.08 mm")" +
         mechanism + R"( }
[[axis.moves]]
distance = "800 mm"
time = "2 s"
force = "30 N"
dwell = "0.5 s"
[axis.require]
position_error = "0.5 mm"
lost_motion = "0.1 mm"
motor_radial_load = "75 N"
)";
}

/// Two ramps of 0.2 s in 2 s: 0.8 m at v = 0.8/1.8 m/s.
constexpr double v = 0.8 / 1.8, a = v / 0.2;
/// Torque of M23L at 24 V, 21.6 V of which are usable, while its current of 4 A is reached.
double torque_of_long_motor(double omega) {
  const double K = 2.2 / (4.0 * std::sqrt(2.0));
  REQUIRE(std::hypot(4.0 * 0.6 + K * omega, 4.0 * 50.0 * omega * 2.2e-3) < 21.6);
  return K * 4.0 - 2.2 * (0.03 + 0.0005 * omega);
}

}  // namespace

TEST_CASE("A rack axis worked by hand: motor and pinion ride") {
  const MachineModel model(problem_of_text(rack_axis("")), parts());
  const Design d = design_of(model, {{"x", "drive", {{"R1.5"}, {"P1.5-20-8"}, {"M23L", "D4"}}, {0.2}}});

  const double r = 0.015;
  const double riding = 1.2 + 0.08, m = 6.0 + riding;
  const double friction = 2.0 + 0.02 * m * g;
  const double F = m * a + friction + 30.0;
  const double omega = v / r;
  const double torque = F * r / 0.9 + (500e-7 + 90e-7) * a / r;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_long_motor(omega), 0.5);
  expect(d, "drive", "C-ST-80", (friction + 30.0) * r / 0.9, 0.8 * 2.2);
  expect(d, "drive", "C-ST-INERTIA", (90e-7 + m * r * r) * 1e4, 10.0 * 500e-7 * 1e4);
  expect(d, "drive", "C-ST-STEPRATE", omega / (2.0 * pi) * 3.2, 24.0);
  expect(d, "drive", "C-SYS-SPEED", v * 1e3, 24e3 / 3200.0 * 2.0 * pi * r * 1e3);
  const double held = 2.2 / std::sqrt(2.0);  // K I at 4 A
  expect(d, "drive", "C-ST-HOLD", 30.0 * r * 0.9, 0.5 * held);
  expect(d, "drive", "C-SYS-TIME", 0.2, 1.0);

  // Lewis on the narrower of both: 12 mm. Commercially cut teeth at v: 3/(3 + v) of the static stress.
  const double factor = 3.0 / (3.0 + v);
  const double pinion = pi * (0.154 - 0.912 / 20.0), rack = pi * 0.154;
  expect(d, "drive", "C-RK-BEND", F / (12.0 * 1.5 * pinion), 120.0 * factor);
  expect(d, "drive", "C-RK-RACK", F / (12.0 * 1.5 * rack), 100.0 * factor);
  expect(d, "drive", "C-ST-RADIAL", F / std::cos(20.0 * pi / 180.0), 75.0);
  expect(d, "drive", "F-RACK-MODULE", 1.5, 1.5);
  expect(d, "drive", "F-RACK-ANGLE", 20.0, 20.0);
  expect(d, "drive", "F-PINION-BORE", 8.0, 8.0);
  expect(d, "drive", "F-RACK-RIDING-MASS", riding, 5.0);

  // The pitch error of 0.1 mm a metre over the stroke of 0.9 m; 0.08 mm of play.
  // On reversal: the play, and what the rotor lags under friction, to either side.
  const double lagging = r * std::asin(friction * r / 0.9 / held) / 50.0;
  expect(d, "drive", "C-ACC-LOST", (80e-6 + 2.0 * lagging) * 1e6, 100.0);
  const double travel = 2.0 * pi * r, step = travel / 200.0;
  const double lag = r * std::asin((friction + 30.0) * r / 0.9 / held) / 50.0;
  expect(
      d, "drive", "C-ACC-TOTAL", (1e-4 * 0.9 + 80e-6 + lag + std::hypot(0.05 * step, 0.5 * step / 16.0)) * 1e6, 500.0);
  expect(d, "drive", "C-ACC-RES", step / 16.0 * 1e6, 250.0);

  // 0.9 m, twice 10 mm overtravel and two teeth are 0.929 m: two pieces of half a metre.
  CHECK(d.cost == Approx(40.0 * 1.0 + 6.0 + 30.0 + 20.0 + 15.0));
  CHECK(d.mass == Approx(1.5 * 1.0 + 0.08 + 1.2 + 0.3 + 0.4));
  for (const auto& part : d.parts)
    if (part.slot == "rack") {
      CHECK(part.quantity == 2.0);
      CHECK(part.length == Approx(0.5));
      CHECK(part.unit_price == Approx(20.0));
    }
}

TEST_CASE("A rack that rides, and parts that do not go together") {
  const MachineModel model(problem_of_text(rack_axis(", motor_rides = false")), parts());
  const Design d = design_of(model, {{"x", "drive", {{"R1"}, {"P1.5-20-6.35"}, {"M23L", "D4"}}, {0.2}}});
  // One piece of a metre: 0.7 kg ride instead of motor and pinion.
  const double r = 0.015, m = 6.0 + 0.7;
  expect(d, "drive", "F-RACK-RIDING-MASS", 0.7, 5.0);
  expect(d, "drive", "C-ST-INERTIA", (95e-7 + m * r * r) * 1e4, 10.0 * 500e-7 * 1e4);
  expect(d, "drive", "F-RACK-MODULE", 1.5, 1.0);
  expect(d, "drive", "F-RACK-MODULE-MIN", 1.0, 1.5);
  expect(d, "drive", "F-PINION-BORE", 8.0, 6.35);
  expect(d, "drive", "F-PINION-BORE-MIN", 6.35, 8.0);
  CHECK_FALSE(d.satisfied());
}

// Going up the mesh asks for W/0.9 and going down it gives back 0.9 W: half of the difference rubs on reversal.
TEST_CASE("A vertical rack loses on reversal what its mesh takes of the weight") {
  std::string text = rack_axis("");
  text.replace(text.find("guide_friction"), 0, "direction = \"vertical\"\n");
  const Design d = design_of(MachineModel(problem_of_text(text), parts()),
                             {{"x", "drive", {{"R1.5"}, {"P1.5-20-8"}, {"M23L", "D4"}}, {0.2}}});
  const double r = 0.015, W = (6.0 + 1.2 + 0.08) * g, held = 2.2 / std::sqrt(2.0);
  const double rubbing = 2.0 * r / 0.9 + 0.5 * W * r * (1.0 / 0.9 - 0.9);
  expect(d, "drive", "C-ACC-LOST", (80e-6 + 2.0 * r * std::asin(rubbing / held) / 50.0) * 1e6, 100.0);
  expect(d, "drive", "C-ACC-MICRO", rubbing, held * std::sin(pi / 32.0));
}

TEST_CASE("A rack axis with a reduction worked by hand") {
  const MachineModel model(
      problem_of_text(rack_axis(", reduction = { ratio = 4, efficiency = 0.8, inertia = \"2e-6 kg.m2\", "
                                "backlash = \"0.06 deg\", mass = \"0.5 kg\", shaft = \"8 mm\", price = \"25 USD\" }")),
      parts());
  const Design d = design_of(model, {{"x", "drive", {{"R1.5"}, {"P1.5-20-8"}, {"M23", "D4"}}, {0.2}}});
  const double r = 0.015, i = 4.0, eta = 0.9 * 0.8;
  const double riding = 0.7 + 0.08 + 0.5, m = 6.0 + riding;
  const double friction = 2.0 + 0.02 * m * g;
  const double omega = i * v / r;
  expect(d, "drive", "C-ST-80", (friction + 30.0) * r / (i * eta), 0.8 * 1.2);
  const double turning = 2e-6 + 90e-7 / 16.0;
  expect(d, "drive", "C-ST-INERTIA", (turning + m * r * r / 16.0) * 1e4, 10.0 * 280e-7 * 1e4);
  // M23 has a curve at 24 V and 2.8 A: straight between (600 rpm, 0.6 N.m) and (1200 rpm, 0.3 N.m).
  const double rpm = omega * 60.0 / (2.0 * pi);
  REQUIRE((rpm > 600.0 && rpm < 1200.0 && std::abs(rpm - 1131.77) < 0.01));
  const double available = 0.6 - 0.3 * (rpm - 600.0) / 600.0;
  const double F = m * a + friction + 30.0;
  expect(d,
         "drive",
         "C-ST-TORQUE",
         (F * r / (i * eta) + (280e-7 + 2e-6 + 90e-7 / 16.0 / 0.8) * a * i / r) / available,
         0.7);
  expect(d, "drive", "C-ST-STEPRATE", omega / (2.0 * pi) * 3.2, 24.0);
  expect(d, "drive", "C-SYS-SPEED", v * 1e3, 24e3 / 3200.0 * 2.0 * pi * r / i * 1e3);
  expect(d, "drive", "C-ST-HOLD", 30.0 * r * eta / i, 0.5 * 1.2 / std::sqrt(2.0));
  const double lagging = r / i * std::asin(friction * r / (i * eta) / (1.2 / std::sqrt(2.0))) / 50.0;
  expect(d, "drive", "C-ACC-LOST", (80e-6 + 0.06 * pi / 180.0 * r + 2.0 * lagging) * 1e6, 100.0);
  expect(d, "drive", "C-ACC-RES", 2.0 * pi * r / i / 3200.0 * 1e6, 250.0);
  expect_none(d, "drive", "C-ST-RADIAL");  // the bearings of the reduction take it
  // The shaft of the reduction carries the pinion, not that of the motor, 6.35 mm.
  expect(d, "drive", "F-PINION-BORE", 8.0, 8.0);
  expect(d, "drive", "F-RACK-RIDING-MASS", riding, 5.0);
  CHECK(d.cost == Approx(40.0 + 6.0 + 16.0 + 20.0 + 15.0 + 25.0));
  CHECK(d.mass == Approx(1.5 + 0.08 + 0.7 + 0.3 + 0.4 + 0.5));
  const auto line = std::find_if(d.parts.begin(), d.parts.end(), [](const auto& p) { return p.slot == "reduction"; });
  REQUIRE(line != d.parts.end());
  CHECK(line->price == Approx(25.0));
  CHECK(line->mass == Approx(0.5));
}

TEST_CASE("A rotary table worked by hand, and what carries it") {
  const MachineModel model(problem_of_text(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "a"
stroke = "360 deg"
structure_mass = "2 kg"
payload_mass = "1 kg"
structure_inertia = "4e-4 kg.m2"
payload_inertia = "1e-4 kg.m2"
friction_torque = "0.02 N.m"
acceleration_time = ["0.1 s", "0.2 s"]
mechanism = { kind = "rotary" }
motor = { microsteps = 16 }
[[axis.moves]]
distance = "90 deg"
time = "0.5 s"
torque = "0.03 N.m"
dwell = "1 s"
[axis.require]
angle_error = "0.3 deg"
lost_angle = "0.1 deg"
inertia_ratio = 30
[[axis]]
name = "x"
carries = ["a"]
stroke = "500 mm"
structure_mass = "2 kg"
acceleration_time = "0.2 s"
mechanism = { kind = "belt", idler_distance = "80 mm" }
[[axis.moves]]
distance = "400 mm"
time = "1 s"
)"),
                           parts());
  const Design d = design_of(
      model,
      {{"a", "drive", {{"M23", "D4"}}, {0.1}}, {"x", "drive", {{"GT3-9"}, {"G20-6.35"}, {"I20"}, {"M23", "D4"}}, {}}});
  // A quarter turn in 0.5 s with ramps of 0.1 s.
  const double w = pi / 2.0 / 0.4, alpha = w / 0.1, J = 5e-4;
  const double torque = J * alpha + 0.02 + 0.03 + 280e-7 * alpha;
  // Below the curve's first point at 60 rpm its torque of 1 N.m is held.
  REQUIRE(w * 60.0 / (2.0 * pi) < 60.0);
  expect(d, "drive", "C-ST-TORQUE", torque / 1.0, 0.7, "a");
  expect(d, "drive", "C-ST-80", 0.05, 0.8 * 1.2, "a");
  expect(d, "drive", "C-ST-INERTIA", J * 1e4, 30.0 * 280e-7 * 1e4, "a");
  // Ramps of 0.1 s and 0.3 s between them, in a cycle of 1.5 s.
  const double brake = 0.05 - J * alpha - 280e-7 * alpha;
  expect(d,
         "drive",
         "C-ST-RMS",
         std::sqrt((torque * torque * 0.1 + 0.05 * 0.05 * 0.3 + brake * brake * 0.1) / 1.5),
         1.2,
         "a");
  expect(d, "drive", "C-ST-HOLD", 0.03, 0.5 * 1.2 / std::sqrt(2.0), "a");
  expect(d, "drive", "C-SYS-TIME", 0.4, 1.0, "a");
  expect(d, "drive", "C-ROT-SPEED", w * 60.0 / (2.0 * pi), 24e3 / 3200.0 * 60.0, "a");
  const double step = 1.8;  // deg
  const double lag = std::asin(0.05 / (1.2 / std::sqrt(2.0))) / 50.0 * 180.0 / pi;
  expect(d, "drive", "C-ROT-RES", step / 16.0, 0.15, "a");
  expect(d, "drive", "C-ROT-TOTAL", lag + std::hypot(0.05 * step, 0.5 * step / 16.0), 0.3, "a");
  const double lagging = std::asin(0.02 / (1.2 / std::sqrt(2.0))) / 50.0 * 180.0 / pi;  // under friction alone
  expect(d, "drive", "C-ROT-LOST", 2.0 * lagging, 0.1, "a");

  // The belt of x moves its own structure and belt, the table with its workpiece, and the table's motor.
  const double belt = 0.02 * (2.0 * (0.5 + 0.02 + 0.08) + pi / 2.0 * 0.04);
  expect(d, "drive", "C-ST-INERTIA", (30e-7 + (2.0 + belt + 3.0 + 0.7) * 0.01 * 0.01) * 1e4, 10.0 * 280e-7 * 1e4, "x");
}

TEST_CASE("A rotary table behind a reduction worked by hand") {
  const MachineModel model(problem_of_text(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "a"
stroke = "720 deg"
structure_mass = "3 kg"
structure_inertia = "0.02 kg.m2"
friction_torque = "0.3 N.m"
acceleration_time = "0.2 s"
mechanism = { kind = "rotary", reduction = { ratio = 10, efficiency = 0.75, backlash = "2 arcmin", price = "50 USD", mass = "1.5 kg" } }
motor = { microsteps = 8 }
[[axis.moves]]
distance = "180 deg"
speed = "20 rpm"
torque = "2 N.m"
[axis.require]
lost_angle = "0.05 deg"
)"),
                           parts());
  const Design d = design_of(model, {{"a", "drive", {{"M23L", "D4"}}, {}}});
  const double w = 20.0 / 60.0 * 2.0 * pi, alpha = w / 0.2;
  const double torque = (0.02 * alpha + 2.3) / 7.5 + 500e-7 * alpha * 10.0;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_long_motor(10.0 * w), 0.5);
  expect(d, "drive", "C-ST-80", 2.3 / 7.5, 0.8 * 2.2);
  expect(d, "drive", "C-ST-INERTIA", 0.02 / 100.0 * 1e4, 10.0 * 500e-7 * 1e4);
  expect(d, "drive", "C-ROT-SPEED", 20.0, 24e3 / 1600.0 / 10.0 * 60.0);
  const double lagging = std::asin(0.3 / 7.5 / (2.2 / std::sqrt(2.0))) / 50.0 / 10.0 * 180.0 / pi;
  expect(d, "drive", "C-ROT-LOST", 2.0 / 60.0 + 2.0 * lagging, 0.05);
  CHECK(d.cost == Approx(30.0 + 20.0 + 15.0 + 50.0));
}

// Racks, pinions, motors and drivers of the small catalogue, all tried: a table on a rack axis.
TEST_CASE("Cheapest and lightest machines with racks and tables equal those of all builds") {
  unsigned compliant = 0;
  for (const double force : {5.0, 40.0, 120.0, 4000.0}) {
    const machine::Problem problem = problem_of_text(fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "a"
stroke = "360 deg"
structure_mass = "1 kg"
structure_inertia = "3e-4 kg.m2"
acceleration_time = ["0.05 s", "0.2 s"]
mechanism = {{ kind = "rotary" }}
[[axis.moves]]
distance = "90 deg"
time = "0.5 s"
torque = "0.05 N.m"
[[axis]]
name = "x"
carries = ["a"]
stroke = "900 mm"
structure_mass = "3 kg"
guide_friction = 0.02
acceleration_time = ["0.05 s", "0.5 s"]
mechanism = {{ kind = "rack" }}
[[axis.moves]]
distance = "800 mm"
time = "4 s"
force = "{} N"
[axis.require]
inertia_ratio = 30
)",
                                                                 force));
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel model(problem, parts());
    const MachineModel whole(everything, parts());
    const Exhaustive all(whole);
    INFO(force << " N, " << all.builds.size() << " compliant builds");
    for (const bool cost : {true, false}) {
      evaluation::SearchOptions options;
      options.objectives = {cost ? "cost" : "mass"};
      options.threads = 1;
      const evaluation::Synthesis found = evaluation::synthesise(model, options);
      if (all.builds.empty()) {
        CHECK(found.status == solver::Status::infeasible);
        continue;
      }
      ++compliant;
      REQUIRE(found.designs.size() == 1);
      const Design& design = found.designs.front();
      CHECK(design.satisfied());
      CHECK((cost ? design.cost : design.mass) ==
            Approx(all.least(cost ? &BuildValue::cost : &BuildValue::mass)).epsilon(2e-6));
    }
  }
  CHECK(compliant >= 4);
  CHECK(compliant < 8);
}

TEST_CASE("Two racks side by side: each takes its share, and everything is there twice") {
  const std::string reduction =
      ", drives = 2, load_share = 0.6, reduction = { ratio = 4, efficiency = 0.8, mass = \"0.5 kg\", "
      "shaft = \"8 mm\", price = \"25 USD\" }";
  const MachineModel model(problem_of_text(rack_axis(reduction)), parts());
  const Design d = design_of(model, {{"x", "drive", {{"R1.5"}, {"P1.5-20-8"}, {"M23", "D4"}}, {0.2}}});
  const double r = 0.015, i = 4.0, eta = 0.9 * 0.8;
  // Two motors, pinions and reductions ride on the axis; the drive that is looked at moves 60 % of all that.
  const double riding = 0.7 + 0.08 + 0.5, m = 0.6 * (6.0 + 2.0 * riding);
  const double friction = 0.6 * 2.0 + 0.02 * m * g, process = 0.6 * 30.0;
  expect(d, "drive", "C-ST-80", (friction + process) * r / (i * eta), 0.8 * 1.2);
  expect(d, "drive", "C-ST-INERTIA", (90e-7 / 16.0 + m * r * r / 16.0) * 1e4, 10.0 * 280e-7 * 1e4);
  const double form = pi * (0.154 - 0.912 / 20.0);
  expect(d, "drive", "C-RK-BEND", (m * a + friction + process) / (12.0 * 1.5 * form), 120.0 * 3.0 / (3.0 + v));
  expect(d, "drive", "F-RACK-RIDING-MASS", riding, 5.0);
  CHECK(d.cost == Approx(2.0 * (40.0 + 6.0 + 16.0 + 20.0 + 25.0) + 15.0));
  CHECK(d.mass == Approx(2.0 * (1.5 + 0.08 + 0.7 + 0.3 + 0.5) + 0.4));
  for (const auto& part : d.parts) {
    if (part.slot == "rack") CHECK(part.quantity == 4.0);
    if (part.slot == "reduction") CHECK(part.quantity == 2.0);
    if (part.slot == "pinion") CHECK(part.quantity == 2.0);
  }
}

// The guide is chosen before the drive; it is sized for what may ride of the drives, and each drive is held to its
// part.
TEST_CASE("A guide is sized for the riding motors of a rack, and for the belt of a belt drive") {
  const auto load = [](const std::string& mechanism) {
    std::string text = rack_axis("");
    text.replace(
        text.find("mechanism = "),
        text.find("[[axis.moves]]") - text.find("mechanism = "),
        "mechanism = " + mechanism +
            "\nguide = { rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\" }\n");
    const MachineModel model(problem_of_text(text), parts());
    const Design d = design_of(model, {{"x", "guide", {{"R12"}}, {}}});
    for (const Check& c : d.checks)
      if (c.id == "C-GD-STATIC") return c.value;
    return 0.0;
  };
  // Each carriage bears a quarter of 6 kg, four carriages of 0.05 kg and the allowance; static safety 2.
  const auto quarter = [](double riding) { return 2.0 * (6.0 + 0.2 + riding) * g / 4.0; };
  CHECK(load("{ kind = \"rack\" }") == Approx(quarter(5.0)));
  CHECK(load("{ kind = \"rack\", drives = 2 }") == Approx(quarter(10.0)));
  CHECK(load("{ kind = \"belt\" }") == Approx(quarter(0.05)));
}

}  // namespace hand_worked_geared_test
