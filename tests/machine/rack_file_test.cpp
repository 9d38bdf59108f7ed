// SPDX-License-Identifier: Apache-2.0
// Racks, rotary tables and reductions in a problem file: what is read, and what is said about wrong ones.
#include "machine/bill_of_materials.h"
#include "problem_text.h"

namespace rack_file_test {

using namespace problem_text;
using text::Severity;

namespace {

const std::string geared = R"(
[currency]
USD = 1.0
EUR = { rate = 1.08, date = 2026-01-15 }
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
carries = ["a"]
stroke = "2 m"
structure_mass = "20 kg"
mechanism = { kind = "rack", efficiency = 0.9, backlash = "0.12 mm", motor_rides = false, reduction = { ratio = 5, efficiency = 0.95, inertia = "4e-6 kg.m2", backlash = "10 arcmin", mass = "0.4 kg", shaft = "14 mm", price = "60 EUR" } }
[[axis.moves]]
distance = "1.8 m"
speed = "300 mm/s"
[[axis]]
name = "a"
stroke = "2 rev"
structure_mass = "3 kg"
structure_inertia = "0.02 kg.m2"
payload_inertia = "50 kg.cm2"
friction_torque = "0.2 N.m"
acceleration_time = ["0.1 s", "0.5 s"]
mechanism = { kind = "rotary" }
[[axis.moves]]
distance = "90 deg"
speed = "30 deg/s"
torque = "1.5 N.m"
[axis.require]
angle_error = "3 arcmin"
lost_angle = "0.1 deg"
)";

constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180.0;

void check_geared(const std::vector<Case>& cases) {
  for (const Case& one : cases) check(one, geared);
}

}  // namespace

TEST_CASE("A rack with a reduction and a rotary table are read into SI") {
  const Outcome outcome = read(geared);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const machine::Axis& x = outcome.problem->axes[0];
  CHECK(x.mechanism.kind == machine::MechanismKind::rack);
  CHECK_FALSE(machine::is_rotary(x));
  CHECK(x.mechanism.rack_efficiency == 0.9);
  CHECK(x.mechanism.backlash == Approx(1.2e-4).epsilon(1e-12));
  CHECK_FALSE(x.mechanism.motor_rides);
  REQUIRE(x.mechanism.reductions.size() == 1);
  const machine::Reduction& r = x.mechanism.reductions.front();
  CHECK(r.ratio == 5.0);
  CHECK(r.efficiency == 0.95);
  CHECK(r.inertia == Approx(4e-6).epsilon(1e-12));
  CHECK(r.backlash == Approx(degree / 6.0).epsilon(1e-12));
  CHECK(r.mass == 0.4);
  CHECK(r.shaft == Approx(0.014).epsilon(1e-12));
  CHECK(r.price == 60.0);
  CHECK(r.currency == "EUR");
  const machine::Axis& a = outcome.problem->axes[1];
  CHECK(machine::is_rotary(a));
  CHECK(a.carried_by == 0U);
  CHECK(a.stroke == Approx(4.0 * pi).epsilon(1e-12));
  CHECK(a.inertia == Approx(0.025).epsilon(1e-12));
  CHECK(a.friction_torque == Approx(0.2).epsilon(1e-12));
  CHECK(a.mechanism.reductions.empty());
  REQUIRE(a.moves.size() == 1);
  CHECK(a.moves[0].distance == Approx(pi / 2.0).epsilon(1e-12));
  CHECK(a.moves[0].speed.value() == Approx(pi / 6.0).epsilon(1e-12));
  CHECK(a.moves[0].force == 1.5);
  CHECK(a.require(machine::Requirement::angle_error) == Approx(0.05 * degree).epsilon(1e-12));
  using Words = std::vector<std::string>;
  CHECK(machine::slot_names(x) == Words{"rack", "pinion", "motor", "driver"});
  CHECK(machine::slot_names(a) == Words{"motor", "driver"});
  CHECK(machine::setting_names(a) == Words{"acceleration_time", "motor_current"});
}

TEST_CASE("Defaults of a rack: the motor rides, 0.1 mm of play, no reduction") {
  const Outcome outcome =
      read(replaced(sound, "kind = \"belt\", profiles = [\"GT2\"], efficiency = 0.95", "kind = \"rack\""));
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  const machine::Mechanism& rack = outcome.problem->axes[1].mechanism;
  CHECK(rack.motor_rides);
  CHECK(rack.backlash == 1e-4);
  CHECK(rack.rack_efficiency == 0.95);
  CHECK(rack.reductions.empty());
}

