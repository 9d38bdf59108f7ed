// SPDX-License-Identifier: Apache-2.0
// solve --set over a range.
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"

namespace millwright::app::sweep_test {
namespace {

using Json = nlohmann::json;

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

std::string with_time(const std::string& time) { return one_slide_with("\"20 s\"", "\"" + time + "\""); }

TEST_CASE("Each point of a range is what the file with that value gives") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome outcome = shop.run({"solve", "m.toml", "--set", "axis.x.moves[0].time=20:4:3 s", "--json", "-"});
  REQUIRE(outcome.exit_code == 0);
  const Json sweep = Json::parse(outcome.out);
  CHECK(sweep["command"] == "sweep");
  REQUIRE(sweep["points"].size() == 3);
  const std::vector<std::string> times{"20 s", "12 s", "4 s"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& point = sweep["points"][i];
    CHECK(point["text"] == times[i]);
    shop.write("edited.toml", with_time(times[i]));
    const Json single = Json::parse(shop.run({"solve", "edited.toml", "--json", "-"}).out);
    CHECK(point["totals"]["cost"] == single["totals"]["cost"]);
    CHECK(point["build"] == single["build"]);
    CHECK(point["proved"] == true);
    // One move without dwell.
    CHECK(point["cycle_time_s"].get<double>() == Approx(std::stod(times[i])));
  }
}

TEST_CASE("Cycle time of a move that states its speed: its way at that speed and one ramp") {
  const Workshop shop;
  std::string text = one_slide_with("time = \"20 s\"", "speed = \"25 mm/s\"");
  const std::string ramps = "[\"0.1 s\", \"0.3 s\"]";
  text.replace(text.find(ramps), ramps.size(), "\"0.2 s\"");
  shop.write("m.toml", text);
  const Outcome outcome =
      shop.run({"solve", "m.toml", "--set", "axis.x.moves[0].speed=25 mm/s:50 mm/s:2", "--json", "-"});
  REQUIRE(outcome.exit_code == 0);
  const Json sweep = Json::parse(outcome.out);
  CHECK(sweep["points"][0]["cycle_time_s"].get<double>() == Approx(200.0 / 25.0 + 0.2));
  CHECK(sweep["points"][1]["cycle_time_s"].get<double>() == Approx(200.0 / 50.0 + 0.2));
}

// --- a catalogue so small that every build can be checked
// ---------------------------------------------------------------

/// The shipped file less all rows but these; empty if none of them is there.
std::string rows_of(const std::filesystem::path& file, const std::set<std::string>& parts) {
  std::ifstream stream(file);
  std::string out;
  bool header = true;
  bool any = false;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.front() == '#') continue;
    const std::size_t first = line.find(',');
    const std::string part = line.substr(first + 1, line.find(',', first + 1) - first - 1);
    if (header || parts.count(part) > 0) out += line + "\n";
    any = any || (!header && parts.count(part) > 0);
    header = false;
  }
  return any ? out : std::string();
}

const std::vector<std::string> screws{"T10-2", "T10-8", "T8-2"};
const std::vector<std::string> nuts{"T10x2 brass flange", "T10x8 brass flange", "T8x2 brass flange"};
const std::vector<std::pair<std::string, std::string>> motors{{"Usongshine", "17HS4401S"},
                                                              {"Usongshine", "17HS8401S"},
                                                              {"StepperOnline", "17HS19-2004S1"},
                                                              {"Usongshine", "17hs4023"}};

void write_small_catalogue(const Workshop& shop) {
  const std::filesystem::path shipped = MILLWRIGHT_SOURCE_DIR "/catalogues";
  std::set<std::string> parts{"A4988", "D19L25 beam", "EK06", "LRS-50-24"};
  parts.insert(screws.begin(), screws.end());
  parts.insert(nuts.begin(), nuts.end());
  for (const auto& [maker, part] : motors) parts.insert(part);
  for (const char* family :
       {"lead_screws", "lead_nuts", "steppers", "drivers", "couplings", "support_bearings", "power_supplies"})
    for (const auto& entry : std::filesystem::directory_iterator(shipped / family))
      if (const std::string rows = rows_of(entry.path(), parts); !rows.empty())
        shop.write("parts/" + std::string(family) + "/" + entry.path().filename().string(), rows);
  std::filesystem::copy(shipped / "materials", shop.path("parts") / "materials");  // of nuts
  setenv("MILLWRIGHT_CATALOGUES", shop.path("parts").c_str(), 1);
}

