// SPDX-License-Identifier: Apache-2.0
// A belt axis, guides, members and the supply worked by hand, on the figures of tiny_catalogue.h. The right-hand sides
// use <cmath> and nothing of the project.
#include <fmt/format.h>

#include <cmath>

#include "evaluation/hand_worked.h"

namespace hand_worked_elements_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Check;
using evaluation::Design;
using evaluation::MachineModel;

TEST_CASE("A belt axis worked by hand") {
  const MachineModel model(problem_of_text(R"(
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
lost_motion = "0.1 mm"
)"),
                           parts());
  const Design d = design_of(model, {{"x", "drive", {{"GT3-9"}, {"G20-5"}, {"I20"}, {"M17", "D2"}}, {0.2}}});

  const double span = 0.5 + 0.02 + 0.08, r = 0.01;
  const double belt = 0.02 * (2.0 * span + pi / 2.0 * 0.04);
  const double m = 2.0 + belt, v = 0.4 / 0.8, a = v / 0.2;
  const double friction = 1.0 + 0.02 * m * g;
  const double force = m * a + friction + 5.0;
  const double rotating = 60e-7 + 20e-7 + 10e-7;
  const double torque = force * r / 0.95 + rotating * a / r;

  // 21.6 V of 24 are usable. At 50 rad/s: K = 0.5/(2 sqrt 2) N.m/A, E = K w = 8.84 V, X = 50*50*2.8 mH = 7 ohm; 2 A
  // need sqrt((3 + 8.84)^2 + 14^2) = 18.3 V: the current is reached. Losses 0.5 (0.03 + 0.0005*50) N.m.
  const double K = 0.5 / (2.0 * std::sqrt(2.0));
  REQUIRE(std::hypot(3.0 + K * 50.0, 14.0) < 21.6);
  const double available = K * 2.0 - 0.5 * (0.03 + 0.0005 * 50.0);
  expect(d, "drive", "C-ST-TORQUE", torque / available, 0.5);
  expect(d, "drive", "C-ST-80", (friction + 5.0) * r / 0.95, 0.4);
  const double load_inertia = 30e-7 + m * r * r;
  expect(d, "drive", "C-ST-INERTIA", load_inertia * 1e4, 10.0 * 60e-7 * 1e4);

  // Pretension 1.1 F and what the belt's own turning takes; service factor 1.4; ten of twenty teeth in mesh.
  const double turning = 0.02 * v * v, pretension = 1.1 * force + turning;
  expect(d, "drive", "C-BT-TENSION", 1.4 * (pretension + force), 180.0);
  expect(d, "drive", "C-BT-POWER", 1.4 * force * v, (180.0 - turning) * v);
  expect(d, "drive", "C-BT-TEETH", 6.0, 10.0);
  expect(d, "drive", "C-BT-PRET", force + turning, pretension);
  expect(d, "drive", "C-BT-MINZ", 16.0, 20.0);
  expect(d, "drive", "F-PULLEY-BORE", 5.0, 5.0);
  expect(d, "drive", "F-PULLEY-BORE-MIN", 5.0, 5.0);
  expect(d, "drive", "F-BELT-PULLEYS", 1.0, 1.0);

  // Pulses: 50 rad/s of 200*16 microsteps a turn; 0.8 of 30 kHz is the slowest limit of the axis.
  expect(d, "drive", "C-ST-STEPRATE", 50.0 / (2.0 * pi) * 3.2, 24.0);
  expect(d, "drive", "C-SYS-SPEED", 500.0, 24e3 / 3200.0 * 2.0 * pi * r * 1e3);
  expect(d, "drive", "C-ST-HOLD", 5.0 * r * 0.95, 0.5 * K * 2.0);

  // Both strands, each at most half the loop: k = 4 EA/(2 span).
  const double stiffness = 4.0 * 60000.0 / (2.0 * span), reversal = 2.0 * friction / stiffness;
  // The rotor lags to either side under friction.
  const double lagging = r * std::asin(friction * r / 0.95 / (K * 2.0)) / 50.0;
  expect(d, "drive", "C-ACC-LOST", (reversal + 2.0 * lagging) * 1e6, 100.0);
  const double travel = 2.0 * pi * r, step = travel / 200.0;
  const double lag = travel / (2.0 * pi) * std::asin((friction + 5.0) * r / 0.95 / (K * 2.0)) / 50.0;
  expect(d,
         "drive",
         "C-ACC-TOTAL",
         (2e-4 * 0.5 + 5.0 / stiffness + reversal + lag + std::hypot(0.05 * step, 0.5 * step / 16.0)) * 1e6,
         500.0);
  expect(d, "drive", "C-ACC-RES", step / 16.0 * 1e6, 250.0);

  CHECK(d.cost == Approx(5.0 * (2.0 * span + pi / 2.0 * 0.04) + 4.0 + 3.0 + 9.0 + 6.0 + 15.0));
  CHECK(d.mass == Approx(belt + 0.02 + 0.015 + 0.3 + 0.1 + 0.4));
}

