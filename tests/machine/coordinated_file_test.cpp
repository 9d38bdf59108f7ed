// SPDX-License-Identifier: Apache-2.0
// Coordinated moves in a problem file: what each axis gets of them, and what is said about wrong ones.
#include <algorithm>

#include "machine/axis_motion.h"
#include "problem_text.h"

namespace coordinated_file_test {

using namespace problem_text;
using text::Severity;

namespace {

/// Two axes; y has no moves of its own. A third one turns.
const std::string table = R"(
[supply]
voltage = ["24 V"]
[[moves]]
name = "diagonal"
axes = { x = "300 mm", y = "400 mm" }
speed = "100 mm/s"
acceleration_time = "0.2 s"
forces = { y = "12 N" }
dwell = "0.5 s"
[[moves]]
name = "back"
axes = { x = "300 mm", y = "400 mm" }
time = "2.2 s"
acceleration_time = "0.2 s"
[[axis]]
name = "x"
carries = ["y"]
stroke = "500 mm"
structure_mass = "4 kg"
acceleration_time = ["0.05 s", "0.5 s"]
mechanism = { kind = "belt" }
[[axis.moves]]
name = "own"
distance = "100 mm"
time = "2 s"
[[axis]]
name = "y"
carries = ["c"]
stroke = "400 mm"
structure_mass = "4 kg"
mechanism = { kind = "belt" }
[[axis]]
name = "c"
stroke = "360 deg"
structure_mass = "1 kg"
structure_inertia = "0.02 kg.m2"
mechanism = { kind = "rotary" }
[[axis.moves]]
distance = "90 deg"
time = "1 s"
)";

void check_table(const Case& one) { check(one, table); }

}  // namespace

// A path of 500 mm (3-4-5 triangle): x does 0.6 of it, y 0.8. At 100 mm/s along it x goes 60 mm/s and y 80 mm/s.
TEST_CASE("A coordinated move is a move of each of its axes") {
  const Outcome outcome = read(table);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const auto& x = outcome.problem->axes[0].moves;
  const auto& y = outcome.problem->axes[1].moves;
  REQUIRE(x.size() == 3);
  REQUIRE(y.size() == 2);
  CHECK(outcome.problem->axes[2].moves.size() == 1);
  CHECK(x[0].name == "own");
  CHECK(x[1].name == "diagonal");
  CHECK(x[1].distance == Approx(0.3));
  CHECK(*x[1].speed == Approx(0.06));
  CHECK_FALSE(x[1].time.has_value());
  CHECK(*x[1].acceleration_time == Approx(0.2));
  CHECK(x[1].force == 0.0);
  CHECK(x[1].dwell == Approx(0.5));
  CHECK(y[0].name == "diagonal");
  CHECK(y[0].distance == Approx(0.4));
  CHECK(*y[0].speed == Approx(0.08));
  CHECK(y[0].force == Approx(12.0));
  // By time both axes have the same time and ramp, whatever their distance.
  CHECK(*x[2].time == Approx(2.2));
  CHECK(*y[1].time == Approx(2.2));
  CHECK_FALSE(x[2].speed.has_value());
  CHECK(*y[1].acceleration_time == Approx(0.2));
}

// Where one axis goes up and down the others go there and back with it; its time counts on one of them.
TEST_CASE("The axes of a coordinated move that climbs return together") {
  std::string text = table;
  for (const bool climbs : {false, true}) {
    if (climbs) text.replace(text.find("carries = [\"c\"]"), 0, "direction = \"vertical\"\n");
    const Outcome outcome = read(text);
    INFO(text::format(outcome.diagnostics));
    REQUIRE(outcome.problem);
    const machine::Axis& x = outcome.problem->axes[0];
    const machine::Axis& y = outcome.problem->axes[1];
    CHECK_FALSE(x.moves[0].returns);
    for (const machine::Move* move : {&x.moves[1], &x.moves[2], &y.moves[0], &y.moves[1]})
      CHECK(move->returns == climbs);
    CHECK(x.moves[1].counts_in_cycle != y.moves[0].counts_in_cycle);
    const machine::MotionData motion{.moves = x.moves};
    const auto names = machine::phase_names(motion);
    const auto cycle = machine::duty_cycle(motion, 4.0, 0.2);
    CHECK(cycle.phases.size() == names.size());
    CHECK(std::count(names.begin(), names.end(), "diagonal back, brake") == (climbs ? 1 : 0));
    CHECK(std::count(names.begin(), names.end(), "diagonal, brake") == (climbs ? 0 : 1));
    // By hand: 100 mm of its own in 2 s; 300 mm in 5 s + 0.2 s and 0.5 s of rest; 300 mm in 2.2 s.
    const double times = climbs ? 2.0 : 1.0;
    CHECK(cycle.travelled == Approx(0.1 + times * 0.6));
    CHECK(cycle.total_time == Approx(2.0 + times * (5.7 + 2.2)));
    CHECK(cycle.standing_time == Approx(times * 0.5));
  }
}

