// SPDX-License-Identifier: Apache-2.0
// Stiffness, accuracy shares, wear, preload, start, heat and currents of drives worked by hand, on the figures of
// tiny_catalogue.h. The right-hand sides use <cmath> and nothing of the project.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "catch.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"

namespace hand_worked_drive_test {

using namespace millwright;
using evaluation::Check;
using evaluation::Design;
using evaluation::Verdict;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double g = 9.80665;

const catalogue::Catalogue& parts() {
  static const TinyCatalogue tiny;
  return tiny.parts();
}

struct Setup {
  std::string direction = "horizontal", mechanism = {}, motor = "microsteps = 8", require = {};
};

machine::Problem one_axis(const Setup& s) {
  return problem_of_text(fmt::format(R"(
title = "one axis"
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
direction = "{}"
stroke = "400 mm"
structure_mass = "20 kg"
guide_friction = 0.05
guide_drag = "4 N"
acceleration_time = ["0.1 s", "0.4 s"]
mechanism = {{ kind = "screw", {} }}
motor = {{ {} }}
[[axis.moves]]
distance = "300 mm"
time = "10.2 s"
force = "50 N"
dwell = "2 s"
[axis.require]
{}
)",
                                     s.direction,
                                     s.mechanism,
                                     s.motor,
                                     s.require));
}

using Parts = std::vector<std::pair<std::string, std::string>>;  ///< slot, part number

Design worked(const machine::Problem& problem, const Parts& chosen, const char* supply, double acceleration_time) {
  machine::BillOfMaterials bom;
  const auto line = [&](const std::string& axis, const std::string& slot) -> machine::BomLine& {
    machine::BomLine& added = bom.lines.emplace_back();
    added.axis = axis;
    added.slot = slot;
    return added;
  };
  for (const auto& [slot, number] : chosen) line("x", slot).part_number = number;
  line("machine", "supply").part_number = supply;
  line("x", "acceleration_time").value = acceleration_time;
  const auto result = evaluation::check(problem, parts(), bom, false, {});
  for (const auto& p : result.problems) UNSCOPED_INFO(p.message << " / " << p.hint);
  REQUIRE(result.problems.empty());
  return result.design;
}

const Check* find(const Design& design, const std::string& id) {
  for (const Check& c : design.checks)
    if (c.id == id) return &c;
  return nullptr;
}

/// Value and limit, both in the unit of the check.
void expect(const Design& design, const std::string& id, double value, double limit) {
  const Check* c = find(design, id);
  INFO(id);
  REQUIRE(c != nullptr);
  CHECK(c->value == Approx(value).epsilon(1e-9));
  CHECK(c->limit == Approx(limit).epsilon(1e-9));
  CHECK((c->verdict == Verdict::satisfied) == (value <= limit));
}

const Parts lead_screw_parts{{"screw", "Tr16x4"},
                             {"nut", "Tr16x4 nut"},
                             {"motor", "M23"},
                             {"driver", "D4"},
                             {"coupling", "K8"},
                             {"support_fixed", "F6"},
                             {"support_free", "S6"}};
const char* const lead_screw = R"(screw = ["lead_screws"], ends = "fixed-supported")";

Parts ball_screw_parts(const char* free_end) {
  return {{"screw", "B16x5"},
          {"nut", "B16x5"},
          {"motor", "M23"},
          {"driver", "D4"},
          {"coupling", "K8"},
          {"support_fixed", "F6"},
          {"support_free", free_end}};
}

}  // namespace

