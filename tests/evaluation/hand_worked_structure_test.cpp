// SPDX-License-Identifier: Apache-2.0
// Portal frames, plates, twist, natural frequency, fatigue and bushings worked by hand, on the figures of
// tiny_catalogue.h. The right-hand sides use <cmath> and nothing of the project.
#include <algorithm>
#include <cmath>

#include "evaluation/hand_worked.h"
#include "machine/axis_motion.h"

namespace hand_worked_structure_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Check;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Verdict;

namespace {

/// The axis of hand_worked.h with one member called "part" that carries its 20 kg and a belt.
MachineModel model_with(const std::string& member, const std::string& require = "") {
  return {problem_of_text(axis_text("horizontal",
                                    "",
                                    "[[axis.members]]\nname = \"part\"\n" + member + "\n" +
                                        (require.empty() ? "" : "[axis.require]\n" + require))),
          parts()};
}

Design bare() { return design_of(MachineModel(problem_of_text(axis_text("horizontal", "", "")), parts()), {}); }

const Check& check_of(const Design& design, const std::string& id) {
  const auto found =
      std::find_if(design.checks.begin(), design.checks.end(), [&](const Check& c) { return c.id == id; });
  INFO(id);
  REQUIRE(found != design.checks.end());
  return *found;
}

constexpr double carried = 20.0 + belt_allowance;
constexpr double weight = carried * g;

}  // namespace

namespace {
/// Largest moments at corners and feet of a portal of one section under a force P somewhere on its beam, by
/// slope-deflection: what is alike at both ends of the clamped beam turns its corners against each other, what differs
/// turns them alike and sways the frame, whose columns then bear one moment from top to foot.
struct Hung {
  double corner = 0.0, foot = 0.0;
};
Hung hung(double P, double L, double h) {
  Hung most;
  for (int n = 0; n <= 200000; ++n) {
    const double x = n / 200000.0, alike = P * L * x * (1.0 - x) / 2.0, unlike = alike * (1.0 - 2.0 * x);
    const double even = 4.0 / h * alike / (4.0 / h + 2.0 / L), odd = 1.0 / h * unlike / (1.0 / h + 6.0 / L);
    most.corner = std::max({most.corner, std::abs(even + odd), std::abs(even - odd)});
    most.foot = std::max({most.foot, std::abs(0.5 * even + odd), std::abs(0.5 * even - odd)});
  }
  return most;
}
}  // namespace

TEST_CASE("A portal frame of a T-slot profile worked by hand") {
  // The material is that of steel sections: a profile is of the alloy of its row.
  const auto [material, sections] =
      GENERATE(std::pair{"alloy", "\"extrusions\""}, std::pair{"steel", "\"steel_sections\", \"extrusions\""});
  const std::string portal = fmt::format(
      "kind = \"portal_frame\"\nmaterial = \"{}\"\nsections = [{}]\nlength = \"700 mm\"\n"
      "height = \"350 mm\"\nlateral_force = \"60 N\"",
      material,
      sections);
  const Design d =
      design_of(model_with(portal, "frame_natural_frequency = \"30 Hz\"\n"), {{"x", "part", {{"slot4080"}}, {}}});
  // Profile 80 x 40 upright: A 1000 mm2, I 600 000 and 160 000 mm4, 2.7 kg/m; E 70 GPa, yield 200 MPa.
  const double E = 70e9, I = 6e-7, A = 1e-3, L = 0.7, h = 0.35, own = 2.7 * g, H = 60.0;
  // Slope-deflection, divided by EI. The beam's weight in its middle turns the corners by t: (4/h + 2/L) t = Q L/8.
  const double turn = own * L * L / 8.0 / (4.0 / h + 2.0 / L);
  const double of_beam = 4.0 / h * turn;
  const Hung moving = hung(weight, L, h);
  // The lateral force sways the beam by s and turns the corners by r s: (4/h + 6/L) r = 6/h2; shears 2 (12/h3 - 6r/h2).
  const double r = 6.0 / (h * h) / (4.0 / h + 6.0 / L);
  const double s = H / (2.0 * (12.0 / (h * h * h) - 6.0 * r / (h * h)));
  const double swaying = 6.0 * r / L * s, at_foot = (6.0 / (h * h) - 2.0 * r / h) * s;
  const double corner = moving.corner + of_beam + swaying, foot = moving.foot + 0.5 * of_beam + at_foot;
  const double middle = weight * L / 4.0 + own * L * L / 8.0;
  const double axial = weight + own * L / 2.0 + own * h + 2.0 * swaying / L;
  expect(d, "part", "C-FR-SWAY", s / (E * I) * 1e3, 0.35);
  expect(d, "part", "C-FR-STRESS", std::max(middle, corner) * 0.04 / I * 1e-6, 100.0);
  expect(d, "part", "C-FR-COLUMN", (axial / A + std::max(corner, foot) * 0.04 / I) * 1e-6, 100.0);
  expect(d, "part", "C-FR-DEFL", (weight * L * L * L / 48.0 + 5.0 * own * std::pow(L, 4) / 384.0) / (E * I) * 1e3, 0.7);
  // Free to sway, fixity 0.25: slenderness 0.35/12.65 mm = 27.7 is below 41.6, so Johnson, about the weak axis.
  const double johnson = A * 200e6 * (1.0 - 200e6 * h * h * A / (4.0 * 0.25 * pi * pi * E * 1.6e-7));
  expect(d, "part", "C-FR-BUCK", axial, johnson / 3.0);
  const double swinging = carried + 2.7 * (L + 2.0 * 13.0 / 35.0 * h);
  expect(d, "part", "C-FR-FREQ", 30.0, std::sqrt(H / (s / (E * I)) / swinging) / (2.0 * pi));
  CHECK(d.mass - bare().mass == Approx(2.7 * 1.4));
  CHECK(d.cost - bare().cost == Approx(30.0 * 1.4));
}