std::string bill_of(std::size_t screw, std::size_t motor) {
  return "axis,slot,manufacturer,part_number,quantity,length,value\n"
         "x,screw,generic," +
         screws[screw] + ",1,,\nx,nut,generic," + nuts[screw] + ",1,,\nx,motor," + motors[motor].first + "," +
         motors[motor].second +
         ",1,,\nx,driver,Allegro (module),A4988,1,,\nx,coupling,generic,D19L25 beam,1,,\n"
         "x,support_fixed,THK-type,EK06,1,,\nmachine,supply,Mean Well,LRS-50-24,1,,\n";
}

/// The cheapest of all builds that `check` finds nothing wrong with; infinity if there is none.
double cheapest_by_checking(const Workshop& shop) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t screw = 0; screw < screws.size(); ++screw)
    for (std::size_t motor = 0; motor < motors.size(); ++motor) {
      shop.write("b.csv", bill_of(screw, motor));
      const Outcome outcome = shop.run({"check", "edited.toml", "b.csv", "--json", "-"});
      if (outcome.exit_code == 2) continue;  // these parts do not go together
      const Json json = Json::parse(outcome.out);
      if (json["satisfied"] == true) best = std::min(best, json["totals"]["cost"]["value"].get<double>());
    }
  return best;
}

TEST_CASE(
    "The trade-off of a small machine is that of all its builds, checked one by one, and more time never costs more") {
  const Workshop shop;
  write_small_catalogue(shop);
  shop.write("m.toml", one_slide_with("\"5 kg\"", "\"20 kg\""));
  const std::size_t points = sanitized ? 2 : 4;
  const std::string times = "axis.x.moves[0].time=2:17:" + std::to_string(points) + " s";
  const Outcome outcome = shop.run({"solve", "m.toml", "--set", times, "--json", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code <= 1);
  const Json sweep = Json::parse(outcome.out);
  REQUIRE(sweep["points"].size() == points);
  double before = std::numeric_limits<double>::infinity();
  std::set<double> costs;
  for (const Json& point : sweep["points"]) {
    std::string text = with_time(point["text"]);
    text.replace(text.find("\"5 kg\""), 6, "\"20 kg\"");
    shop.write("edited.toml", text);
    const double best = cheapest_by_checking(shop);
    INFO(point["text"]);
    if (point["status"] == "infeasible")
      CHECK(best == std::numeric_limits<double>::infinity());
    else
      CHECK(point["totals"]["cost"]["value"].get<double>() == Approx(best).epsilon(1e-9));
    CHECK(point["proved"] == true);
    CHECK(best <= before);
    before = best;
    costs.insert(best);
  }
  CHECK(costs.size() >= (sanitized ? 2 : 3));  // else there is no trade-off to look at
}

// --- what it prints and writes
// ------------------------------------------------------------------------------------------

TEST_CASE("A range with points that have no build: the others are shown, and those with the reason") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome outcome = shop.run({"solve",
                                    "m.toml",
                                    "--set",
                                    "axis.x.moves[0].time=0.7:20.7:3 s",
                                    "--csv",
                                    "s.csv",
                                    "--report",
                                    "s.html",
                                    "--json",
                                    "s.json"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.prints("0.7 s"));
  CHECK(outcome.prints("none"));
  CHECK(outcome.prints("cycle:"));
  std::istringstream csv(shop.read("s.csv"));
  std::string line;
  std::getline(csv, line);
  CHECK(line ==
        "axis.x.moves[0].time [s],status,proved,cost,currency,mass [kg],cycle_time [s],lower_bound,changes,reason");
  std::getline(csv, line);
  CHECK(line.rfind("0.7,infeasible,yes,,,,,,,", 0) == 0);
  CHECK(line.back() != ',');  // the reason
  std::getline(csv, line);
  CHECK(line.rfind("10.7,optimal,yes,", 0) == 0);
  const std::string page = shop.read("s.html");
  CHECK(count_of(page, "<path class=\"none\"") == 1);
  CHECK(count_of(page, "<circle") == 4);  // two points in each of two charts
  CHECK(Json::parse(shop.read("s.json"))["points"][0].contains("reason"));
  const Outcome none = shop.run({"solve", "m.toml", "--set", "axis.x.moves[0].time=0.6:0.7:2 s"});
  CHECK(none.exit_code == 1);
  CHECK_FALSE(none.prints("cycle:"));
}

TEST_CASE("What is limited has a column in a range, as what is minimised has") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const std::vector<std::string> swept{"solve", "m.toml", "--set", "axis.x.moves[0].time=10:20:2 s"};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = swept;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = shop.run(words);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome;
  };
  const Json json = Json::parse(run({"--limit", "energy=1 Wh", "--json", "-"}).out);
  const Outcome said = run({"--limit", "energy=1 Wh", "--csv", "s.csv"});
  std::istringstream lines(shop.read("s.csv"));
  std::string line;
  std::getline(lines, line);
  CHECK(line.find(",cycle_time [s],energy [J],lower_bound,") != std::string::npos);
  CHECK(said.prints(" energy "));
  for (const Json& point : json["points"]) {
    REQUIRE(std::getline(lines, line));
    const double energy = point["totals"]["energy"]["value"];
    CHECK(energy <= 3600.0);
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 8; ++i) std::getline(cells, cell, ',');
    CHECK(std::stod(cell) == Approx(energy).epsilon(1e-11));
    CHECK(said.prints(fmt::format("{:.5g} J", energy)));
  }
  CHECK_FALSE(run({}).prints(" energy "));
  // The page has the column too, and a table has it whatever is found.
  run({"--limit", "energy=1 Wh", "--report", "s.html"});
  const std::string page = shop.read("s.html");
  for (const Json& point : json["points"])
    CHECK(page.find(fmt::format(">{:.5g} J</td>", point["totals"]["energy"]["value"].get<double>())) !=
          std::string::npos);
  std::vector<std::string> none = swept;
  none.insert(none.end(), {"--limit", "energy=1 uJ", "--csv", "none.csv"});
  CHECK(shop.run(none).exit_code == 1);
  CHECK(shop.read("none.csv").find(",energy [J],lower_bound,") != std::string::npos);
  // What is minimised has one column, not two.
  const std::string least = run({"--minimise", "energy"}).out;
  const std::size_t header = least.find("cycle  proof");
  REQUIRE(header != std::string::npos);
  CHECK(count_of(least.substr(least.rfind('\n', header), header - least.rfind('\n', header)), " energy ") == 1);
}

