// SPDX-License-Identifier: Apache-2.0
// What is said about wrong problem files, and where: the marks « » show the characters that must be pointed at.
#include "problem_text.h"

namespace problem_errors_test {

using namespace problem_text;
using text::Severity;

namespace {

void check_all(const std::vector<Case>& cases) {
  for (const Case& one : cases) check(one);
}

}  // namespace

TEST_CASE("The sound problem of these tests is read without a word") {
  const Outcome outcome = read(sound);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.problem);
  CHECK(outcome.problem->axes.size() == 2);
}

TEST_CASE("By how much a preferred part may be dearer is a share, and what is none is shown how") {
  const std::string at = "minimise = \"cost\"";
  const std::string with = at + "\npreference = ";
  const std::string advice = "write for example 0.05 or \"5 %\"";
  check_all({
      {at, with + "«-0.05»", "preference: must not be negative", advice},
      {at, with + "\"«-3» %\"", "preference: must not be negative", advice},
      {at, with + "\"5 «mm»\"", "preference: 'mm' (m) does not fit", advice},
      {at, with + "\"0.05 «USD»\"", "preference: 'USD' (currency) does not fit", ""},
      {at, with + "«5»", "preference: a share is at most 1, this is 5", "5 percent are 0.05 or \"5 %\""},
      {at, with + "«\"500 %\"»", "preference: a share is at most 1, this is 5", "80 percent are 0.8 or \"80 %\""},
      {at, with + "«1e300»", "preference: more than any machine has", advice},
      {at, with + "\"«much»\"", "preference: 'much' does not start with a number", advice},
      {at, with + "«true»", "preference: true or false where a number is needed", advice},
      {at, with + "«[0.05]»", "preference: a list where a number is needed", advice},
  });
  for (const std::string sound_one : {"0", "0.05", "\"5 %\"", "1", "\"100 %\""}) {
    std::string text = sound;
    text.replace(text.find(at), at.size(), with + sound_one);
    const Outcome outcome = read(text);
    INFO(sound_one << text::format(outcome.diagnostics));
    CHECK(outcome.diagnostics.count() == 0);
  }
}

TEST_CASE("A quantity that is none is reported at the wrong word of it") {
  const std::string stroke = "\"700 mm\"";
  check_all({
      {stroke, "\"20 «kgg»\"", "stroke: unknown unit 'kgg'", "did you mean 'kg'?"},
      {stroke, "\"20 «kg»\"", "stroke: 'kg' (kg) does not fit: 'mm'", "\"700 mm\""},
      {stroke, "«700»", "stroke: a bare number where a unit is needed", "write \"700 mm\""},
      {stroke, "«700.5»", "stroke: a bare number", "write \"700.5 mm\""},
      {stroke, "\"«700»\"", "stroke: a unit is missing", "700 mm"},
      {stroke, "\"«700mm»\"", "stroke: a blank is missing", "'700 mm'"},
      {stroke, "\"«7OO» mm\"", "stroke: '7OO' is not a number", "letter O"},
      {stroke, "\"«−700» mm\"", "stroke: '−700' is not a number", "minus sign of typesetting: write -700"},
      {stroke, "\"«7l0» mm\"", "stroke: '7l0' is not a number", "letter l"},
      {stroke, "\"«0,7» m\"", "stroke: '0,7' has a comma", "decimal point"},
      {stroke, "\"«fast»\"", "stroke: 'fast' does not start with a number", "\"700 mm\""},
      {stroke, "\"«nan» mm\"", "stroke: 'nan", "\"700 mm\""},
      {stroke, "\"«inf» mm\"", "stroke: 'inf", "\"700 mm\""},
      {stroke, "«true»", "stroke: true or false where a quantity with a unit is needed", "\"700 mm\""},
      {stroke, "«{ a = 1 }»", "stroke: a table where a quantity with a unit is needed", "\"700 mm\""},
      {stroke, "«2026-01-15»", "stroke: a date where a quantity", "\"700 mm\""},
      {stroke, "\"«0» mm\"", "stroke: must be greater than zero", "\"700 mm\""},
      {stroke, "\"«-700» mm\"", "stroke: must not be negative", "\"700 mm\""},
      {stroke, "\"«1e300» m\"", "stroke: more than any machine has", "at most 1000 m"},
      {stroke, "\"1e308 «km»\"", "stroke: '1e308 km' is too large", "\"700 mm\""},
      {stroke, "\"«1e999» mm\"", "stroke: '1e999' is too large", ""},
      {stroke, "\"«1e-300» mm\"", "stroke: less than any machine has", "is it the right unit?"},
      {"\"16 kg\"", "\"«-16» kg\"", "structure_mass: must not be negative", "\"16 kg\""},
      {"\"16 kg\"", "\"16 «N»\"", "structure_mass: 'N'", ""},
      {"\"16 kg\"", "\"16 «degC»\"", "structure_mass: 'degC'", ""},
      {"\"36 s\"", "\"«0» s\"", "time: must be greater than zero", "\"0.2 s\""},
      {"\"20 mm/s\"", "\"20 «kg»\"", "speed: 'kg' (kg) does not fit: 'mm/s'", "\"20 mm/s\""},
      {"\"20 mm/s\"", "\"20 mm/«sek»\"", "speed: unknown unit 'sek'", "did you mean"},
      {"\"20 mm/s\"", "\"20 «Hz»\"", "speed: 'Hz'", ""},
      {"guide_friction = 0.1",
       "guide_friction = «-0.1»",
       "guide_friction: must not be negative",
       "write for example 1"},
      {"guide_friction = 0.1", "guide_friction = \"0.1 «mm»\"", "guide_friction: 'mm'", "write for example 1"},
      {"\"20000 h\"", "«20000»", "life: a bare number where a unit is needed", "write \"20000 s\""},
  });
}