TEST_CASE("What a lead screw drive is reported for, worked by hand") {
  const std::string require = R"(position_error = { limit = "0.2 mm", over = "300 mm" }
efficiency = 0.3
axial_stiffness = "20 N/um"
output_power_factor = 1.0
)";
  const Design d = worked(one_axis({.mechanism = lead_screw, .require = require}), lead_screw_parts, "P36-350", 0.2);

  // As in hand_worked_screw_test: 0.03 m/s, 0.15 m/s^2; mass with the nut; mu_e = 0.1/cos 15 deg.
  const double v = 0.03, a = 0.15, lead = 0.004, m = 20.25;
  const double supported = 0.4 + 0.02 + 0.032, cut = supported + 0.08;
  const double friction = 4.0 + 0.05 * m * g, steady = friction + 50.0, force = m * a + steady;
  const double lambda = std::atan(lead / (pi * 0.014)), friction_angle = std::atan(0.1 / std::cos(15.0 * pi / 180.0));
  const double efficiency = std::tan(lambda) / std::tan(lambda + friction_angle);
  const double per_newton = lead / (2.0 * pi * efficiency);

  // Core: force/(pi d^2/4) = 400 MPa/4.
  expect(d, "C-SCR-DC", std::sqrt(force / 100.0 / (pi / 4.0)), 11.5);
  expect(d, "C-SCR-EFF", 0.3, efficiency);
  expect(d, "C-SCR-NTURNS", 32.0 / 4.0, 10.0);

  // Wear: the nut's thread, 2 mm + 2 mm tan 15 deg thick at its root, may lose a quarter; greased bronze 1e-15 m^2/N.
  // Mean force over the 300 mm: 3 mm accelerating, 294 mm, 3 mm braking; on 8 turns of 2 mm depth. The thread slides
  // hypot(pi d_m, l) per lead.
  const double mean = (force * 0.003 + steady * 0.294 + (steady - m * a) * 0.003) / 0.3;
  const double pressure = mean / (pi * 0.014 * 0.002 * 8.0);
  const double thickness = 0.002 + 0.002 * std::tan(15.0 * pi / 180.0);
  const double slide = 0.25 * thickness * std::cos(15.0 * pi / 180.0) / (1e-15 * pressure);
  expect(d, "C-SCR-WEAR", 10000.0 * 3600.0 / 12.2 * 0.3e-3, slide * lead / std::hypot(pi * 0.014, lead) * 1e-3);

  // 50 um in 300 mm, and 12 um/(m K) * 5 K * 0.3 m, each of the 200 um.
  expect(d, "C-BS-LEAD", 50.0, 200.0);
  expect(d, "C-ACC-THERM", 18.0, 200.0);
  // Shaft and fixed bearing in a row; nobody states the stiffness of a lead nut.
  const double shaft = 206e9 * pi / 4.0 * 0.0115 * 0.0115 / supported;
  expect(d, "C-BS-STIFF", 20.0, 1e-6 / (1.0 / shaft + 1.0 / 40e6));
  // Twist of screw and coupling (60 N.m/rad) under the load torque, over a lead of 4 mm a turn.
  const double load_torque = steady * per_newton;
  const double screw_torsion = 79.2e9 * pi / 32.0 * std::pow(0.0115, 4) / supported;
  const double torsion = 1.0 / (1.0 / 60.0 + 1.0 / screw_torsion);
  expect(d, "C-CP-WINDUP", load_torque / torsion * lead / (2.0 * pi) * 1e6, 200.0);

  // Static torque 1.2/sqrt(2) N.m, 50 teeth: f_n of all inertia; the drive line twice as high.
  const double static_torque = 1.2 / std::sqrt(2.0), rotor = 280e-7;
  const double load_inertia =
      10e-7 + pi / 32.0 * 7850.0 * std::pow(0.014, 4) * cut + m * std::pow(lead / (2.0 * pi), 2);
  const double resonance = std::sqrt(50.0 * static_torque / (rotor + load_inertia)) / (2.0 * pi);
  expect(d, "C-CP-RES", 2.0 * resonance, std::sqrt(torsion * (1.0 / rotor + 1.0 / load_inertia)) / (2.0 * pi));
  expect(d, "C-CP-MISAL", 0.1, 0.2);
  expect(d, "C-CP-MISAL-ANGULAR", 0.5, 1.0);
  expect(d, "C-CP-MISAL-AXIAL", 0.1, 0.3);

  // The first full step, 1.8 degrees, from rest takes sqrt(2 theta/alpha).
  const double alpha = a * 2.0 * pi / lead;
  const double first = 1.0 / std::sqrt(2.0 * (pi / 100.0) / alpha);
  const double lag = std::asin(load_torque / static_torque);
  const double barrier = (2.0 * static_torque * std::cos(lag) - load_torque * (pi - 2.0 * lag)) / 50.0;
  const double jump = std::sqrt(2.0 * barrier / (rotor + load_inertia));
  expect(d, "C-ST-START", first / 200.0 * 60.0, 0.5 * jump * 30.0 / pi);

  // Heat: 2.8 A amplitude in 0.9 ohm, 31.44 % more at 100 degrees; rated for 80 K at 2.8 A direct in both windings.
  // Iron: 9.8 s at 47.1 rad/s and two ramps of 0.2 s from rest to it, evenly, in 12.2 s.
  const double omega = v / lead * 2.0 * pi;
  const auto iron = [](double w) { return 1.2 * (0.03 + 0.0005 * w) * w; };
  const double of_ramp = 1.2 * (0.03 * omega / 2.0 + 0.0005 * omega * omega / 3.0);
  const double watts = 2.8 * 2.8 * 0.9 * 1.3144 + (0.4 * of_ramp + 9.8 * iron(omega)) / 12.2;
  expect(d, "C-ST-TEMP", watts * 80.0 / (2.0 * 2.8 * 2.8 * 0.9 * 1.3144), 60.0);
  // Shaft power while accelerating, at the end of the ramp, against I^2 R of one winding.
  const double rotating = rotor + load_inertia - m * std::pow(lead / (2.0 * pi), 2);
  expect(d, "C-ST-POWER", (force * per_newton + rotating * alpha) * omega, 2.8 * 2.8 * 0.9);
  expect(d, "C-ACC-MICRO", friction * per_newton, static_torque * std::sin(pi / 16.0));
  expect(d, "C-DR-CURRENT", 2.8, 4.2);
  expect(d, "C-DR-MOTORI", 1.0, std::sqrt(2.0));
  expect(d, "C-PSU-CURRENT", 2.8 * 2.0 / 3.0, 9.7);
  CHECK(find(d, "C-ST-RES") == nullptr);     // eighth steps
  CHECK(find(d, "C-BS-PREMAX") == nullptr);  // a lead nut
}

