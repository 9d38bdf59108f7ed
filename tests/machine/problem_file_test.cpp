// SPDX-License-Identifier: Apache-2.0
// What is read from sound problem files: every key once against values worked out by hand, the same as JSON, the
// defaults, --set, and the shipped machines.
#include <cmath>
#include <filesystem>
#include <set>

#include "machine/quantity_reader.h"
#include "problem_text.h"
#include "scalar/unit.h"

namespace problem_file_test {

using namespace problem_text;
using machine::Axis;
using machine::Problem;
using machine::Requirement;

namespace {

const std::string maximal_toml = R"(title = "Everything"
source = "nowhere"
catalogues = ["parts", "more-parts"]
[objective]
minimise = "mass"
[currency]
EUR = { rate = 1, date = 2026-01-15 }
USD = { rate = 0.925, date = "2026-02-28" }
GBP = 1.15
[supply]
voltage = ["24 V", "0.048 kV"]
[require]
static_safety = 3
lost_motion = "0.02 mm"
[[axis]]
name = "x"
carries = ["y"]
direction = "inclined"
inclination = "30 deg"
stroke = "70 cm"
structure_mass = "16500 g"
payload_mass = "2 kg"
guide_friction = "5 %"
guide_drag = "1 kgf"
counterbalance_force = "0.05 kN"
acceleration_time = ["50 ms", "0.5 s"]
[axis.mechanism]
kind = "screw"
screw = ["ball_screws", "lead_screws"]
thread_forms = ["trapezoidal", "square"]
nut_materials = "bronze"
ends = "supported-supported"
end_allowance = "9 cm"
greased = false
thread_friction = 0.15
ball_friction = 0.004
preload = 0.05
length = "900 mm"
[axis.motor]
from = "steppers"
frame = ["NEMA17", "NEMA23"]
microsteps = 8
brake_torque = "50 N.cm"
[axis.guide]
from = "linear_guides"
kinds = "profile rail"
rails = 2
carriages = 4
carriage_spacing = "200 mm"
rail_spacing = "0.25 m"
load_offset_x = "-60 mm"
load_offset_y = "15 mm"
force_height = "6 cm"
[[axis.moves]]
name = "sand"
distance = "600 mm"
time = "1 min"
speed = "1.2 m/min"
acceleration_time = "0.2 s"
force = "9.6 N"
dwell = "500 ms"
[axis.require]
inertia_ratio = 30
static_safety = 4
position_error = { limit = "50 um", over = "300 mm" }
[[axis.members]]
name = "shaft"
kind = "shaft"
support = "fixed"
length = "0.8 m"
count = 2
extra_force = "30 N"
lateral_force = "3 N"
load_share = 0.5
material = "C45"
rides = true
diameter = ["8 mm", "20 mm"]
guide = true
[[axis.members]]
name = "bar"
kind = "bar"
support = "cantilever"
length = "400 mm"
material = "6061-T6"
width = "20 mm"
height = ["10 mm", "3 cm"]
[[axis.members]]
name = "column"
kind = "column"
length = "1 m"
material = "S235JR"
sections = ["steel_sections", "extrusions"]
section_kinds = ["angle"]
end_fixity = 0.25
[[axis.members]]
name = "joint"
kind = "weld"
material = "E6013"
leg = ["3 mm", "8 mm"]
joint_width = "40 mm"
joint_depth = "50 mm"
lever_arm = "120 mm"
[[axis]]
name = "y"
direction = "vertical"
stroke = "250 mm"
structure_mass = "4 kg"
acceleration_time = "0.1 s"
mechanism = { kind = "belt", profiles = ["GT2", "GT3"], efficiency = 0.9, idler_distance = "30 mm" }
[[axis.moves]]
distance = "100 mm"
speed = "20 mm/s"
)";

const std::string maximal_json = R"({
 "title": "Everything", "source": "nowhere", "catalogues": ["parts", "more-parts"],
 "objective": {"minimise": "mass"},
 "currency": {"EUR": {"rate": 1, "date": "2026-01-15"}, "USD": {"rate": 0.925, "date": "2026-02-28"}, "GBP": 1.15},
 "supply": {"voltage": ["24 V", "0.048 kV"]},
 "require": {"static_safety": 3, "lost_motion": "0.02 mm"},
 "axis": [
  {"name": "x", "carries": ["y"], "direction": "inclined", "inclination": "30 deg", "stroke": "70 cm",
   "structure_mass": "16500 g", "payload_mass": "2 kg", "guide_friction": "5 %", "guide_drag": "1 kgf",
   "counterbalance_force": "0.05 kN", "acceleration_time": ["50 ms", "0.5 s"],
   "mechanism": {"kind": "screw", "screw": ["ball_screws", "lead_screws"], "thread_forms": ["trapezoidal", "square"],
     "nut_materials": "bronze", "ends": "supported-supported", "end_allowance": "9 cm", "greased": false,
     "thread_friction": 0.15, "ball_friction": 0.004, "preload": 0.05, "length": "900 mm"},
   "motor": {"from": "steppers", "frame": ["NEMA17", "NEMA23"], "microsteps": 8, "brake_torque": "50 N.cm"},
   "guide": {"from": "linear_guides", "kinds": "profile rail", "rails": 2, "carriages": 4,
     "carriage_spacing": "200 mm", "rail_spacing": "0.25 m", "load_offset_x": "-60 mm", "load_offset_y": "15 mm",
     "force_height": "6 cm"},
   "moves": [{"name": "sand", "distance": "600 mm", "time": "1 min", "speed": "1.2 m/min",
     "acceleration_time": "0.2 s", "force": "9.6 N", "dwell": "500 ms"}],
   "require": {"inertia_ratio": 30, "static_safety": 4, "position_error": {"limit": "50 um", "over": "300 mm"}},
   "members": [
    {"name": "shaft", "kind": "shaft", "support": "fixed", "length": "0.8 m", "count": 2, "extra_force": "30 N",
     "lateral_force": "3 N", "load_share": 0.5, "material": "C45", "rides": true,
     "diameter": ["8 mm", "20 mm"], "guide": true},
    {"name": "bar", "kind": "bar", "support": "cantilever", "length": "400 mm", "material": "6061-T6",
     "width": "20 mm", "height": ["10 mm", "3 cm"]},
    {"name": "column", "kind": "column", "length": "1 m", "material": "S235JR",
     "sections": ["steel_sections", "extrusions"], "section_kinds": ["angle"], "end_fixity": 0.25},
    {"name": "joint", "kind": "weld", "material": "E6013", "leg": ["3 mm", "8 mm"], "joint_width": "40 mm",
     "joint_depth": "50 mm", "lever_arm": "120 mm"}]},
  {"name": "y", "direction": "vertical", "stroke": "250 mm", "structure_mass": "4 kg", "acceleration_time": "0.1 s",
   "mechanism": {"kind": "belt", "profiles": ["GT2", "GT3"], "efficiency": 0.9, "idler_distance": "30 mm"},
   "moves": [{"distance": "100 mm", "speed": "20 mm/s"}]}]})";

