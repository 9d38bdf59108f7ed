// SPDX-License-Identifier: Apache-2.0
// Words with which a problem chooses among parts: those that choose nothing, and bills of materials with other parts.
#include <algorithm>

#include "app/program.h"
#include "catch.h"
#include "shipped_machines.h"

namespace millwright::app::choosing_words_test {
namespace {

const std::string problems = MILLWRIGHT_SOURCE_DIR "/problems/";
const std::string lifter_problem = problems + "lifter.toml";
const std::string lifter_bom = problems + "lifter-bom.csv";

/// What `check` says of the lifter's bill of materials when the problem has this setting.
Outcome checked_with(const std::string& setting) {
  const Workshop shop;
  return shop.run({"check", lifter_problem, lifter_bom, "--set", setting});
}

TEST_CASE("A word that no part of the catalogues has is warned of where it stands, with the nearest that one has") {
  const Workshop shop;
  shop.write("m.toml", one_slide_with("frame = [\"NEMA17\"]", "frame = [\"NEMA17\", \"NEMA99\"]"));
  const Outcome frame = shop.run({"solve", "m.toml", "--quiet"});
  CHECK(frame.exit_code == 0);
  CHECK(frame.says("m.toml:14:49: warning: axis 'x': frame: the catalogues have no motor of frame 'NEMA99'"));
  const Outcome set = shop.run({"solve",
                                lifter_problem,
                                "--set",
                                "axis.z.guide.kinds=[\"profile rail\", \"bushs\"]",
                                "--set",
                                "axis.z.mechanism.screw=[\"ball_screws\", \"lead_screws\"]",
                                "--set",
                                "axis.z.mechanism.thread_forms=[\"trapezodial\"]",
                                "--set",
                                "axis.z.mechanism.nut_materials=[\"bronze\", \"BRONZE\"]"});
  CHECK(set.exit_code == 0);
  CHECK(set.says("kinds: the catalogues have no guide of kind 'bushs'"));
  CHECK(set.says("did you mean 'bush'?"));
  CHECK(set.says("thread_forms: the catalogues have no lead screw of form 'trapezodial'"));
  CHECK(set.says("nut_materials: the catalogues have no nut of material 'BRONZE'"));
  CHECK_FALSE(set.says("no nut of material 'bronze'"));
  CHECK_FALSE(set.says("no guide of kind 'profile rail'"));
  const Outcome blank = shop.run({"solve", lifter_problem, "--set", "axis.z.guide.kinds=[\"profile rail \", \" \"]"});
  CHECK(blank.exit_code == 2);
  CHECK(blank.says("kinds: 'profile rail ' begins or ends with a blank"));
  CHECK(blank.says("kinds: ' ' begins or ends with a blank"));
}

TEST_CASE("A part of a text chooses guides and no motors, and the warnings go by what the search takes") {
  const Workshop shop;
  const Outcome guide = shop.run({"solve", lifter_problem, "--set", "axis.z.guide.kinds=[\"rofile rai\"]"});
  CHECK(guide.exit_code == 0);
  CHECK_FALSE(guide.says("the catalogues have no"));
  const Outcome motor = shop.run({"solve", lifter_problem, "--set", "axis.z.motor.frame=[\"NEMA2\"]"});
  CHECK(motor.exit_code == 1);
  CHECK(motor.says("the catalogues have no motor of frame 'NEMA2'"));
  CHECK(motor.says("did you mean 'NEMA23'?"));
}

// The lifter has a bracket with screws and a screw drive with guides, no member that bends.
TEST_CASE("A limit that no check of the machine reads, and a check to enforce that is not there, are warned of") {
  const Workshop shop;
  const Outcome outcome = shop.run({"solve",
                                    lifter_problem,
                                    "--set",
                                    "axis.z.require.frame_twist='0.0001 deg'",
                                    "--set",
                                    "axis.z.require.axial_stiffness='1 N/um'",
                                    "--set",
                                    "axis.z.require.enforce=[\"C-FR-FREQ\", \"C-ST-RMS\", \"C-GD-SLOPE\"]",
                                    "--set",
                                    "require.frame_natural_frequency='5 kHz'"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.says("frame_twist: no check of axis 'z' reads it"));
  CHECK(outcome.says("frame_natural_frequency: no check of this machine reads it"));
  CHECK(outcome.says("enforce: there is no check C-FR-FREQ of axis 'z'"));
  CHECK_FALSE(outcome.says("axial_stiffness: no check"));
  CHECK_FALSE(outcome.says("no check C-ST-RMS"));
  CHECK_FALSE(outcome.says("no check C-GD-SLOPE"));  // of bushings: the guide that was chosen has none
}

TEST_CASE("No shipped machine chooses with a word that chooses nothing, or has a limit that nothing is held to") {
  for (const char* name : millwright::shipped_machines) {
    const Workshop shop;
    INFO(name);
    const Outcome outcome = shop.run({"check", problems + name + ".toml", problems + name + "-bom.csv"});
    CHECK(outcome.exit_code <= 1);
    CHECK_FALSE(outcome.says("the catalogues have no"));
    CHECK_FALSE(outcome.says("no check"));
  }
}

TEST_CASE("A word of a member is pointed at in the member's own table") {
  const Workshop shop;
  std::string text = shop.read(problems + "gantry.toml");
  const std::string kinds = "section_kinds = [\"";
  const std::size_t at = text.find(kinds);
  REQUIRE(at != std::string::npos);
  text.insert(at + kinds.size(), "round holow\", \"");
  const std::size_t line =
      1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  const std::size_t quote = at + kinds.size() - 1;
  const std::size_t column = quote - text.rfind('\n', at);
  shop.write("g.toml", text);
  const Outcome outcome = shop.run({"check", "g.toml", problems + "gantry-bom.csv"});
  CAPTURE(outcome.err);
  CHECK(outcome.says("g.toml:" + std::to_string(line) + ":" + std::to_string(column) + ":"));
  CHECK(outcome.says("section_kinds: the catalogues have no section of kind 'round holow'"));
}

TEST_CASE("A bill of materials with what the problem would not choose is checked, and that is said") {
  CHECK_FALSE(checked_with("axis.z.stroke='300 mm'").says("would not choose"));
  const auto says = [](const std::string& setting, const std::string& words) {
    const Outcome outcome = checked_with(setting);
    CAPTURE(setting, outcome.err);
    CHECK(outcome.exit_code <= 1);
    CHECK(outcome.says("lifter-bom.csv:"));
    CHECK(outcome.says("warning: axis 'z', " + words));
    CHECK(outcome.says("it is checked as it is; solve would not choose it"));
  };
  // Kinds and sizes of the bill, from the catalogues by hand.
  says("axis.z.motor.frame=[\"NEMA34\"]", "motor: 23HS45-4204S is NEMA23, and the problem takes NEMA34 (frame)");
  says("axis.z.guide.kinds=[\"bush\"]", "guide: HGH20CA clone is profile rail, and the problem takes bush (kinds)");
  says("axis.z.members.bracket.sizes=[\"M10\"]", "bracket: ISO4762 M8 8.8 is M8, and the problem takes M10 (sizes)");
  says("axis.z.members.bracket.property_classes=[\"12.9\"]",
       "bracket: ISO4762 M8 8.8 is 8.8, and the problem takes 12.9 (property_classes)");
  says("axis.z.mechanism.screw=[\"lead_screws\"]",
       "screw: SFU1605-4 (generic) is one of the ball screws, which the problem does not take");
  says("axis.z.mechanism.screw=[\"lead_screws\"]",
       "nut: SFU1605-4 (generic) is one of the nuts of ball screws, which the problem does not take");
}

TEST_CASE("A ramp outside those of the problem is said, and one of them is not") {
  const Workshop shop;
  const auto said = [&](const std::string& ramp) {
    shop.write("b.csv", shop.read(lifter_bom) + "z,acceleration_time,,,,," + ramp + "\n");
    return shop.run({"check", lifter_problem, "b.csv", "--set", "axis.z.acceleration_time=[\"0.1 s\",\"0.3 s\"]"});
  };
  CHECK(said("0.5 s").says("acceleration_time: this is 0.5 s, and the problem takes 0.1 s to 0.3 s"));
  CHECK_FALSE(said("0.3 s").says("would not choose"));
  CHECK_FALSE(said("100 ms").says("would not choose"));
  shop.write("c.csv", shop.read(lifter_bom) + "z,motor_current,,,,,2 A\n");
  CHECK(shop.run({"check", lifter_problem, "c.csv", "--set", "axis.z.motor.current=[\"1 A\", \"1.5 A\"]"})
            .says("motor_current: this is 2 A, and the problem takes 1 A, 1.5 A"));
  const std::string torch = problems + "torch-table";
  std::string bom = shop.read(torch + "-bom.csv");
  const std::size_t at = bom.find("shaft.diameter,,,,,");
  REQUIRE(at != std::string::npos);
  bom.replace(at, bom.find('\n', at) - at, "shaft.diameter,,,,,35 mm,paper");
  shop.write("t.csv", bom);
  CHECK(shop.run({"check", torch + ".toml", "t.csv"})
            .says("shaft.diameter: this is 35 mm, and the problem takes 6 mm to 30 mm"));
}

TEST_CASE("What is not cut has no length on a bill of materials") {
  const Workshop shop;
  std::string bom = shop.read(lifter_bom);
  const std::string line = "z,motor,StepperOnline,23HS45-4204S,1,,";
  REQUIRE(bom.find(line) != std::string::npos);
  shop.write("b.csv", bom.replace(bom.find(line), line.size(), "z,motor,StepperOnline,23HS45-4204S,1,77 mm,"));
  const Outcome outcome = shop.run({"check", lifter_problem, "b.csv"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("'23HS45-4204S' has a length, and the motor of axis 'z' is not cut"));
}

}  // namespace
}  // namespace millwright::app::choosing_words_test
