// SPDX-License-Identifier: Apache-2.0
// Screws and belts behind a reduction, and a nut that turns, worked by hand on the figures of tiny_catalogue.h. The
// right-hand sides use <cmath> and nothing of the project.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/hand_worked.h"

namespace hand_worked_reduction_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

std::string screw_axis(const std::string& mechanism, const std::string& more = "") {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "400 mm"
structure_mass = "20 kg"
guide_friction = 0.05
guide_drag = "4 N"
acceleration_time = ["0.2 s", "0.4 s"]
mechanism = {{ kind = "screw", {} }}
motor = {{ microsteps = 4 }}
{}
[[axis.moves]]
distance = "300 mm"
time = "10.2 s"
force = "50 N"
dwell = "2 s"
[axis.require]
position_error = {{ limit = "0.3 mm", over = "300 mm" }}
lost_motion = "0.1 mm"
)",
                     mechanism,
                     more);
}

/// Two ramps of 0.2 s in 10.2 s: 0.3 m at 30 mm/s.
constexpr double v = 0.03, a = 0.15;
constexpr double steel = 79.2e9;  // shear modulus [Pa]
/// Torque of M23 at 24 V and 2.8 A, between the points of its curve at 600 and 1200 rpm.
double torque_of_motor(double omega) {
  const double rpm = omega * 60.0 / (2.0 * pi);
  REQUIRE((rpm >= 600.0 && rpm <= 1200.0));
  return 0.6 - 0.3 * (rpm - 600.0) / 600.0;
}
double value_of(const Design& d, const std::string& id) {
  for (const auto& c : d.checks)
    if (c.id == id) return c.value;
  FAIL("no check " << id);
  return 0.0;
}

}  // namespace