TEST_CASE("A wrong word after others with accents is still pointed at by characters") {
  check({"title = \"Two axes\"\n[objective]",
         "title = \"Fräse µ\"\nsource = \"ä\"\n«objektive» = 1\n[objective]",
         "unknown key 'objektive' in problem",
         ""});
  check({"stroke = \"700 mm\"", "stroke = \"700 «µmm»\"", "stroke: unknown unit", ""});
}

TEST_CASE("Unknown keys are reported at the key with the nearest known one") {
  check_all({
      {"[objective]", "«titel» = \"a\"\n[objective]", "unknown key 'titel' in problem", "did you mean 'title'?"},
      {"stroke =", "«strokes» = 3\nstroke =", "unknown key 'strokes' in axis 'x'", "did you mean 'stroke'?"},
      {"guide_friction = 0.1", "«guide_fricton» = 0.1", "in axis 'x'", "did you mean 'guide_friction'?"},
      {"life = ", "«lief» = ", "unknown key 'lief' in [require]", "did you mean 'life'?"},
      {"over = ", "«ovr» = ", "unknown key 'ovr' in position_error", "did you mean 'over'?"},
      {"ends = ", "«end» = ", "unknown key 'end' in mechanism of axis 'x'", "did you mean"},
      {"microsteps = ", "«microstep» = ", "unknown key 'microstep' in motor of axis 'x'", "did you mean 'microsteps'?"},
      {"rails = 2", "«rail» = 2", "unknown key 'rail' in guide of axis 'x'", "did you mean 'rails'?"},
      {"time = \"36 s\"", "time = \"36 s\"\n«forse» = \"1 N\"", "in move of axis 'x'", "did you mean 'force'?"},
      {"kind = \"beam\"", "kind = \"beam\"\n«lenght» = \"1 m\"", "in member of axis 'x'", "did you mean 'length'?"},
      {"date = 2026-01-15", "«dat» = 2026-01-15", "unknown key 'dat' in currency EUR", "did you mean 'date'?"},
      {"[supply]", "[supply]\n«voltge» = 1", "unknown key 'voltge' in [supply]", "did you mean 'voltage'?"},
      {"[objective]", "[objective]\n«maximise» = \"cost\"", "unknown key 'maximise'", "minimise"},
  });
}

TEST_CASE("Missing keys are reported at their table with what to add") {
  check_all({
      {"[[axis]]\nname = \"x\"\ncarries = [\"y\"]\n", "«[[axis]]»\n", "axis needs the key 'name'", "name = \"x\""},
      {"[[axis]]\nname = \"y\"\nstroke = \"250 mm\"\n",
       "«[[axis]]»\nname = \"y\"\n",
       "axis 'y' needs the key 'stroke'",
       "add stroke = \"700 mm\""},
      {"[supply]\nvoltage = [\"24 V\", \"48 V\"]", "«[supply]»", "[supply] needs the key 'voltage'", "add voltage ="},
      {"[objective]\nminimise = \"cost\"", "«[objective]»", "[objective] needs the key 'minimise'", "\"cost\""},
      {"{ kind = \"belt\", ", "«»{ ", "mechanism of axis 'y' needs the key 'kind'", "kind = \"screw\" or kind"},
      {"{ kind = \"screw\", screw = [\"ball_screws\", \"lead_screws\"], ",
       "«»{ kind = \"screw\", ",
       "mechanism of axis 'x' needs the key 'screw'",
       "add screw = [\"ball_screws\", \"lead_screws\"]"},
      {"[[axis.moves]]\nname = \"sand\"\ndistance = \"700 mm\"",
       "«[[axis.moves]]»\nname = \"sand\"",
       "move of axis 'x' needs the key 'distance'",
       "add distance = \"700 mm\""},
      {"[[axis.moves]]\ndistance = \"100 mm\"\nspeed = \"20 mm/s\"",
       "«[[axis.moves]]»\ndistance = \"100 mm\"",
       "move of axis 'y' needs a time or a speed",
       "add time = \"1 s\""},
      {"[[axis.members]]\nname = \"beam\"\nkind = \"beam\"",
       "«[[axis.members]]»\nname = \"beam\"",
       "member of axis 'x' needs the key 'kind'",
       "shaft, bar, column, weld"},
      {"[[axis.members]]\nname = \"beam\"\n", "«[[axis.members]]»\n", "needs the key 'name'", "name = \"beam\""},
      {"[[axis.members]]\nname = \"beam\"\nkind = \"beam\"\nlength = \"500 mm\"",
       "«[[axis.members]]»\nname = \"beam\"\nkind = \"beam\"",
       "needs the key 'length'",
       "add length ="},
      {"\"500 mm\"\nmaterial = \"S235JR\"\nsections = [\"steel_sections\"]",
       "\"500 mm\"\nmaterial = «\"\"»\nsections = [\"steel_sections\"]",
       "material: is empty",
       "S235JR"},
      {"{ rate = 1.08, ", "«»{ ", "currency EUR needs the key 'rate'", "rate = 1.08"},
      {"{ limit = \"0.05 mm\", ", "«»{ ", "position_error needs the key 'limit'", "limit ="},
  });
}

