// SPDX-License-Identifier: Apache-2.0
// Faults sown into sound rows are found, and sound rows are left alone.
#include "catalogue/lint.h"

#include <fmt/format.h>

#include <map>

#include "catalogue/read_table.h"
#include "catch.h"
#include "temporary_folder.h"

namespace lint_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

using Cells = std::map<std::string, std::string>;

/// A sound row of each family, all in declared units; figures from data sheets and standards.
Cells sound(Family family) {
  switch (family) {
    case Family::steppers:
      return {{"frame", "NEMA23"},
              {"frame_size [mm]", "57"},
              {"body_length [mm]", "76"},
              {"shaft_diameter [mm]", "6.35"},
              {"step_angle [deg]", "1.8"},
              {"holding_torque [N.m]", "1.89"},
              {"detent_torque [N.m]", "0.066"},
              {"rated_current [A]", "2.8"},
              {"phase_resistance [ohm]", "1.13"},
              {"phase_inductance [mH]", "3.6"},
              {"rotor_inertia [g.cm2]", "480"},
              {"mass [kg]", "1.0"}};
    case Family::ball_screws:
      return {{"nominal_diameter [mm]", "16"},
              {"outside_diameter [mm]", "16"},
              {"lead [mm]", "5"},
              {"starts [1]", "1"},
              {"root_diameter [mm]", "13.36"},
              {"dynamic_load_rating [N]", "7649"},
              {"static_load_rating [N]", "17554"},
              {"nut_outside_diameter [mm]", "28"},
              {"nut_length [mm]", "50"},
              {"nut_mass [kg]", "0.22"},
              {"screw_mass_per_length [kg/m]", "1.329"},
              {"lead_error_per_300mm [um]", "50"},
              {"maximum_length [mm]", "3000"},
              {"dn_limit [mm.rpm]", "50000"}};
    case Family::lead_screws:
      return {{"designation", "Tr16x4"},
              {"thread_form", "trapezoidal 30deg"},
              {"major_diameter [mm]", "16"},
              {"pitch [mm]", "4"},
              {"starts [1]", "1"},
              {"lead [mm]", "4"},
              {"pitch_diameter [mm]", "14"},
              {"minor_diameter [mm]", "11.5"},
              {"nut_major_diameter [mm]", "16.5"},
              {"flank_half_angle [deg]", "15"},
              {"lead_angle [deg]", "5.197"},
              {"material", "C45"},
              {"yield_strength [MPa]", "430"},
              {"screw_mass_per_length [kg/m]", "1.2084"},
              {"lead_error_per_300mm [um]", "100"},
              {"maximum_length [mm]", "3000"}};
    case Family::couplings:
      return {{"outside_diameter [mm]", "30"},
              {"length [mm]", "35"},
              {"minimum_bore [mm]", "4"},
              {"maximum_bore [mm]", "16"},
              {"rated_torque [N.m]", "12.5"},
              {"maximum_torque [N.m]", "25"},
              {"torsional_stiffness [N.m/rad]", "171.9"},
              {"inertia [g.cm2]", "55.7"},
              {"mass [kg]", "0.0445"}};
    case Family::drivers:
      return {{"minimum_voltage [V]", "20"},
              {"maximum_voltage [V]", "50"},
              {"recommended_maximum_voltage [V]", "48"},
              {"rms_current [A]", "4"},
              {"peak_current [A]", "5.6"},
              {"maximum_microsteps [1]", "128"},
              {"mass [kg]", "0.27"}};
    case Family::power_supplies:
      return {{"output_voltage [V]", "48"},
              {"output_current [A]", "7.3"},
              {"power [W]", "350.4"},
              {"efficiency [%]", "89"},
              {"mass [kg]", "0.76"}};
    case Family::linear_guides:
      return {{"kind", "profile rail"},
              {"size [mm]", "20"},
              {"block_length [mm]", "77.5"},
              {"block_width [mm]", "44"},
              {"assembly_height [mm]", "30"},
              {"rail_width [mm]", "20"},
              {"rail_height [mm]", "17.5"},
              {"dynamic_load_rating [N]", "17750"},
              {"static_load_rating [N]", "27760"},
              {"rating_distance [km]", "50"},
              {"roll_moment_rating [N.m]", "270"},
              {"carriage_mass [kg]", "0.3"},
              {"rail_mass_per_length [kg/m]", "2.21"},
              {"friction_coefficient [1]", "0.004"},
              {"maximum_rail_length [mm]", "4000"}};
    case Family::pulleys:
      return {{"type", "pulley"},
              {"profile", "GT2"},
              {"pitch [mm]", "2"},
              {"teeth [1]", "20"},
              {"belt_width [mm]", "6"},
              {"bore [mm]", "5"},
              {"pitch_diameter [mm]", "12.732"},
              {"outside_diameter [mm]", "12.224"},
              {"mass [kg]", "0.0044"},
              {"overall_width [mm]", "16"},
              {"inertia [g.cm2]", "0.967"}};
    case Family::racks:  // module 2 in a bar of 20 mm by 20 mm: 20 (20 - 2.12) mm2 of steel, 160 teeth
      return {{"module [mm]", "2"},
              {"pressure_angle [deg]", "20"},
              {"pitch [mm]", "6.2832"},
              {"face_width [mm]", "20"},
              {"height [mm]", "20"},
              {"pitch_height [mm]", "18"},
              {"material", "C45"},
              {"allowable_stress [MPa]", "190"},
              {"mass_per_length [kg/m]", "2.81"},
              {"pitch_error_per_1000mm [um]", "150"},
              {"piece_length [mm]", "1005.31"}};
    case Family::pinions:  // steel ring 40/14, 20 mm wide: 0.173 kg and 388 g.cm2; outside 44
      return {{"module [mm]", "2"},
              {"pressure_angle [deg]", "20"},
              {"teeth [1]", "20"},
              {"face_width [mm]", "20"},
              {"bore [mm]", "14"},
              {"pitch_diameter [mm]", "40"},
              {"outside_diameter [mm]", "44"},
              {"material", "C45"},
              {"allowable_stress [MPa]", "190"},
              {"mass [kg]", "0.173"},
              {"inertia [g.cm2]", "388"}};
    case Family::screws:
      return {{"designation", "M8"},
              {"nominal_diameter [mm]", "8"},
              {"pitch [mm]", "1.25"},
              {"property_class", "8.8"},
              {"tensile_stress_area [mm2]", "36.61"},
              {"tensile_strength [MPa]", "800"},
              {"yield_strength [MPa]", "640"},
              {"proof_strength [MPa]", "580"},
              {"proof_load [N]", "21233"},
              {"maximum_preload [N]", "15925"},
              {"tightening_torque [N.m]", "24.683"}};
    case Family::steel_sections:
      return {{"kind", "rectangular hollow"},
              {"height [mm]", "100"},
              {"width [mm]", "50"},
              {"area [mm2]", "841"},
              {"mass_per_length [kg/m]", "6.6"},
              {"second_moment_x [mm4]", "1060000"},
              {"second_moment_y [mm4]", "361000"},
              {"section_modulus_x [mm3]", "21300"},
              {"section_modulus_y [mm3]", "14400"},
              {"material", "S235JR"},
              {"elastic_modulus [MPa]", "206000"}};
    case Family::materials:
      return {{"class", "steel"},
              {"elastic_modulus [MPa]", "206000"},
              {"shear_modulus [MPa]", "79231"},
              {"poisson_ratio [1]", "0.3"},
              {"density [kg/m3]", "7850"},
              {"yield_strength [MPa]", "355"},
              {"ultimate_strength [MPa]", "470"},
              {"shear_yield_strength [MPa]", "205"},
              {"thermal_expansion [1/K]", "1.2e-5"}};
    default:
      return {};
  }
}

