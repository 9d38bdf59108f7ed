// SPDX-License-Identifier: Apache-2.0
// The keys of plates, portal frames, bolted joints, rotating shafts, bushings and cuts: where they arrive, what they
// are without being given, and what is said of wrong ones.
#include <cmath>

#include "machine/references.h"
#include "problem_text.h"

namespace structure_keys_test {

using namespace problem_text;
using machine::MemberKind;
using machine::SurfaceFinish;
using text::Severity;

namespace {

const std::string beam =
    "kind = \"beam\"\nlength = \"500 mm\"\nmaterial = \"S235JR\"\nsections = [\"steel_sections\"]\n";
const std::string plate =
    "kind = \"plate\"\nlength = \"300 mm\"\nmaterial = \"S235JR\"\nwidth = \"400 mm\"\nthickness = \"10 mm\"\n";
const std::string column =
    "kind = \"column\"\nlength = \"500 mm\"\nmaterial = \"S235JR\"\nsections = [\"steel_sections\"]\n";
const std::string weld =
    "kind = \"weld\"\nmaterial = \"S235JR\"\nleg = [\"2 mm\", \"5 mm\"]\njoint_width = \"20 mm\"\njoint_depth = \"20 "
    "mm\"\n"
    "lever_arm = \"60 mm\"\n";
const std::string portal =
    "kind = \"portal_frame\"\nlength = \"700 mm\"\nmaterial = \"Al 6063-T5\"\nheight = \"350 mm\"\nsections = "
    "[\"extrusions\"]\n";
const std::string shaft =
    "kind = \"shaft\"\nlength = \"300 mm\"\nmaterial = \"S235JR\"\ndiameter = [\"8 mm\", \"20 mm\"]\n";
const std::string bolts = "kind = \"bolts\"\nrow_spacing = \"60 mm\"\ncolumn_spacing = \"80 mm\"\n";
const std::string cut =
    "cutting = { material = \"aluminium\", depth = \"2 mm\", width = \"2 mm\", feed_per_tooth = \"0.05 mm\", teeth = "
    "2, "
    "diameter = \"6 mm\", cutting_speed = \"5.655 m/s\" }";
const std::string slow = "speed = \"20 mm/s\"\n";  // of axis y's move in the sound problem

machine::Problem sound_with(const std::string& old, const std::string& with) {
  const Outcome outcome = read(replaced(sound, old, with));
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  CHECK(outcome.diagnostics.count() == 0);
  return *outcome.problem;
}

machine::Member member(const std::string& keys) { return sound_with(beam, keys).axes[0].members[0]; }

void check_all(const std::vector<Case>& cases) {
  for (const Case& one : cases) check(one);
}

Approx near(double x) { return Approx(x).epsilon(1e-12); }

/// What is said of a member with these keys beside the shipped catalogues.
std::string said_of_references(const std::string& keys) {
  text::Diagnostics loading, diagnostics;
  static const auto catalogue = catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, loading);
  REQUIRE(loading.error_count() == 0);
  const bool good = machine::check_references(sound_with(beam, keys), catalogue, diagnostics);
  CHECK(good == (diagnostics.count() == 0));
  return text::format(diagnostics);
}

}  // namespace

TEST_CASE("Plates and portal frames are read") {
  const machine::Member table = member(plate);
  CHECK(table.kind == MemberKind::plate);
  CHECK(table.length == near(0.3));
  CHECK(table.plate_width == near(0.4));
  CHECK(table.thickness.lower == near(0.01));
  CHECK(table.thickness.fixed());
  const machine::Member frame = member(portal + "lateral_force = \"60 N\"\n");
  CHECK(frame.kind == MemberKind::portal_frame);
  CHECK(frame.length == near(0.7));
  CHECK(frame.column_height == near(0.35));
  CHECK(frame.sections == std::vector<std::string>{"extrusions"});
  CHECK(frame.end_fixity == 0.25);
  CHECK(member(portal + "end_fixity = 1\n").end_fixity == 1.0);
}

