// SPDX-License-Identifier: Apache-2.0
// Measured profiles and jerk in a problem file: what is read, and what is said about wrong ones.
#include <fmt/format.h>

#include <cmath>

#include "catalogue/temporary_folder.h"
#include "problem_text.h"
#include "sanitized.h"

namespace profile_file_test {

using namespace problem_text;
using millwright::sanitized;

namespace {

const std::string lift = R"(
[supply]
voltage = ["24 V"]
[[axis]]
name = "z"
direction = "vertical"
stroke = "150 mm"
structure_mass = "4 kg"
mechanism = { kind = "belt" }
[[axis.moves]]
name = "measured"
profile = "z.csv"
dwell = "0.5 s"
)";

const std::string good = "time [s],position [mm],force [N]\n0,0,0\n0.1,5,0\n0.2,20,10\n0.3,35,10\n0.4,40,0\n";

Outcome read_files(const std::string& problem, const std::string& profile, const char* name = "z.csv") {
  const TemporaryFolder folder;
  const auto path = folder.write("problem.toml", problem);
  folder.write(name, profile);
  Outcome outcome;
  outcome.problem = machine::read_problem(path, {}, outcome.diagnostics);
  return outcome;
}

/// The profile is refused at the marks, in these words.
void check_profile(std::string profile, const std::string& message) {
  const Place place = take_marks(profile);
  const Outcome outcome = read_files(lift, profile);
  INFO(profile << "\n" << text::format(outcome.diagnostics));
  CHECK_FALSE(outcome.problem.has_value());
  REQUIRE(outcome.diagnostics.count() == 1);
  const text::Diagnostic said = outcome.diagnostics.all().front();
  REQUIRE(said.where.text != nullptr);
  CHECK(said.where.text->path().ends_with("z.csv"));
  CHECK(said.where.line == place.line);
  CHECK(said.where.column == place.column);
  CHECK(said.message.find(message) != std::string::npos);
  CHECK_FALSE(said.hint.empty());
}

}  // namespace

// Even accelerations: 0.1 s to 100 mm/s. Parabolas give 0, 100, 150, 100, 0 mm/s at the samples.
TEST_CASE("A profile of positions and forces is read into SI") {
  const Outcome outcome = read_files(lift, good);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const machine::Axis& z = outcome.problem->axes[0];
  REQUIRE(z.moves.size() == 1);
  CHECK(z.moves[0].dwell == Approx(0.5));
  REQUIRE(z.moves[0].profile);
  const machine::MeasuredProfile& profile = *z.moves[0].profile;
  CHECK(profile.time == Approx(0.4));
  CHECK(profile.extent == Approx(0.04));
  CHECK(profile.peak_speed == Approx(0.15));
  CHECK(profile.largest_force == Approx(10.0));
  CHECK(profile.phases.front().acceleration == Approx(1.0));
  CHECK(z.acceleration_time.fixed());  // no ramp is left to choose
}

// From standstill with 0.4 m/s2: the parabola through the first three samples leaves 7e-18 m/s backwards at the first.
TEST_CASE("What differences of positions leave of a standstill is no motion") {
  const Outcome outcome = read_files(replaced(lift, "\"vertical\"", "\"horizontal\""),
                                     "time [s],position [mm],force [N]\n0,0,0\n0.25,12.5,0\n0.5,50,0\n0.75,87.5,50\n"
                                     "1,100,50\n1.5,100,0\n2.5,0,0\n");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  const auto& phases = outcome.problem->axes[0].moves[0].profile->phases;
  CHECK_FALSE(phases.front().backwards);
  for (const machine::ProfilePhase& phase : phases) CHECK(phase.duration > 0.01);
}

TEST_CASE("A profile is understood as a spreadsheet writes it, in any unit that fits") {
  const Outcome outcome = read_files(lift,
                                     "\xEF\xBB\xBF# recorded on Monday\r\nforce [kN];speed [m/min];time "
                                     "[ms]\r\n0;0;0\r\n0,01;6;100\r\n0,02;3;200,5\r\n0;0;300\r\n");
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const machine::MeasuredProfile& profile = *outcome.problem->axes[0].moves[0].profile;
  CHECK(profile.peak_speed == Approx(0.1));
  CHECK(profile.largest_force == Approx(20.0));
  CHECK(profile.time == Approx(0.3));
  // 0.005 m, (0.1 + 0.05)/2 * 0.1005 m, 0.05/2 * 0.0995 m
  CHECK(profile.travelled == Approx(0.005 + 0.0075375 + 0.0024875));
}

TEST_CASE("A table's profile is one of angles and torques") {
  const std::string table = replaced(replaced(lift,
                                              "direction = \"vertical\"\nstroke = \"150 mm\"",
                                              "stroke = \"180 deg\"\nstructure_inertia = \"0.02 kg.m2\""),
                                     "\"belt\"",
                                     "\"rotary\"");
  const Outcome outcome =
      read_files(table, "time [s],angle [deg],torque [N.m]\n0,0,1\n0.1,9,1\n0.2,36,1\n0.3,63,1\n0.4,72,1\n");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  const machine::MeasuredProfile& profile = *outcome.problem->axes[0].moves[0].profile;
  CHECK(profile.extent == Approx(72.0 * 3.14159265358979 / 180.0));
  CHECK(profile.largest_force == Approx(1.0));
}