// The belt's large wheel sits on the screw: no coupling.
TEST_CASE("A lead screw behind a belt reduction worked by hand") {
  const MachineModel model(
      problem_of_text(screw_axis(
          "screw = [\"lead_screws\"], reduction = { ratio = 2, efficiency = 0.9, inertia = \"3e-6 kg.m2\", backlash = "
          "\"0.1 deg\", stiffness = \"200 N.m/rad\", torque = \"3 N.m\", speed = \"3000 rpm\", mass = \"0.6 kg\", "
          "price = \"28 USD\" }")),
      parts());
  const Design d = design_of(model, {{"x", "drive", {{"Tr16x4", "Tr16x4 nut"}, {"M23", "D4"}, {"F6"}, {"S6"}}, {0.2}}});
  const double lead = 0.004, i = 2.0, eta_g = 0.9, m = 20.25, supported = 0.4 + 0.02 + 0.032, cut = supported + 0.08;
  const double friction = 4.0 + 0.05 * m * g, steady = friction + 50.0, force = m * a + steady;
  const double lambda = std::atan(lead / (pi * 0.014)), friction_angle = std::atan(0.1 / std::cos(15.0 * pi / 180.0));
  const double per_newton = lead / (2.0 * pi) * std::tan(lambda + friction_angle) / std::tan(lambda);
  const double screw = pi * 7850.0 * cut * std::pow(0.014, 4) / 32.0;
  const double omega = 2.0 * pi * v / lead, alpha = 2.0 * pi * a / lead;  // of the screw

  const double torque = force * per_newton / (i * eta_g) + (280e-7 + 3e-6 + screw / 4.0 / eta_g) * alpha * i;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_motor(i * omega), 0.7);
  expect(d, "drive", "C-ST-80", steady * per_newton / (i * eta_g), 0.8 * 1.2);
  const double load = (screw + m * std::pow(lead / (2.0 * pi), 2)) / 4.0;
  expect(d, "drive", "C-ST-INERTIA", (3e-6 + load) * 1e4, 10.0 * 280e-7 * 1e4);
  expect(d, "drive", "C-ST-STEPRATE", i * omega / (2.0 * pi) * 0.8, 24.0);
  expect(d, "drive", "C-ST-HOLD", 0.0, 0.5 * 1.2 / std::sqrt(2.0));  // self-locking
  expect(d, "drive", "C-ACC-MICRO", friction * per_newton / (i * eta_g), 1.2 / std::sqrt(2.0) * std::sin(pi / 8.0));
  // From rest over the first full step of 1.8 deg of the motor.
  CHECK(value_of(d, "C-ST-START") ==
        Approx(0.5 * std::sqrt(2.0 * alpha * i * pi / 100.0) * 60.0 / (2.0 * pi)).epsilon(1e-9));

  expect(d, "drive", "C-RD-TORQUE", force * per_newton + screw * alpha, 3.0);
  expect(d, "drive", "C-RD-SPEED", 900.0, 3000.0);
  // The screw itself turns at half the motor's speed.
  CHECK(value_of(d, "C-SCR-NCRIT") == Approx(450.0));
  CHECK(value_of(d, "F-SUPPORT-SPEED") == Approx(450.0));
  CHECK(value_of(d, "C-SCR-VS") == Approx(omega / (2.0 * pi) * std::hypot(pi * 0.014, lead)));
  // 24 kHz of 800 pulses a turn are 30 turns of the motor and 15 of the screw a second, 60 mm/s; critical speed and
  // bearings allow more.
  expect(d, "drive", "C-SYS-SPEED", 30.0, 60.0);
  for (const char* id : {"C-CP-TORQUE", "F-COUPLING-MOTOR", "F-COUPLING-SCREW", "F-COUPLING-SPEED", "C-CP-MISAL"})
    expect_none(d, "drive", id);

  // Core of the screw and the reduction twist one after the other.
  const double core = supported / (steel * pi * std::pow(0.0115, 4) / 32.0);
  const double windup = steady * per_newton * (core + 1.0 / 200.0) * lead / (2.0 * pi);
  expect(d, "drive", "C-CP-WINDUP", windup * 1e6, 300.0);
  const double k = 1.0 / (core + 1.0 / 200.0) / 4.0;  // at the motor
  const double held = 1.2 / std::sqrt(2.0);
  expect(d,
         "drive",
         "C-CP-RES",
         2.0 * std::sqrt(50.0 * held / (280e-7 + 3e-6 + load)) / (2.0 * pi),
         std::sqrt(k * (1.0 / (280e-7 + 3e-6) + 1.0 / load)) / (2.0 * pi));
  const double rod = 206e9 * pi / 4.0 * std::pow(0.0115, 2) / supported, chain = 1.0 / (1.0 / rod + 1.0 / 40e6);
  const double lost =
      0.05e-3 + 2.0 * friction / chain + (0.1 * pi / 180.0 + 2.0 * friction * per_newton / 200.0) * lead / (2.0 * pi);
  // The rotor and the core of the screw give way under friction, to either side.
  const double turned = std::asin(friction * per_newton / (i * eta_g) / held) / 50.0 / i + friction * per_newton * core;
  expect(d, "drive", "C-ACC-LOST", (lost + 2.0 * turned * lead / (2.0 * pi)) * 1e6, 100.0);
  const double lag = lead / i / (2.0 * pi) * std::asin(steady * per_newton / (i * eta_g) / held) / 50.0;
  const double step = lead / i / 200.0, growth = 12e-6 * 0.3 * 5.0;  // 5 K over the stated 300 mm
  expect(d,
         "drive",
         "C-ACC-TOTAL",
         (50e-6 + lost + 50.0 / chain + windup + lag + growth + std::hypot(0.05 * step, 0.5 * step / 4.0)) * 1e6,
         300.0);
  expect(d, "drive", "C-ACC-RES", step / 4.0 * 1e6, 150.0);

  CHECK(d.cost == Approx(20.0 * cut + 8.0 + 16.0 + 20.0 + 10.0 + 4.0 + 28.0 + 15.0));
  CHECK(d.mass == Approx(1.2 * cut + 0.25 + 0.7 + 0.3 + 0.2 + 0.1 + 0.6 + 0.4));
}