TEST_CASE("A portal frame whose columns sway is worked at its feet") {
  // A light load and a hard push: the feet bend more than the corners.
  const Design d =
      design_of(model_with("kind = \"portal_frame\"\nmaterial = \"steel\"\nsections = [\"steel_sections\"]\n"
                           "length = \"400 mm\"\nheight = \"800 mm\"\nlateral_force = \"500 N\"\n"
                           "load_share = 0.1\ncount = 2"),
                {{"x", "part", {{"box60"}}, {}}});
  const double I = 5e-7, L = 0.4, h = 0.8, H = 250.0, own = 8.0 * g;
  const double of_beam = 4.0 / h * own * L * L / 8.0 / (4.0 / h + 2.0 / L);
  const Hung moving = hung(0.05 * weight, L, h);
  const double r = 6.0 / (h * h) / (4.0 / h + 6.0 / L);
  const double s = H / (2.0 * (12.0 / (h * h * h) - 6.0 * r / (h * h)));
  const double swaying = 6.0 * r / L * s, corner = moving.corner + of_beam + swaying;
  const double foot = moving.foot + 0.5 * of_beam + (6.0 / (h * h) - 2.0 * r / h) * s;
  REQUIRE(foot > corner);
  REQUIRE(corner > 0.05 * weight * L / 4.0 + own * L * L / 8.0);
  const double axial = 0.05 * weight + own * L / 2.0 + own * h + 2.0 * swaying / L;
  expect(d, "part", "C-FR-COLUMN", (axial / 1e-3 + foot * 0.03 / I) * 1e-6, 120.0);
  expect(d, "part", "C-FR-STRESS", corner * 0.03 / I * 1e-6, 120.0);
  CHECK(d.mass - bare().mass == Approx(2.0 * 8.0 * 2.0));
}

TEST_CASE("A plate between two rails worked by hand") {
  const double E = 200e9, L = 0.3, t = 0.01;
  const auto plate = [&](const char* width, const char* support) {
    return design_of(model_with(fmt::format("kind = \"plate\"\nmaterial = \"steel\"\nlength = \"300 mm\"\nwidth = "
                                            "\"{}\"\nsupport = \"{}\"\nthickness = [\"4 mm\", \"20 mm\"]",
                                            width,
                                            support)),
                     {{"x", "part", {}, {t}}});
  };
  SECTION("a narrow one bends as a whole") {
    const Design d = plate("200 mm", "supported");
    const double I = 0.2 * t * t * t / 12.0, w = 8000.0 * 0.2 * t * g;
    expect(d, "part", "C-FR-STRESS", (weight * L / 4.0 + w * L * L / 8.0) * t / 2.0 / I * 1e-6, 120.0);
    expect(d, "part", "C-FR-DEFL", (weight * L * L * L / 48.0 + 5.0 * w * std::pow(L, 4) / 384.0) / (E * I) * 1e3, 0.3);
    CHECK(d.mass - bare().mass == Approx(8000.0 * 0.3 * 0.2 * t));
    CHECK(d.cost - bare().cost == Approx(2.0 * 8000.0 * 0.3 * 0.2 * t));
  }
  SECTION("of a wide one only 1.229 spans help, but all of it weighs") {
    const Design d = plate("600 mm", "fixed");
    const double I = 1.229 * L * t * t * t / 12.0, w = 8000.0 * 0.6 * t * g;
    // The load may stand anywhere: a third of the span from a clamp F a b^2/L^2 = 4/27 F L is more than in the middle.
    const double a = L / 3.0, b = L - a;
    expect(d, "part", "C-FR-STRESS", (weight * a * b * b / (L * L) + w * L * L / 12.0) * t / 2.0 / I * 1e-6, 120.0);
    expect(d, "part", "C-FR-DEFL", (weight * L * L * L / 192.0 + w * std::pow(L, 4) / 384.0) / (E * I) * 1e3, 0.3);
  }
}