TEST_CASE("Guides worked by hand") {
  const std::string four =
      "{ rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\", load_offset_x = \"20 "
      "mm\", "
      "load_offset_y = \"30 mm\", force_height = \"50 mm\" }";
  const double rail = 0.5 + 0.02 + 0.1 + 0.045;
  const double m = 20.0 + 4 * 0.05 + belt_allowance, G = m * g;
  const double pitch = G * 0.02 + 50.0 * 0.05;
  const double aside =
      50.0 * 0.03;  // the process force acts where the load is: it turns the table about its normal too
  // The shortest ramp, 0.05 s, to 0.4 m in 0.95 s; the mass beside the middle then turns the table about its normal.
  const double speed = 0.4 / 0.95, yaw = m * speed / 0.05 * 0.03;
  const double off = m * speed / 0.05 * 0.02;  // on a steep axis it stands 20 mm off the rails, and pitches as well
  // Mean over the travel of the loads of both ramps, each half of speed x 0.05 s long, and between them.
  const double ramps = speed * 0.05 / 0.4;
  const auto mean = [&](double steady, double ramping) {
    return std::cbrt(ramps * std::pow(ramping, 3) + (1.0 - ramps) * std::pow(steady, 3));
  };
  // Distance for 90 % of the carriages: 50 km (C/(1.5 P))^3; mean speed 0.4 m in the 2 s of the cycle.
  const auto life_hours = [](double rating, double load, double mean_speed) {
    return 50e3 * std::pow(rating / (1.5 * load), 3) / mean_speed / 3600.0;
  };
  SECTION("four carriages, horizontal: weight, pitch and roll") {
    const Design d = design_of(MachineModel(problem_of_text(axis_text("horizontal", four, "")), parts()),
                               {{"x", "guide", {{"R12"}}, {}}});
    const double P = G / 4.0 + pitch / 0.2 + G * 0.03 / 0.4 + aside / 0.2;
    expect(d, "guide", "C-GD-STATIC", 2.0 * (P + yaw / 0.2), 5000.0);
    expect(d, "guide", "C-GD-LIFE", 10000.0, life_hours(3000.0, mean(P, P + yaw / 0.2), 0.2));
    for (const Check& c : d.checks)
      if (c.id == "C-GD-STATIC") CHECK(c.phase == "move 1, accelerate");
    expect(d, "guide", "C-SYS-RAIL", rail * 1e3, 2000.0);
  }
  SECTION("four carriages, vertical: the weight pulls along, and across when it hangs to the side") {
    const Design d = design_of(MachineModel(problem_of_text(axis_text("vertical", four, "")), parts()),
                               {{"x", "guide", {{"R12"}}, {}}});
    expect(d, "guide", "C-GD-STATIC", 2.0 * (pitch / 0.2 + G * 0.03 / 0.2 + (aside + yaw + off) / 0.2), 5000.0);
  }
  SECTION("on a slope of 30 degrees most of the weight presses on the guides") {
    const Design d =
        design_of(MachineModel(problem_of_text(axis_text("inclined\"\ninclination = \"30 deg", four, "")), parts()),
                  {{"x", "guide", {{"R12"}}, {}}});
    const double across = G * std::cos(pi / 6.0), along = G * 0.5;
    // The 20 mm are a lever of what presses if they lie along the travel, and of what pulls if they stand off the
    // rails.
    const double tilt = across * 0.02 + along * 0.02 + 50.0 * 0.05;
    expect(d,
           "guide",
           "C-GD-STATIC",
           2.0 * (across / 4.0 + tilt / 0.2 + across * 0.03 / 0.4 + along * 0.03 / 0.2 + (aside + yaw + off) / 0.2),
           5000.0);
  }
  SECTION("what pulls along a steep axis pitches by its height above the line of the drive") {
    const std::string high =
        "{ rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\", load_height = "
        "\"80 mm\" }";
    const auto guided = [&](const char* direction) {
      return design_of(MachineModel(problem_of_text(axis_text(direction, high, "")), parts()),
                       {{"x", "guide", {{"R12"}}, {}}});
    };
    const double inertia = m * speed / 0.05 * 0.08 / 0.2, upright = G * 0.08 / 0.2;
    const Design vertical = guided("vertical");
    expect(vertical, "guide", "C-GD-STATIC", 2.0 * (upright + inertia), 5000.0);
    expect(vertical, "guide", "C-GD-LIFE", 10000.0, life_hours(3000.0, mean(upright, upright + inertia), 0.2));
    expect(guided("inclined\"\ninclination = \"30 deg"),
           "guide",
           "C-GD-STATIC",
           2.0 * (G * std::cos(pi / 6.0) / 4.0 + 0.5 * upright + inertia),
           5000.0);
  }
  SECTION("a mass above the line of the drive pitches when it is accelerated, and not between") {
    const std::string high =
        "{ rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\", load_height = "
        "\"-80 mm\" }";
    const Design d = design_of(MachineModel(problem_of_text(axis_text("horizontal", high, "")), parts()),
                               {{"x", "guide", {{"R12"}}, {}}});
    const double P = G / 4.0, ramping = P + m * speed / 0.05 * 0.08 / 0.2;
    expect(d, "guide", "C-GD-STATIC", 2.0 * ramping, 5000.0);
    expect(d, "guide", "C-GD-LIFE", 10000.0, life_hours(3000.0, mean(P, ramping), 0.2));
  }
  SECTION("bushings on two round shafts held at their ends") {
    const std::string bushings =
        "{ kinds = [\"linear ball bush\"], rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = "
        "\"200 "
        "mm\" }";
    const Design d = design_of(MachineModel(problem_of_text(axis_text("horizontal", bushings, "")), parts()),
                               {{"x", "guide", {{"LB16"}}, {}}});
    // Half of weight and process force on each shaft, at two places 100 mm apart in the middle.
    const double F = ((20.0 + 0.4 + belt_allowance) * g + 50.0) / 2.0, L = 0.5 + 0.02 + 0.1 + 0.04, a = (L - 0.1) / 2.0;
    const double I = pi / 64.0 * std::pow(0.016, 4);
    expect(d,
           "guide",
           "C-GD-DEFL",
           F / 2.0 * a * (3.0 * L * L - 4.0 * a * a) / (24.0 * 206e9 * I) * 1e3,
           L * 1e3 / 3000.0);
    expect(d, "guide", "C-GD-STRESS", F / 2.0 * a * 32.0 / (pi * std::pow(0.016, 3)) * 1e-6, 345.0 / 3.0);
  }
  SECTION("moments press on one shaft, and with a couple on the two bushings of each") {
    const std::string bushings =
        "{ kinds = [\"linear ball bush\"], rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = "
        "\"200 mm\", load_offset_x = \"20 mm\", load_offset_y = \"30 mm\", force_height = \"50 mm\" }";
    const double moved = 20.0 + 0.4 + belt_allowance, W = moved * g, inertia = moved * speed / 0.05;
    const double L = 0.5 + 0.02 + 0.1 + 0.04, a = (L - 0.1) / 2.0;
    const auto stress = [&](const char* direction, double F) {
      const Design d = design_of(MachineModel(problem_of_text(axis_text(direction, bushings, "")), parts()),
                                 {{"x", "guide", {{"LB16"}}, {}}});
      expect(d, "guide", "C-GD-STRESS", F / 2.0 * a * 32.0 / (pi * std::pow(0.016, 3)) * 1e-6, 345.0 / 3.0);
    };
    // What turns the slide pushes one bushing of each shaft up and the other down: M (L - s)/L where it bends most.
    const double turning = 50.0 * 0.05 + W * 0.02 + aside + inertia * 0.03;
    const double even = (W + 50.0) / 2.0 + W * 0.03 / 0.2, couple = turning / 2.0 / 0.1;
    const auto turned = [&](double moment) { return moment / 2.0 * (L - 0.1) / L / ((L - 0.1) / 4.0); };
    stress("horizontal", even + turned(turning));
    // Upright, the weight pulls along: 20 mm before the rails, 30 mm beside their middle.
    stress("vertical", 50.0 / 2.0 + turned(turning + inertia * 0.02 + W * 0.03));
    // The beam on two supports with half of the even load at each bushing, the couple added on the left one: at no
    // place of the slide is more moment there than it is sized for.
    for (double left = 0.01; left < L - 0.11; left += 0.01) {
      const double first = even / 2.0 + couple, second = even / 2.0 - couple;
      const double support = (first * (L - left) + second * (L - left - 0.1)) / L;
      const double at_first = support * left, at_second = at_first + (support - first) * 0.1;
      CHECK(std::max(at_first, at_second) <= (even + turned(turning)) / 2.0 * a);
    }
  }
  SECTION("on a face the weight draws across the rails, and rolls by what it hangs before them") {
    const std::string before = four.substr(0, four.size() - 1) + ", load_height = \"80 mm\" }";
    const Design d =
        design_of(MachineModel(problem_of_text(axis_text("horizontal\"\nnormal = \"y", before, "")), parts()),
                  {{"x", "guide", {{"R12"}}, {}}});
    const double P = G / 4.0 + G * 0.08 / 0.4 + (50.0 * 0.05 + G * 0.02 + aside) / 0.2;
    const double ramping = P + m * speed / 0.05 * (0.08 + 0.03) / 0.2;
    expect(d, "guide", "C-GD-STATIC", 2.0 * ramping, 5000.0);
    expect(d, "guide", "C-GD-LIFE", 10000.0, life_hours(3000.0, mean(P, ramping), 0.2));
    const std::string one = "{ rails = 1, carriages = 1, load_height = \"80 mm\" }";
    const Design single =
        design_of(MachineModel(problem_of_text(axis_text("horizontal\"\nnormal = \"y", one, "")), parts()),
                  {{"x", "guide", {{"R20"}}, {}}});
    const double weight = (20.0 + 0.4 + belt_allowance) * g;
    const double turned = weight / g * speed / 0.05 * 0.08 / 200.0;
    expect(single, "guide", "C-GD-STATIC", 2.0 * (weight + 25000.0 * (weight * 0.08 / 250.0 + turned)), 25000.0);
  }
  SECTION("a single carriage takes the moments itself") {
    const std::string one =
        "{ rails = 1, carriages = 1, load_offset_x = \"20 mm\", load_offset_y = \"30 mm\", force_height = \"50 mm\" }";
    const double weight = (20.0 + 0.4 + belt_allowance) * g;
    const double roll = weight * 0.03, pitching = weight * 0.02 + 50.0 * 0.05;
    const Design d = design_of(MachineModel(problem_of_text(axis_text("horizontal", one, "")), parts()),
                               {{"x", "guide", {{"R20"}}, {}}});
    const double P = weight + 25000.0 * (roll / 250.0 + (pitching + aside) / 200.0);
    const double turning = weight / g * speed / 0.05 * 0.03, ramping = P + 25000.0 * turning / 200.0;
    expect(d, "guide", "C-GD-STATIC", 2.0 * ramping, 25000.0);
    expect(d, "guide", "C-GD-LIFE", 10000.0, life_hours(15000.0, mean(P, ramping), 0.2));
    const Design upright = design_of(MachineModel(problem_of_text(axis_text("vertical", one, "")), parts()),
                                     {{"x", "guide", {{"R20"}}, {}}});
    expect(upright,
           "guide",
           "C-GD-STATIC",
           2.0 * 25000.0 * (pitching + aside + turning / 0.03 * 0.02 + roll + turning) / 200.0,
           25000.0);
  }
}