TEST_CASE("What a screw and its coupling bear at rest, worked by hand, and the phases that are named") {
  machine::Problem problem = one_axis({.mechanism = lead_screw});
  machine::Move& held = problem.axes[0].moves.emplace_back();
  held.name = "held";
  held.profile = machine::measured_profile(std::vector{0.0, 0.2, 1.0, 1.2, 1.3, 3.0},
                                           std::vector{0.0, 0.01, 0.01, 0.0, 0.0, 0.0},
                                           std::vector{0.0, 0.0, 0.0, 0.0, -400.0, 400.0});
  const Design d = worked(problem, lead_screw_parts, "P36-350", 0.2);
  const auto check = [&](const std::string& id) {
    const Check* c = find(d, id);
    INFO(id);
    REQUIRE(c != nullptr);
    return *c;
  };
  // 400 N and friction; the torque that this asks of the screw goes through the coupling whole, twice for shocks. While
  // it moves 50 N, friction and 0.15 m/s2.
  const double m = 20.25, friction = 4.0 + 0.05 * m * g, force = friction + 400.0;
  const double moving = friction + 50.0 + m * 0.15;
  const double lambda = std::atan(0.004 / (pi * 0.014)), angle = std::atan(0.1 / std::cos(15.0 * pi / 180.0));
  const double torque = force * 0.004 / (2.0 * pi) * std::tan(lambda + angle) / std::tan(lambda);
  CHECK(check("C-SCR-BUCK").value == Approx(force).epsilon(1e-9));
  CHECK(check("C-SCR-BUCK").phase == "standstill");
  CHECK(check("C-CP-TORQUE").value == Approx(2.0 * torque).epsilon(1e-9));
  CHECK(check("C-CP-TORQUE").phase == "standstill");
  const double area = pi * 0.014 * 0.002 * 8.0, sliding = 0.03 / 0.004 * std::hypot(pi * 0.014, 0.004);
  CHECK(check("C-SCR-PB").value == Approx(force / area * 1e-6).epsilon(1e-9));
  CHECK(check("C-SCR-PV").value == Approx(moving / area * 1e-6 * sliding).epsilon(1e-9));
  CHECK(check("C-SCR-PV").phase == "move 1, accelerate");
  CHECK(check("C-ST-TORQUE").phase == "move 1, accelerate");
  // The thread locks itself: the motor holds nothing of the 400 N, so that longer at rest is cooler.
  held.dwell = 5.0;
  const Design longer = worked(problem, lead_screw_parts, "P36-350", 0.2);
  REQUIRE(find(longer, "C-ST-RMS") != nullptr);
  const double cycle = 10.2 + 2.0 + 3.0;
  CHECK(find(longer, "C-ST-RMS")->value * std::sqrt((cycle + 5.0) / cycle) ==
        Approx(check("C-ST-RMS").value).epsilon(1e-9));
}