// 400 mm in 1 s with ramps of 0.05 s, the shortest there are: 0.4/0.95 m/s, 8.421 m/s2. All that the axis moves goes up
// with it, or with the sine of its slope; along a level nothing does.
TEST_CASE("The structure of a climbing axis bears what its ramps take") {
  const double acceleration = 0.4 / 0.95 / 0.05;
  struct Way {
    const char* direction;
    double sine;
  };
  for (const Way way : {Way{"horizontal", 0.0}, {"vertical", 1.0}, {"inclined\"\ninclination = \"30 deg", 0.5}}) {
    INFO(way.direction);
    const double down = carried * (g + way.sine * acceleration);
    const auto built = [&](const std::string& member, const Chosen& chosen) {
      return design_of(
          MachineModel(problem_of_text(axis_text(
                           way.direction, "", "[[axis.members]]\nname = \"part\"\nextra_force = \"30 N\"\n" + member)),
                       parts()),
          {chosen});
    };
    const Design arm = built(
        "kind = \"beam\"\nmaterial = \"steel\"\nsupport = \"cantilever\"\nlength = \"300 mm\"\nsections = "
        "[\"steel_sections\"]\n",
        {"x", "part", {{"box60"}}, {}});
    const double own = 8.0 * g;
    expect(arm, "part", "C-FR-STRESS", ((down + 30.0) * 0.3 + own * 0.09 / 2.0) * 0.03 / 5e-7 * 1e-6, 120.0);
    // One that rides is sped up as well.
    const Design riding = built(
        "kind = \"beam\"\nmaterial = \"steel\"\nsupport = \"cantilever\"\nlength = \"300 mm\"\nrides = "
        "true\nload_share "
        "= 0\nsections = [\"steel_sections\"]\n",
        {"x", "part", {{"box60"}}, {}});
    const double moved = 8.0 * (g + way.sine * acceleration);
    expect(riding, "part", "C-FR-STRESS", (30.0 * 0.3 + moved * 0.09 / 2.0) * 0.03 / 5e-7 * 1e-6, 120.0);
    const Design joint = built("kind = \"bolts\"\nrow_spacing = \"80 mm\"\ncolumn_spacing = \"60 mm\"\nfitted = true\n",
                               {"x", "part", {{"M8 8.8"}}, {}});
    expect(joint, "part", "C-BOLT-SHEAR", (down + 30.0) / 4.0 / 36e-6 * 1e-6, 640.0 / std::sqrt(3.0) / 2.0);
  }
}

// A recording that goes up gently and is stopped hard on its way down: 1 m/s2 up, 4 m/s2 while it stops.
TEST_CASE("What a recorded motion does upwards counts, also at the end of its way down") {
  machine::MotionData motion;
  motion.inclination = pi / 2.0;
  machine::Move move;
  std::vector<double> times, speeds;
  const auto until = [&](double time, double speed) {
    times.push_back(time);
    speeds.push_back(speed);
  };
  until(0.0, 0.0);
  until(0.2, 0.2);
  until(0.4, 0.0);
  until(0.8, -0.4);
  until(0.9, 0.0);
  move.profile = machine::measured_profile(times, speeds, {});
  motion.moves = {move};
  CHECK(machine::climbing_acceleration(motion) == Approx(4.0));
  motion.inclination = pi / 6.0;
  CHECK(machine::climbing_acceleration(motion) == Approx(2.0));
  motion.inclination = 0.0;
  CHECK(machine::climbing_acceleration(motion) == 0.0);
}