TEST_CASE("A file without axes, supply or moves says what to add") {
  const auto only = [](const std::string& contents, const std::string& message, const std::string& hint) {
    const Outcome outcome = read(contents);
    INFO(text::format(outcome.diagnostics));
    CHECK_FALSE(outcome.problem);
    bool found = false;
    for (const auto& said : outcome.diagnostics.all())
      found = found || (said.message.find(message) != std::string::npos && said.hint.find(hint) != std::string::npos);
    CHECK(found);
  };
  only("", "the problem is empty", "millwright new --template");
  only("title = \"later\"", "problem needs the key 'axis'", "[[axis]]");
  only("title = \"later\"", "problem needs the key 'supply'", "[supply]");
  only("axis = []", "axis: a machine needs at least one", "[[axis]]");
  only("axis = 3", "'axis' must be a list", "brackets");
  only("axis = [3]", "axis must be a table", "[header]");
  only("supply = 24", "'supply' must be a table", "");
  check({"[[axis.moves]]\ndistance = \"100 mm\"\nspeed = \"20 mm/s\"",
         "moves = «[]»",
         "axis 'y' has no moves",
         "[[axis.moves]]"});
}

TEST_CASE("Values outside their range are reported at the value") {
  const std::string weld =
      "kind = \"weld\"\nmaterial = \"S235JR\"\nleg = [\"3 mm\", \"8 mm\"]\njoint_width = \"40 mm\"\njoint_depth = \"40 "
      "mm\"\n";
  check_all({
      {"microsteps = 16", "microsteps = «0»", "microsteps: a whole number from 1 to 256 is needed, this is 0", "16"},
      {"microsteps = 16", "microsteps = «-4»", "microsteps: a whole number", "16"},
      {"microsteps = 16", "microsteps = «3.5»", "this is 3.5", "16"},
      {"microsteps = 16", "microsteps = «512»", "this is 512", "16"},
      {"microsteps = 16", "microsteps = «12»", "microsteps: 12 is no power of two", "1, 2, 4, 8, 16"},
      {"frame = [\"NEMA17\"]", "frame = [\"NEMA17\", «\"NEMA 23\"»]", "frame: 'NEMA 23'", "\"NEMA23\""},
      {"frame = [\"NEMA17\"]", "frame = [«\"nema34\"»]", "frame: 'nema34' is no motor frame", "\"NEMA34\""},
      {"frame = [\"NEMA17\"]", "frame = «[]»", "frame: the list is empty", "leave the key out"},
      {"frame = [\"NEMA17\"]", "frame = [\"NEMA17\", «\"NEMA17\"»]", "frame: 'NEMA17' is there twice", "leave one out"},
      {"frame = [\"NEMA17\"]", "frame = [«17»]", "'frame' must be text", "quotes"},
      {"from = \"steppers\"", "from = «\"servos\"»", "'from' cannot be 'servos'", "steppers"},
      {"carriages = 4", "carriages = «3»", "carriages: a guide has 4 or 1, not 3", "two rails"},
      {"carriages = 4", "carriages = «0»", "carriages: a whole number from 1 to 4", "4"},
      {"carriages = 4", "carriages = «2.5»", "carriages: a whole number", "4"},
      {"rails = 2", "rails = «1»", "rails: 1 with 4 carriages", "two rails"},
      {"rails = 2", "rails = «3»", "rails: a whole number from 1 to 2", "2"},
      {"carriage_spacing = \"200 mm\"",
       "carriage_spacing = «\"0 mm\"»",
       "carriage_spacing: four carriages need it",
       ""},
      {"guide = { rails = 2, carriages = 4, carriage_spacing = \"200 mm\"",
       "guide = «»{ rails = 2, carriages = 4",
       "carriage_spacing: four carriages need it",
       "add carriage_spacing = \"200 mm\", the distance between carriages along the travel"},
      {"efficiency = 0.95", "efficiency = «0»", "efficiency: must be greater than zero", ""},
      {"efficiency = 0.95", "efficiency = «1.05»", "efficiency: a share is at most 1, this is 1.05", "0.8"},
      {"efficiency = 0.95",
       "efficiency = «95»",
       "efficiency: a share is at most 1, this is 95",
       "95 percent are 0.95 or \"95 %\""},
      {"efficiency = 0.95", "efficiency = «\"120 %\"»", "efficiency: a share is at most 1, this is 1.2", "0.8"},
      {"ends = \"fixed-free\"", "ends = «\"fixed-fre\"»", "'ends' cannot be 'fixed-fre'", "did you mean 'fixed-free'?"},
      {"ends = \"fixed-free\"", "preload = «1.5»", "preload: a share is at most 1", "0.8"},
      {"ends = \"fixed-free\"", "ball_friction = «0»", "ball_friction: must be greater than zero", ""},
      {"ends = \"fixed-free\"",
       "length = «\"600 mm\"»",
       "length: the screw is shorter than the stroke of axis 'x'",
       "leave it out"},
      {"ends = \"fixed-free\"", "greased = «\"true\"»", "'greased' must be true or false", "without quotes"},
      {"[\"ball_screws\", \"lead_screws\"]",
       "[«\"ball_screw\"»]",
       "screw: 'ball_screw' is no kind of screw",
       "did you mean 'ball_screws'?"},
      {"[\"ball_screws\", \"lead_screws\"]", "«[]»", "screw: the list is empty", ""},
      {"[\"ball_screws\", \"lead_screws\"]", "«\"acme\"»", "screw: 'acme'", "ball_screws or lead_screws"},
      {"kind = \"belt\"", "kind = «\"belts\"»", "'kind' cannot be 'belts'", "did you mean 'belt'?"},
      {"kind = \"belt\"", "kind = \"belt\", «screw» = \"ball_screws\"", "screw: a belt has none", "kind = \"screw\""},
      {"kind = \"screw\"", "kind = \"screw\", «profiles» = [\"GT2\"]", "profiles: a screw has none", "kind = \"belt\""},
      {"sections = [\"steel_sections\"]",
       "sections = [\"steel_sections\", «\"extrusion\"»]",
       "sections: 'extrusion' has none",
       "did you mean 'extrusions'?"},
      {"length = \"500 mm\"", "length = \"500 mm\"\ncount = «0»", "count: a whole number from 1 to 100", "1"},
      {"length = \"500 mm\"", "length = \"500 mm\"\ncount = «1.5»", "count: a whole number", "1"},
      {"length = \"500 mm\"", "length = \"500 mm\"\nload_share = «1.5»", "load_share: a share is at most 1", "0.8"},
      {"length = \"500 mm\"",
       "length = \"500 mm\"\nsupport = «\"fix\"»",
       "'support' cannot be 'fix'",
       "did you mean 'fixed'?"},
      {"length = \"500 mm\"",
       "length = \"500 mm\"\n«diameter» = \"8 mm\"",
       "diameter: this kind of member",
       "\"shaft\""},
      {"length = \"500 mm\"", "length = \"500 mm\"\n«leg» = \"8 mm\"", "leg: this kind of member", "\"weld\""},
      {"kind = \"beam\"\nlength = \"500 mm\"\nmaterial = \"S235JR\"\nsections = [\"steel_sections\"]\n",
       weld + "«length» = \"500 mm\"\n",
       "length: this kind of member has none",
       "\"column\""},
      {"kind = \"beam\"", "kind = «\"girder\"»", "'kind' cannot be 'girder'", "beam"},
      {"minimise = \"cost\"",
       "minimise = \"«price»\"",
       "minimise: there is no quantity 'price'",
       "quantities: cost, mass"},
      {"minimise = \"cost\"",
       "minimise = \"«costs»\"",
       "minimise: there is no quantity 'costs'",
       "did you mean 'cost'?"},
      {"minimise = \"cost\"", "minimise = «3»", "minimise", ""},
      {"minimise = \"cost\"", "minimise = \"cost +«»\"", "the name of a quantity is expected here", "quantities: cost"},
      {"minimise = \"cost\"",
       "minimise = \"cost + «25»\"",
       "'*' and a quantity are expected behind a weight",
       "25*mass"},
      {"minimise = \"cost\"", "minimise = \"cost + 25 «mass»\"", "'*' and a quantity are expected", "25*mass"},
      {"minimise = \"cost\"",
       "minimise = \"cost + 25 «USD/kg»*mass\"",
       "'*' and a quantity are expected",
       "plain numbers"},
      {"minimise = \"cost\"", "minimise = \"cost + mass«*25»\"", "a weight stands before its quantity", "25*mass"},
      {"minimise = \"cost\"", "minimise = \"cost «-» mass\"", "there is no minus", ""},
      {"minimise = \"cost\"", "minimise = \"cost «mass»\"", "'+' is expected here", "cost + 25*mass"},
      {"minimise = \"cost\"", "minimise = \"cost + 2*«cost»\"", "cost is there twice", "add its weights up"},
      {"minimise = \"cost\"", "minimise = \"cost + «0»*mass\"", "a weight must be greater than zero", ""},
      {"minimise = \"cost\"", "minimise = \"cost + «-2»*mass\"", "a weight must be greater than zero", ""},
      {"minimise = \"cost\"", "minimise = \"cost + «1e20»*mass\"", "a weight lies between", ""},
      {"minimise = \"cost\"", "minimise = \"cost + «2,5»*mass\"", "'2,5' is not a number", ""},
      {"minimise = \"cost\"",
       "minimise = «\"position_error\"»",
       "minimise: position_error: axis 'y' has no error budget",
       "to its [axis.require]"},
      {"life = \"20000 h\"", "life = \"«-1» h\"", "life: must not be negative", "\"0.2 s\""},
      {"life = \"20000 h\"",
       "«position_error_over» = \"1 m\"",
       "position_error_over: without a position_error",
       "write position_error = {"},
      {"over = \"300 mm\" }",
       "over = \"300 mm\" }\n«position_error_over» = \"300 mm\"",
       "position_error_over: is given as 'over'",
       "leave one out"},
  });
}