TEST_CASE("What a problem does not ask for is not checked") {
  const Design d = worked(one_axis({.mechanism = lead_screw}), lead_screw_parts, "P36-350", 0.2);
  for (const char* id : {"C-SCR-EFF", "C-BS-LEAD", "C-BS-STIFF", "C-CP-WINDUP", "C-ACC-THERM", "C-ST-POWER"}) {
    INFO(id);
    CHECK(find(d, id) == nullptr);
  }
}

TEST_CASE("A coupling without stated misalignments, and a nut of unknown wear, are not evaluated") {
  Parts chosen = lead_screw_parts;
  chosen[4].second = "K12";
  // A bronze nut that runs dry has no usual wear rate.
  const Design d =
      worked(one_axis({.mechanism = std::string(lead_screw) + ", greased = false"}), chosen, "P36-350", 0.2);
  for (const char* id : {"C-CP-MISAL", "C-CP-MISAL-ANGULAR", "C-CP-MISAL-AXIAL", "C-SCR-WEAR"}) {
    INFO(id);
    REQUIRE(find(d, id) != nullptr);
    CHECK(find(d, id)->verdict == Verdict::not_evaluated);
    CHECK(find(d, id)->kind == machine::ConstraintKind::soft);
  }
  // The problem may know better.
  const Design told = worked(one_axis({.mechanism = std::string(lead_screw) + ", greased = false",
                                       .require = "nut_wear_rate = \"1e-12 m2/N\""}),
                             chosen,
                             "P36-350",
                             0.2);
  REQUIRE(find(told, "C-SCR-WEAR") != nullptr);
  CHECK(find(told, "C-SCR-WEAR")->verdict == Verdict::violated);
}

TEST_CASE("More turns than share the load carry no more of it") {
  const Design d = worked(
      one_axis({.mechanism = lead_screw, .require = "load_sharing_turns = 5"}), lead_screw_parts, "P36-350", 0.2);
  expect(d, "C-SCR-NTURNS", 8.0, 5.0);
  const double force = 20.25 * 0.15 + 4.0 + 0.05 * 20.25 * g + 50.0;
  expect(d, "C-SCR-PB", force / (pi * 14.0 * 2.0 * 5.0), 10.0);
}

TEST_CASE("Full steps near the motor's resonance are reported") {
  const Design d =
      worked(one_axis({.mechanism = lead_screw, .motor = "microsteps = 1"}), lead_screw_parts, "P36-350", 0.2);
  // 7.5 rev/s of 200 steps.
  const double cut = 0.532, lead = 0.004, m = 20.25;
  const double inertia =
      280e-7 + 10e-7 + pi / 32.0 * 7850.0 * std::pow(0.014, 4) * cut + m * std::pow(lead / (2.0 * pi), 2);
  const double resonance = std::sqrt(50.0 * 1.2 / std::sqrt(2.0) / inertia) / (2.0 * pi);
  expect(d, "C-ST-RES", std::log(1.3), std::abs(std::log(1500.0 / resonance)));
}