TEST_CASE("Twist of members worked by hand") {
  const std::string bar =
      "kind = \"bar\"\nmaterial = \"steel\"\nlength = \"600 mm\"\nwidth = \"20 mm\"\nheight = \"30 mm\"\n"
      "torque = \"20 N.m\"\ncount = 2\n";
  const std::string beam =
      "kind = \"beam\"\nmaterial = \"steel\"\nlength = \"300 mm\"\nsections = [\"steel_sections\"]\n"
      "torque = \"20 N.m\"\nsupport = \"cantilever\"";
  const std::string limit = "frame_twist = \"0.2 deg\"\n";
  SECTION("a bar held at both ends takes half of the torque to each side") {
    // Roark: a c3 (16/3 - 3.36 c/a (1 - c4/12a4)), half sides 15 and 10 mm; 10 N.m each, 5 N.m over 300 mm.
    const double a = 0.015, c = 0.010;
    const double J = a * c * c * c * (16.0 / 3.0 - 3.36 * c / a * (1.0 - std::pow(c / a, 4) / 12.0));
    expect(design_of(model_with(bar, limit), {}), "part", "C-FR-TWIST", 5.0 * 0.3 / (80e9 * J) * 180.0 / pi, 0.2);
  }
  SECTION("a cantilever takes it all the way") {
    const Design d = design_of(model_with(beam, limit), {{"x", "part", {{"box60"}}, {}}});
    expect(d, "part", "C-FR-TWIST", 20.0 * 0.3 / (80e9 * 7.5e-7) * 180.0 / pi, 0.2);
  }
  SECTION("a section without torsion constant cannot bear a torque") {
    const auto choices = [](const MachineModel& model) {
      const auto part = std::find_if(
          model.entries().begin(), model.entries().end(), [](const auto& entry) { return entry.element == "part"; });
      return part->tables().front().rows();
    };
    const std::string untwisted = beam.substr(0, beam.find("torque"));
    CHECK(choices(model_with(beam, limit)) == 1);
    CHECK(choices(model_with(untwisted, limit)) == 2);
  }
  SECTION("without a limit there is no check") { expect_none(design_of(model_with(bar), {}), "part", "C-FR-TWIST"); }
}

TEST_CASE("Natural frequencies of members worked by hand") {
  const auto built = [](const char* support, const char* require) {
    return design_of(model_with(fmt::format("kind = \"bar\"\nmaterial = \"steel\"\nlength = \"500 mm\"\ncount = 2\n"
                                            "width = \"20 mm\"\nheight = \"30 mm\"\nsupport = \"{}\"",
                                            support),
                                require),
                     {});
  };
  // Each of two bars carries half of it and weighs 2.4 kg; it swings sideways first.
  const double EI = 200e9 * 0.03 * 8e-6 / 12.0, own = 0.5 * 0.02 * 0.03 * 8000.0, L3 = 0.125;
  const auto frequency = [&](double k, double part) {
    return std::sqrt(k * EI / L3 / (0.5 * carried + part * own)) / (2.0 * pi);
  };
  const char* stated = "frame_natural_frequency = \"40 Hz\"\nringing_amplitude = \"0.1 mm\"\n";
  expect(built("supported", stated), "part", "C-FR-FREQ", 40.0, frequency(48.0, 17.0 / 35.0));
  expect(built("cantilever", stated), "part", "C-FR-FREQ", 40.0, frequency(3.0, 33.0 / 140.0));
  expect(built("fixed", stated), "part", "C-FR-FREQ", 40.0, frequency(192.0, 13.0 / 35.0));
  // Not stated: 400 mm in 1 s with the shortest ramps, of 0.05 s, need 0.4/0.95 m/s: 8.42 m/s2.
  expect(built("fixed", "ringing_amplitude = \"0.1 mm\"\n"),
         "part",
         "C-FR-FREQ",
         std::sqrt(0.4 / 0.95 / 0.05 / 1e-4) / (2.0 * pi),
         frequency(192.0, 13.0 / 35.0));
  expect_none(built("fixed", "frame_safety_factor = 2\n"), "part", "C-FR-FREQ");
}