TEST_CASE("Ramps and ranges") {
  const std::string ramps = "[\"0.05 s\", \"0.5 s\"]";
  check_all({
      {ramps, "«[\"0.5 s\", \"0.05 s\"]»", "acceleration_time: the lower end is above the upper end", "swap"},
      {ramps, "«[\"0.5 s\"]»", "acceleration_time: a range has two ends, this list has 1", "write [\"1 s\", \"2 s\"]"},
      {ramps, "«[]»", "acceleration_time: a range has two ends, this list has 0", ""},
      {ramps, "[\"0.05 s\", \"0.5 «sec.»\"]", "acceleration_time:", ""},
      {ramps, "[«0.05», \"0.5 s\"]", "acceleration_time: a bare number", "write \"0.05 s\""},
      {ramps, "[\"«0» s\", \"0.5 s\"]", "acceleration_time: must be greater than zero", ""},
  });
}

TEST_CASE("Names that would break bills of materials and --set paths are refused") {
  const std::string carries_nothing = replaced(sound, "carries = [\"y\"]\n", "");
  const std::vector<std::pair<std::string, std::string>> names{{"y« »1", "y_1"},
                                                               {"y«,»1", "y_1"},
                                                               {"y«.»1", "y_1"},
                                                               {"«1»", "x1"},
                                                               {"«-»y", "x-y"},
                                                               {"«ü»ber", "x_ber"},
                                                               {"y«;»", "y_"}};
  for (const auto& [marked, advice] : names) {
    std::string contents = replaced(carries_nothing, "name = \"y\"", "name = \"" + marked + "\"");
    const Place place = take_marks(contents);
    const Outcome outcome = read(contents);
    INFO(text::format(outcome.diagnostics));
    REQUIRE(outcome.diagnostics.count() == 1);
    check_place(outcome.diagnostics.all()[0], place, {"", "", "name: an axis cannot be called", "\"" + advice + "\""});
    check({"name = \"beam\"", "name = \"" + marked + "\"", "name: a member cannot be called", "\"" + advice + "\""});
  }
  std::string nameless = replaced(carries_nothing, "name = \"y\"", "name = «\"\"»");
  const Place place = take_marks(nameless);
  check_place(read(nameless).diagnostics.all().at(0), place, {"", "", "name: is empty", "write name = \"x\""});
}