/// The diagnostics of linting one row, with the cells of `faults` (and header cells, if renamed) put in place.
text::Diagnostics lint_row(Family family, const Cells& faults, const std::string& waiver = "") {
  Cells cells = sound(family);
  for (const auto& [name, value] : faults) {
    std::erase_if(cells, [&, key = name](const auto& cell) {
      return cell.first.substr(0, cell.first.find(" [")) == key.substr(0, key.find(" ["));
    });
    cells[name] = value;
  }
  const FamilyDeclaration& sold = declaration(family);
  if (sold.priced_per_piece) cells.try_emplace("price", family == Family::screws ? "0.15" : "10");
  if (sold.priced_per_length) cells.try_emplace("price_per_length [1/m]", "10");
  if (sold.priced_per_mass) cells.try_emplace("price_per_mass [1/kg]", "2");
  cells["currency"] = "USD";
  cells["source"] = "maker";
  cells["confidence"] = "high";
  cells["waiver"] = waiver;
  std::string header = "manufacturer,part_number", row = "Acme,P1";
  for (const auto& [name, value] : cells) {
    header += "," + name;
    row += "," + value;
  }
  text::Diagnostics diagnostics;
  const Table table =
      read_table(text::SourceText::from_string("x.csv", header + "\n" + row + "\n"), family, 0, diagnostics);
  lint(table, diagnostics);
  return diagnostics;
}