using Words = std::vector<std::string>;

Approx near(double value) { return Approx(value).epsilon(1e-12); }

void check_range(const machine::Range& range, double lower, double upper) {
  CHECK(range.lower == near(lower));
  CHECK(range.upper == near(upper));
}

void check_parts(const Axis& x) {
  const machine::Mechanism& screw = x.mechanism;
  CHECK(screw.kind == machine::MechanismKind::screw);
  CHECK(screw.ball_screws);
  CHECK(screw.lead_screws);
  CHECK(screw.thread_forms == Words{"trapezoidal", "square"});
  CHECK(screw.nut_materials == Words{"bronze"});
  CHECK(screw.ends == machine::Ends::supported_supported);
  CHECK(screw.end_allowance == near(0.09));
  CHECK_FALSE(screw.greased);
  CHECK(screw.thread_friction.value() == 0.15);
  CHECK(screw.ball_friction == 0.004);
  CHECK(screw.preload_fraction == 0.05);
  CHECK(screw.length.value() == near(0.9));
  CHECK(x.motor.frames == Words{"NEMA17", "NEMA23"});
  CHECK(x.motor.microsteps == 8.0);
  CHECK(x.motor.brake_torque == near(0.5));
  REQUIRE(x.guide);
  CHECK(x.guide->kinds == Words{"profile rail"});
  CHECK(x.guide->rails == 2.0);
  CHECK(x.guide->carriages == 4.0);
  CHECK(x.guide->carriage_spacing == near(0.2));
  CHECK(x.guide->rail_spacing == near(0.25));
  CHECK(x.guide->load_offset_x == near(-0.06));
  CHECK(x.guide->load_offset_y == near(0.015));
  CHECK(x.guide->force_height == near(0.06));
}

