// SPDX-License-Identifier: Apache-2.0
// [tool], [limits] and enforced constraints in a problem file: what is read, and what is said about wrong ones.
#include "problem_text.h"

namespace tool_file_test {

using namespace problem_text;
using text::Severity;

namespace {

const std::string machine_text = R"(
[currency]
USD = 1.0
EUR = { rate = 1.08, date = 2026-01-15 }
[supply]
voltage = ["24 V"]
[limits]
cost = "500 EUR"
mass = "12 kg"
[require]
enforce = ["C-ST-RMS"]
[tool]
axis = "z"
force = { x = "200 N", z = "100 N" }
deflection = "0.05 mm"
stiffness = "4 N/um"
[[axis]]
name = "z"
direction = "vertical"
normal = "y"
stroke = "100 mm"
structure_mass = "1 kg"
mechanism = { kind = "belt" }
guide = { carriages = 4, carriage_spacing = "80 mm", rail_spacing = "60 mm", tool_at = ["-70 mm", "10 mm", "50 mm"] }
[[axis.moves]]
distance = "80 mm"
time = "1 s"
)";

void check_all(const std::vector<Case>& cases) {
  for (const Case& one : cases) check(one, machine_text);
}

}  // namespace

TEST_CASE("Tool, limits and enforced constraints are read into SI") {
  const Outcome outcome = read(machine_text);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  REQUIRE(outcome.problem->tool);
  const machine::Tool& tool = *outcome.problem->tool;
  CHECK(tool.axis == 0);
  CHECK(tool.force[0] == Approx(200.0));
  CHECK(tool.force[1] == 0.0);
  CHECK(tool.force[2] == Approx(100.0));
  CHECK(tool.deflection.value() == Approx(5e-5));
  CHECK(tool.stiffness == Approx(4e6));
  CHECK(*outcome.problem->limits[machine::Quantity::cost] == Approx(540.0));
  CHECK(*outcome.problem->limits[machine::Quantity::mass] == Approx(12.0));
  CHECK(outcome.problem->axes[0].require.enforces("C-ST-RMS"));
  CHECK_FALSE(outcome.problem->axes[0].require.enforces("C-ST-TEMP"));
  CHECK(outcome.problem->axes[0].along == std::size_t{2});
  CHECK(outcome.problem->axes[0].normal == std::size_t{1});
  CHECK((*outcome.problem->axes[0].guide->tool_at)[0] == Approx(-0.07));
}

TEST_CASE("What is wrong with tool, limits or enforced constraints is said at the place") {
  check_all({
      {"axis = \"z\"", "axis = «\"zz\"»", "axis: there is no axis 'zz'", "z"},
      {"force = { x = \"200 N\", z = \"100 N\" }", "force = «{ x = \"0 N\" }»", "force: there is none", "200 N"},
      {"force = { x = \"200 N\", z = \"100 N\" }", "force = { x = \"«-2» N\" }", "x: must not be negative", ""},
      {"normal = \"y\"", "normal = «\"z\"»", "normal: that is the direction of the travel", "leans on x or y"},
      {"normal = \"y\"", "along = «\"x\"»\nnormal = \"y\"", "along: axis 'z' is vertical", "along z"},
      {"guide = { carriages = 4, carriage_spacing = \"80 mm\", rail_spacing = \"60 mm\", tool_at = [\"-70 mm\", \"10 "
       "mm\", "
       "\"50 mm\"] }",
       "guide = «{ carriages = 4, carriage_spacing = \"80 mm\", rail_spacing = \"60 mm\" }»",
       "tool_at: where is the tool",
       "tool_at = "},
      {machine_text.substr(machine_text.find("direction")),
       "direction = \"horizontal\"\nalong = \"x\"\nnormal = \"y\"\nstroke = \"100 mm\"\nstructure_mass = \"1 kg\"\n"
       "mechanism = { kind = \"belt\" }\n"
       "guide = «{ carriages = 4, carriage_spacing = \"80 mm\", rail_spacing = \"60 mm\", "
       "tool_at = [\"-70 mm\", \"10 mm\", \"50 mm\"] }»\n"
       "[[axis.moves]]\ndistance = \"80 mm\"\ntime = \"1 s\"\n",
       "guide: its rails stand on a face",
       "load_height",
       Severity::warning},
      {"tool_at = [\"-70 mm\", \"10 mm\", \"50 mm\"]",
       "tool_at = «[\"-70 mm\", \"10 mm\"]»",
       "tool_at: needs three lengths",
       "above the guides"},
      {"deflection = \"0.05 mm\"",
       "position_error = \"«0» mm\"",
       "position_error: must be greater than zero",
       "700 mm"},
      {"cost = \"500 EUR\"", "cost = «\"500 GBP\"»", "cost: needs an amount above zero", "USD"},
      {"cost = \"500 EUR\"", "cost = «\"-1 USD\"»", "cost: needs an amount above zero", "USD"},
      {"mass = \"12 kg\"", "mass = \"12 «N»\"", "mass", ""},
      {"enforce = [\"C-ST-RMS\"]", "enforce = [«\"C-ST-RNS\"»]", "is no constraint that is only reported", "C-ST-RMS"},
      {"enforce = [\"C-ST-RMS\"]", "enforce = [«\"C-ST-TORQUE\"»]", "is no constraint that is only reported", ""},
  });
}

}  // namespace tool_file_test