bool mentions(const text::Diagnostics& diagnostics, const std::string& rule) {
  for (const text::Diagnostic& each : diagnostics.all()) {
    const std::size_t rules = each.message.rfind('[');
    if (rules == std::string::npos) continue;
    const std::string list = each.message.substr(rules + 1, each.message.size() - rules - 2) + ",";
    if ((" " + list).find(" " + rule + ",") != std::string::npos) return true;
  }
  return false;
}

struct Fault {
  Family family;
  std::string cell;
  std::string value;
  std::string rule;
  bool impossible;
};

}  // namespace

TEST_CASE("sound rows raise no doubt") {
  for (const FamilyDeclaration& each : families) {
    if (sound(each.family).empty()) continue;
    const text::Diagnostics diagnostics = lint_row(each.family, {});
    INFO(each.name << "\n" << text::format(diagnostics));
    CHECK(diagnostics.count() == 0);
  }
}

TEST_CASE("faults sown one at a time are found") {
  const std::vector<Fault> faults = {
      {Family::steppers, "phase_inductance [mH]", "36", "torque-constant", false},
      {Family::steppers, "phase_inductance [H]", "3.6", "magnitude", true},
      {Family::steppers, "phase_inductance [uH]", "3.6", "magnitude", true},
      {Family::steppers, "holding_torque [N.m]", "189", "magnitude", true},
      {Family::steppers, "holding_torque [N.m]", "18.9", "holding-torque", true},
      {Family::steppers, "rotor_inertia [kg.cm2]", "480", "magnitude", true},
      {Family::steppers, "rotor_inertia [g.cm2]", "4800", "rotor-inertia", true},
      {Family::steppers, "rotor_inertia [g.cm2]", "48", "rotor-inertia", false},
      {Family::steppers, "detent_torque [N.m]", "2.5", "detent-torque", true},
      {Family::steppers, "step_angle [deg]", "1.7", "step-angle", true},
      {Family::steppers, "step_angle [deg]", "7.5", "step-angle", false},
      {Family::steppers, "mass [g]", "1", "magnitude", true},
      {Family::steppers, "mass [kg]", "10", "motor-mass", true},
      {Family::steppers, "frame_size [mm]", "42.3", "frame-size", false},
      {Family::steppers, "phase_resistance [ohm]", "113", "copper-loss", true},
      {Family::steppers, "mass [kg]", "", "missing", false},
      {Family::ball_screws, "root_diameter [mm]", "16", "root-diameter", true},
      {Family::ball_screws, "static_load_rating [N]", "1755.4", "load-ratings", true},
      {Family::ball_screws, "static_load_rating [N]", "7000", "load-ratings", false},
      {Family::ball_screws, "screw_mass_per_length [kg/m]", "13.29", "screw-mass", true},
      {Family::ball_screws, "nut_mass [kg]", "22", "nut-mass", true},
      {Family::ball_screws, "dynamic_load_rating [kgf]", "7649000", "magnitude", true},
      {Family::lead_screws, "minor_diameter [mm]", "14.5", "root-diameter", true},
      {Family::lead_screws, "lead [mm]", "8", "lead-starts", true},
      {Family::lead_screws, "lead_angle [deg]", "2.6", "lead-angle", true},
      {Family::lead_screws, "flank_half_angle [deg]", "30", "flank-angle", true},
      {Family::couplings, "maximum_bore [mm]", "31", "bore", true},
      {Family::couplings, "maximum_torque [N.m]", "10", "maximum-torque", true},
      {Family::couplings, "inertia [kg.m2]", "5.57e-5", "inertia", true},
      {Family::couplings, "torsional_stiffness [N.m/rad]", "3", "stiffness", true},
      {Family::drivers, "rms_current [A]", "6", "rms-current", true},
      {Family::drivers, "minimum_voltage [V]", "60", "voltage-range", true},
      {Family::power_supplies, "power [W]", "35.04", "supply-power", true},
      {Family::power_supplies, "power [W]", "370", "supply-power", false},
      {Family::linear_guides, "rating_distance [km]", "75", "rating-distance", true},
      {Family::linear_guides, "static_load_rating [N]", "2776", "load-ratings", true},
      {Family::linear_guides, "carriage_mass [kg]", "3", "carriage-mass", true},
      {Family::linear_guides, "roll_moment_rating [N.m]", "27000", "moment-rating", true},
      {Family::pulleys, "pitch_diameter [mm]", "14", "pitch-diameter", true},
      {Family::pulleys, "bore [mm]", "13", "bore", true},
      {Family::pulleys, "inertia [g.cm2]", "9.67", "inertia", true},
      {Family::racks, "pitch [mm]", "6", "tooth-pitch", true},
      {Family::racks, "pitch_height [mm]", "20", "pitch-line", true},
      {Family::racks, "height [mm]", "4", "root-geometry", true},
      {Family::racks, "face_width [mm]", "4", "face-width", false},
      {Family::racks, "face_width [mm]", "30", "rack-mass", false},
      {Family::racks, "mass_per_length [kg/m]", "28.1", "rack-mass", true},
      {Family::racks, "piece_length [mm]", "1000", "piece-length", false},
      {Family::racks, "module [in]", "2", "magnitude", true},
      {Family::pinions, "teeth [1]", "20.5", "teeth", true},
      {Family::pinions, "pitch_diameter [mm]", "44", "pitch-diameter", true},
      {Family::pinions, "outside_diameter [mm]", "40", "outside-diameter", false},
      {Family::pinions, "bore [mm]", "35", "root-geometry", true},
      {Family::pinions, "bore [mm]", "32", "root-geometry", false},
      {Family::pinions, "mass [kg]", "0.0173", "inertia", true},
      {Family::pinions, "inertia [kg.m2]", "0.000388", "inertia", true},
      {Family::screws, "tensile_stress_area [mm2]", "50.3", "stress-area", true},
      {Family::screws, "proof_strength [MPa]", "680", "strength-order", true},
      {Family::screws, "maximum_preload [N]", "22000", "preload", true},
      {Family::steel_sections, "second_moment_x [mm4]", "180000", "strong-axis", false},
      {Family::steel_sections, "section_modulus_x [cm3]", "213", "section-modulus", true},
      {Family::steel_sections, "mass_per_length [kg/m]", "66", "section-mass", true},
      {Family::materials, "shear_modulus [MPa]", "179231", "shear-modulus", true},
      {Family::materials, "elastic_modulus [GPa]", "20.6", "material-class", true},
      {Family::materials, "yield_strength [MPa]", "500", "strength-order", true},
      {Family::materials, "density [kg/m3]", "2700", "material-class", true},
  };
  for (const Fault& each : faults) {
    const text::Diagnostics diagnostics = lint_row(each.family, {{each.cell, each.value}});
    INFO(declaration(each.family).name << " " << each.cell << " = " << each.value << "\n" << text::format(diagnostics));
    CHECK(mentions(diagnostics, each.rule));
    CHECK((!each.impossible || diagnostics.has_errors()));
  }
}