TEST_CASE("Names that are there twice or mean something else") {
  const std::string move = "[[axis.moves]]\nname = \"sand\"\n";
  check_all({
      {"name = \"beam\"", "name = «\"motor\"»", "name: a member cannot be called 'motor'", "beam, column"},
      {"name = \"beam\"", "name = «\"acceleration_time\"»", "cannot be called 'acceleration_time'", "slot"},
      {"name = \"beam\"", "name = «\"supply\"»", "cannot be called 'supply'", "slot"},
      {move,
       move + "distance = \"1 mm\"\ntime = \"2 s\"\n[[axis.moves]]\nname = «\"sand\"»\n",
       "name: axis 'x' has two moves 'sand'",
       "its own name"},
      {"[[axis.members]]\nname = \"beam\"",
       "[[axis.members]]\nname = \"beam\"\nkind = \"shaft\"\nlength = \"1 m\"\nmaterial = \"C45\"\ndiameter = \"9 "
       "mm\"\n"
       "[[axis.members]]\nname = «\"beam\"»",
       "name: axis 'x' has two members 'beam'",
       "its own name"},
  });
  // An axis twice: the first one keeps its carrier.
  check({"[[axis]]\nname = \"y\"\n",
         "[[axis]]\nname = \"y\"\nstroke = \"9 mm\"\nstructure_mass = \"1 kg\"\nmechanism = { kind = \"belt\" }\n"
         "[[axis.moves]]\ndistance = \"9 mm\"\ntime = \"2 s\"\n[[axis]]\nname = «\"y\"»\n",
         "name: axis 'y' is there twice",
         "its own name"});
  const std::string carries_nothing = replaced(sound, "carries = [\"y\"]\n", "");
  std::string machine = replaced(carries_nothing, "name = \"y\"", "name = «\"machine\"»");
  const Place place = take_marks(machine);
  check_place(read(machine).diagnostics.all().at(0), place, {"", "", "cannot be called 'machine'", "share"});
}

TEST_CASE("What is wrong in carries is reported at its entry") {
  check_all({
      {"carries = [\"y\"]", "carries = [\"y\", «\"yy\"»]", "carries: there is no axis 'yy'", "did you mean 'y'?"},
      {"carries = [\"y\"]", "carries = «\"Y\"»", "carries: there is no axis 'Y'", "did you mean 'y'?"},
      {"carries = [\"y\"]", "carries = [\"y\", «\"y\"»]", "carries: axis 'y' is carried already, by 'x'", "one place"},
      {"carries = [\"y\"]", "carries = [\"y\", «\"x\"»]", "carries: axis 'x' carries itself", "leave it out"},
      {"carries = [\"y\"]", "carries = [\"y\", «3»]", "'carries' must be text", ""},
      {"carries = [\"y\"]", "carries = [\"y\", «\"spindle\"»]", "carries: there is no axis 'spindle'", "axes: x, y"},
  });
  std::string circle = replaced(sound, "carries = [\"y\"]", "carries = [«\"y\"»]");
  circle = replaced(circle, "name = \"y\"", "name = \"y\"\ncarries = [\"x\"]");
  const Place place = take_marks(circle);
  const Outcome outcome = read(circle);
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.diagnostics.count() == 1);
  check_place(outcome.diagnostics.all()[0],
              place,
              {"", "", "carries: a circle, 'x' carries 'y' carries 'x'", "cannot stand on what it carries"});
}