TEST_CASE("Rotating shafts and torques are read") {
  const machine::Member still = member(shaft);
  CHECK_FALSE(still.rotating);
  CHECK(still.surface == SurfaceFinish::machined);
  CHECK(still.notch_factor == 1.0);
  CHECK(still.torque == 0.0);
  const machine::Member turning =
      member(shaft + "rotating = true\nsurface = \"hot_rolled\"\nnotch_factor = 1.7\ntorque = \"250 N.cm\"\n");
  CHECK(turning.rotating);
  CHECK(turning.surface == SurfaceFinish::hot_rolled);
  CHECK(turning.notch_factor == 1.7);
  CHECK(turning.torque == near(2.5));
  CHECK(member(shaft + "rotating = true\nsurface = \"ground\"\n").surface == SurfaceFinish::ground);
  CHECK(member(shaft + "rotating = true\nsurface = \"forged\"\n").surface == SurfaceFinish::forged);
}

TEST_CASE("Bolted joints are read") {
  const machine::Member plain = member(bolts);
  CHECK(plain.kind == MemberKind::bolts);
  CHECK(plain.bolts.count() == 4.0);
  CHECK(plain.bolts.row_spacing == near(0.06));
  CHECK(plain.bolts.column_spacing == near(0.08));
  CHECK(plain.bolts.friction == 0.15);
  CHECK(plain.bolts.joint_constant == 0.25);
  CHECK_FALSE(plain.bolts.tightening_torque);
  CHECK_FALSE(plain.bolts.fitted);
  CHECK(plain.lever_arm == 0.0);
  const machine::Member full = member(
      "kind = \"bolts\"\nrows = 3\ncolumns = 1\nrow_spacing = \"60 mm\"\nedge_distance = \"2 cm\"\nlever_arm = \"0.1 "
      "m\"\n"
      "eccentricity = \"5 mm\"\npull_force = \"9 N\"\nfriction = 0.12\njoint_constant = 0.3\ntightening_torque = \"10 "
      "N.m\"\nnut_factor = 0.15\nfitted = true\nsizes = [\"M6\", \"M8\"]\nproperty_classes = \"8.8\"\n");
  CHECK(full.bolts.count() == 3.0);
  CHECK(full.bolts.edge_distance == near(0.02));
  CHECK(full.lever_arm == near(0.1));
  CHECK(full.bolts.eccentricity == near(0.005));
  CHECK(full.bolts.pull_force == near(9.0));
  CHECK(full.bolts.friction == 0.12);
  CHECK(full.bolts.joint_constant == 0.3);
  CHECK(full.bolts.tightening_torque.value() == near(10.0));
  CHECK(full.bolts.nut_factor == 0.15);
  CHECK(full.bolts.fitted);
  CHECK(full.bolts.sizes == std::vector<std::string>{"M6", "M8"});
  CHECK(full.bolts.property_classes == std::vector<std::string>{"8.8"});
}

// Axis x of the sound problem has one drive and a guide of four carriages, axis y none.
TEST_CASE("Joints of motors and carriages count themselves and take no load by hand") {
  CHECK(member(bolts).bolts.holds == machine::Held::burden);
  const machine::Member flange = member(bolts + "holds = \"motor\"\n");
  CHECK(flange.bolts.holds == machine::Held::motor);
  CHECK(flange.count == 1.0);
  const machine::Member slide = member(bolts + "holds = \"guide\"\n");
  CHECK(slide.bolts.holds == machine::Held::carriage);
  CHECK(slide.count == 4.0);
  CHECK(slide.rides);
  check_all({
      {beam, bolts + "holds = «\"gear\"»\n", "'holds' cannot be 'gear'", "motor"},
      {beam, bolts + "holds = \"motor\"\n«count» = 2\n", "count: there is a joint for each motor", "leave it out"},
      {beam, bolts + "holds = \"guide\"\n«count» = 4\n", "count: there is a joint for each carriage", "leave it out"},
      {beam,
       bolts + "holds = \"motor\"\n«load_share» = 0.5\n",
       "load_share: the joint bears its motor",
       "holds = \"axis\""},
      {beam, bolts + "holds = \"guide\"\n«rides» = true\n", "rides: that follows from what the joint holds", "leave"},
      {beam,
       bolts + "holds = \"guide\"\n«lever_arm» = \"0 mm\"\n",
       "lever_arm: the load of a carriage includes all moments",
       "holds = \"axis\""},
      {beam,
       "kind = \"bolts\"\nholds = \"motor\"\nrows = «1»\ncolumns = 1\n",
       "rows: a single screw cannot keep the motor from turning",
       "rows = 2"},
      {beam, plate + "«holds» = \"motor\"\n", "holds: this kind of member has none", "\"bolts\""},
  });
}