TEST_CASE("a thousandfold error is named") {
  const text::Diagnostics diagnostics = lint_row(Family::steppers, {{"phase_inductance [H]", "3.6"}});
  CHECK(diagnostics.all().front().hint.find("uH read as mH") != std::string::npos);
  const text::Diagnostics supply = lint_row(Family::power_supplies, {{"power [W]", "35.04"}});
  CHECK(supply.all().front().message.find("10 times too small") != std::string::npos);
}

TEST_CASE("figures at the ends of what a number can be are doubted like others") {
  const text::Diagnostics huge = lint_row(Family::couplings,
                                          {{"maximum_bore [mm]", "1e300"},
                                           {"minimum_bore [mm]", "1e200"},
                                           {"torsional_stiffness [N.m/rad]", "1e-150"},
                                           {"mass [kg]", "1e-300"},
                                           {"price", "1e150"}});
  CHECK(huge.has_errors());
  CHECK(lint_row(Family::couplings, {{"mass [kg]", "1e-310"}}).has_errors());
  CHECK(lint_row(Family::couplings, {{"outside_diameter [mm]", "1e300"}, {"length [mm]", "1e300"}}).has_errors());
}

TEST_CASE("a waiver with a reason excuses a row from one rule") {
  CHECK(lint_row(Family::steppers, {{"step_angle [deg]", "7.5"}}, "step-angle: a tin-can motor").count() == 0);
  const text::Diagnostics other = lint_row(Family::steppers, {{"step_angle [deg]", "7.5"}}, "motor-mass: hollow");
  CHECK(other.warning_count() == 2);  // the step angle, and a waiver that nothing needs
  CHECK(text::format(other).find("waiver of motor-mass that this row does not need") != std::string::npos);
}