TEST_CASE("A brake on the motor holds a screw through its reduction, worked by hand") {
  std::string text = screw_axis(
      "screw = [\"lead_screws\"], reduction = { ratio = 2, efficiency = 0.9, inertia = \"3e-6 kg.m2\", torque = \"3 "
      "N.m\", speed = \"3000 rpm\", mass = \"0.6 kg\", price = \"28 USD\" }");
  const auto put = [&](const std::string& old, const std::string& now) {
    text.replace(text.find(old), old.size(), now);
  };
  put("stroke =", "direction = \"vertical\"\nstroke =");
  put("microsteps = 4", "microsteps = 4, brake_torque = \"0.05 N.m\"");
  const MachineModel model(problem_of_text(text), parts());
  const Design d = design_of(model, {{"x", "drive", {{"Tr16x4", "Tr16x4 nut"}, {"M23", "D4"}, {"F6"}, {"S6"}}, {0.2}}});
  // The thread locks itself by less than 1.3; of what comes through with a friction that is less by that factor, half
  // reaches the motor, less the losses of the reduction.
  const double slope = 0.004 / (pi * 0.014), friction = 0.1 / std::cos(15.0 * pi / 180.0), weight = 20.25 * g;
  const double through =
      (weight - 4.0) * 0.004 / (2.0 * pi) * std::tan(std::atan(slope) - std::atan(friction / 1.3)) / slope;
  REQUIRE(through > 0.0);
  expect(d, "drive", "C-SCR-LOCK", std::max(through * 0.9 / 2.0, 1e-3) / 0.05 / 1.3, 1.0 / 1.3);
}

// A gearbox on the motor; the coupling joins its shaft to the screw.
TEST_CASE("A ball screw behind a gearbox worked by hand") {
  const MachineModel model(
      problem_of_text(screw_axis("screw = [\"ball_screws\"], reduction = { ratio = 3, efficiency = 0.95, inertia = "
                                 "\"2e-6 kg.m2\", shaft = \"8 mm\", mass = \"0.4 kg\", price = \"45 USD\" }")),
      parts());
  const Design d = design_of(model, {{"x", "drive", {{"B16x5"}, {"M23", "D4"}, {"K8"}, {"F6"}, {"S6"}}, {0.2}}});
  const double lead = 0.005, i = 3.0, eta_g = 0.95, m = 20.25, supported = 0.4 + 0.02 + 0.04, cut = supported + 0.08;
  const double friction = 4.0 + 0.05 * m * g, steady = friction + 50.0, force = m * a + steady;
  const double slope = lead / (pi * 0.0165);
  const double eta = (1.0 - 0.005 * slope) / (1.0 + 0.005 / slope);
  const double eta_r = (1.0 - 0.005 / slope) / (1.0 + 0.005 * slope);
  const double per_newton = lead / (2.0 * pi * eta);
  const double turning = pi * 7850.0 * cut * std::pow(0.0145, 4) / 32.0 + 10e-7;  // with the coupling
  const double omega = 2.0 * pi * v / lead, alpha = 2.0 * pi * a / lead;
  const double torque = force * per_newton / (i * eta_g) + (280e-7 + 2e-6 + turning / 9.0 / eta_g) * alpha * i;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_motor(i * omega), 0.7);
  const double load = (turning + m * std::pow(lead / (2.0 * pi), 2)) / 9.0;
  expect(d, "drive", "C-ST-INERTIA", (2e-6 + load) * 1e4, 10.0 * 280e-7 * 1e4);
  // The load drives: screw and gearbox both lose on the way back to the motor.
  expect(d, "drive", "C-ST-HOLD", 50.0 * lead / (2.0 * pi) * eta_r * eta_g / i, 0.5 * 1.2 / std::sqrt(2.0));
  // All that turns the screw goes through the coupling.
  expect(d, "drive", "C-CP-TORQUE", 2.0 * (force * per_newton + turning * alpha), 2.0);
  expect(d, "drive", "F-COUPLING-MOTOR", 8.0, 8.0);
  expect(d, "drive", "F-COUPLING-MOTOR-MIN", 3.0, 8.0);
  expect(d, "drive", "F-COUPLING-SPEED", 360.0, 6000.0);
  CHECK(value_of(d, "C-BS-DN") == Approx(16.0 * 360.0));
  expect(d,
         "drive",
         "C-CP-WINDUP",
         steady * per_newton * (supported / (steel * pi * std::pow(0.013, 4) / 32.0) + 1.0 / 60.0) * lead / (2.0 * pi) *
             1e6,
         300.0);
  expect_none(d, "drive", "C-RD-TORQUE");  // nothing is stated
  expect_none(d, "drive", "C-RD-SPEED");
  CHECK(d.cost == Approx(40.0 * cut + 20.0 + 16.0 + 20.0 + 2.0 + 10.0 + 4.0 + 45.0 + 15.0));
}