TEST_CASE("A recording that begins or ends in motion is warned of") {
  const auto warned = [](const std::string& profile) {
    const Outcome outcome = read_files(lift, profile);
    CHECK(outcome.diagnostics.error_count() == 0);
    REQUIRE(outcome.problem);
    return text::format(outcome.diagnostics);
  };
  const std::string ends = warned("time [s],speed [mm/s]\n0,0\n0.1,100\n0.2,80\n");
  CHECK(ends.find("z.csv:4:") != std::string::npos);
  CHECK(ends.find("the recording ends in motion, at 80 % of its largest speed: what stops the axis") !=
        std::string::npos);
  CHECK(ends.find("begins") == std::string::npos);
  const std::string begins = warned("time [s],speed [mm/s]\n0,-50\n0.1,-100\n0.2,0\n");
  CHECK(begins.find("z.csv:2:") != std::string::npos);
  CHECK(begins.find("the recording begins in motion, at 50 %") != std::string::npos);
  CHECK(warned("time [s],speed [mm/s]\n0,1\n0.1,100\n0.2,-1\n").empty());
}

TEST_CASE("A wrong profile is refused at its place") {
  check_profile("«»time [s],position [mm]\n0,0\n1,5\n", "has 2 samples");
  check_profile("«»position [mm],force [N]\n0,0\n1,5\n2,6\n", "no column 'time'");
  check_profile("«»time [s],force [N]\n0,0\n1,5\n2,6\n", "no column 'position' or 'speed'");
  check_profile("time [s],position [mm],«speed» [mm/s]\n0,0,0\n1,5,1\n2,6,1\n", "both 'position' and 'speed'");
  check_profile("time [s],«posision» [mm]\n0,0\n1,5\n2,6\n", "no column 'posision'");
  check_profile("time [s],position [mm],«temperature» [K]\n0,0,1\n1,5,1\n2,6,1\n", "no column 'temperature'");
  check_profile("time [s],«position»\n0,0\n1,5\n2,6\n", "no unit");
  check_profile("time [«mm»],position [mm]\n0,0\n1,5\n2,6\n", "time:");
  check_profile("time [s],position [mm]\n0,0\n1,«five»\n2,6\n", "five");
  check_profile("time [s],position [mm]\n0,0\n1,«»\n2,6\n", "the cell is empty");
  check_profile("time [s],position [mm]\n0,0\n2,5\n«1»,6\n", "not after the sample before");
  check_profile("time [s],position [mm]\n0,0\n2,5\n«2»,6\n", "not after the sample before");
  check_profile("time [s],position [mm]\n0,0\n1,5\n«1.0000000001»,6\n", "less than 1 ns");
  check_profile("time [s],position [mm]\n0,0\n1,5\n2,«9e9»\n", "more than any machine");
  check_profile("«»time [s],position [mm]\n0,3\n1,3\n2,3\n", "nothing moves");
  check_profile("«»time [s],speed [mm/s]\n0,9\n1,9\n2,5\n", "nothing gets faster");
  check_profile("time [s],position [mm]\n«»0,0\n1e-6,50\n2e-6,100\n", "the speed at this sample");
}

TEST_CASE("A profile that is not there, or does not fit the axis, is refused in the problem file") {
  const auto said = [](const std::string& problem, const std::string& profile, const char* name = "z.csv") {
    const Outcome outcome = read_files(problem, profile, name);
    INFO(text::format(outcome.diagnostics));
    CHECK_FALSE(outcome.problem.has_value());
    REQUIRE(outcome.diagnostics.count() == 1);
    const text::Diagnostic first = outcome.diagnostics.all().front();
    REQUIRE(first.where.text != nullptr);
    CHECK(first.where.text->path().ends_with("problem.toml"));
    CHECK(first.where.line == 12);
    CHECK_FALSE(first.hint.empty());
    return first.message;
  };
  CHECK(said(lift, good, "other.csv").find("z.csv") != std::string::npos);
  CHECK(said(replaced(lift, "\"z.csv\"", "7"), good).find("name of a file") != std::string::npos);
  CHECK(said(replaced(lift, "\"z.csv\"", "\"\""), good).find("name of a file") != std::string::npos);
  CHECK(said(lift, "time [s],position [mm]\n0,-80\n1,-80\n2,-80\n3,0\n4,80\n5,80\n6,80\n")
            .find("160 mm is longer than the stroke") != std::string::npos);
  CHECK(said(replaced(lift, "name = \"measured\"\nprofile", "\nforce = \"3 N\"\nprofile"), good).find("force") !=
        std::string::npos);
}