TEST_CASE("a waiver takes a relation out of the judgement of its row") {
  const Cells heavy = {{"mass [kg]", "2.9"}};
  const text::Diagnostics doubted = lint_row(Family::steppers, heavy);
  REQUIRE(mentions(doubted, "motor-mass"));
  const text::Diagnostics excused =
      lint_row(Family::steppers, heavy, "motor-mass: with brake; torque-mass: with brake; inertia-mass: with brake");
  INFO(text::format(excused));
  CHECK_FALSE(mentions(excused, "motor-mass"));
  CHECK_FALSE(excused.has_errors());
}

TEST_CASE("waivers need a rule that exists, and a reason") {
  const text::Diagnostics misspelt = lint_row(Family::steppers, {{"step_angle [deg]", "7.5"}}, "step-angel: tin can");
  REQUIRE(misspelt.error_count() == 1);
  CHECK(text::format(misspelt).find("did you mean 'step-angle'?") != std::string::npos);
  for (const std::string waiver : {"step-angle", "step-angle:", "step-angle:  "}) {
    const text::Diagnostics unfounded = lint_row(Family::steppers, {{"step_angle [deg]", "7.5"}}, waiver);
    CHECK(text::format(unfounded).find("waiver of step-angle without a reason") != std::string::npos);
    CHECK(mentions(unfounded, "step-angle"));
  }
}