TEST_CASE("A belt axis behind a reduction worked by hand") {
  const MachineModel model(problem_of_text(R"(
[currency]
USD = 1.0
EUR = 1.5
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "500 mm"
structure_mass = "6 kg"
guide_friction = 0.02
guide_drag = "1 N"
acceleration_time = ["0.2 s", "0.3 s"]
mechanism = { kind = "belt", idler_distance = "80 mm", reduction = { ratio = 2, efficiency = 0.9, inertia = "4e-6 kg.m2", backlash = "0.1 deg", stiffness = "100 N.m/rad", torque = "0.5 N.m", speed = "800 rpm", shaft = "6.35 mm", mass = "0.5 kg", price = "20 EUR" } }
motor = { microsteps = 16 }
[[axis.moves]]
distance = "400 mm"
time = "1 s"
force = "5 N"
dwell = "0.5 s"
[axis.require]
position_error = "0.5 mm"
lost_motion = "0.1 mm"
motor_radial_load = "75 N"
reduction_service_factor = 1.25
)"),
                           parts());
  const Design d = design_of(model, {{"x", "drive", {{"GT3-9"}, {"G20-6.35"}, {"I20"}, {"M23", "D4"}}, {0.2}}});
  const double span = 0.5 + 0.02 + 0.08, r = 0.01, i = 2.0, eta = 0.95 * 0.9;
  const double m = 6.0 + 0.02 * (2.0 * span + pi / 2.0 * 0.04), speed = 0.4 / 0.8, ramp = speed / 0.2;
  const double friction = 1.0 + 0.02 * m * g, force = m * ramp + friction + 5.0, pulleys = 30e-7;
  const double torque = force * r / (i * eta) + (280e-7 + 4e-6 + pulleys / 4.0 / 0.9) * ramp / r * i;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_motor(speed / r * i), 0.7);
  expect(d, "drive", "C-ST-80", (friction + 5.0) * r / (i * eta), 0.8 * 1.2);
  expect(d, "drive", "C-ST-INERTIA", (4e-6 + (pulleys + m * r * r) / 4.0) * 1e4, 10.0 * 280e-7 * 1e4);
  expect(d, "drive", "C-ST-HOLD", 5.0 * r * eta / i, 0.5 * 1.2 / std::sqrt(2.0));
  // 100 rad/s of 3200 pulses a turn.
  expect(d, "drive", "C-ST-STEPRATE", 100.0 / (2.0 * pi) * 3.2, 24.0);
  // Pulses: 24 kHz are 7.5 turns a second, 450 rpm, less than the reduction bears: 225 rpm of the pulley.
  expect(d, "drive", "C-SYS-SPEED", 500.0, 225.0 / 60.0 * 2.0 * pi * r * 1e3);
  expect(d, "drive", "C-RD-TORQUE", 1.25 * (force * r / 0.95 + pulleys * ramp / r), 0.5);
  expect(d, "drive", "C-RD-SPEED", 100.0 / (2.0 * pi) * 60.0, 800.0);
  // The shaft of the reduction carries the pulley.
  expect(d, "drive", "F-PULLEY-BORE", 6.35, 6.35);
  expect_none(d, "drive", "C-ST-RADIAL");
  const double stiffness = 4.0 * 60000.0 / (2.0 * span), play = 0.1 * pi / 180.0;
  const double reversal = 2.0 * friction / stiffness + (play + 2.0 * friction * r / 0.95 / 100.0) * r;
  const double lagging = r / i * std::asin(friction * r / (i * eta) / (1.2 / std::sqrt(2.0))) / 50.0;
  expect(d, "drive", "C-ACC-LOST", (reversal + 2.0 * lagging) * 1e6, 100.0);
  const double windup = (friction + 5.0) * r / 0.95 / 100.0 * r, step = 2.0 * pi * r / i / 200.0;
  const double lag = r / i * std::asin((friction + 5.0) * r / (i * eta) / (1.2 / std::sqrt(2.0))) / 50.0;
  expect(d,
         "drive",
         "C-ACC-TOTAL",
         (2e-4 * 0.5 + 5.0 / stiffness + reversal + windup + lag + std::hypot(0.05 * step, 0.5 * step / 16.0)) * 1e6,
         500.0);
  expect(d, "drive", "C-ACC-RES", step / 16.0 * 1e6, 250.0);
  CHECK(d.cost == Approx(5.0 * (2.0 * span + pi / 2.0 * 0.04) + 4.0 + 3.0 + 16.0 + 20.0 + 15.0 + 30.0));
}

