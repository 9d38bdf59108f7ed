// SPDX-License-Identifier: Apache-2.0
// Designs that leave the range in which a formula is stated: listed, and judged as before.
#include "hand_worked.h"

namespace outside_validity_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::OutsideValidity;

namespace {

Design with_member(const std::string& text, const std::vector<double>& variables) {
  const std::string member = "[[axis.members]]\nmaterial = \"steel\"\nname = \"part\"\n" + text;
  const MachineModel model(problem_of_text(axis_text("horizontal", "", member)), parts());
  return design_of(model, {{"x", "part", {}, variables}});
}

Design with_bar(double length, double width, double height, const std::string& more = {}) {
  return with_member(fmt::format("kind = \"bar\"\nlength = \"{} mm\"\nwidth = [\"10 mm\", \"80 mm\"]\n"
                                 "height = [\"10 mm\", \"80 mm\"]\n{}",
                                 length,
                                 more),
                     {1e-3 * width, 1e-3 * height});
}

/// Formula and sentence of each finding.
std::vector<std::pair<std::string, std::string>> findings(const Design& design) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const OutsideValidity& line : design.outside_validity) result.emplace_back(line.formula, line.sentence);
  return result;
}
using Findings = std::vector<std::pair<std::string, std::string>>;

const Findings stubby{{"beam.span_to_height", "it does not hold that length >= 8·height"}};

}  // namespace

// 8 times 30 mm is 240 mm.
TEST_CASE("A stubby beam is listed, and fails nothing by that") {
  const Design slender = with_bar(250, 30, 30);
  CHECK(findings(slender).empty());
  CHECK(slender.formulas_watched > 0);
  const Design design = with_bar(230, 30, 30);
  REQUIRE(findings(design) == stubby);
  const OutsideValidity& line = design.outside_validity.front();
  CHECK(line.axis == "x");
  CHECK(line.element == "part");
  CHECK(line.constraint.empty());  // the deflection serves several checks
  CHECK(line.title == "Span over height of a beam");
  CHECK(line.source == "shigley, Table A-9");
  REQUIRE(line.values.size() == 2);
  CHECK(line.values[0].name == "length");
  CHECK(line.values[0].numbers == std::vector<double>{0.23});
  CHECK(line.values[1].name == "height");
  CHECK(line.values[1].numbers == std::vector<double>{0.03});
  for (const evaluation::Check& check : design.checks)
    if (check.element == "part") CHECK(check.verdict == evaluation::Verdict::satisfied);
}

TEST_CASE("Sideways a beam is judged by its width, and only where something bends it sideways") {
  CHECK(findings(with_bar(250, 40, 20)).empty());
  CHECK(findings(with_bar(250, 40, 20, "lateral_force = \"40 N\"\n")) == stubby);
  CHECK(findings(with_bar(250, 40, 40, "lateral_force = \"40 N\"\n")) == stubby);  // both ways: said once
}

// 10 N.m with a nut factor of 0.2 preload an M8 screw by 10/(0.2·0.008) = 6250 N; three quarters of what pulls at each
// of the four screws unload the joint: 0.75 · 32000/4 = 6000 N leaves it closed, 0.75 · 36000/4 = 6750 N opens it.
TEST_CASE("A range that one check leaves is listed with the check") {
  const auto joint = [](const std::string& pull) {
    return design_of(MachineModel(problem_of_text(axis_text("horizontal",
                                                            "",
                                                            "[[axis.members]]\nname = \"flange\"\nkind = \"bolts\"\n"
                                                            "row_spacing = \"80 mm\"\ncolumn_spacing = \"60 mm\"\n"
                                                            "tightening_torque = \"10 N.m\"\npull_force = \"" +
                                                                pull + "\"\n")),
                                  parts()),
                     {{"x", "flange", {{"M8 8.8"}}, {}}});
  };
  CHECK(findings(joint("32 kN")).empty());
  const Design open = joint("36 kN");
  REQUIRE(findings(open) ==
          Findings{{"bolt.slip_safety", "it does not hold that (1 - joint_constant)·external_tension <= preload"}});
  CHECK(open.outside_validity.front().constraint == "C-BOLT-SLIP");
  CHECK(open.outside_validity.front().element == "flange");
}

// The effective friction of a thread is good up to 20 degrees: tan λ = l / (π d_m).
TEST_CASE("A steep thread is listed, although its efficiency comes from a table") {
  const TinyCatalogue tiny({}, {"lead_screws", "lead_nuts"});
  const char* const said = ",USD,test,computed,test,high\n";
  const auto drive = [&](double starts, double lead) {
    TemporaryFolder folder;
    folder.write("lead_screws/steep.csv",
                 fmt::format("manufacturer,part_number,designation,thread_form,major_diameter [mm],pitch [mm],starts "
                             "[1],lead [mm],pitch_diameter [mm],minor_diameter [mm],flank_half_angle "
                             "[deg],yield_strength [MPa],lead_error_per_300mm [um],maximum_length "
                             "[mm],screw_mass_per_length [kg/m],price_per_length [1/m],currency,price_basis,evidence,"
                             "source,confidence\ntiny,S,S,trapezoidal 30deg,8,2,{},{},7,5.5,15,400,50,2000,0.25,10{}",
                             starts,
                             lead,
                             said));
    folder.write("lead_nuts/steep.csv",
                 fmt::format("manufacturer,part_number,for_screw,nominal_diameter [mm],lead [mm],material,length "
                             "[mm],allowable_pressure [MPa],maximum_pv [MPa.m/s],maximum_sliding_speed "
                             "[m/s],friction_dry [1],friction_greased [1],backlash [mm],preload_drag_torque "
                             "[N.m],mass [kg],price,currency,price_basis,evidence,source,confidence\n"
                             "tiny,N,S,8,{},bronze CuSn8,20,10,2,0.5,0.2,0.1,0.05,0,0.1,4{}",
                             lead,
                             said));
    const catalogue::Catalogue catalogue = catalogue_of({tiny.path(), folder.path()});
    const MachineModel model(problem_of_text(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "5 kg"
mechanism = { kind = "screw", screw = ["lead_screws"] }
[[axis.moves]]
distance = "200 mm"
time = "8 s"
)"),
                             catalogue);
    return design_of(model, {});
  };
  CHECK(findings(drive(3, 6)).empty());  // atan(6 / 21.99) = 15.3 degrees
  const Design steep = drive(6, 12);     // 28.6 degrees
  CHECK(findings(steep) ==
        Findings{{"power_screw.exact_friction_ratio", "it does not hold that lead angle < 20 degrees"}});
}

}  // namespace outside_validity_test