TEST_CASE("A motor asked for more current than its driver gives and it stands") {
  // 1.6 times 2.8 A are 4.48 A; the driver gives 4.2 A, half as much again as the rated current: more than sqrt(2).
  const Design d =
      worked(one_axis({.mechanism = lead_screw, .require = "current_factor = 1.6"}), lead_screw_parts, "P36-350", 0.2);
  expect(d, "C-DR-CURRENT", 4.48, 4.2);
  expect(d, "C-DR-MOTORI", 1.5, std::sqrt(2.0));
  CHECK(find(d, "C-DR-CURRENT")->kind == machine::ConstraintKind::soft);
  CHECK(find(d, "C-DR-MOTORI")->kind == machine::ConstraintKind::hard);
  CHECK_FALSE(d.satisfied());
  // A weak driver alone is no fault: the motor runs with less current and torque.
  Parts weak = lead_screw_parts;
  weak[3].second = "D2";
  const Design less = worked(one_axis({.mechanism = lead_screw}), weak, "P24-350", 0.2);
  expect(less, "C-DR-CURRENT", 2.8, 2.0);
  expect(less, "C-DR-MOTORI", 2.0 / 2.8, std::sqrt(2.0));
  CHECK(find(less, "C-ST-HOLD")->limit == Approx(0.5 * 1.2 / std::sqrt(2.0) * 2.0 / 2.8));
}

TEST_CASE("A preloaded ball screw held at both ends, worked by hand") {
  const char* const mechanism = R"(screw = ["ball_screws"], ends = "fixed-fixed", preload = 0.05)";
  const Design d =
      worked(one_axis({.direction = "vertical", .mechanism = mechanism, .require = "axial_stiffness = \"30 N/um\""}),
             ball_screw_parts("F10"),
             "P24-350",
             0.2);
  const double m = 20.25, weight = m * g, force = m * 0.15 + weight + 4.0 + 50.0, lead = 0.005;
  expect(d, "C-BS-PREMIN", force / std::pow(2.0, 1.5), 400.0);
  expect(d, "C-BS-PREMAX", 0.05, 0.1);
  // Both raceways roll: the force adds to the one and takes from the other, until that lifts off at 2^1.5 of the
  // preload, 1131 N. Up and down over 0.3 m, once in 24.4 s.
  double loaded = 0.0, unloaded = 0.0;
  for (const double direction : {1.0, -1.0})
    for (const auto& [acceleration, travel] :
         {std::pair{0.15, 0.003}, std::pair{0.0, 0.294}, std::pair{-0.15, 0.003}}) {
      const double f = std::abs(m * acceleration + direction * weight + 4.0 + 50.0);
      const double inner = 400.0 * std::pow(1.0 + f / (400.0 * std::pow(2.0, 1.5)), 1.5);
      loaded += std::pow(inner, 3) * travel;
      unloaded += std::pow(inner - f, 3) * travel;
    }
  const auto life = [](double cubes) { return 1e6 * std::pow(8000.0 / 1.2, 3) / (cubes / 0.6); };
  const double turns = std::pow(std::pow(life(loaded), -10.0 / 9.0) + std::pow(life(unloaded), -10.0 / 9.0), -0.9);
  CHECK(turns < 0.9 * life(loaded));
  REQUIRE(find(d, "C-BS-LIFE") != nullptr);
  CHECK(find(d, "C-BS-LIFE")->limit == Approx(turns / (0.6 / lead / 24.4) / 3600.0).epsilon(1e-9));
  // Softest where both sides give way alike: a quarter of the compliance of bearing, shaft and bearing in a row. 200
  // N/um of the nut hold at 10 % preload; 0.8 for its body, and stiffness grows with the cube root.
  const double shaft = 206e9 * pi / 4.0 * 0.013 * 0.013 / 0.46;
  const double sides = 0.25 * (1.0 / shaft + 1.0 / 40e6 + 1.0 / 90e6), nut = 0.8 * 200e6 * std::cbrt(0.5);
  expect(d, "C-BS-STIFF", 30.0, 1e-6 / (sides + 1.0 / nut));
  // Every other place is stiffer: bearing and shaft on each side of the nut, side by side.
  for (double x = 0.0; x <= 0.46; x += 0.02) {
    const double left = 1.0 / 40e6 + x / 0.46 / shaft, right = 1.0 / 90e6 + (0.46 - x) / 0.46 / shaft;
    CHECK(1.0 / (1.0 / left + 1.0 / right) <= sides * (1.0 + 1e-12));
  }
  // Friction: drag through the screw, the preload's drag, and what the weight costs more up than it gives back down.
  const double lambda = std::atan(lead / (pi * 0.0165)), slope = std::tan(lambda);
  const double eta = (1.0 - 0.005 * slope) / (1.0 + 0.005 / slope),
               back = (1.0 - 0.005 / slope) / (1.0 + 0.005 * slope);
  const double drag = 0.05 / std::sqrt(slope) * 400.0 * lead / (2.0 * pi);
  expect(d,
         "C-ACC-MICRO",
         4.0 * lead / (2.0 * pi * eta) + drag + 0.5 * weight * lead / (2.0 * pi) * (1.0 / eta - back),
         1.2 / std::sqrt(2.0) * std::sin(pi / 16.0));
}