TEST_CASE("What is wrong with a rack or a reduction is said at the place") {
  check_geared({
      {"backlash = \"0.12 mm\"", "«profiles» = [\"GT2\"]", "profiles: a rack has none", "kind = \"belt\""},
      {"backlash = \"0.12 mm\"", "«ends» = \"fixed-free\"", "ends: a rack has none", "kind = \"screw\""},
      {"backlash = \"0.12 mm\"", "backlash = \"«-1» mm\"", "backlash: must not be negative", ""},
      {"backlash = \"0.12 mm\"",
       "backlash = «\"1.2 mm\"»",
       "backlash: 0.0012 is unusually high",
       "0.05 mm to 0.2 mm",
       Severity::warning},
      {"motor_rides = false", "motor_rides = «\"false\"»", "'motor_rides' must be true or false", "without quotes"},
      {"motor_rides = false", "«motor_ride» = false", "motor_ride", "motor_rides"},
      {"{ ratio = 5, ", "«»{ ", "needs the key 'ratio'", "ratio = 5"},
      {"ratio = 5", "ratio = «0.2»", "ratio: 0.2 makes the output faster than the motor", "5 for 5:1"},
      {"ratio = 5, efficiency = 0.95", "ratio = 5, efficiency = «95»", "efficiency: a share is at most 1", "95 %"},
      {"\"4e-6 kg.m2\"", "\"4e-6 «kg.m»\"", "inertia: 'kg.m'", "kg.m2"},
      {"\"10 arcmin\"", "\"10 «mm»\"", "backlash: 'mm'", ""},
      {"{ ratio = 5, efficiency = 0.95, inertia = \"4e-6 kg.m2\", backlash = \"10 arcmin\", mass = \"0.4 kg\", "
       "shaft = \"14 mm\", ",
       "«»{ ratio = 5, ",
       "needs the key 'shaft'",
       "shaft = \"14 mm\""},
      {"\"60 EUR\"", "«\"60\"»", "price: an amount of money is needed", "\"60 USD\""},
      {"\"60 EUR\"", "«\"60 kg\"»", "price: an amount of money is needed", "\"60 USD\""},
      {"\"60 EUR\"", "«\"sixty EUR\"»", "price: an amount of money is needed", "\"60 USD\""},
      {"\"60 EUR\"", "«\"-6 EUR\"»", "price: must not be negative", "\"60 USD\""},
      {"\"60 EUR\"", "«60»", "price: an amount of money is needed", "\"60 USD\""},
      {"reduction = { ratio = 5, efficiency = 0.95, inertia = \"4e-6 kg.m2\", backlash = \"10 arcmin\", mass = \"0.4 "
       "kg\", shaft = \"14 mm\", price = \"60 EUR\" }",
       "reduction = «{ ratio = 5, shaft = \"14 mm\", price = \"60 GBP\" }»",
       "price: there is no rate for GBP",
       "add GBP to [currency]"},
  });
  check({"kind = \"belt\"", "kind = \"belt\", «motor_rides» = true", "motor_rides: a belt has none", "\"rack\""});
}

TEST_CASE("What is wrong with a rotary table is said at the place") {
  check_geared({
      {"stroke = \"2 rev\"", "stroke = \"2 «mm»\"", "stroke: 'mm'", "\"90 deg\""},
      {"stroke = \"2 rev\"", "stroke = «2»", "stroke: a bare number", "write \"2 deg\""},
      {"distance = \"90 deg\"",
       "distance = «\"721 deg\"»",
       "distance: 721 deg is longer than the stroke of axis 'a', 720 deg",
       "lengthen the stroke"},
      {"speed = \"30 deg/s\"", "speed = \"30 «mm/s»\"", "speed: 'mm/s'", "\"30 rpm\""},
      {"speed = \"30 deg/s\"", "speed = \"30 «Hz»\"", "speed: 'Hz'", "rpm"},
      {"distance = \"90 deg\"\nspeed = \"30 deg/s\"",
       "distance = \"90 deg\"\nspeed = «\"300 rpm\"»",
       "speed: 300 rpm is never reached",
       "or lower the speed"},
      {"[[axis.moves]]\ndistance = \"90 deg\"\nspeed = \"30 deg/s\"",
       "«[[axis.moves]]»\ndistance = \"90 deg\"",
       "move of axis 'a' needs a time or a speed",
       "speed = \"20 rpm\""},
      {"torque = \"1.5 N.m\"", "«force» = \"3 N\"", "force: a table is turned against a torque", "torque = \"2 N.m\""},
      {"torque = \"1.5 N.m\"", "torque = \"1.5 «N»\"", "torque: 'N'", "0.5 N.m"},
      {"[[axis]]\nname = \"a\"\nstroke = \"2 rev\"\nstructure_mass = \"3 kg\"\nstructure_inertia = \"0.02 kg.m2\"\n",
       "«[[axis]]»\nname = \"a\"\nstroke = \"2 rev\"\nstructure_mass = \"3 kg\"\n",
       "axis 'a' needs the key 'structure_inertia'",
       "0.02 kg.m2"},
      {"structure_inertia = \"0.02 kg.m2\"",
       "structure_inertia = \"0.02 «kg»\"",
       "structure_inertia: 'kg'",
       "\"0.02 kg.m2\""},
      {"structure_mass = \"3 kg\"\nstructure_inertia = \"0.02 kg.m2\"",
       "structure_inertia = «\"0.02 kg.m2\"»",
       "structure_inertia: table 'a' has an inertia, but no mass",
       "structure_mass = \"3 kg\"",
       Severity::warning},
      {"kind = \"rotary\"",
       "kind = \"rotary\", «backlash» = \"1 mm\"",
       "backlash: a rotary table has none",
       "\"rack\""},
      {"kind = \"rotary\"", "kind = \"rotary\", «efficiency» = 0.9", "efficiency: a rotary table has none", "\"belt\""},
      {"kind = \"rotary\"",
       "kind = \"rotary\", reduction = { ratio = 9, «shaft» = \"8 mm\" }",
       "shaft: a table has no pinion",
       "leave it out"},
  });
}

