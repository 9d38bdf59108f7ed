// SPDX-License-Identifier: Apache-2.0
// Joints of screws, and the power of a cut, worked by hand on the figures of tiny_catalogue.h. The right-hand sides use
// <cmath> and nothing of the project.
#include <algorithm>
#include <cmath>

#include "evaluation/hand_worked.h"

namespace hand_worked_bolts_test {

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
  // With a lever arm the upper row is pulled at as well: both stresses together, each over what is permitted of it.
  const Design pulled = design_of(
      joint(pattern + "fitted = true\neccentricity = \"50 mm\"\nlever_arm = \"150 mm\"\nedge_distance = \"20 mm\"\n"),
      {{"x", "flange", {{"M8 8.8"}}, {}}});
  const double tension = weight * 0.15 * 0.1 / (2.0 * (0.02 * 0.02 + 0.1 * 0.1));
  const double of_tension = tension / 36e-6 / (640e6 / 2.0), of_shear = worst / 36e-6 / (640e6 / std::sqrt(3.0) / 2.0);
  const auto& check = *std::find_if(pulled.checks.begin(), pulled.checks.end(), [](const evaluation::Check& each) {
    return each.id == "C-BOLT-SHEAR";
  });
  CHECK(check.utilisation == Approx(std::hypot(of_tension, of_shear)).epsilon(1e-9));
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

// Two M23 (1.2 N.m, 0.7 kg) and the pull of a belt at each, which C-ST-RADIAL tells (worked in
// hand_worked_drive_test.cpp).
TEST_CASE("The joint of a motor bears its torque, its weight and the pull of its belt") {
  const auto model = [](const std::string& more) {
    std::string text = axis_text("horizontal",
                                 "",
                                 "[axis.require]\nmotor_radial_load = \"1 kN\"\n[[axis.members]]\nname = "
                                 "\"flange\"\nkind = \"bolts\"\nholds = \"motor\"\n" +
                                     pattern + more);
    const std::string one = "kind = \"belt\"";
    text.replace(text.find(one), one.size(), one + ", drives = 2, load_share = 0.5");
    return MachineModel(problem_of_text(text), parts());
  };
  const auto chosen = [](const MachineModel& machine) {
    return design_of(
        machine,
        {{"x", "drive", {{"GT3-9"}, {"G20-6.35"}, {"I20"}, {"M23", "D4"}}, {}}, {"x", "flange", {{"M6 8.8"}}, {}}});
  };
  const MachineModel plain = model("");
  const Design d = chosen(plain);
  double pull = 0.0;
  for (const evaluation::Check& check : d.checks)
    if (check.id == "C-ST-RADIAL") pull = check.value;
  REQUIRE(pull > 100.0);
  // Screws at +-30 and +-40 mm, 50 mm from the middle: 1.2 N.m * 0.05 m / (4 * 0.05^2 m2) = 6 N on each.
  const double F = 0.7 * g + pull, preload = 0.75 * 20e-6 * 600e6;
  expect(d, "flange", "C-BOLT-SLIP", 1.5, 0.15 * preload / (F / 4.0 + 6.0));
  expect(d, "flange", "C-BOLT-SEP", 1.5, preload / 0.75);  // nothing pulls: one newton
  // The motor hangs over: it tilts its flange about the lower edge, rows at 20 and 100 mm. 12 N across are for both.
  const Design tilted = chosen(
      model("lever_arm = \"50 mm\"\nedge_distance = \"20 mm\"\nextra_force = \"8 N\"\nlateral_force = \"12 N\"\n"));
  const double P = (F + 4.0) * 0.05 * 0.1 / (2.0 * (0.02 * 0.02 + 0.1 * 0.1)) +
                   6.0 * 0.05 * 0.08 / (2.0 * (0.02 * 0.02 + 0.08 * 0.08));
  expect(tilted, "flange", "C-BOLT-SEP", 1.5, preload / (0.75 * P));
  expect(tilted, "flange", "C-BOLT-SLIP", 1.5, 0.15 * (preload - 0.75 * P) / ((F + 4.0) / 4.0 + 6.0 + 6.0 / 4.0));
  // Four screws at each motor.
  for (const evaluation::PartLine& line : d.parts)
    if (line.slot == "flange") CHECK(line.quantity == 8.0);
  // On the joint of a reduction the belt does not pull.
  std::string geared = axis_text("horizontal",
                                 "",
                                 "[[axis.members]]\nname = \"flange\"\nkind = \"bolts\"\nholds = "
                                 "\"motor\"\n" +
                                     pattern);
  const std::string belt = "idler_distance = \"80 mm\"";
  geared.replace(geared.find(belt),
                 belt.size(),
                 belt +
                     ", reduction = { ratio = 2, efficiency = 0.9, inertia = \"1e-6 kg.m2\", mass = \"0.2 kg\", shaft "
                     "= \"6.35 mm\" }");
  const MachineModel with_reduction(problem_of_text(geared), parts());
  const Design behind = design_of(
      with_reduction,
      {{"x", "drive", {{"GT3-9"}, {"G20-6.35"}, {"I20"}, {"M23", "D4"}}, {}}, {"x", "flange", {{"M6 8.8"}}, {}}});
  expect(behind, "flange", "C-BOLT-SLIP", 1.5, 0.15 * preload / (0.7 * g / 4.0 + 6.0));
}

TEST_CASE("The joint of a carriage bears what its carriage does, off the slide and along it") {
  const MachineModel model(problem_of_text(axis_text(
                               "horizontal",
                               "{ rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\" }",
                               "[[axis.members]]\nname = \"slide\"\nkind = \"bolts\"\nholds = \"guide\"\n" + pattern)),
                           parts());
  const Design d = design_of(model, {{"x", "guide", {{"R12"}}, {}}, {"x", "slide", {{"M6 8.8"}}, {}}});
  // Nothing stands off: each carriage bears a quarter of the weight.
  const double load = (20.0 + 4.0 * 0.05 + belt_allowance) * g / 4.0, preload = 0.75 * 20e-6 * 600e6;
  expect(d, "guide", "C-GD-STATIC", 2.0 * load, 5000.0);
  expect(d, "slide", "C-BOLT-SEP", 1.5, preload / (0.75 * load / 4.0));
  expect(d, "slide", "C-BOLT-SLIP", 1.5, 0.15 * (preload - 0.75 * load / 4.0) / (load / 4.0));
  for (const evaluation::PartLine& line : d.parts)
    if (line.slot == "slide") CHECK(line.quantity == 16.0);
}

TEST_CASE("Two joints, one behind the other, hold the same motor") {
  const auto text = [](const char* name) {
    return fmt::format("[[axis.members]]\nname = \"{}\"\nkind = \"bolts\"\nholds = \"motor\"\n{}", name, pattern);
  };
  const MachineModel model(problem_of_text(axis_text("horizontal", "", text("flange") + text("bracket"))), parts());
  const Design d = design_of(model, {});
  const auto slip = [&](const char* element) {
    for (const evaluation::Check& check : d.checks)
      if (check.element == element && check.id == "C-BOLT-SLIP") return check.limit;
    return 0.0;
  };
  CHECK(slip("flange") > 0.0);
  CHECK(slip("flange") == slip("bracket"));
}

// The search hands on no load of a motor that every screw bears; the report tells the load as it is.
TEST_CASE("A joint of a motor is refused by the search just when its checks fail") {
  std::size_t refused = 0, borne = 0, by_one_only = 0;
  for (double torque = 0.05; torque < 5.0; torque *= 1.1) {
    const MachineModel model(
        problem_of_text(axis_text("horizontal",
                                  "",
                                  "[[axis.members]]\nname = \"flange\"\nkind = \"bolts\"\nholds = \"motor\"\nlever_arm "
                                  "= \"40 mm\"\nedge_distance = \"6 mm\"\n" +
                                      pattern + fmt::format("tightening_torque = \"{:.6f} N.m\"\n", torque))),
        parts());
    const auto& drive = model.entries().at(0);
    const auto& flange = model.entries().at(1);
    REQUIRE(flange.element == "flange");
    const auto rows_of = [](const evaluation::StageEntry& entry, std::size_t slot) {
      return static_cast<solver::Row>(entry.tables()[slot].rows());
    };
    for (solver::Row motor = 0; motor < rows_of(drive, 1); ++motor) {
      std::size_t of_motor = 0;
      for (solver::Row screw = 0; screw < rows_of(flange, 0); ++screw) {
        solver::Build build;
        build.shared = {0};
        for (const evaluation::StageEntry& entry : model.entries()) {
          solver::StageChoice& choice = build.stages.emplace_back();
          choice.rows.assign(entry.tables().size(), 0);
          for (const auto& v : entry.as_stage().variables()) choice.variables.push_back(v.lower);
        }
        build.stages[0].rows[1] = motor;
        build.stages[1].rows[0] = screw;
        solver::Answer<double> answer;
        std::vector<double> state = model.problem().first_state;
        for (std::size_t i = 0; i < 2; ++i) {
          const solver::StageChoice& choice = build.stages[i];
          model.entries()[i].as_stage().evaluate({build.shared, state, choice.rows, choice.variables}, answer);
          state = answer.handed_on;
        }
        const bool accepted =
            std::all_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u <= 1.0; });
        const Design d = model.design(build);
        const bool holds = std::none_of(d.checks.begin(), d.checks.end(), [](const evaluation::Check& check) {
          return check.element == "flange" && check.verdict == evaluation::Verdict::violated;
        });
        INFO(torque << " N.m, motor " << motor << ", screw " << screw);
        CHECK(accepted == holds);
        of_motor += accepted ? 1 : 0;
      }
      borne += of_motor;
      refused += rows_of(flange, 0) - of_motor;
      by_one_only += of_motor == 1;
    }
  }
  CHECK(borne > 20);
  CHECK(refused > 20);
  CHECK(by_one_only > 3);
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

}  // namespace hand_worked_bolts_test