TEST_CASE("Members worked by hand") {
  const std::string member = "[[axis.members]]\nmaterial = \"steel\"\n";
  const auto built = [&](const std::string& name, const std::string& text, const Chosen& chosen) {
    const MachineModel model(problem_of_text(axis_text("horizontal", "", member + "name = \"" + name + "\"\n" + text)),
                             parts());
    return design_of(model, {chosen});
  };
  const double E = 200e9, weight = (20.0 + belt_allowance) * g;
  SECTION("two fixed round shafts with a side load") {
    const Design d = built("rod",
                           "kind = \"shaft\"\nsupport = \"fixed\"\nguide = true\nlength = \"700 mm\"\ncount = 2\n"
                           "lateral_force = \"30 N\"\ndiameter = [\"10 mm\", \"30 mm\"]\n",
                           {"x", "rod", {}, {0.02}});
    const double L = 0.7, A = pi / 4.0 * 4e-4, I = pi / 64.0 * 16e-8, w = 8000.0 * A * g, F = weight / 2.0;
    // Each wherever it bends most: a third of the span from a clamp, F a (L - a)^2/L^2.
    const double most = L / 3.0 * (2.0 * L / 3.0) * (2.0 * L / 3.0) / (L * L);
    const double M = F * most + w * L * L / 12.0, side = 15.0 * most;
    const double down = F * L * L * L / (192.0 * E * I) + w * std::pow(L, 4) / (384.0 * E * I);
    const double across = 15.0 * L * L * L / (192.0 * E * I);
    const double Z = pi / 32.0 * 8e-6;
    expect(d, "rod", "C-GD-STRESS", (M + side) / Z * 1e-6, 80.0);
    expect(d, "rod", "C-GD-DEFL", std::hypot(down, across) * 1e3, 700.0 / 3000.0);
    expect(d, "rod", "C-SH-DIAM", std::cbrt(32.0 * std::hypot(M, side) / (pi * 80e6)) * 1e3, 20.0);
    CHECK(d.mass - 2.0 * 8000.0 * A * L ==
          Approx(design_of(MachineModel(problem_of_text(axis_text("horizontal", "", "")), parts()), {}).mass));
  }
  SECTION("a supported bar with a side load") {
    const Design d = built("bar",
                           "kind = \"bar\"\nlength = \"600 mm\"\nlateral_force = \"40 N\"\nextra_force = \"100 N\"\n"
                           "width = [\"10 mm\", \"40 mm\"]\nheight = [\"10 mm\", \"40 mm\"]\n",
                           {"x", "bar", {}, {0.02, 0.03}});
    const double L = 0.6, b = 0.02, h = 0.03, w = 8000.0 * b * h * g, F = weight + 100.0;
    const double strong = b * h * h * h / 12.0, weak = h * b * b * b / 12.0;
    const double M = F * L / 4.0 + w * L * L / 8.0, side = 40.0 * L / 4.0;
    const double down = F * L * L * L / (48.0 * E * strong) + 5.0 * w * std::pow(L, 4) / (384.0 * E * strong);
    const double across = 40.0 * L * L * L / (48.0 * E * weak);
    expect(d, "bar", "C-FR-STRESS", (M * h / 2.0 / strong + side * b / 2.0 / weak) * 1e-6, 120.0);
    expect(d, "bar", "C-FR-DEFL", std::hypot(down, across) * 1e3, 0.6);
  }
  SECTION("a cantilever of a catalogue section") {
    const Design d =
        built("arm",
              "kind = \"beam\"\nsupport = \"cantilever\"\nlength = \"300 mm\"\nsections = [\"steel_sections\"]\n",
              {"x", "arm", {{"box60"}}, {}});
    const double L = 0.3, I = 5e-7, w = 8.0 * g;
    expect(d, "arm", "C-FR-STRESS", (weight * L + w * L * L / 2.0) * 0.03 / I * 1e-6, 120.0);
    expect(d,
           "arm",
           "C-FR-DEFL",
           (weight * std::pow(L, 3) / (3.0 * E * I) + w * std::pow(L, 4) / (8.0 * E * I)) * 1e3,
           0.3);
  }
  SECTION("four columns: a slender and a stocky one") {
    const auto column = [&](const char* length, const char* section) {
      return built("legs",
                   fmt::format("kind = \"column\"\nlength = \"{}\"\ncount = 4\nextra_force = \"100 N\"\nsections = "
                               "[\"steel_sections\"]\n",
                               length),
                   {"x", "legs", {{section}}, {}});
    };
    // Radius of gyration sqrt(10000/200) = 7.07 mm: 1 m is slender (141 > 128), 0.5 m is not (71).
    expect(column("1000 mm", "box20"), "legs", "C-FR-BUCK", (weight + 100.0) / 4.0, pi * pi * E * 1e-8 / 3.0);
    const double yield = 240e6, area = 200e-6;
    const double johnson = area * yield * (1.0 - yield * 0.25 / (4.0 * pi * pi * E * 1e-8 / area));
    expect(column("500 mm", "box20"), "legs", "C-FR-BUCK", (weight + 100.0) / 4.0, johnson / 3.0);
  }
  SECTION("a weld all around a rectangle") {
    const Design d =
        built("joint",
              "kind = \"weld\"\nlever_arm = \"200 mm\"\njoint_width = \"30 mm\"\njoint_depth = \"20 mm\"\nleg "
              "= [\"2 mm\", \"8 mm\"]\n",
              {"x", "joint", {}, {0.005}});
    const double t = 0.005 / std::sqrt(2.0);
    const double direct = weight / (t * 0.1);
    const double bending = weight * 0.2 / (t * (0.03 * 0.02 + 0.02 * 0.02 / 3.0));
    expect(d, "joint", "C-WELD", std::hypot(direct, bending) * 1e-6, 80.0);
    // Two legs of 5 mm make a triangle along 100 mm.
    const Design bare = design_of(MachineModel(problem_of_text(axis_text("horizontal", "", "")), parts()), {});
    CHECK(d.mass - bare.mass == Approx(0.5 * 25e-6 * 0.1 * 8000.0));
    CHECK(d.cost - bare.cost == Approx(2.0 * 0.5 * 25e-6 * 0.1 * 8000.0));
  }
}