TEST_CASE("What belongs to an axis that slides is refused of one that turns, and the other way round") {
  const std::string friction = "friction_torque = \"0.2 N.m\"";
  check_geared({
      {friction, "«guide_friction» = 0.1", "guide_friction: a rotary axis has none", "friction_torque"},
      {friction, "«guide_drag» = \"2 N\"", "guide_drag: a rotary axis has none", "friction_torque"},
      {friction, "«direction» = \"vertical\"", "direction: a rotary axis turns", "leave it out"},
      {friction, "«carries» = []", "carries: a rotary axis carries no axis", "another axis carry both"},
      {friction,
       "«guide» = { rails = 1, carriages = 1 }",
       "guide: a rotary axis has none",
       "the bearing of the table comes with the table"},
      {"angle_error = \"3 arcmin\"",
       "«position_error» = \"0.1 mm\"",
       "position_error: the travel of this axis is an angle",
       "angle_error = \"0.1 deg\""},
      {"lost_angle = \"0.1 deg\"",
       "«lost_motion» = \"0.1 mm\"",
       "lost_motion: the travel of this axis is an angle",
       "lost_angle = \"0.1 deg\""},
      {"lost_angle = \"0.1 deg\"", "lost_angle = \"0.1 «mm»\"", "lost_angle: 'mm'", "\"90 deg\""},
  });
  check({"position_error = { limit = \"0.05 mm\", over = \"300 mm\" }",
         "«angle_error» = \"0.1 deg\"",
         "angle_error: the travel of this axis is a length",
         "position_error = \"0.05 mm\""});
}

TEST_CASE("Reductions of screws and belts are read into SI, a list of them each with its name") {
  const std::string belt = "kind = \"belt\", profiles = [\"GT2\"], efficiency = 0.95";
  const std::string ends = "ends = \"fixed-free\"";
  const std::string list =
      ends +
      ", reduction = [{ name = \"3:1 belt\", ratio = 3, torque = \"8 N.m\", speed = \"3000 rpm\", stiffness = \"2 "
      "kN.m/rad\" }, { name = \"direct\", ratio = 1, efficiency = 1 }]";
  const Outcome outcome = read(replaced(
      replaced(sound, ends, list), belt, belt + ", reduction = { ratio = 4, shaft = \"8 mm\", price = \"30 EUR\" }"));
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  CHECK(outcome.diagnostics.error_count() == 0);
  CHECK(outcome.diagnostics.warning_count() == 2);  // of the three, two have no price
  const std::vector<machine::Reduction>& x = outcome.problem->axes[0].mechanism.reductions;
  REQUIRE(x.size() == 2);
  CHECK(x[0].name == "3:1 belt");
  CHECK(x[0].ratio == 3.0);
  CHECK(x[0].efficiency == 0.9);
  CHECK(x[0].rated_torque == 8.0);
  CHECK(x[0].largest_speed.value() == Approx(100.0 * pi).epsilon(1e-12));
  CHECK(x[0].stiffness == 2000.0);
  CHECK(x[0].shaft == 0.0);
  CHECK(x[1].name == "direct");
  CHECK(x[1].efficiency == 1.0);
  CHECK_FALSE(x[1].rated_torque);
  CHECK_FALSE(x[1].largest_speed);
  CHECK_FALSE(x[1].stiffness);
  const std::vector<machine::Reduction>& y = outcome.problem->axes[1].mechanism.reductions;
  REQUIRE(y.size() == 1);
  CHECK(y[0].name.empty());
  CHECK(y[0].shaft == Approx(0.008).epsilon(1e-12));
  CHECK(y[0].currency == "EUR");
  // A wheel on the screw leaves no place for a coupling, and the bill of materials tells the two by their names; the
  // only one of y needs none.
  using Words = std::vector<std::string>;
  CHECK(machine::slot_names(outcome.problem->axes[0]) ==
        Words{"guide", "beam", "screw", "nut", "motor", "driver", "support_fixed", "reduction"});
  CHECK(machine::slot_names(outcome.problem->axes[1]) ==
        Words{"belt", "pulley_drive", "pulley_idle", "motor", "driver"});
}