// tan 5.2 deg of lead over the friction is 0.88 here: the thread locks itself, but not with the factor of 1.3.
TEST_CASE("A brake that holds stands for self-locking, one that does not hold is none") {
  const auto with = [](const std::string& brake, const std::string& require = {}) {
    return worked(
        one_axis(
            {.direction = "vertical", .mechanism = lead_screw, .motor = "microsteps = 8" + brake, .require = require}),
        lead_screw_parts,
        "P36-350",
        0.2);
  };
  const double m = 20.25, weight = m * g, drag = 4.0, lead = 0.004;
  const double slope = lead / (pi * 0.014), friction = 0.1 / std::cos(15.0 * pi / 180.0);
  const double limit = 1.0 / 1.3;
  expect(with(""), "C-SCR-LOCK", slope / friction, limit);
  // With a friction that is less by that factor: tan(lambda - phi) of what comes through.
  const double through =
      (weight - drag) * lead / (2.0 * pi) * std::tan(std::atan(slope) - std::atan(friction / 1.3)) / slope;
  CHECK(through > 0.0);
  expect(with(", brake_torque = \"1e-9 N.m\""), "C-SCR-LOCK", slope / friction, limit);
  expect(with(", brake_torque = \"0.1 N.m\""), "C-SCR-LOCK", through / 0.1 / 1.3, limit);
  expect(with(fmt::format(", brake_torque = \"{} N.m\"", 1.01 * through)), "C-SCR-LOCK", 1.0 / 1.01 / 1.3, limit);
  CHECK(find(with(fmt::format(", brake_torque = \"{} N.m\"", 0.99 * through)), "C-SCR-LOCK")->verdict ==
        Verdict::violated);
  CHECK(find(with(", brake_torque = \"0.1 N.m\""), "C-SCR-LOCK")->requirement == "self_locking_factor");
  // A factor of 1.05 it keeps by itself, whatever the brake.
  expect(
      with(", brake_torque = \"1e-9 N.m\"", "self_locking_factor = 1.05"), "C-SCR-LOCK", slope / friction, 1.0 / 1.05);
  // Nor is it one where a counterbalance happens to hold the load.
  for (const double brake : {0.0, 1e-9, 0.01}) {
    CAPTURE(brake);
    machine::Problem balanced = one_axis({.direction = "vertical", .mechanism = lead_screw});
    balanced.axes[0].counterbalance_force = weight;
    balanced.axes[0].motor.brake_torque = brake;
    const double value = brake < 1e-3 ? slope / friction : 1e-3 / brake / 1.3;
    expect(worked(balanced, lead_screw_parts, "P36-350", 0.2), "C-SCR-LOCK", value, limit);
  }
  // Of a thread that runs down anyway 1.5 times the torque is more than what a more slippery one lets through.
  const double runs = 0.05 / std::cos(15.0 * pi / 180.0);
  const double torque =
      1.5 * (weight - drag) * lead / (2.0 * pi) * std::tan(std::atan(slope) - std::atan(runs)) / slope;
  const Design braked = worked(one_axis({.direction = "vertical",
                                         .mechanism = std::string(lead_screw) + ", thread_friction = 0.05",
                                         .motor = "microsteps = 8, brake_torque = \"0.2 N.m\""}),
                               lead_screw_parts,
                               "P36-350",
                               0.2);
  expect(braked, "C-SCR-LOCK", torque / 0.2 / 1.3, limit);
  CHECK(find(braked, "C-SCR-LOCK")->requirement == "brake_factor");
}

