// SPDX-License-Identifier: Apache-2.0
// Joints of screws, and the power of a cut, worked by hand on the figures of tiny_catalogue.h. The right-hand sides use
// <cmath> and nothing of the project.
#include <cmath>

#include "evaluation/hand_worked.h"

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

MachineModel joint(const std::string& text) {
  return {
      problem_of_text(axis_text("horizontal", "", "[[axis.members]]\nname = \"flange\"\nkind = \"bolts\"\n" + text)),
      parts()};
}

Design bare() { return design_of(MachineModel(problem_of_text(axis_text("horizontal", "", "")), parts()), {}); }

const std::string pattern = "row_spacing = \"80 mm\"\ncolumn_spacing = \"60 mm\"\n";
constexpr double weight = (20.0 + belt_allowance) * g;

}  // namespace

TEST_CASE("Two joints of four screws that hold a bracket by friction") {
  const Design d =
      design_of(joint(pattern + "count = 2\nedge_distance = \"20 mm\"\nlever_arm = \"150 mm\"\nextra_force = \"52 N\"\n"
                                "lateral_force = \"40 N\"\npull_force = \"100 N\"\n"),
                {{"x", "flange", {{"M8 8.8"}}, {}}});
  const double F = (weight + 52.0) / 2.0, H = 20.0;
  // Tilting about the lower edge: rows at 20 and 100 mm; about the side: columns at 20 and 80 mm; 100 N on 8 screws.
  const double down = F * 0.15 * 0.1 / (2.0 * (0.02 * 0.02 + 0.1 * 0.1));
  const double across = H * 0.15 * 0.08 / (2.0 * (0.02 * 0.02 + 0.08 * 0.08));
  const double P = down + across + 12.5, shear = std::hypot(F / 4.0, H / 4.0);
  // M8 8.8: 36 mm2 at 600 MPa prove 21 600 N, preloaded by 75 % of that; a quarter of the tension reaches the screw.
  const double preload = 16200.0;
  expect(d, "flange", "C-BOLT-PROOF", 1.15, 21600.0 / (preload + 0.25 * P));
  expect(d, "flange", "C-BOLT-SEP", 1.5, preload / (0.75 * P));
  expect(d, "flange", "C-BOLT-SLIP", 1.5, 0.15 * (preload - 0.75 * P) / shear);
  expect_none(d, "flange", "C-BOLT-SHEAR");
  // Shank 3 d, head 1.5 d wide and d high.
  CHECK(d.mass - bare().mass == Approx(8.0 * 7850.0 * pi / 4.0 * (3.0 + 2.25) * std::pow(0.008, 3)));
  CHECK(d.cost - bare().cost == Approx(8.0 * 0.1));
}

TEST_CASE("Fitted bolts under an eccentric load are sheared") {
  const Design d =
      design_of(joint(pattern + "fitted = true\neccentricity = \"50 mm\"\ntightening_torque = \"10 N.m\"\n"),
                {{"x", "flange", {{"M8 8.8"}}, {}}});
  // Screws at +-30 and +-40 mm: S = 4 (0.03^2 + 0.04^2) = 0.01 m2.
  const double turning = weight * 0.05 / 0.01;
  const double worst = std::hypot(turning * 0.04, weight / 4.0 + turning * 0.03);
  expect(d, "flange", "C-BOLT-SHEAR", worst / 36e-6 * 1e-6, 640.0 / std::sqrt(3.0) / 2.0);
  // 10 N.m with a nut factor of 0.2 give 10/(0.2*0.008) = 6250 N; nothing pulls, so one newton is taken.
  expect(d, "flange", "C-BOLT-PROOF", 1.15, 21600.0 / 6250.0);
  expect(d, "flange", "C-BOLT-SEP", 1.5, 6250.0 / 0.75);
  expect_none(d, "flange", "C-BOLT-SLIP");
}

TEST_CASE("An eccentric load and a lateral force are added where they may meet") {
  const Design d = design_of(joint(pattern + "eccentricity = \"50 mm\"\nlateral_force = \"40 N\"\n"),
                             {{"x", "flange", {{"M6 8.8"}}, {}}});
  const double turning = weight * 0.05 / 0.01;
  const double worst = std::hypot(turning * 0.04, weight / 4.0 + turning * 0.03) + 10.0;
  expect(d, "flange", "C-BOLT-SLIP", 1.5, 0.15 * 0.75 * 20e-6 * 600e6 / worst);
}

TEST_CASE("A joint chooses among the screws that are wanted and known well enough") {
  const auto rows = [](const std::string& more) { return joint(pattern + more).entries()[0].tables()[0].rows(); };
  CHECK(rows("") == 3);
  CHECK(rows("sizes = [\"M8\"]\n") == 2);
  CHECK(rows("property_classes = \"8.8\"\n") == 2);
  CHECK(rows("sizes = [\"M8\"]\nproperty_classes = [\"12.9\"]\n") == 1);
  CHECK(rows("fitted = true\n") == 2);  // the 12.9 has no yield strength, and shear is judged by it
  const auto none = joint(pattern + "sizes = \"M7\"\n").empty_slots();
  REQUIRE(none.size() == 1);
  CHECK(none[0].slot == "flange");
}

TEST_CASE("What a riding joint weighs burdens the axis") {
  const auto force = [](const char* rides) {
    const Design d = design_of(joint(pattern + "rides = " + rides +
                                     "\n[[axis.members]]\nname = \"legs\"\nkind = "
                                     "\"column\"\nmaterial = \"steel\"\nlength = \"500 mm\"\nsections = "
                                     "\"steel_sections\"\n"),
                               {{"x", "flange", {{"M8 8.8"}}, {}}});
    for (const auto& c : d.checks)
      if (c.id == "C-FR-BUCK") return c.value;
    return 0.0;
  };
  CHECK(force("false") == Approx(weight));
  CHECK(force("true") == Approx(weight + 4.0 * 7850.0 * pi / 4.0 * 5.25 * std::pow(0.008, 3) * g));
}

TEST_CASE("The power of a cut against the spindle's, worked by hand") {
  const auto axis = [](const std::string& spindle) {
    return MachineModel(problem_of_text(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "500 mm"
structure_mass = "2 kg"
mechanism = { kind = "belt", idler_distance = "80 mm" }
[[axis.moves]]
name = "roughing"
distance = "400 mm"
cutting = { material = "aluminium", depth = "2 mm", width = "2 mm", feed_per_tooth = "0.03 mm", teeth = 2, diameter = "6 mm", cutting_speed = "5.655 m/s")" +
                                        spindle + R"( }
[[axis.moves]]
distance = "400 mm"
time = "2 s"
)"),
                        parts());
  };
  const Design d = design_of(axis(", spindle_power = \"200 W\""), {});
  // phi = acos(1 - 2*2/6), h_m = 2*0.03*2/(6 phi) mm, k_c = 700 h_m^-0.25; 1885 rad/s make a feed of 18.0 mm/s.
  const double engaged = std::acos(1.0 - 4.0 / 6.0), chip = 2.0 * 0.03 * 2.0 / (6.0 * engaged);
  const double feed = 0.03e-3 * 2.0 * (2.0 * 5.655 / 0.006) / (2.0 * pi);
  expect(d, "drive", "C-TOOL-POWER", 700e6 * std::pow(chip, -0.25) * 2e-3 * 2e-3 * feed, 160.0);
  expect_none(design_of(axis(""), {}), "drive", "C-TOOL-POWER");
}