TEST_CASE("Fatigue of rotating shafts worked by hand") {
  const auto shaft = [](const char* material, const char* more, const char* require = "") {
    return model_with(fmt::format("kind = \"shaft\"\nmaterial = \"{}\"\nlength = \"400 mm\"\n"
                                  "diameter = [\"10 mm\", \"30 mm\"]\nlateral_force = \"90 N\"\n{}",
                                  material,
                                  more),
                      require);
  };
  const double d = 0.02, L = 0.4, Z = pi / 32.0 * d * d * d;
  const auto moment = [&](double density) {
    const double own = density * pi / 4.0 * d * d * g;
    return std::hypot(weight * L / 4.0 + own * L * L / 8.0, 90.0 * L / 4.0);
  };
  const double size = 1.24 * std::pow(20.0, -0.107), reliability = 0.814;
  SECTION("steel with a steady torque") {
    const Design design = design_of(shaft("steel", "rotating = true\ntorque = \"30 N.m\""), {{"x", "part", {}, {d}}});
    const double limit = 4.51 * std::pow(400.0, -0.265) * size * reliability * 200e6;
    const double mean = std::sqrt(3.0) * 30.0 / (2.0 * Z);
    expect(design, "part", "C-SH-FAT", 1.5, 1.0 / (moment(8000.0) / Z / limit + mean / 400e6));
    // Steady loads on a rotating shaft: 1.5 times the moment, the torque as it is (Khurmi and Gupta, table 14.2).
    const auto required = [&](double moment_factor, double torque_factor) {
      const double torque = torque_factor * 30.0;
      return std::cbrt(32.0 / (pi * 80e6) * std::hypot(moment_factor * moment(8000.0), std::sqrt(0.75) * torque)) * 1e3;
    };
    expect(design, "part", "C-SH-DIAM", required(1.5, 1.0), 20.0);
    const auto expected = [&](const char* more, const char* require, double diameter) {
      const MachineModel model = shaft("steel", more, require);
      expect(design_of(model, {{"x", "part", {}, {d}}}), "part", "C-SH-DIAM", diameter, 20.0);
    };
    expected("torque = \"30 N.m\"\nrotating = true",
             "shaft_bending_factor = 2\nshaft_torsion_factor = 1.5",
             required(2.0, 1.5));
    expected("torque = \"30 N.m\"", "", required(1.0, 1.0));
  }
  SECTION("another metal, ground, with a notch: its endurance limit as measured") {
    const Design design = design_of(shaft("alloy", "rotating = true\nsurface = \"ground\"\nnotch_factor = 1.5"),
                                    {{"x", "part", {}, {d}}});
    const double limit = 1.58 * std::pow(300.0, -0.085) * size * reliability * 100e6;
    expect(design, "part", "C-SH-FAT", 1.5, limit / (1.5 * moment(2700.0) / Z));
  }
  SECTION("a metal without these figures cannot be taken") {
    const auto empty = shaft("CuSn8", "rotating = true").empty_slots();
    REQUIRE(empty.size() == 1);
    CHECK(empty[0].reason.find("ultimate strength or endurance limit") != std::string::npos);
    CHECK(shaft("CuSn8", "").empty_slots().empty());
  }
  SECTION("a shaft at rest does not tire") {
    expect_none(design_of(shaft("steel", ""), {{"x", "part", {}, {d}}}), "part", "C-SH-FAT");
  }
}

TEST_CASE("Slope and jamming of bushings worked by hand") {
  const auto guided = [](const char* part, const char* kinds, const char* more) {
    const std::string guide =
        fmt::format("{{ kinds = [\"{}\"], carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\"{} }}",
                    kinds,
                    more);
    return design_of(MachineModel(problem_of_text(axis_text("horizontal", guide, "")), parts()),
                     {{"x", "guide", {{part}}, {}}});
  };
  // Half of weight and process force on each 16 mm shaft, at two bushings 100 mm apart in the middle of 660 mm.
  const double F = ((carried + 0.4) * g + 50.0) / 2.0, a = 0.28, I = pi / 64.0 * std::pow(0.016, 4);
  const double slope = F / 2.0 * a * 0.1 / (2.0 * 206e9 * I) * 180.0 / pi;
  const Design plain = guided("LB16", "bush", ", drive_offset = \"120 mm\", bushing_friction = 0.25");
  expect(plain, "guide", "C-GD-SLOPE", slope, 0.1);
  // 2:1 rule: a friction of 0.25 lets the drive pull from twice the bearing length, here 120 mm by 60 mm.
  expect(plain, "guide", "C-GD-BIND", 60.0, 100.0);
  const Design aligning = guided("LB16", "bush", ", self_aligning = true, drive_offset = \"120 mm\"");
  expect(aligning, "guide", "C-GD-SLOPE", slope, 0.5);
  CHECK(check_of(aligning, "C-GD-BIND").verdict == Verdict::not_evaluated);  // the catalogue has no friction of it
  expect_none(guided("LB16", "bush", ""), "guide", "C-GD-BIND");
  const Design rails = guided("R12", "rail", ", drive_offset = \"120 mm\"");
  expect_none(rails, "guide", "C-GD-BIND");
  expect_none(rails, "guide", "C-GD-SLOPE");
}

}  // namespace hand_worked_structure_test