// The speed of the reduction limits the axis where it is less than the pulse rate allows.
TEST_CASE("The slowest part limits the speed of an axis, its reduction too") {
  const MachineModel model(
      problem_of_text(screw_axis("screw = [\"lead_screws\"], reduction = { ratio = 2, speed = \"1000 rpm\" }")),
      parts());
  const Design d = design_of(model, {{"x", "drive", {{"Tr16x4", "Tr16x4 nut"}, {"M23", "D4"}, {"F6"}, {"S6"}}, {0.2}}});
  expect(d, "drive", "C-SYS-SPEED", 30.0, 500.0 / 60.0 * 4.0);
}

// Nut, motor and reduction ride; the screw stands and turns nothing.
TEST_CASE("A nut that turns worked by hand, and what carries its axis") {
  const MachineModel model(
      problem_of_text(
          screw_axis("screw = [\"ball_screws\"], rotating = \"nut\", nut_inertia = \"4 kg.cm2\", reduction = { "
                     "ratio = 2, efficiency = 0.9, inertia = \"3e-6 kg.m2\", mass = \"0.4 kg\" }") +
          R"([[axis]]
name = "y"
carries = ["x"]
stroke = "500 mm"
structure_mass = "2 kg"
acceleration_time = "0.2 s"
mechanism = { kind = "belt", idler_distance = "80 mm" }
[[axis.moves]]
distance = "400 mm"
time = "1 s"
)"),
      parts());
  const Design d = design_of(model,
                             {{"x", "drive", {{"B16x5"}, {"M23", "D4"}, {"F6"}, {"S6"}}, {0.2}},
                              {"y", "drive", {{"GT3-9"}, {"G20-6.35"}, {"I20"}, {"M23", "D4"}}, {}}});
  const double lead = 0.005, i = 2.0, eta_g = 0.9, supported = 0.46, cut = 0.54;
  const double riding = 0.25 + 0.7 + 0.4, m = 20.0 + riding;
  const double friction = 4.0 + 0.05 * m * g, steady = friction + 50.0, force = m * a + steady;
  const double slope = lead / (pi * 0.0165), eta = (1.0 - 0.005 * slope) / (1.0 + 0.005 / slope);
  const double per_newton = lead / (2.0 * pi * eta), omega = 2.0 * pi * v / lead, alpha = 2.0 * pi * a / lead;
  const double torque = force * per_newton / (i * eta_g) + (280e-7 + 3e-6 + 4e-4 / 4.0 / eta_g) * alpha * i;
  expect(d, "drive", "C-ST-TORQUE", torque / torque_of_motor(i * omega), 0.7, "x");
  expect(d,
         "drive",
         "C-ST-INERTIA",
         (3e-6 + (4e-4 + m * std::pow(lead / (2.0 * pi), 2)) / 4.0) * 1e4,
         10.0 * 280e-7 * 1e4,
         "x");
  expect(d, "drive", "F-NUT-RIDING-MASS", riding, 5.0);
  // The balls run as fast as if the screw turned: 360 rpm on 16 mm.
  expect(d, "drive", "C-BS-DN", 16.0 * 360.0, 70000.0);
  for (const char* id : {"C-BS-NCRIT", "F-SUPPORT-SPEED", "F-NUT-MASS", "C-CP-TORQUE", "F-COUPLING-MOTOR"})
    expect_none(d, "drive", id);
  // Pulses: 30 turns of the motor a second, 15 of the nut; no bearing and no bending of the screw limits it.
  expect(d, "drive", "C-SYS-SPEED", 30.0, 75.0);
  // The clamped end holds the nut's torque through the screw.
  const double core = supported / (steel * pi * std::pow(0.013, 4) / 32.0);
  expect(d, "drive", "C-CP-WINDUP", steady * per_newton * core * lead / (2.0 * pi) * 1e6, 300.0);
  CHECK(value_of(d, "C-SCR-TWIST") == Approx(force * per_newton * core * 180.0 / pi));

  // y moves all of x: structure, what rides on it and its standing screw and supports, but not the driver.
  const double belt = 0.02 * (2.0 * 0.6 + pi / 2.0 * 0.04);
  const double all = 2.0 + belt + m + 1.3 * cut + 0.2 + 0.1;
  expect(d, "drive", "C-ST-INERTIA", (30e-7 + all * 1e-4) * 1e4, 10.0 * 280e-7 * 1e4, "y");
}