TEST_CASE("A range under a time limit says which points are not proved") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome outcome =
      shop.run({"solve", "m.toml", "--set", "axis.x.moves[0].time=10:20:3 s", "--time-limit", "1e-9", "--json", "-"});
  CHECK(outcome.exit_code == 3);
  const Json sweep = Json::parse(outcome.out);
  REQUIRE(sweep["points"].size() == 3);
  for (const Json& point : sweep["points"]) CHECK(point["proved"] == false);
}

TEST_CASE("Bad ranges and settings are reported where they were typed") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const auto refuses = [&](const std::vector<std::string>& words, const std::vector<std::string>& complaints) {
    std::vector<std::string> all{"solve", "m.toml"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = shop.run(all);
    INFO(words[1]);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    for (const std::string& each : complaints) {
      INFO(outcome.err);
      CHECK(outcome.says(each));
    }
  };
  refuses({"--set", "axis.x.moves[0].tme=1:2:3 s"}, {"1:23: error: unknown key 'tme'", "did you mean 'time'?"});
  refuses({"--set", "axis.x.moves[0].time=1:2:3 mm"}, {"1:30: error: time: 'mm'"});
  refuses({"--set", "axis.x.moves[0].time=1:2"}, {"1:28: error: axis.x.moves[0].time: a range is FROM:TO:COUNT"});
  refuses({"--set", "axis.x.moves[0].time=1:2:1 s"},
          {"1:32: error: axis.x.moves[0].time: a range has 2 to 200 values"});
  refuses({"--set", "axis.x.moves[0].time=1:2:2.5 s"}, {"a range has 2 to 200 values"});
  refuses({"--set", "axis.x.moves[0].time=1:2:1e9 s"}, {"a range has 2 to 200 values"});
  refuses({"--set", "axis.x.moves[0].time=2:2:3 s"}, {"both ends of the range are the same"});
  refuses({"--set", "axis.x.moves[0].time=1 s:2 min:3"}, {"different units"});
  refuses({"--set", "axis.x.moves[0].time=1:b:3 s"}, {"1:30: error: axis.x.moves[0].time: this is no number"});
  refuses({"--set", "axis.x.stroke=-1:1:3 m"}, {"stroke: must not be negative"});
  refuses({"--set", "axis.q.stroke=1:2:3 m"}, {"no element has the name 'q'", "there is x"});
  refuses({"--set", "axis.x.stroke=0.1:0.2:2 m", "--set", "axis.x.moves[0].time=1:2:3 s"},
          {"only one value can go over a range"});
  refuses({"--set", "axis.x.stroke=0.1:0.2:2 m", "--bom", "b.csv", "--order", "o.csv", "--alternatives", "2"},
          {"--bom: of a range", "--order: of a range", "--alternatives: of a range", "3 errors"});
  refuses({"--set", "axis.x.stroke=0.1:0.2:2 m", "--csv", "none/s.csv"}, {"there is no folder 'none'"});
  refuses({"--csv", "s.csv"}, {"--csv: the table is of a range"});
  const Outcome front = shop.run({"pareto", "m.toml", "--set", "axis.x.stroke=0.1:0.2:2 m"});
  CHECK(front.exit_code == 2);
  CHECK(front.says("only 'solve' takes a range"));
}

}  // namespace
}  // namespace millwright::app::sweep_test