TEST_CASE("What bushings need is read") {
  const std::string spacing = "rail_spacing = \"250 mm\" }";
  const machine::GuideChoice usual = sound_with(spacing, spacing).axes[0].guide.value();
  CHECK_FALSE(usual.self_aligning);
  CHECK_FALSE(usual.drive_offset);
  CHECK_FALSE(usual.bushing_friction);
  const machine::GuideChoice given = sound_with(spacing,
                                                "rail_spacing = \"250 mm\", self_aligning = true, drive_offset = "
                                                "\"4 cm\", bushing_friction = 0.25 }")
                                         .axes[0]
                                         .guide.value();
  CHECK(given.self_aligning);
  CHECK(given.drive_offset.value() == near(0.04));
  CHECK(given.bushing_friction.value() == 0.25);
}

TEST_CASE("A cut sets force and speed of its move") {
  const auto move = [](const std::string& keys) { return sound_with(slow, keys + "\n").axes[1].moves[0]; };
  // 2 * 5.655 m/s / 6 mm = 1885 rad/s; two teeth of 0.05 mm a turn.
  const machine::Move side = move(cut);
  CHECK(side.speed.value() == near(0.05e-3 * 2.0 * 1885.0 / (2.0 * std::acos(-1.0))));
  // One tooth in the cut: the handbook's check value for these figures.
  CHECK(side.force == Approx(141.6358988).epsilon(1e-9));
  REQUIRE(side.cutting);
  CHECK(side.cutting->spindle_power == 0.0);
  // A slot with four teeth has two in the cut, at the full feed: 700 N/mm2 * 0.05^-0.25 * 2 mm * 0.05 mm each; the axis
  // along the tool gets 0.4 of it.
  const machine::Move slot = move(
      "cutting = { specific_force = \"700 N/mm^2\", exponent = 0.25, depth = \"2 mm\", width = \"6 mm\", "
      "feed_per_tooth "
      "= \"0.05 mm\", teeth = 4, diameter = \"6 mm\", cutting_speed = \"200 m/min\", force_ratio = 0.4, spindle_power "
      "= "
      "\"0.5 kW\" }");
  CHECK(slot.force == Approx(0.4 * 2.0 * 700.0 * std::pow(0.05, -0.25) * 2.0 * 0.05).epsilon(1e-12));
  CHECK(slot.cutting.value().spindle_power == near(500.0));
  CHECK(slot.cutting.value().cutting_speed == near(200.0 / 60.0));
  CHECK_FALSE(slot.time);
}

TEST_CASE("Groups of materials have the specific cutting force of the handbook") {
  const auto specific = [](const std::string& name) {
    return sound_with(slow, replaced(cut, "aluminium", name) + "\n").axes[1].moves[0].cutting.value();
  };
  CHECK(specific("unalloyed steel").unit_specific_force == 1700e6);
  CHECK(specific("alloy steel").unit_specific_force == 1950e6);
  CHECK(specific("stainless steel").unit_specific_force == 2000e6);
  CHECK(specific("stainless steel").exponent == 0.21);
  CHECK(specific("grey iron").unit_specific_force == 1100e6);
  CHECK(specific("grey iron").exponent == 0.28);
  CHECK(specific("brass").unit_specific_force == 700e6);
  CHECK(specific("plastic").unit_specific_force == 250e6);
  CHECK(specific("plastic").exponent == 0.20);
}