TEST_CASE("what is wrong is told apart by the other figures of the row") {
  // QSH5718-76-28-189 with one figure changed; each time two relations are off, and the one they share is to blame.
  const auto blamed = [](const std::string& cell, const std::string& value) {
    const text::Diagnostics found = lint_row(Family::steppers, {{cell, value}});
    REQUIRE(found.count() == 1);
    return found.all().front();
  };
  const text::Diagnostic inductance = blamed("phase_inductance [mH]", "36");
  CHECK(inductance.message.find("P1: phase_inductance 36 mH is ") == 0);
  CHECK(inductance.message.find("[time-constant, torque-constant, torque-energy]") != std::string::npos);
  CHECK(inductance.hint.find("decimal point") == 0);
  CHECK(inductance.hint.find("certainty ") != std::string::npos);
  CHECK(blamed("phase_resistance [ohm]", "11.3").message.find("P1: phase_resistance 11.3 ohm is ") == 0);
  CHECK(blamed("rated_current [A]", "28").message.find("P1: rated_current 28 A is ") == 0);
  CHECK(blamed("holding_torque [N.m]", "18.9").message.find("P1: holding_torque 18.9 N.m is ") == 0);
  CHECK(blamed("holding_torque [N.m]", "189").hint.find("N.cm read as N.m?") == 0);
  CHECK(blamed("holding_torque [N.m]", "267.6").hint.find("oz.in read as N.m?") == 0);  // 1.89 N.m = 267.6 oz.in
  CHECK(blamed("rotor_inertia [g.cm2]", "0.48").hint.find("kg.cm2 read as g.cm2?") == 0);
  CHECK(blamed("mass [kg]", "1000").hint.find("g read as kg?") == 0);
}

TEST_CASE("figures in the wrong columns are seen as swapped") {
  const text::Diagnostics found =
      lint_row(Family::ball_screws, {{"dynamic_load_rating [N]", "17554"}, {"static_load_rating [N]", "7649"}});
  INFO(text::format(found));
  CHECK(mentions(found, "load-ratings"));
  const text::Diagnostics axes =
      lint_row(Family::steel_sections, {{"second_moment_x [mm4]", "361000"}, {"second_moment_y [mm4]", "1060000"}});
  CHECK(mentions(axes, "strong-axis"));
}

TEST_CASE("a part number that says its size must not say another") {
  CHECK(mentions(lint_row(Family::lead_screws, {{"designation", "Tr18x4"}}), "designation"));
  CHECK(mentions(lint_row(Family::lead_screws, {{"designation", "Tr16x8(P4)"}}), "designation"));
  CHECK(mentions(lint_row(Family::screws, {{"designation", "M10"}}), "designation"));
  CHECK_FALSE(mentions(lint_row(Family::screws, {{"designation", "M8x1.25"}}), "designation"));
}

TEST_CASE("holding torque is stated with one phase on or two") {
  CHECK(lint_row(Family::steppers, {{"phases_on [1]", "1"}}).count() == 0);
  CHECK(mentions(lint_row(Family::steppers, {{"phases_on [1]", "1.5"}}), "phases-on"));
}

TEST_CASE("a torque curve that rises is doubted at the point") {
  text::Diagnostics diagnostics;
  const Table table =
      read_table(text::SourceText::from_string(
                     "x.csv",
                     "manufacturer,part_number,current_kind,drive_voltage [V],phase_current [A],speed [rpm],torque "
                     "[N.m],source,confidence\n"
                     "A,M,rms,24,2,240,0.9,s,high\nA,M,rms,24,2,60,0.5,s,high\nA,M,rms,48,2,300,1,s,high\n"),
                 Family::stepper_curves,
                 0,
                 diagnostics);
  lint(table, diagnostics);
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(diagnostics.all().front().where.line == 2);
}

TEST_CASE("lint reads files, tells the family, and finds duplicates across files") {
  const TemporaryFolder folder;
  const std::string header =
      "manufacturer,part_number,output_voltage [V],output_current [A],power [W],price,currency\n";
  const auto a = folder.write("a.csv", header + "A,P1,48,7.3,350.4,30,USD\n");
  const auto b = folder.write("b.csv", header + "A,P1,48,7.3,350.4,30,USD\nA,P2,48,7.3,3.5,30,USD\n");
  text::Diagnostics diagnostics;
  const LintSummary summary = lint_files({a, b, folder.path() / "none.csv"}, std::nullopt, diagnostics);
  INFO(text::format(diagnostics));
  CHECK(summary.files == 2);
  CHECK(summary.rows == 2);
  CHECK(summary.errors == 3);  // the duplicate, the power, the file that is not there
  CHECK(mentions(diagnostics, "supply-power"));
}

}  // namespace lint_test