TEST_CASE("Two nuts that turn: the drive looked at moves its share of both motors") {
  const MachineModel model(problem_of_text(screw_axis("screw = [\"ball_screws\"], rotating = \"nut\", nut_inertia = "
                                                      "\"4 kg.cm2\", drives = 2, load_share = 0.6")),
                           parts());
  const Design d = design_of(model, {{"x", "drive", {{"B16x5"}, {"M23", "D4"}, {"F6"}, {"S6"}}, {0.2}}});
  // A nut each, as with screws that turn; 60 % of the load and of both motors.
  const double m = 0.6 * 20.0 + 0.25 + 0.6 * 2.0 * 0.7;
  expect(d, "drive", "C-ST-INERTIA", (4e-4 + m * std::pow(0.005 / (2.0 * pi), 2)) * 1e4, 10.0 * 280e-7 * 1e4);
  expect(d, "drive", "F-NUT-RIDING-MASS", 0.25 + 0.7, 5.0);
}

TEST_CASE("A guide is sized for the motor that rides with a nut that turns") {
  const auto load = [](const std::string& mechanism) {
    const MachineModel model(
        problem_of_text(screw_axis(
            "screw = [\"ball_screws\"]" + mechanism,
            "guide = { rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\" }")),
        parts());
    return value_of(design_of(model, {{"x", "guide", {{"R12"}}, {}}}), "C-GD-STATIC");
  };
  // Each carriage bears a quarter of 20 kg, four carriages of 0.05 kg and the allowance; static safety 2.
  CHECK(load("") == Approx(2.0 * (20.2 + 0.5) * g / 4.0));
  CHECK(load(", rotating = \"nut\", nut_inertia = \"4 kg.cm2\"") == Approx(2.0 * (20.2 + 5.0) * g / 4.0));
}

}  // namespace hand_worked_reduction_test
