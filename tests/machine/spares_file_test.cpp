// SPDX-License-Identifier: Apache-2.0
// The table [spares] of a problem file.
#include "machine/spares_file.h"

#include "catch.h"
#include "machine/problem_file.h"
#include "text/document.h"

namespace spares_file_test {

using namespace millwright;

namespace {

const std::string axis = R"(
[supply]
voltage = "24 V"
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "4 kg"
guide_friction = 0.05
acceleration_time = "0.1 s"
mechanism = { kind = "belt" }
[[axis.moves]]
distance = "200 mm"
time = "6 s"
)";

struct Read {
  explicit Read(const std::string& spares) {
    const auto text = text::SourceText::from_string("machine.toml", spares + axis);
    if (const auto document = text::read_toml(text, diagnostics)) problem = machine::problem_of(*document, diagnostics);
  }
  text::Diagnostics diagnostics;
  std::optional<machine::Problem> problem;
};

}  // namespace

TEST_CASE("Spares are counted by slot, of all axes or of one") {
  const Read read("[spares]\nmotor = 1\n\"x.motor\" = 2\nbelt = 3\nsupply = 1\n");
  INFO(text::format(read.diagnostics));
  REQUIRE(read.problem);
  CHECK(machine::spares_of(*read.problem, "x", "motor") == 3.0);
  CHECK(machine::spares_of(*read.problem, "y", "motor") == 1.0);
  CHECK(machine::spares_of(*read.problem, "x", "belt") == 3.0);
  CHECK(machine::spares_of(*read.problem, "machine", "supply") == 1.0);
  // As reports and bills of materials call it.
  const Read machine("[spares]\n\"machine.supply\" = 2\n");
  REQUIRE(machine.problem);
  CHECK(machine::spares_of(*machine.problem, "machine", "supply") == 2.0);
  CHECK(machine::spares_of(*machine.problem, "x", "motor") == 0.0);
  CHECK(machine::spares_of(*read.problem, "x", "driver") == 0.0);
}

TEST_CASE("What is wrong with spares is said at its place") {
  const Read read("[spares]\nmotr = 1\nscrew = 1\n\"y.motor\" = 1\nbelt = 0.5\ndriver = -1\nx.motor = 1\n");
  const std::string text = text::format(read.diagnostics);
  INFO(text);
  CHECK_FALSE(read.problem);
  CHECK(read.diagnostics.error_count() == 6);
  CHECK(text.find("machine.toml:2:1: error: spares: nothing is chosen from a catalogue for 'motr'") != text.npos);
  CHECK(text.find("did you mean 'motor'?") != text.npos);
  CHECK(text.find("machine.toml:3:1: error: spares: nothing is chosen from a catalogue for 'screw'") != text.npos);
  CHECK(text.find("machine.toml:5:8: error: spares: belt is no number of pieces") != text.npos);
  CHECK(text.find("\"x.motor\" = 1") != text.npos);
}

}  // namespace spares_file_test