TEST_CASE("Ramps are left to the search only where a move of the axis needs them") {
  const Outcome outcome = read(table);
  REQUIRE(outcome.problem);
  CHECK_FALSE(outcome.problem->axes[0].acceleration_time.fixed());
  CHECK(outcome.problem->axes[1].acceleration_time.fixed());
}

TEST_CASE("Wrong coordinated moves are reported at their place") {
  const std::string first = "axes = { x = \"300 mm\", y = \"400 mm\" }\nspeed";
  check_table({first, "axes = { x = \"300 mm\", «yy» = \"400 mm\", y = \"400 mm\" }\nspeed", "no axis 'yy'", "'y'"});
  check_table({first, "axes = { x = \"300 mm\", y = \"400 mm\", «c» = \"90 deg\" }\nspeed", "turns", "[[axis.moves]]"});
  check_table({first, "axes = { x = \"«-300» mm\", y = \"400 mm\" }\nspeed", "axes.x: must not be negative", "mm"});
  check_table({first, "axes = { x = «\"501 mm\"», y = \"400 mm\" }\nspeed", "longer than the stroke of axis 'x'", ""});
  check_table({first, "axes = «{}»\nspeed", "no axis is named", "axes ="});
  check_table({"forces = { y = \"12 N\" }", "forces = { «z» = \"12 N\" }", "no axis 'z'", "x, y, c"});
  check_table({"name = \"back\"", "name = «\"diagonal\"»", "two moves", "own name"});
  check_table({"name = \"back\"", "name = «\"own\"»", "axis 'x' has a move 'own' of its own", "own name"});
  check_table({"dwell = \"0.5 s\"", "«force» = \"5 N\"", "a force acts on one axis", "forces ="});
  check_table({"dwell = \"0.5 s\"", "«dwel» = \"0.5 s\"", "dwel", "dwell"});
  // Two ramps of 0.2 s need 0.4 s; a path of 500 mm at 100 mm/s takes 5 s, ramps of 6 s never reach that speed.
  check_table({"time = \"2.2 s\"", "time = «\"0.3 s\"»", "faster than its ramps allow", "0.15 s"});
  check_table({"speed = \"100 mm/s\"\nacceleration_time = \"0.2 s\"",
               "speed = «\"100 mm/s\"»\nacceleration_time = \"6 s\"",
               "never reached",
               "5 s"});
}

TEST_CASE("A coordinated move needs a name, axes, a speed or time, and a ramp") {
  for (const std::string line : {"name = \"back\"\n",
                                 "time = \"2.2 s\"\n",
                                 "time = \"2.2 s\"\nacceleration_time = \"0.2 s\"\n[[axis]]\nname = \"x\"\n"}) {
    std::string with = line.starts_with("time = \"2.2 s\"\na") ? "time = \"2.2 s\"\n[[axis]]\nname = \"x\"\n" : "";
    const Outcome outcome = read(replaced(table, line, with));
    INFO(line << text::format(outcome.diagnostics));
    CHECK_FALSE(outcome.problem.has_value());
    REQUIRE(outcome.diagnostics.count() == 1);
    CHECK(outcome.diagnostics.all().front().where.line == 11);  // [[moves]] of "back"
  }
  // Without coordinated moves an axis needs its own.
  const Outcome outcome = read(replaced(table, "axes = { x = \"300 mm\", y = \"400 mm\" }\ntime", "time"));
  CHECK_FALSE(outcome.problem.has_value());
  CHECK(outcome.diagnostics.count() == 1);
}

}  // namespace coordinated_file_test