TEST_CASE("The nut without preload, and a preload that is too high") {
  const Design loose = worked(one_axis({.mechanism = R"(screw = ["ball_screws"], ends = "fixed-supported")",
                                        .require = "axial_stiffness = \"30 N/um\""}),
                              ball_screw_parts("S6"),
                              "P24-350",
                              0.2);
  // The catalogue's 200 N/um hold at 30 % of 8000 N; the move presses with 50 N.
  const double force = 50.0;
  const double shaft = 206e9 * pi / 4.0 * 0.013 * 0.013 / 0.46;
  const double nut = 0.8 * 200e6 * std::cbrt(force / 2400.0);
  expect(loose, "C-BS-STIFF", 30.0, 1e-6 / (1.0 / shaft + 1.0 / 40e6 + 1.0 / nut));
  // A move that presses more does not stiffen it, nor does a harder ramp: the least with which one presses counts. Drag
  // and friction are always there.
  const auto stiffness_with = [](std::initializer_list<double> forces, double ramp) {
    machine::Problem problem = one_axis({.mechanism = R"(screw = ["ball_screws"], ends = "fixed-supported")",
                                         .require = "axial_stiffness = \"30 N/um\""});
    std::vector<machine::Move>& moves = problem.axes[0].moves;
    moves.resize(forces.size(), moves.front());
    std::size_t i = 0;
    for (const double each : forces) moves[i++].force = each;
    const Design design = worked(problem, ball_screw_parts("S6"), "P24-350", ramp);
    return find(design, "C-BS-STIFF")->limit;
  };
  const auto under = [&](double newton) {
    return 1e-6 / (1.0 / shaft + 1.0 / 40e6 + 1.0 / (0.8 * 200e6 * std::cbrt(newton / 2400.0)));
  };
  CHECK(stiffness_with({50.0, 150.0, 0.0}, 0.2) == Approx(under(50.0)).epsilon(1e-9));
  CHECK(stiffness_with({150.0, -20.0}, 0.1) == Approx(under(20.0)).epsilon(1e-9));
  for (const double little : {0.0, 0.5, 13.0})
    CHECK(stiffness_with({little}, 0.2) == Approx(under(4.0 + 0.05 * 20.25 * g)).epsilon(1e-9));
  CHECK_FALSE(loose.satisfied());
  CHECK(find(loose, "C-BS-PREMIN") == nullptr);
  CHECK(find(loose, "C-BS-PREMAX") == nullptr);
  const Design tight =
      worked(one_axis({.mechanism = R"(screw = ["ball_screws"], ends = "fixed-supported", preload = 0.12)"}),
             ball_screw_parts("S6"),
             "P24-350",
             0.2);
  expect(tight, "C-BS-PREMAX", 0.12, 0.1);
  CHECK_FALSE(tight.satisfied());
}

namespace {
constexpr const char* belt_axis = R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "500 mm"
structure_mass = "2 kg"
guide_friction = 0.02
guide_drag = "1 N"
acceleration_time = ["0.2 s", "0.3 s"]
mechanism = { kind = "belt", idler_distance = "80 mm" }
motor = { microsteps = 16 }
[[axis.moves]]
distance = "400 mm"
time = "1 s"
force = "5 N"
dwell = "0.5 s"
[axis.require]
position_error = "0.5 mm"
motor_radial_load = "15 N"
start_rate = "400 Hz"
)";
const Parts belt_parts = {
    {"belt", "GT3-9"}, {"pulley_drive", "G20-5"}, {"pulley_idle", "I20"}, {"motor", "M17"}, {"driver", "D2"}};
}  // namespace