TEST_CASE("What is wrong in plates, portal frames and shafts is said at its place") {
  check_all({
      {beam, plate + "«thicknes» = \"1 mm\"\n", "unknown key 'thicknes'", "did you mean 'thickness'?"},
      {beam, plate + "«height» = \"1 mm\"\n", "height: this kind of member has none", "\"portal_frame\""},
      {beam, portal + "«width» = \"1 mm\"\n", "width: this kind of member has none", "\"bar\" or \"plate\""},
      {beam, portal + "«support» = \"fixed\"\n", "support: this kind of member has none", "clamped at its feet"},
      {beam, plate + "«torque» = \"1 N.m\"\n", "torque: this kind of member has none", "\"shaft\""},
      {beam, column + "«lateral_force» = \"1 N\"\n", "lateral_force: this kind of member has none", "\"portal_frame\""},
      {beam, weld + "«lateral_force» = \"1 N\"\n", "lateral_force: this kind of member has none", "\"bolts\""},
      {beam, beam + "«rotating» = true\n", "rotating: this kind of member has none", "\"shaft\""},
      {beam, replaced(portal, "\"extrusions\"", "«\"extrusion\"»"), "sections: 'extrusion' has none", "'extrusions'"},
      {beam, shaft + "«notch_factor» = 1.5\n", "notch_factor: counts only for a shaft that turns", "rotating = true"},
      {beam, shaft + "rotating = true\nnotch_factor = «0.5»\n", "notch_factor: 0.5 would make", "shoulder"},
      {beam,
       shaft + "rotating = true\nsurface = «\"grund\"»\n",
       "'surface' cannot be 'grund'",
       "did you mean 'ground'?"},
      {beam,
       replaced(shaft, "[\"8 mm\", \"20 mm\"]", "«[\"8 mm\", \"60 mm\"]»") + "rotating = true\n",
       "diameter: the fatigue of rotating shafts",
       "narrow the range"},
      {beam, shaft + "torque = \"5 «N»\"\n", "torque", ""},
      {beam, replaced(beam, "\"beam\"", "«\"portal\"»"), "'kind' cannot be 'portal'", "portal_frame"},
  });
}

TEST_CASE("What is wrong in a bolted joint is said at its place") {
  check_all({
      {beam, bolts + "«material» = \"S235JR\"\n", "material: screws have their own", "property_classes"},
      {beam, bolts + "«length» = \"1 m\"\n", "length: this kind of member has none", "\"beam\""},
      {beam, bolts + "«support» = \"fixed\"\n", "support: this kind of member has none", "hold by themselves"},
      {beam, bolts + "«end_fixity» = 2\n", "end_fixity: this kind of member has none", "\"column\""},
      {beam, beam + "«end_fixity» = 2\n", "end_fixity: this kind of member has none", "\"portal_frame\""},
      {beam, column + "end_fixity = «5»\n", "end_fixity: 5 is not between", "hinged"},
      {beam, column + "«support» = \"fixed\"\n", "support: this kind of member has none", "end_fixity"},
      {beam, beam + "«fitted» = true\n", "fitted: this kind of member has none", "\"bolts\""},
      {beam, bolts + "«nut_factor» = 0.15\n", "nut_factor: counts only with a tightening torque", "10 N.m"},
      {beam, bolts + "lever_arm = «\"100 mm\"»\n", "lever_arm: the load tilts the joint", "edge_distance"},
      {beam, "kind = \"bolts\"\nrows = «3»\ncolumns = 1\n", "rows: 3 rows need their distance", "row_spacing"},
      {beam,
       "kind = \"bolts\"\nrows = 1\ncolumns = 1\neccentricity = «\"10 mm\"»\n",
       "eccentricity: a single screw",
       "add rows"},
      {beam, bolts + "rows = «0»\n", "rows: a whole number from 1 to 20", ""},
      {beam, bolts + "joint_constant = «1.5»\n", "joint_constant: a share is at most 1", ""},
      {beam, bolts + "friction = «0.6»\n", "friction: 0.6 is unusually high", "0.15 dry", Severity::warning},
      {beam, bolts + "«size» = \"M6\"\n", "unknown key 'size'", "did you mean 'sizes'?"},
  });
}