TEST_CASE("A nut that turns is read, with its inertia") {
  const std::string ends = "ends = \"fixed-free\"";
  const Outcome outcome = read(replaced(sound, ends, ends + ", rotating = \"nut\", nut_inertia = \"2 kg.cm2\""));
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  const machine::Axis& x = outcome.problem->axes[0];
  CHECK(x.mechanism.nut_rotates);
  CHECK(x.mechanism.nut_inertia == Approx(2e-4).epsilon(1e-12));
  CHECK_FALSE(machine::has_coupling(x.mechanism));
  CHECK(machine::riding_mass_allowance(x) == 5.0);
  CHECK(machine::riding_mass_allowance(read(sound).problem->axes[0]) == 0.5);
}

TEST_CASE("What is wrong with the reductions of screws and belts, and with a nut that turns, is said at the place") {
  const std::string ends = "ends = \"fixed-free\"";
  const auto of_screw = [&](const std::string& keys, const char* message, const char* hint) {
    check({ends, ends + ", " + keys, message, hint});
  };
  of_screw("reduction = { ratio = 3, torque = \"8 «kg»\" }", "torque: 'kg'", "N.m");
  of_screw("reduction = { ratio = 3, speed = «3000» }", "speed: a bare number", "rpm");
  of_screw("reduction = { ratio = 3, stiffness = \"20 «N/m»\" }", "stiffness: 'N/m'", "");
  of_screw("reduction = { ratio = 3, torque = \"«-8» N.m\" }", "torque: must not be negative", "");
  of_screw("reduction = «3»", "reduction in the mechanism of axis 'x'", "");
  of_screw("reduction = «[]»", "reduction: the list is empty", "leave the key out");
  of_screw("reduction = [«»{ ratio = 3 }]", "needs the key 'name'", "3:1 belt");
  of_screw("reduction = { ratio = 3, name = «\"\"» }", "name", "");
  of_screw("reduction = { ratio = 3, «rato» = 2 }", "rato", "ratio");
  of_screw("reduction = [{ name = \"a\", ratio = 3 }, { name = «\"a\"», ratio = 4 }]",
           "name: two reductions are called 'a'",
           "give each its own name");
  of_screw("reduction = [{ name = \"a\", ratio = 3 }, «{ name = \"b\", ratio = 4, shaft = \"8 mm\" }»]",
           "shaft: one reduction has an output shaft and another has none",
           "list one sort");
  of_screw(
      "reduction = [{ name = \"a\", ratio = 3, price = \"1 USD\" }, «{ name = \"b\", ratio = 4, price = \"5 GBP\" }»]",
      "price: there is no rate for GBP",
      "add GBP to [currency]");
  of_screw("rotating = «\"nuts\"»", "rotating", "nut");
  of_screw("«nut_inertia» = \"2 kg.cm2\"", "nut_inertia: the screw turns, not its nut", "rotating = \"nut\"");
  of_screw("rotating = \"nut\", nut_inertia = \"2 «kg»\"", "nut_inertia: 'kg'", "kg.m2");
  of_screw("rotating = \"nut\", nut_inertia = \"1 kg.cm2\", reduction = { ratio = 2, «shaft» = \"8 mm\" }",
           "shaft: its last wheel sits on the nut",
           "leave it out");
  check({"mechanism = { kind = \"screw\", screw = [\"ball_screws\", \"lead_screws\"], ends = \"fixed-free\" }",
         "mechanism = «{ kind = \"screw\", screw = [\"ball_screws\", \"lead_screws\"], rotating = \"nut\" }»",
         "needs the key 'nut_inertia'",
         "of the nut with the wheel on it"});
  check({"kind = \"belt\"", "kind = \"belt\", reduction = «{ ratio = 5 }»", "needs the key 'shaft'", "drive pulley"});
  check({"kind = \"belt\"", "kind = \"belt\", «rotating» = \"nut\"", "rotating: a belt has none", "\"screw\""});
}

}  // namespace rack_file_test