TEST_CASE("What a belt drive is reported for, worked by hand") {
  const machine::Problem problem = problem_of_text(belt_axis);
  const Design d = worked(problem, belt_parts, "P24-100", 0.2);
  // As in hand_worked_elements_test.
  const double span = 0.6, r = 0.01, m = 2.0 + 0.02 * (2.0 * span + pi / 2.0 * 0.04), v = 0.5, a = 2.5;
  const double friction = 1.0 + 0.02 * m * g, force = m * a + friction + 5.0, turning = 0.02 * v * v;
  // 1.4 (F + m v^2) on 180 N per 9 mm, ten teeth in mesh.
  expect(d, "C-BT-WIDTH", 1.4 * (force + turning) / (180.0 / 9.0), 9.0);
  const double stiffness = 4.0 * 60000.0 / (2.0 * span);
  expect(d, "C-BT-STIFF", (friction + 5.0) / stiffness * 1e6, 500.0);
  expect(d, "C-BT-FREQ", 20.0, std::sqrt(stiffness / m) / (2.0 * pi));
  // Both strands pull one way on equal pulleys; next to the drive pulley one of them bears all of the force as well.
  expect(d, "C-ST-RADIAL", 2.0 * (1.1 * force + turning) + force, 15.0);
  CHECK_FALSE(d.satisfied());
  // The ramp begins at 400 of 3200 pulses a turn; the mean speed over the first full step of 1.8 degrees.
  const double from = 400.0 / 3200.0 * 2.0 * pi, alpha = a / r;
  const double to = std::sqrt(from * from + 2.0 * alpha * pi / 100.0);
  const double static_torque = 0.5 / std::sqrt(2.0), load = (friction + 5.0) * r / 0.95;
  const double inertia = 60e-7 + 30e-7 + m * r * r;
  const double lag = std::asin(load / static_torque);
  const double barrier = (2.0 * static_torque * std::cos(lag) - load * (pi - 2.0 * lag)) / 50.0;
  expect(d, "C-ST-START", (from + to) / 2.0 * 30.0 / pi, 0.5 * std::sqrt(2.0 * barrier / inertia) * 30.0 / pi);
  expect(d, "C-ACC-MICRO", friction * r / 0.95, static_torque * std::sin(pi / 32.0));
  expect(d, "C-DR-CURRENT", 2.0, 2.0);
  expect(d, "C-PSU-CURRENT", 2.0 * 2.0 / 3.0, 4.2);
}

TEST_CASE("What a motor holds at rest counts in its RMS torque, worked by hand") {
  machine::Problem problem = problem_of_text(belt_axis);
  machine::Move& move = problem.axes[0].moves[0];
  move = {};
  move.name = "pressed";
  move.profile = machine::measured_profile(
      std::vector{0.0, 0.2, 0.8, 1.0, 2.0}, std::vector{0.0, 0.5, 0.5, 0.0, 0.0}, std::vector(5, 6.0));
  move.dwell = 0.5;
  const Design d = worked(problem, belt_parts, "P24-100", 0.2);
  const double r = 0.01, m = 2.0 + 0.02 * (2.0 * 0.6 + pi / 2.0 * 0.04), a = 2.5;
  const double friction = 1.0 + 0.02 * m * g, rotating = 90e-7 * a / r;
  const double starting = (m * a + friction + 6.0) * r / 0.95 + rotating;
  const double steady = (friction + 6.0) * r / 0.95;
  const double braking = (-m * a + friction + 6.0) * r / 0.95 - rotating;
  REQUIRE(-m * a + friction + 6.0 > 0.0);
  // A second of the recording and the dwell: 6 N come back through the belt, nothing of the friction.
  const double held = 6.0 * r * 0.95;
  const double heat = starting * starting * 0.2 + steady * steady * 0.6 + braking * braking * 0.2 + held * held * 1.5;
  expect(d, "C-ST-RMS", std::sqrt(heat / 2.5), 0.5);
}

TEST_CASE("A motor as weak as its load cannot start") {
  // M17 at 2 A has 0.354 N.m; 100 kg upwards on a lead of 5 mm ask for 0.8 N.m.
  machine::Problem problem =
      one_axis({.direction = "vertical", .mechanism = R"(screw = ["ball_screws"], ends = "fixed-supported")"});
  problem.axes[0].structure_mass = 100.0;
  Parts chosen = ball_screw_parts("S6");
  chosen[2].second = "M17";
  const Design d = worked(problem, chosen, "P24-350", 0.2);
  REQUIRE(find(d, "C-ST-START") != nullptr);
  CHECK(find(d, "C-ST-START")->verdict == Verdict::violated);
  CHECK(find(d, "C-ST-START")->utilisation > 1e6);
  CHECK(std::isfinite(find(d, "C-ST-START")->utilisation));
}

}  // namespace hand_worked_drive_test