namespace {

/// Axes by name with what each carries, and nothing else of interest.
std::string chain(const std::vector<std::pair<std::string, std::string>>& axes) {
  std::string contents = "[supply]\nvoltage = \"24 V\"\n";
  for (const auto& [name, carries] : axes)
    contents += "[[axis]]\nname = \"" + name + "\"\ncarries = [" + carries +
                "]\nstroke = \"9 mm\"\nstructure_mass = \"1 kg\"\nmechanism = { kind = \"belt\" }\n"
                "[[axis.moves]]\ndistance = \"9 mm\"\ntime = \"2 s\"\n";
  return contents;
}

}  // namespace

TEST_CASE("Each circle of axes is reported once with everyone in it") {
  // d stands on the first circle without being part of it; e and f are a second one; g is sound.
  const Outcome outcome =
      read(chain({{"a", "'b', 'd'"}, {"b", "'c'"}, {"c", "'a'"}, {"d", ""}, {"e", "'f'"}, {"f", "'e'"}, {"g", ""}}));
  INFO(text::format(outcome.diagnostics));
  CHECK_FALSE(outcome.problem);
  const auto all = outcome.diagnostics.all();
  REQUIRE(all.size() == 2);
  CHECK(all[0].message.find("'a' carries 'b' carries 'c' carries 'a'") != std::string::npos);
  CHECK(all[1].message.find("'e' carries 'f' carries 'e'") != std::string::npos);
}

TEST_CASE("Axes are ordered from the tools to the bases") {
  const Outcome outcome = read(chain({{"base", "'a', 'b'"}, {"a", "'tool'"}, {"b", ""}, {"tool", ""}, {"bed", ""}}));
  REQUIRE(outcome.problem);
  const machine::Problem& problem = *outcome.problem;
  std::vector<std::size_t> when(5);
  REQUIRE(problem.order.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) when.at(problem.order[i]) = i;
  for (std::size_t i = 0; i < 5; ++i)
    if (problem.axes[i].carried_by) CHECK(when[i] < when[*problem.axes[i].carried_by]);
  CHECK(problem.axes[1].carried_by == 0U);
  CHECK(problem.axes[2].carried_by == 0U);
  CHECK(problem.axes[3].carried_by == 1U);
  CHECK_FALSE(problem.axes[0].carried_by);
  CHECK_FALSE(problem.axes[4].carried_by);
}

TEST_CASE("Currencies: one of rate 1, rates that are rates, dates that are dates") {
  check_all({
      {"[currency]\nUSD = 1.0", "«[currency]»\nUSD = 1.1", "currency: none has the rate 1", "USD = 1.0"},
      {"[currency]\nUSD = 1.0\nEUR = { rate = 1.08, date = 2026-01-15 }", "«[currency]»", "the table is empty", "USD"},
      {"rate = 1.08", "rate = «1.0»", "EUR: a second currency with the rate 1", "1.0001"},
      {"rate = 1.08", "rate = «0»", "EUR: 0 is no rate of exchange", "greater than zero"},
      {"rate = 1.08", "rate = «-1.08»", "EUR: -1.08 is no rate of exchange", "greater than zero"},
      {"rate = 1.08", "rate = «1e30»", "EUR: 1e+30 is no rate of exchange", ""},
      {"rate = 1.08", "rate = «\"1.08\"»", "EUR: text where a rate is needed", "rate = 1.08"},
      {"{ rate = 1.08, date = 2026-01-15 }", "«[1.08]»", "EUR: a list where a rate is needed", "rate = 1.08"},
      {"USD = 1.0", "USD = 1.0\n«Euro» = 1.2", "currency: 'Euro' is no currency", "three capital letters"},
      {"USD = 1.0", "USD = 1.0\n«gbp» = 1.2", "currency: 'gbp' is no currency", "did you mean 'GBP'?"},
      {"USD = 1.0", "USD = 1.0\n«mm» = 1.2", "currency: 'mm' is no currency", "three capital letters"},
      {"date = 2026-01-15", "date = «\"2026-02-30\"»", "EUR: date is not a date", "2026-01-15"},
      {"date = 2026-01-15", "date = «\"2025-02-29\"»", "EUR: date is not a date", "2026-01-15"},
      {"date = 2026-01-15", "date = «\"15.01.2026\"»", "EUR: date is not a date", "2026-01-15"},
      {"date = 2026-01-15", "date = «07:32:00»", "EUR: date is not a date", "2026-01-15"},
      {"date = 2026-01-15", "date = «2026»", "EUR: date is not a date", "2026-01-15"},
  });
  for (const char* good : {"\"2024-02-29\"", "2024-02-29", "\"2026-12-31\""}) {
    const Outcome outcome = read(replaced(sound, "2026-01-15", good));
    INFO(good << text::format(outcome.diagnostics));
    CHECK(outcome.problem.has_value());
  }
}