TEST_CASE("What rides on an axis burdens its guide, what stands does not") {
  const std::string guide = "{ carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\" }";
  const auto load = [&](const char* rides) {
    const std::string bar = fmt::format(
        "[[axis.members]]\nname = \"bar\"\nmaterial = \"steel\"\nkind = \"bar\"\nlength = \"500 mm\"\nrides = "
        "{}\nwidth = \"40 mm\"\nheight = \"50 mm\"\n",
        rides);
    const Design d = design_of(MachineModel(problem_of_text(axis_text("horizontal", guide, bar)), parts()),
                               {{"x", "guide", {{"R12"}}, {}}});
    for (const Check& c : d.checks)
      if (c.id == "C-GD-STATIC") return c.value;
    return 0.0;
  };
  CHECK(load("false") == Approx(2.0 * ((20.2 + belt_allowance) * g / 4.0)));
  CHECK(load("true") == Approx(2.0 * ((20.2 + belt_allowance + 0.5 * 0.04 * 0.05 * 8000.0) * g / 4.0)));
}

TEST_CASE("A machine whose member has no known material says so") {
  const MachineModel model(problem_of_text(axis_text(
                               "horizontal",
                               "",
                               "[[axis.members]]\nname = \"bar\"\nmaterial = \"unobtainium\"\nkind = \"bar\"\nlength = "
                               "\"500 mm\"\nwidth = \"40 mm\"\nheight = \"50 mm\"\n")),
                           parts());
  const auto empty = model.empty_slots();
  REQUIRE(empty.size() == 1);
  CHECK(empty[0].axis == "x");
  CHECK(empty[0].slot == "bar");
  CHECK(empty[0].reason.find("unobtainium") != std::string::npos);
}

}  // namespace hand_worked_elements_test
