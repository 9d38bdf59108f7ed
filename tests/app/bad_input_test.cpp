// SPDX-License-Identifier: Apache-2.0
// What bad input gets: the exact place, a hint, exit code 2, and no output.
#include <random>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::bad_input_test {
namespace {

/// The machine with one change; `complaint` must be in standard error, with its place and its hint.
void refuses(const std::string& from, const std::string& to, const std::string& complaint) {
  const Workshop shop;
  shop.write("m.toml", one_slide_with(from, to));
  const Outcome outcome = shop.run({"solve", "m.toml", "--bom", "b.csv", "--json", "r.json"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says(complaint));
  CHECK(outcome.out.empty());
  CHECK(shop.entries() == 1);
}

TEST_CASE("A misspelt key is named with the key that was meant") {
  refuses("guide_friction",
          "gide_friction",
          "m.toml:11:1: error: unknown key 'gide_friction' in axis 'x'\n"
          "   11 | gide_friction = 0.1\n"
          "      | ^~~~~~~~~~~~~ hint: did you mean 'guide_friction'?\n");
}

TEST_CASE("A mass is no speed") {
  refuses("time = \"20 s\"",
          "speed = \"20 kg\"",
          "m.toml:17:13: error: speed: 'kg' (kg) does not fit: 'mm/s' (m/s) is wanted\n"
          "   17 | speed = \"20 kg\"\n"
          "      |             ^~ hint: write for example \"20 mm/s\"\n");
}

TEST_CASE("A bare number needs a unit") {
  refuses("force = \"20 N\"", "force = 20", "m.toml:18:9: error: force: a bare number where a unit is needed");
  refuses("force = \"20 N\"", "force = 20", "hint: write \"20 N\"");
}

TEST_CASE("A number that is none is complained about once") {
  for (const char* word : {"nan", "-inf"}) {
    const Workshop shop;
    shop.write("m.toml", one_slide_with("\"5 kg\"", word));
    const Outcome outcome = shop.run({"solve", "m.toml"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.says("m.toml:10:18: error: not a finite number"));
    CHECK(outcome.says("\n1 error, "));
  }
}

TEST_CASE("An unknown unit is named with the nearest one") {
  refuses("\"5 kg\"",
          "\"5 kgg\"",
          "m.toml:10:21: error: structure_mass: unknown unit 'kgg'\n"
          "   10 | structure_mass = \"5 kgg\"\n"
          "      |                     ^~~ hint: did you mean 'kg'?\n");
}

TEST_CASE("A mass is not negative") {
  refuses("\"5 kg\"",
          "\"-5 kg\"",
          "m.toml:10:19: error: structure_mass: must not be negative\n"
          "   10 | structure_mass = \"-5 kg\"\n"
          "      |                   ^~ hint: write for example \"16 kg\"\n");
}

TEST_CASE("An axis does not carry itself") {
  refuses("name = \"x\"",
          "name = \"x\"\ncarries = [\"x\"]",
          "m.toml:8:12: error: carries: axis 'x' carries itself\n"
          "    8 | carries = [\"x\"]\n"
          "      |            ^~~ hint: leave it out\n");
}

TEST_CASE("A move that its own ramps do not fit is refused where it stands") {
  refuses("time = \"20 s\"",
          "time = \"0.1 s\"",
          "m.toml:17:8: error: time: the move is faster than its ramps allow: two ramps of 0.1 s in 0.1 s\n"
          "   17 | time = \"0.1 s\"\n"
          "      |        ^~~~~~~ hint: make acceleration_time 0.05 s or less, or allow more time\n");
}

TEST_CASE("What the search cannot hold cannot be enforced, and what holds it instead is said") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome supply = shop.run({"solve", "m.toml", "--set", "require.enforce=[\"C-PSU-CURRENT\"]"});
  CHECK(supply.exit_code == 2);
  CHECK(supply.says("C-PSU-CURRENT is of all motors together"));
  CHECK(supply.says("a larger supply_reserve asks for a larger supply"));
  CHECK(shop.run({"solve", "m.toml", "--set", "require.enforce=[\"C-ST-RMS\"]", "--quiet"}).exit_code == 0);
}

TEST_CASE("A material that does not exist is named with the nearest one") {
  refuses("[[axis.moves]]",
          "[[axis.members]]\nname = \"beam\"\nkind = \"beam\"\nlength = \"400 mm\"\nmaterial = \"S235JX\"\n"
          "sections = [\"steel_sections\"]\n[[axis.moves]]",
          "m.toml:15:1: error: axis 'x', beam: no part 'S235JX' in materials");
}

TEST_CASE("All mistakes of a file are reported at once, and bad settings too") {
  const Workshop shop;
  std::string text = one_slide_with("\"5 kg\"", "\"5 kgg\"");
  text.replace(text.find("force ="), 7, "forse =");
  shop.write("m.toml", text);
  const Outcome outcome = shop.run(
      {"solve", "m.toml", "--set", "axis.y.stroke=1 m", "--set", "axis.x.direction=up", "--catalogue", "none"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("m.toml:10:21: error: "));
  CHECK(outcome.says("m.toml:18:1: error: unknown key 'forse'"));
  CHECK(outcome.says("hint: did you mean 'force'?"));
  CHECK(outcome.says("command line:1:"));
  CHECK(outcome.says("none: error: cannot be opened"));
  CHECK(outcome.out.empty());
}

TEST_CASE("A value that is set twice is refused: the last one would win without a word") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome twice = shop.run(
      {"solve", "m.toml", "--set", "axis.x.stroke=200 mm", "--set", "axis.x.stroke=201 mm", "--set", "axis.y.x=1"});
  CHECK(twice.exit_code == 2);
  CHECK(twice.says("--set axis.x.stroke is given twice"));
  CHECK(twice.says("axis.y.x"));
}

TEST_CASE("A JSON problem of nothing but null is no silence") {
  const Workshop shop;
  shop.write("n.json", " null\n");
  for (const char* verb : {"solve", "pareto", "explain", "audit"}) {
    const Outcome outcome = shop.run({verb, "n.json"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.says("n.json:1:2: error: JSON: nothing but null"));
  }
}

TEST_CASE("A reduction without a price is warned of where it stands") {
  const Workshop shop;
  const std::string ends = "ends = \"fixed-free\"";
  shop.write("m.toml", one_slide_with(ends, ends + ", reduction = { ratio = 1.5 }"));
  CHECK(shop.run({"solve", "m.toml"}).says("m.toml:13:89: warning: "));
  CHECK(shop.run({"solve", "m.toml"}).says("has no price and counts as free"));
  shop.write("m.toml", one_slide_with(ends, ends + ", reduction = { ratio = 1.5, price = \"0 USD\" }"));
  const Outcome free = shop.run({"solve", "m.toml"});
  CHECK(free.exit_code == 0);
  CHECK_FALSE(free.says("has no price"));
}

TEST_CASE("A problem that is not there, is a folder or is no TOML") {
  const Workshop shop;
  shop.write("bad.toml", "title = \"a\nb\"\n");
  CHECK(shop.run({"solve", "no.toml"}).says("no.toml: error: cannot be opened: No such file or directory"));
  CHECK(shop.run({"solve", "no.toml"}).exit_code == 2);
  CHECK(shop.run({"solve", "."}).exit_code == 2);
  CHECK(shop.run({"solve", "bad.toml"}).exit_code == 2);
  CHECK(shop.run({"solve", "bad.toml"}).says("bad.toml:1:"));
  CHECK(shop.run({"check", "no.toml", "no.csv"}).says("no.csv: error: cannot be opened"));
  CHECK(shop.run({"audit", "no.toml"}).exit_code == 2);
}

// --- catalogues
// -------------------------------------------------------------------------------------------------------

const char* driver_header =
    "manufacturer,part_number,kind,minimum_voltage [V],maximum_voltage [V],recommended_maximum_voltage [V],"
    "rms_current [A],peak_current [A],maximum_microsteps [1],price,currency,price_basis,source,confidence\n";
const char* driver_row = "Acme,D1,box,9,42,36,2.8,4,32,9,USD,shop,shop page,high\n";

Outcome solve_with_drivers(const std::string& contents) {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("parts/drivers/d.csv", contents);
  Outcome outcome = shop.run({"solve", "m.toml", "--catalogue", "parts"});
  if (outcome.exit_code == 2) CHECK(outcome.out.empty());
  return outcome;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

void refuses_drivers(const std::string& contents, const std::string& complaint) {
  const Outcome outcome = solve_with_drivers(contents);
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says(complaint));
}

TEST_CASE("A good overlay is accepted") {
  CHECK(solve_with_drivers(std::string(driver_header) + driver_row).exit_code == 0);
}

TEST_CASE("Catalogues of a problem that do not exist are named where the problem names them") {
  const Workshop shop;
  shop.write("m.toml", "catalogues = [\"parts\", \"more\"]\n" + std::string(one_slide));
  shop.write("parts/drivers/d.csv", std::string(driver_header) + driver_row);
  const Outcome outcome = shop.run({"solve", "m.toml"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("m.toml:1:24: error: there is no catalogue 'more'"));
  CHECK(outcome.says("1 error\n"));
}

TEST_CASE("An empty catalogue, and an empty folder") {
  refuses_drivers("", "parts/drivers/d.csv: error: is empty: a header was expected");
  refuses_drivers("# only this\n", "hint: the first line that is no comment names the columns, separated by commas");
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("parts/drivers/readme.txt", "");
  const Outcome outcome = shop.run({"solve", "m.toml", "--catalogue", "parts"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("error: the catalogue 'parts' is empty: it holds no CSV file"));
  CHECK(outcome.says("hint: a catalogue has a folder for each part family"));
}

TEST_CASE("A header without a unit") {
  const std::string text = with(driver_header, "maximum_voltage [V]", "maximum_voltage") + driver_row;
  refuses_drivers(text, "parts/drivers/d.csv:1:51: error: ");
  refuses_drivers(text, "[V]");
}

TEST_CASE("A letter O in a number") {
  const std::string text = driver_header + with(driver_row, ",36,", ",3O,");
  refuses_drivers(text, "parts/drivers/d.csv:2:18: error: ");
  refuses_drivers(text, "letter O");
}

TEST_CASE("A part that stands twice") {
  const std::string text = std::string(driver_header) + driver_row + driver_row;
  refuses_drivers(text, "parts/drivers/d.csv:3:");
  refuses_drivers(text, "D1");
}

TEST_CASE("Binary noise as a catalogue") {
  std::string noise(std::size_t{20} << 20U, '\0');
  std::mt19937 random(1);
  for (char& byte : noise) byte = static_cast<char>(random());
  const Outcome outcome = solve_with_drivers(noise);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("parts/drivers/d.csv"));
  CHECK(outcome.err.size() < 2000);
}

// --- bills of materials
// -----------------------------------------------------------------------------------------------

const char* full_bom = R"(axis,slot,manufacturer,part_number,quantity,length,value
x,screw,generic,T10-2,1,318 mm,
x,nut,generic,T10x2 brass flange,1,,
x,motor,Usongshine,17HS4401S,1,,
x,driver,Allegro (module),A4988,1,,
x,coupling,generic,D19L25 beam,1,,
x,support_fixed,THK-type,EK06,1,,
machine,supply,Mean Well,LRS-50-24,1,,
x,acceleration_time,,,,,0.2 s
)";

Outcome check_bom(const std::string& bom, const std::vector<std::string>& more = {}) {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("b.csv", bom);
  std::vector<std::string> words = {"check", "m.toml", "b.csv"};
  words.insert(words.end(), more.begin(), more.end());
  Outcome outcome = shop.run(words);
  if (outcome.exit_code == 2) CHECK(outcome.out.empty());
  return outcome;
}

TEST_CASE("A bill of materials with an unknown part, slot or axis") {
  const Outcome part = check_bom(with(full_bom, "17HS4401S", "17HS4401X"));
  CHECK(part.exit_code == 2);
  CHECK(part.says("b.csv:4:20: error: no part '17HS4401X'"));
  CHECK(part.says("hint: did you mean '17hs4401'?"));
  const Outcome slot = check_bom(with(full_bom, "x,motor", "x,motr"));
  CHECK(slot.exit_code == 2);
  CHECK(slot.says("b.csv:4:3: error: slot: axis 'x' has no 'motr'"));
  CHECK(slot.says("hint: did you mean 'motor'?"));
  const Outcome axis = check_bom(with(full_bom, "machine,", "machin,"));
  CHECK(axis.exit_code == 2);
  CHECK(axis.says("b.csv:8:1: error: axis: the problem has no axis 'machin'"));
  CHECK(axis.says("hint: did you mean 'machine'?"));
}

TEST_CASE("A missing slot is an error that names it, unless it is to be chosen") {
  const std::string bom = with(full_bom, "x,coupling,generic,D19L25 beam,1,,\n", "");
  const Outcome outcome = check_bom(bom);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("b.csv: error: axis 'x' has no coupling"));  // of the file: no line of it is at fault
  CHECK(outcome.says("hint: add a line 'x,coupling,...' or use --complete to have it chosen"));
  const Outcome completed = check_bom(bom, {"--complete"});
  CHECK(completed.exit_code == 0);
  CHECK(completed.prints("What it leaves open was chosen"));
}

TEST_CASE("A length that is no length, a slot given twice, an origin that is not there") {
  CHECK(check_bom(with(full_bom, "318 mm", "318")).says("b.csv:2:25: error: length"));
  CHECK(check_bom(with(full_bom, "318 mm", "318 kg")).exit_code == 2);
  const Outcome twice = check_bom(std::string(full_bom) + "x,motor,Usongshine,17HS4401S,1,,\n");
  CHECK(twice.exit_code == 2);
  CHECK(twice.says("b.csv:10:3: error: slot: motor of axis 'x' is given twice"));
  CHECK(check_bom(full_bom, {"--hold-origin", "paper"}).says("no line of b.csv has the origin 'paper'"));
}

// --- output files
// -----------------------------------------------------------------------------------------------------

TEST_CASE("Output that cannot be written is refused before any work") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("folder/file", "");
  for (const char* option : {"--json", "--bom", "--report"}) {
    CHECK(shop.run({"solve", "m.toml", option, "none/r"}).says("error: none/r: cannot be written: there is no folder"));
    CHECK(shop.run({"solve", "m.toml", option, "none/r"}).exit_code == 2);
    CHECK(shop.run({"solve", "m.toml", option, "folder"}).says("it is a folder"));
    CHECK(shop.run({"solve", "m.toml", option, "folder"}).out.empty());
  }
  const Outcome twice = shop.run({"solve", "m.toml", "--json", "r", "--report", "r"});
  CHECK(twice.exit_code == 2);
  CHECK(twice.says("error: r: two outputs cannot go to one file"));
  CHECK(shop.entries() == 2);
}

}  // namespace
TEST_CASE("A result is not written over what is read") {
  const Workshop shop;
  const std::string motors =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current "
      "[A],price,currency,source,confidence\n"
      "Mine,M1,1.8,1,2,10,USD,own,high\n";
  shop.write("mine.csv", motors);
  shop.write("parts/steppers/mine.csv", motors);
  const std::string problem = MILLWRIGHT_SOURCE_DIR "/problems/lifter.toml";
  CHECK(shop.run({"solve", problem, "--catalogue", "parts", "--json", "parts/steppers/mine.csv"}).exit_code == 2);
  CHECK(shop.read("parts/steppers/mine.csv") == motors);
  std::filesystem::copy_file(MILLWRIGHT_SOURCE_DIR "/problems/lifter-bom.csv", shop.path("a.csv"));
  const std::string bill = shop.read("a.csv");
  CHECK(shop.run({"compare", "a.csv", "a.csv", "--problem", problem, "--json", "a.csv"}).exit_code == 2);
  CHECK(shop.read("a.csv") == bill);
}

}  // namespace millwright::app::bad_input_test