TEST_CASE("Currents of a motor") {
  const std::string steps = "microsteps = 16";
  check_all({
      {steps, "current = [\"2 A\", «\"2000 mA\"»]", "current: 2 A is there twice", "leave one out"},
      {steps, "current = «[]»", "current: the list is empty", "current = [\"2 A\"]"},
      {steps, "current = «1.5»", "current: a bare number", "write \"1.5 A\""},
      {steps, "current = \"«0» A\"", "current: must be greater than zero", "\"2 A\""},
      {steps, "current = [\"1 A\", \"«-2» A\"]", "current: must not be negative", "\"2 A\""},
      {steps, "current = \"«5000» A\"", "current: more than any machine has", "at most 1000 A"},
      {steps, "current = \"2 «V»\"", "current: 'V'", ""},
  });
  const std::string twice = replaced(
      replaced(sound, steps, "current = \"2 A\""), "[axis.require]\n", "[axis.require]\ncurrent_factor = 1.2\n");
  const Outcome outcome = read(twice);
  REQUIRE(outcome.diagnostics.error_count() == 1);
  CHECK(text::format(outcome.diagnostics).find("current_factor: the motor's current is given") != std::string::npos);
  for (const char* good : {"current = \"2 A\"", "current = [\"1.5 A\", \"2 A\", \"2500 mA\"]"}) {
    const Outcome fine = read(replaced(sound, steps, good));
    INFO(good << text::format(fine.diagnostics));
    REQUIRE(fine.problem.has_value());
    CHECK(fine.problem->axes.front().motor.currents.size() ==
          (std::string(good).find('[') == std::string::npos ? 1U : 3U));
    CHECK(fine.problem->axes.front().motor.currents.back() ==
          (std::string(good).find('[') == std::string::npos ? 2.0 : 2.5));
  }
}

TEST_CASE("Supply voltages") {
  const std::string list = "[\"24 V\", \"48 V\"]";
  check_all({
      {list, "[\"24 V\", «\"24000 mV\"»]", "voltage: 24 V is there twice", "leave one out"},
      {list, "«[]»", "voltage: the list is empty", "\"24 V\""},
      {list, "[\"24 V\", «48»]", "voltage: a bare number", "write \"48 V\""},
      {list, "[\"24 V\", \"«0» V\"]", "voltage: must be greater than zero", "\"24 V\""},
      {list, "[\"24 V\", \"«-48» V\"]", "voltage: must not be negative", "\"24 V\""},
      {list, "[\"24 V\", \"«1e5» V\"]", "voltage: more than any machine has", "at most 1000 V"},
      {list, "\"24 «A»\"", "voltage: 'A'", ""},
  });
}

TEST_CASE("Directions and inclinations") {
  const std::string direction = "direction = \"horizontal\"";
  check_all({
      {direction, "direction = «\"horisontal\"»", "'direction' cannot be 'horisontal'", "did you mean 'horizontal'?"},
      {direction, "direction = «\"inclined\"»", "direction: inclined by how much?", "inclination = \"30 deg\""},
      {direction, "inclination = «\"30 deg\"»", "inclination: the axis is horizontal", "direction = \"inclined\""},
      {direction, "direction = \"inclined\"\ninclination = «\"91 deg\"»", "more than upright", "90 deg"},
      {direction, "direction = \"inclined\"\ninclination = \"«-5» deg\"", "must not be negative", "\"30 deg\""},
      {direction, "direction = \"inclined\"\ninclination = «30»", "a bare number", "write \"30 deg\""},
  });
}

TEST_CASE("Moves that no machine can do") {
  check_all({
      {"time = \"36 s\"",
       "time = «\"0.09 s\"»",
       "time: the move is faster than its ramps allow: two ramps of 0.05 s",
       "0.045 s or less"},
      {"time = \"36 s\"",
       "time = «\"1 s\"»\nspeed = \"700 mm/s\"",
       "time: the move cannot be done in 1 s: at 700 mm/s and with ramps of 0.05 s it takes 1.05 s",
       "more time"},
      {"speed = \"20 mm/s\"",
       "speed = «\"5 m/s\"»",
       "speed: 5000 mm/s is never reached: ramps of 0.05 s",
       "acceleration_time 0.02 s or less"},
      {"distance = \"100 mm\"",
       "distance = «\"250.1 mm\"»",
       "distance: 250.1 mm is longer than the stroke of axis 'y', 250 mm",
       "lengthen"},
      {"time = \"36 s\"",
       "time = «\"1 s\"»\nacceleration_time = \"0.6 s\"",
       "two ramps of 0.6 s in 1 s",
       "0.5 s or less"},
      {"time = \"36 s\"", "time = \"36 s\"\nforce = \"«-1» N\"", "force: must not be negative", "\"60 N\""},
      {"time = \"36 s\"", "time = \"36 s\"\ndwell = \"1 «m»\"", "dwell: 'm'", ""},
  });
  // Just possible: a triangle, and a distance that is the stroke in another unit.
  const Outcome outcome =
      read(replaced(replaced(sound, "time = \"36 s\"", "time = \"0.1 s\"\nacceleration_time = \"50 ms\""),
                    "\"700 mm\"",
                    "\"70 cm\""));
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.problem.has_value());
}