TEST_CASE("What is wrong in bushings and cuts is said at its place") {
  const std::string spacing = "rail_spacing = \"250 mm\" }";
  check_all({
      {spacing,
       "rail_spacing = \"250 mm\", «bushing_friction» = 0.1 }",
       "bushing_friction: tells whether bushings jam",
       "drive_offset"},
      {spacing,
       "rail_spacing = \"250 mm\", drive_offset = \"1 mm\", bushing_friction = «0.8» }",
       "bushing_friction: 0.8 is unusually high",
       "plain polymer",
       Severity::warning},
      {slow, cut + "\n«force» = \"1 N\"\n", "force: the cut gives the force already", "leave out"},
      {slow, cut + "\n«speed» = \"1 mm/s\"\n", "speed: the feed of the cut", "feed_per_tooth"},
      {slow, replaced(cut, "\"aluminium\"", "«\"alumnium\"»") + "\n", "'material' cannot be 'alumnium'", "'aluminium'"},
      {slow, replaced(cut, "width = \"2 mm\"", "width = «\"7 mm\"»") + "\n", "width: a cutter of 6 mm", "full slot"},
      {slow, replaced(replaced(cut, " teeth = 2,", ""), "{", "«»{") + "\n", "needs the key 'teeth'", "teeth = 2"},
      {slow,
       replaced(cut, "material", "specific_force = \"1 GPa\", «material»") + "\n",
       "material: the specific force is given as well",
       "leave one out"},
      {slow, replaced(cut, "teeth = 2", "teeth = 2, «exponent» = 0.3") + "\n", "exponent: a material has its own", ""},
      {slow, "acceleration_time = \"9 s\"\n" + replaced(cut, "{", "«»{") + "\n", "speed: 30", "acceleration_time"},
  });
}

TEST_CASE("A bolted joint needs no material, and its screws must be in the catalogues") {
  const auto said = [](const std::string& keys) { return said_of_references(bolts + keys); };
  CHECK(said("").empty());
  CHECK(said("sizes = [\"M6\", \"M8\"]\nproperty_classes = [\"8.8\", \"A2-70\"]\n").empty());
  const std::string size = said("sizes = [\"M6\", \"m8\"]\n");
  CHECK(size.find("axis 'x', beam: sizes: no screw 'm8' in the catalogues") != std::string::npos);
  CHECK(size.find("did you mean 'M8'?") != std::string::npos);
  CHECK(said("property_classes = \"8.9\"\n").find("property_classes: no screw '8.9'") != std::string::npos);
}

TEST_CASE("A material that contradicts the sections cut of it is an error") {
  const auto said = said_of_references;
  const std::string both = replaced(beam, "\"steel_sections\"", "\"steel_sections\", \"extrusions\"");
  CHECK(said(both).empty());
  CHECK(said(portal).empty());
  CHECK(said(plate).empty());
  CHECK(said(replaced(portal, "Al 6063-T5", "S235JR")).find("extrusions are not of 'S235JR' (steel)") !=
        std::string::npos);
  for (const std::string& keys : {beam, both}) {
    const std::string aluminium = said(replaced(keys, "S235JR", "Al 6061-T6"));
    CHECK(aluminium.find("axis 'x', beam: steel_sections are not of 'Al 6061-T6' (aluminium)") != std::string::npos);
    CHECK(aluminium.find("name the grade of steel") != std::string::npos);
  }
}

}  // namespace structure_keys_test