void check_members(const std::vector<machine::Member>& members) {
  REQUIRE(members.size() == 4);
  const machine::Member& shaft = members[0];
  CHECK(shaft.name == "shaft");
  CHECK(shaft.kind == machine::MemberKind::round_shaft);
  CHECK(shaft.support == machine::BeamSupport::fixed);
  CHECK(shaft.length == near(0.8));
  CHECK(shaft.count == 2.0);
  CHECK(shaft.extra_force == near(30.0));
  CHECK(shaft.lateral_force == near(3.0));
  CHECK(shaft.load_share == 0.5);
  CHECK(shaft.material == "C45");
  CHECK(shaft.rides);
  CHECK(shaft.is_guide);
  check_range(shaft.diameter, 0.008, 0.020);
  const machine::Member& bar = members[1];
  CHECK(bar.kind == machine::MemberKind::rectangular_bar);
  CHECK(bar.support == machine::BeamSupport::cantilever);
  check_range(bar.width, 0.020, 0.020);
  CHECK(bar.width.fixed());
  check_range(bar.height, 0.010, 0.030);
  CHECK_FALSE(bar.rides);
  CHECK(bar.load_share == 1.0);
  const machine::Member& column = members[2];
  CHECK(column.kind == machine::MemberKind::column);
  CHECK(column.support == machine::BeamSupport::supported);
  CHECK(column.sections == Words{"steel_sections", "extrusions"});
  CHECK(column.section_kinds == Words{"angle"});
  CHECK(column.end_fixity == 0.25);
  const machine::Member& weld = members[3];
  CHECK(weld.kind == machine::MemberKind::weld);
  CHECK(weld.name == "joint");
  check_range(weld.leg, 0.003, 0.008);
  CHECK(weld.joint_width == near(0.04));
  CHECK(weld.joint_depth == near(0.05));
  CHECK(weld.lever_arm == near(0.12));
}

void check_x(const Axis& x) {
  CHECK(x.name == "x");
  CHECK(x.carries == Words{"y"});
  CHECK(x.direction == machine::Direction::inclined);
  CHECK(x.inclination == near(std::acos(-1.0) / 6.0));
  CHECK(x.stroke == near(0.7));
  CHECK(x.structure_mass == near(16.5));
  CHECK(x.payload_mass == near(2.0));
  CHECK(x.guide_friction == near(0.05));
  CHECK(x.guide_drag == near(9.80665));
  CHECK(x.counterbalance_force == near(50.0));
  check_range(x.acceleration_time, 0.05, 0.5);
  check_parts(x);
  check_members(x.members);
  REQUIRE(x.moves.size() == 1);
  const machine::Move& move = x.moves.front();
  CHECK(move.name == "sand");
  CHECK(move.distance == near(0.6));
  CHECK(move.time.value() == near(60.0));
  CHECK(move.speed.value() == near(0.02));
  CHECK(move.acceleration_time.value() == near(0.2));
  CHECK(move.force == near(9.6));
  CHECK(move.dwell == near(0.5));
  CHECK(x.require(Requirement::inertia_ratio) == 30.0);
  CHECK(x.require(Requirement::static_safety) == 4.0);  // the axis's own before the shared one
  CHECK(x.require(Requirement::lost_motion) == near(2e-5));
  CHECK(x.require(Requirement::position_error) == near(5e-5));
  CHECK(x.require(Requirement::position_error_over) == near(0.3));
  CHECK_FALSE(x.carried_by);
}

