// SPDX-License-Identifier: Apache-2.0
#include "app/program.h"
#include "catch.h"
#include "sanitized.h"

namespace millwright::app::command_line_test {
namespace {

struct Case {
  std::vector<std::string> words;
  const char* complaint;
};

TEST_CASE("Every mistake on the command line is exit code 2 with a hint, and prints nothing") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const std::vector<Case> cases = {
      {{}, "hint: commands: new, solve, pareto, check"},
      {{"slove", "m.toml"}, "there is no command 'slove'\n  hint: did you mean 'solve'?"},
      {{"catalogue", "lst"}, "there is no command 'catalogue lst'\n  hint: did you mean 'list'?"},
      {{"solve"}, "PROBLEM is required"},
      {{"solve", "m.toml", "b.toml"}, "not expected: b.toml"},
      {{"solve", "m.toml", "--minimze", "mass"}, "there is no option '--minimze'"},
      {{"solve", "m.toml", "--minimise", "weight"}, "command line:1:12: error: there is no quantity 'weight'"},
      {{"solve", "m.toml", "--minimise", "cost + 25*mas"}, "command line:1:22: error: there is no quantity 'mas'"},
      {{"solve", "m.toml", "--minimise", "cost + 25*mas"}, "hint: did you mean 'mass'?"},
      {{"solve", "m.toml", "--minimise", ""}, "the name of a quantity is expected here"},
      {{"solve", "m.toml", "--json", ""}, "--json: the name is empty"},
      {{"solve", "m.toml", "--bom", ""}, "--bom: the name is empty"},
      {{"solve", "m.toml", "--order", ""}, "--order: the name is empty"},
      {{"solve", "m.toml", "--bom", "build.xlsx"}, "--bom: build.xlsx: a .csv file is expected here"},
      {{"solve", "m.toml", "--bom", "-"}, "--bom: -: a .csv file is expected here"},
      {{"solve", "m.toml", "--report", "sheet.PDF"}, "--report: sheet.PDF: a .html file is expected here"},
      {{"solve", "m.toml", "--report", "sheet.md"}, "--report: sheet.md: a .html file is expected here"},
      {{"solve", "m.toml", "--locked", ""}, "--locked: the name is empty"},
      {{"check", "m.toml", "b.csv", "--write-lock", ""}, "--write-lock: the name is empty"},
      {{"check", "m.toml", "b.csv", "--hold-origin", ""}, "--hold-origin: the name is empty"},
      {{"calc", "power_screw.raising_torque", "--unit", ""}, "--unit: the name is empty"},
      {{"catalogue", "diff", "a", "--family", ""}, "--family: the name is empty"},
      {{"solve", "m.toml", "--minimise", "position_error"}, "--minimise: position_error: axis 'x' has no error budget"},
      {{"pareto", "m.toml", "--minimise", "cost,cost + mass"}, "a front is of plain quantities"},
      {{"pareto", "m.toml", "--minimise", "cost,cost"}, "a front has two or three different objectives"},
      {{"solve", "m.toml", "--minimise", "cost,mass"}, "hint: 'millwright pareto' gives the front of two"},
      {{"pareto", "m.toml", "--minimise", "cost"}, "hint: write --minimise cost,mass"},
      {{"solve", "m.toml", "--threads", "0"}, "--threads"},
      {{"solve", "m.toml", "--threads", "x"}, "--threads"},
      {{"solve", "m.toml", "--time-limit", "-3"}, "-3 is not a number above 0"},
      {{"solve", "m.toml", "--time-limit", "nan"}, "nan is not a number above 0"},
      {{"solve", "m.toml", "--gap", "2"}, "2 is not a number from 0 to 1"},
      {{"solve", "m.toml", "--gap", "nan"}, "nan is not a number from 0 to 1"},
      {{"solve", "m.toml", "--set", "stroke"}, "'=' is missing"},
      {{"solve", "m.toml", "--json"}, "--json"},
      {{"formulas", "no_such_formula"}, "hint: 'millwright formulas' lists all"},
      {{"catalogue", "list", "stepers"}, "hint: did you mean 'steppers'?"},
      {{"catalogue", "show", "no-such-part"}, "no-such-part"},
  };
  std::size_t number = 0;
  for (const Case& each : cases) {
    if (millwright::sanitized && number++ % 3 > 0) continue;
    const Outcome outcome = shop.run(each.words);
    CAPTURE(each.complaint, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.says(each.complaint));
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("Help and version") {
  const Workshop shop;
  CHECK(shop.run({"--version"}).exit_code == 0);
  CHECK(shop.run({"--version"}).out == "millwright 0.1.0\n");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--help"},
                                                                                     {"solve", "--help"},
                                                                                     {"pareto", "--help"},
                                                                                     {"check", "--help"},
                                                                                     {"audit", "--help"},
                                                                                     {"calc", "--help"},
                                                                                     {"formulas", "--help"},
                                                                                     {"new", "--help"},
                                                                                     {"reference", "--help"},
                                                                                     {"schema", "--help"},
                                                                                     {"catalogue", "--help"},
                                                                                     {"catalogue", "lint", "--help"}}) {
    const Outcome outcome = shop.run(words);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.prints("Examples:\n  millwright "));
    CHECK(outcome.err.empty());
  }
}

TEST_CASE("Reference and schema are printed, and take nothing") {
  const Workshop shop;
  const Outcome reference = shop.run({"reference"});
  CHECK(reference.exit_code == 0);
  CHECK(reference.out.rfind("# The problem file\n", 0) == 0);
  CHECK(reference.prints("## `[[axis.moves]]`\n"));
  CHECK(reference.prints(
      "| `life` | time, `\"10000 h\"` | `\"10000 h\"` (iso3408_5) | Service life of screws and guides |\n"));
  const Outcome schema = shop.run({"schema"});
  CHECK(schema.exit_code == 0);
  CHECK(schema.prints("\"$schema\": \"http://json-schema.org/draft-07/schema#\""));
  for (const char* verb : {"reference", "schema"}) CHECK(shop.run({verb, "x"}).exit_code == 2);
}

TEST_CASE("The version is that of the project") {
  std::ifstream stream(MILLWRIGHT_SOURCE_DIR "/CMakeLists.txt");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  const Workshop shop;
  const std::string version = shop.run({"--version"}).out.substr(11);
  CHECK(text.find("project(millwright VERSION " + version.substr(0, version.size() - 1) + " ") != std::string::npos);
}

TEST_CASE("A search that the memory is too small for says so") {
  if (sanitized) return;  // these take all address space there is
  const Workshop shop;
  const Outcome outcome = shop.run({"pareto", MILLWRIGHT_SOURCE_DIR "/problems/router.toml"}, rlim_t{100} << 20U);
  CHECK(outcome.exit_code == 70);
  CHECK(outcome.says("millwright: error: not enough memory\n"));
  CHECK(outcome.out.empty());
}

}  // namespace
}  // namespace millwright::app::command_line_test