TEST_CASE("What follows from an error is not reported again") {
  // The stroke cannot be read, so nothing is said about the move being longer; likewise ramps, and the kind.
  check({"\"700 mm\"", "\"«7OO» mm\"", "stroke", "letter O"});
  check({"distance = \"100 mm\"", "distance = \"100 «mn»\"", "distance: unknown unit", "did you mean"});
  check({"[\"0.05 s\", \"0.5 s\"]", "\"60 «kg»\"", "acceleration_time", "0.2 s"});
  check({"structure_mass = \"4 kg\"", "structure_mass = \"4 «kilo»\"", "structure_mass", ""});
}

TEST_CASE("Legal but odd values are warnings") {
  const Severity warning = Severity::warning;
  check_all({
      {"stroke = \"250 mm\"", "stroke = «\"250 m\"»", "stroke: 250 m is a long way", "mm?", warning},
      {"guide_friction = 0.1", "guide_friction = «0.6»", "guide_friction: 0.6 is unusually high", "0.003", warning},
      {"guide_friction = 0.1", "guide_friction = «1.5»", "guide_friction: 1.5 is unusually high", "0.003", warning},
      {"structure_mass = \"4 kg\"",
       "structure_mass = «\"0 kg\"»",
       "structure_mass: nothing of axis 'y'",
       "5 kg",
       warning},
      {"[[axis]]\nname = \"y\"\nstroke = \"250 mm\"\nstructure_mass = \"4 kg\"",
       "«[[axis]]»\nname = \"y\"\nstroke = \"250 mm\"",
       "structure_mass: nothing of axis 'y' has a mass",
       "5 kg",
       warning},
      {"ends = \"fixed-free\"",
       "thread_friction = «1.2»",
       "thread_friction: 1.2 is unusually high",
       "plastic",
       warning},
      {"ends = \"fixed-free\"", "ball_friction = «0.1»", "ball_friction: 0.1 is unusually high", "0.01", warning},
      {"ends = \"fixed-free\"", "preload = «0.3»", "preload: 0.3 is unusually high", "0.1", warning},
      {"guide_friction = 0.1", "counterbalance_force = «\"9 N\"»", "no weight to balance", "vertical", warning},
      {"life = \"20000 h\"", "torque_margin = «1.5»", "torque_margin: 1.5 allows more", "default 0.7", warning},
      {"life = \"20000 h\"",
       "static_safety = «0.5»",
       "static_safety: 0.5 is less than no safety",
       "default 2",
       warning},
  });
}

TEST_CASE("A range of ramps that a move has no time for is warned of at its upper end, once, for the tightest move") {
  std::string contents = replaced(sound,
                                  "time = \"36 s\"",
                                  "time = \"0.6 s\"\n[[axis.moves]]\ndistance = \"9 mm\"\ntime = \"0.4 s\"\n"
                                  "[[axis.moves]]\ndistance = \"9 mm\"\ntime = \"0.5 s\"");
  contents = replaced(contents, "[\"0.05 s\", \"0.5 s\"]", "[\"0.05 s\", «\"0.5 s\"»]");
  const Place place = take_marks(contents);
  const Outcome outcome = read(contents);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.problem.has_value());
  REQUIRE(outcome.diagnostics.count() == 1);
  const text::Diagnostic said = outcome.diagnostics.all().front();
  check_place(said, place, {"", "", "no time for ramps above 0.2 s", "\"0.2 s\"", Severity::warning});
  REQUIRE(said.related);
  CHECK(said.related->line == place.line + 8);  // the second of the three moves
}

TEST_CASE("A list longer than anything in a machine is refused at once") {
  const auto machine_of = [](int axes) {
    std::string all = "[[axis]]\nname = \"a\"\n";
    for (int i = 1; i < axes; ++i) all += "[[axis]]\nname = \"a" + std::to_string(i) + "\"\n";
    return read(all);
  };
  CHECK(machine_of(1000).diagnostics.error_count() > 1000);
  const Outcome many = machine_of(30000);
  REQUIRE(many.diagnostics.count() == 1);
  CHECK(many.diagnostics.all()[0].message == "a list of 30000: more than 1000 are not taken");
  CHECK(many.diagnostics.all()[0].where.line == 2001);
  std::string frames = "\"N0\"";
  for (int i = 1; i < 2000; ++i) frames += ", \"N" + std::to_string(i) + "\"";
  CHECK(read(replaced(sound, "[\"NEMA17\"]", "[" + frames + "]")).diagnostics.error_count() == 1);
}

TEST_CASE("All that is wrong in a file is said in one go") {
  std::string contents = sound;
  contents = replaced(contents, "\"cost\"", "\"costs\"");
  contents = replaced(contents, "\"48 V\"", "\"48 W\"");
  contents = replaced(contents, "\"20000 h\"", "\"20000 k\"");
  contents = replaced(contents, "carries = [\"y\"]", "carries = [\"u\"]");
  contents = replaced(contents, "\"700 mm\"", "700");
  contents = replaced(contents, "microsteps = 16", "microsteps = 10");
  contents = replaced(contents, "\"S235JR\"", "235");
  contents = replaced(contents, "\"20 mm/s\"", "\"20 kg\"");
  const Outcome outcome = read(contents);
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.error_count() == 8);
}

}  // namespace problem_errors_test