void check_y(const Axis& y) {
  CHECK(y.direction == machine::Direction::vertical);
  CHECK(y.inclination == near(std::acos(0.0)));
  check_range(y.acceleration_time, 0.1, 0.1);
  CHECK(y.mechanism.kind == machine::MechanismKind::belt);
  CHECK(y.mechanism.profiles == Words{"GT2", "GT3"});
  CHECK(y.mechanism.belt_efficiency == 0.9);
  CHECK(y.mechanism.idler_distance == near(0.03));
  CHECK_FALSE(y.guide);
  CHECK(y.members.empty());
  REQUIRE(y.moves.size() == 1);
  CHECK_FALSE(y.moves[0].time);
  CHECK(y.moves[0].speed.value() == near(0.02));
  CHECK(y.require(Requirement::static_safety) == 3.0);
  CHECK_FALSE(y.require.known(Requirement::position_error));
  CHECK(y.carried_by == std::size_t{0});
}

void check_maximal(const Outcome& outcome, const std::string& file) {
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const Problem& problem = *outcome.problem;
  CHECK(problem.title == "Everything");
  CHECK(problem.source == "nowhere");
  CHECK(problem.file == file);
  CHECK(problem.objective == "mass");
  CHECK(problem.catalogues == Words{"parts", "more-parts"});
  CHECK(problem.currency == "EUR");
  REQUIRE(problem.currencies.size() == 3);
  CHECK(problem.currencies.at("EUR").rate == 1.0);
  CHECK(problem.currencies.at("EUR").date == "2026-01-15");
  CHECK(problem.currencies.at("USD").rate == 0.925);
  CHECK(problem.currencies.at("USD").date == "2026-02-28");
  CHECK(problem.currencies.at("GBP").rate == 1.15);
  REQUIRE(problem.supply_voltages.size() == 2);
  CHECK(problem.supply_voltages[0] == near(24.0));
  CHECK(problem.supply_voltages[1] == near(48.0));
  REQUIRE(problem.axes.size() == 2);
  CHECK(problem.order == std::vector<std::size_t>{1, 0});
  check_x(problem.axes[0]);
  check_y(problem.axes[1]);
}

Outcome with_settings(const std::vector<std::pair<std::string, std::string>>& settings) {
  Outcome outcome;
  outcome.problem = machine::read_problem(MILLWRIGHT_SOURCE_DIR "/problems/sander.toml", settings, outcome.diagnostics);
  return outcome;
}

}  // namespace

TEST_CASE("Every key of a problem file arrives where it belongs, in SI") {
  check_maximal(read(maximal_toml, "all.toml"), "all.toml");
}

TEST_CASE("The same problem as JSON is the same problem") { check_maximal(read(maximal_json, "all.json"), "all.json"); }

TEST_CASE("A complaint about a JSON problem stands at its place too") {
  std::string contents = replaced(maximal_json, "\"70 cm\"", "\"70 «cmm»\"");
  const Place place = take_marks(contents);
  const Outcome outcome = read(contents, "all.json");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.diagnostics.count() == 1);
  check_place(outcome.diagnostics.all()[0], place, {"", "", "stroke: unknown unit 'cmm'", "did you mean"});
}

TEST_CASE("What a problem file leaves out has its documented default") {
  const Outcome outcome = read(
      "[supply]\nvoltage = \"24 V\"\n[[axis]]\nname = \"x\"\nstroke = \"100 mm\"\nstructure_mass = \"1 kg\"\n"
      "mechanism = { kind = \"screw\", screw = \"lead_screws\" }\nguide = { carriages = 1 }\n"
      "[[axis.moves]]\ndistance = \"10 mm\"\ntime = \"1 s\"\n");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  CHECK(outcome.diagnostics.count() == 0);
  const Problem& problem = *outcome.problem;
  CHECK(problem.objective == "cost");
  CHECK(problem.currency == "USD");
  CHECK(problem.currencies.empty());
  const Axis& x = problem.axes.front();
  CHECK(x.direction == machine::Direction::horizontal);
  CHECK(x.inclination == 0.0);
  check_range(x.acceleration_time, 0.05, 0.5);
  CHECK(x.mechanism.ends == machine::Ends::fixed_supported);
  CHECK(x.mechanism.greased);
  CHECK_FALSE(x.mechanism.ball_screws);
  CHECK_FALSE(x.mechanism.thread_friction);
  CHECK_FALSE(x.mechanism.length);
  CHECK(x.mechanism.end_allowance == near(0.08));
  CHECK(x.mechanism.ball_friction == 0.005);
  CHECK(x.motor.microsteps == 16.0);
  CHECK(x.motor.brake_torque == 0.0);
  CHECK(x.guide.value().rails == 1.0);  // one carriage runs on one rail
  for (const machine::RequirementDeclaration& declaration : machine::requirements()) {
    CHECK_FALSE(x.require.given(declaration.requirement));
    CHECK(x.require.known(declaration.requirement) == !std::isnan(declaration.default_value));
    if (!std::isnan(declaration.default_value)) CHECK(x.require(declaration.requirement) == declaration.default_value);
  }
  CHECK(x.require(Requirement::life) == 3.6e7);
  CHECK(x.require(Requirement::twist_per_length) == near(0.3 * std::acos(-1.0) / 180.0));
  CHECK_FALSE(x.require.known(Requirement::position_error));
}