TEST_CASE("What a profile says is not said again") {
  for (const char* line : {"distance = \"20 mm\"",
                           "time = \"2 s\"",
                           "speed = \"20 mm/s\"",
                           "jerk = \"9 m/s^3\"",
                           "acceleration_time = \"0.1 s\"",
                           "force = \"3 N\""}) {
    const Outcome outcome = read_files(lift + line + "\n", good);
    INFO(line << "\n" << text::format(outcome.diagnostics));
    CHECK_FALSE(outcome.problem.has_value());
    CHECK(outcome.diagnostics.count() == 1);
  }
}

TEST_CASE("A million samples are gathered into a few phases") {
  const int samples = sanitized ? 100000 : 1000000;
  const double step = 100.0 / samples;
  std::string profile = "time [s],speed [mm/s],force [N]\n";
  for (int i = 0; i < samples; ++i) {
    const double t = i * step;
    profile += fmt::format("{:.4f},{:.5f},{:.3f}\n", t, 100.0 * std::sin(t), 5.0 + 3.0 * std::sin(7.0 * t));
  }
  // sin swings by 1 - cos: 200 mm at 100 mm/s.
  const Outcome outcome = read_files(replaced(lift, "150 mm", "201 mm"), profile);
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  CHECK(outcome.problem->axes[0].moves[0].profile->phases.size() <= 2 * 17 * 9);
  CHECK(outcome.problem->axes[0].moves[0].profile->time == Approx(100.0 - step));
}

TEST_CASE("Jerk is that of the move, else of the axis, and its ramp must have time") {
  const std::string base = replaced(lift, "profile = \"z.csv\"", "distance = \"100 mm\"\nspeed = \"200 mm/s\"");
  const auto of = [](const std::string& text) {
    const Outcome outcome = read(text);
    INFO(text::format(outcome.diagnostics));
    REQUIRE(outcome.problem);
    return outcome.problem->axes[0].moves[0].jerk;
  };
  CHECK_FALSE(of(base).has_value());
  CHECK(of(base + "jerk = \"50 m/s^3\"\n") == 50.0);
  const std::string axis = replaced(base, "structure_mass", "jerk = \"20 m/s^3\"\nstructure_mass");
  CHECK(of(axis) == 20.0);
  CHECK(of(axis + "jerk = \"5e4 mm/s^3\"\n") == Approx(50.0));
  // The cruise of 0.5 s leaves 0.5 s for a ramp: 4 * 0.2/0.25 = 3.2 m/s3 at least.
  CHECK(of(base + "jerk = \"3.21 m/s^3\"\n") == Approx(3.21));
  check({"jerk = \"20 m/s^3\"", "jerk = «\"3.19 m/s^3\"»", "0.5008 s", "3.20"}, axis);
  check({"dwell = \"0.5 s\"", "jerk = «\"3.19 m/s^3\"»", "0.5008 s", "longer ramps"}, base);
  check({"dwell = \"0.5 s\"", "jerk = \"50 «m/s^2»\"", "jerk", ""}, base);
}

// 450 mm along the line by 3-4-5: 0.8 of it for x, 0.6 for y, at 500 mm/s and 40 m/s3.
TEST_CASE("The shipped inserter moves in every way") {
  Outcome outcome;
  outcome.problem = machine::read_problem(MILLWRIGHT_SOURCE_DIR "/problems/inserter.toml", {}, outcome.diagnostics);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  const auto& axes = outcome.problem->axes;
  REQUIRE(axes.size() == 3);
  REQUIRE(axes[0].moves.size() == 1);
  CHECK(axes[0].moves[0].profile.has_value());
  REQUIRE(axes[1].moves.size() == 2);
  CHECK(*axes[1].moves[0].speed == Approx(0.3));
  CHECK(*axes[1].moves[0].jerk == Approx(24.0));
  REQUIRE(axes[2].moves.size() == 3);
  CHECK(axes[2].moves[0].jerk == 25.0);  // its own move has the jerk of the axis
  CHECK(*axes[2].moves[1].speed == Approx(0.4));
  CHECK(*axes[2].moves[1].jerk == Approx(32.0));
  CHECK_FALSE(axes[2].acceleration_time.fixed());
}

// Without a jerk of the path no axis exceeds its own: 20 m/s3 of x, 0.6 of the way, are 33.3 along it; 8 m/s3 of y,
// 0.8 of the way, are 10. So y sets it, and x gets 6.
TEST_CASE("A coordinated move has the jerk that its axes allow") {
  const Outcome outcome = read(R"(
[supply]
voltage = ["24 V"]
[[moves]]
name = "diagonal"
axes = { x = "300 mm", y = "400 mm" }
speed = "100 mm/s"
acceleration_time = "0.3 s"
[[axis]]
name = "x"
carries = ["y"]
stroke = "500 mm"
structure_mass = "4 kg"
jerk = "20 m/s^3"
mechanism = { kind = "belt" }
[[axis]]
name = "y"
stroke = "400 mm"
structure_mass = "4 kg"
jerk = "8 m/s^3"
mechanism = { kind = "belt" }
)");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  CHECK(*outcome.problem->axes[0].moves[0].jerk == Approx(6.0));
  CHECK(*outcome.problem->axes[1].moves[0].jerk == Approx(8.0));
}

}  // namespace profile_file_test