TEST_CASE("Each declared requirement can be set, and its declaration makes sense") {
  std::set<std::string> keys;
  for (const machine::RequirementDeclaration& declaration : machine::requirements()) {
    const std::string key(declaration.key);
    INFO(key);
    CHECK(keys.insert(key).second);
    CHECK(machine::find_requirement(key) == &declaration);
    CHECK_FALSE(declaration.meaning.empty());
    CHECK(declaration.source.empty() == std::isnan(declaration.default_value));
    std::string reason;
    const auto unit = scalar::Unit::parse(declaration.unit, reason);
    REQUIRE(unit);
    CHECK(unit->to_si(1.0) == 1.0);  // SI, so that the default may be read as it is
    const machine::UsualValues usual = machine::usual_values(declaration.unit);
    CHECK_FALSE(usual.example.empty());
    if (!std::isnan(declaration.default_value)) {
      CHECK(declaration.default_value >= usual.smallest);
      CHECK(declaration.default_value <= usual.largest);
    }
    machine::QuantityFault fault;
    CHECK(machine::read_quantity(usual.example, declaration.unit, machine::Sign::positive, fault));
    // 1 is on neither side of what is a share or a safety factor, so it is never odd.
    const std::string value = declaration.unit == "1" ? "1" : "\"1 " + std::string(declaration.unit) + "\"";
    const bool needs_limit = declaration.requirement == Requirement::position_error_over;
    const std::string line = key + " = " + value + "\n" + (needs_limit ? "position_error = \"1 mm\"\n" : "");
    for (const bool shared : {true, false}) {
      const std::string contents =
          shared ? replaced(sound, "life = \"20000 h\"\n", line) : sound + "[axis.require]\n" + line;
      Outcome outcome = read(contents);
      const bool of_tables =
          declaration.requirement == Requirement::angle_error || declaration.requirement == Requirement::lost_angle;
      if (!shared && of_tables) continue;  // y slides: refused there, see rack_file_test.cpp
      if (shared && (needs_limit || declaration.requirement == Requirement::position_error)) continue;  // x has its own
      INFO(text::format(outcome.diagnostics));
      CHECK(outcome.diagnostics.count() == 0);
      REQUIRE(outcome.problem);
      const machine::Requirements& require = outcome.problem->axes[shared ? 0 : 1].require;
      CHECK(require.given(declaration.requirement));
      CHECK(require(declaration.requirement) == 1.0);
    }
  }
  CHECK(machine::find_requirement("nothing") == nullptr);
  CHECK(machine::find_requirement("") == nullptr);
}

TEST_CASE("A setting given by --set changes what the file says") {
  const Outcome outcome = with_settings({{"axis.x.stroke", "800 mm"},
                                         {"axis[1].stroke", "0.3 m"},
                                         {"axis.x.moves.sand.time", "40 s"},
                                         {"axis.y.moves[0].dwell", "\"1 s\""},
                                         {"axis.z.require.position_error.limit", "0.5 mm"},
                                         {"require.inertia_ratio", "12"},
                                         {"objective.minimise", "mass"},
                                         {"supply.voltage", "[\"48 V\"]"},
                                         {"axis.x.acceleration_time", "0.25 s"},
                                         {"axis.x.members.beam.length", "600 mm"}});
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  const Problem& problem = *outcome.problem;
  CHECK(problem.axes[0].stroke == near(0.8));
  CHECK(problem.axes[1].stroke == near(0.3));
  CHECK(problem.axes[0].moves[0].time.value() == near(40.0));
  CHECK(problem.axes[1].moves[0].dwell == near(1.0));
  CHECK(problem.axes[2].require(Requirement::position_error) == near(5e-4));
  CHECK(problem.axes[2].require(Requirement::position_error_over) == near(0.05));
  CHECK(problem.axes[0].require(Requirement::inertia_ratio) == 12.0);
  CHECK(problem.objective == "mass");
  CHECK(problem.supply_voltages == std::vector<double>{48.0});
  CHECK(problem.axes[0].acceleration_time.fixed());
  CHECK(problem.axes[0].members[0].length == near(0.6));
}

TEST_CASE("What is wrong in --set is said at what was typed, all of it") {
  struct Wrong {
    std::string path, value;
    int column;
    std::string message, hint;
  };
  // Columns count from the '--set ' that the text begins with, 6 characters.
  for (const Wrong& wrong :
       std::vector<Wrong>{{"axis.x.stroke", "20 kgg", 24, "stroke: unknown unit 'kgg'", "'kg'"},
                          {"axis.x.stroke", "700", 21, "a bare number where a unit is needed", "write \"700 mm\""},
                          {"axis.x.stroke", "-5 mm", 21, "stroke: must not be negative", ""},
                          {"axis.xx.stroke", "1 mm", 12, "xx", ""},
                          {"axis[7].stroke", "1 mm", 12, "", ""},
                          {"axis.x.strok", "1 mm", 14, "unknown key 'strok' in axis 'x'", "did you mean 'stroke'?"},
                          {"axis..stroke", "1 mm", 12, "a key is expected", "axis.x.moves[0].time"},
                          {"axis.x.moves[0].time", "[\"1 s\"", 34, "end-of-file", ""},
                          {"axis.x.motor.microsteps", "3.5", 31, "microsteps: a whole number from 1 to 256", ""},
                          {"axis.z.carries", "[\"y\", \"q\"]", 28, "carries: there is no axis 'q'", "axes: x, y, z"},
                          {"currency.USD", "2", 0, "currency: none has the rate 1", "USD = 1.0"}}) {
    const Outcome outcome = with_settings({{wrong.path, wrong.value}});
    INFO(wrong.path << "=" << wrong.value << "\n" << text::format(outcome.diagnostics));
    CHECK_FALSE(outcome.problem);
    bool found = false;
    for (const text::Diagnostic& said : outcome.diagnostics.all())
      found = found || ((wrong.column == 0 || said.where.column == wrong.column) &&
                        said.message.find(wrong.message) != std::string::npos &&
                        said.hint.find(wrong.hint) != std::string::npos);
    CHECK(found);
  }
  const Outcome both = with_settings({{"axis.q.stroke", "1 mm"}, {"axis.w.stroke", "1 mm"}});
  CHECK(both.diagnostics.error_count() == 2);
}

TEST_CASE("A problem file that is not there is an error without a crash") {
  text::Diagnostics diagnostics;
  CHECK_FALSE(machine::read_problem("/nowhere/at/all.toml", {}, diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(diagnostics.all()[0].message.find("cannot be opened") != std::string::npos);
  text::Diagnostics folder;
  CHECK_FALSE(machine::read_problem(MILLWRIGHT_SOURCE_DIR "/problems", {}, folder));
  CHECK(folder.error_count() == 1);
}

TEST_CASE("The shipped machines are read without error or warning") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/problems")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    text::Diagnostics diagnostics;
    const auto problem = machine::read_problem(entry.path(), {}, diagnostics);
    INFO(text::format(diagnostics));
    CHECK(diagnostics.count() == 0);
    REQUIRE(problem);
    CHECK_FALSE(problem->title.empty());
    CHECK(problem->order.size() == problem->axes.size());
  }
  CHECK(count >= 4);
}

}  // namespace problem_file_test
