// SPDX-License-Identifier: Apache-2.0
// millwright explain as a user sees it.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"
#include "text/utf8.h"

namespace millwright::app::explain_test {
namespace {

using Json = nlohmann::json;

/// Any line but the title and the notes that tables may widen: 80 columns.
void expect_narrow(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(text::count_characters(line) <= 80);
  }
}

TEST_CASE("A conflict is told with axis, name and place, and its ways out hold") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  // A fixed motor that is not had at that price.
  const Outcome free = shop.run({"solve", "m.toml", "--fix", "x.motor=17HS4401S", "--json", "-"});
  REQUIRE(free.exit_code == 0);
  const double cost = Json::parse(free.out).at("totals").at("cost").at("value").get<double>();
  const std::string less = std::to_string(cost - 0.5);
  const Outcome text = shop.run({"explain", "m.toml", "--limit", "cost=1"});
  CAPTURE(text.out);
  CHECK(text.exit_code == 1);
  CHECK(text.prints("No compliant build exists"));
  CHECK(text.prints("--limit cost"));
  CHECK(text.prints("This is enough"));
  expect_narrow(text.out);

  const Outcome outcome =
      shop.run({"explain", "m.toml", "--fix", "x.motor=17HS4401S", "--limit", "cost=" + less, "--json", "-"});
  CHECK(outcome.exit_code == 1);
  const Json json = Json::parse(outcome.out);
  CHECK(json.at("status") == "infeasible");
  REQUIRE(json.at("conflicts").size() == 1);
  bool budget = false;
  for (const Json& way : json.at("conflicts")[0].at("ways_out")) {
    if (way.at("name") != "--limit cost") continue;
    budget = true;
    CHECK(way.at("enough") == true);
    CHECK(way.at("to").get<double>() == Approx(cost).margin(0.0100001));
  }
  CHECK(budget);
  // A number of a way out, written into the problem, is enough.
  std::size_t tried = 0;
  for (std::size_t i = 0; i < json.at("conflicts")[0].at("ways_out").size(); ++i) {
    const Json& way = json.at("conflicts")[0].at("ways_out")[i];
    std::string setting, unit;
    for (const Json& member : json.at("conflicts")[0].at("conditions"))
      if (member.at("name") == way.at("name") && member.contains("setting")) {
        setting = member.at("setting").get<std::string>();
        unit = member.at("unit") == "1" ? std::string() : " " + member.at("unit").get<std::string>();
      }
    if (setting.find(".require.") == std::string::npos || way.at("to").is_null()) continue;
    ++tried;
    std::ostringstream value;
    value.precision(12);
    value << way.at("to").get<double>() << unit;
    CAPTURE(setting, value.str());
    CHECK(shop.run({"solve",
                    "m.toml",
                    "--fix",
                    "x.motor=17HS4401S",
                    "--limit",
                    "cost=" + less,
                    "--set",
                    setting + "=" + value.str()})
              .exit_code == 0);
  }
  CHECK(tried > 0);
}

TEST_CASE("Parts left out and slots fixed are conditions too") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Json best = Json::parse(shop.run({"solve", "m.toml", "--json", "-"}).out);
  const double cost = best.at("totals").at("cost").at("value").get<double>();
  std::string motor;
  for (const Json& part : best.at("build").at("parts"))
    if (part.at("slot") == "motor") motor = part.at("part_number").get<std::string>();
  const Outcome outcome = shop.run(
      {"explain", "m.toml", "--without", motor, "--limit", "cost=" + std::to_string(cost + 1e-3), "--json", "-"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  const Json json = Json::parse(outcome.out);
  REQUIRE_FALSE(json.at("conflicts").empty());
  bool left_out = false;
  for (const Json& way : json.at("conflicts")[0].at("ways_out"))
    if (way.at("name") == "--without" && way.at("enough") == true) {
      left_out = true;
      CHECK(way.at("totals").at("cost").at("value").get<double>() == Approx(cost));
    }
  CHECK(left_out);
  // What fails without a way out, and what is asked as the limit of a check, is told with where its formula is from.
  std::set<std::string> told;
  for (const Json& check : json.at("checks")) {
    CAPTURE(check.dump());
    CHECK(told.insert(check.at("id").get<std::string>()).second);
    CHECK_FALSE(check.at("title").get<std::string>().empty());
    CHECK_FALSE(check.at("source").get<std::string>().empty());
  }
  std::size_t broken = 0;
  for (const Json& way : json.at("conflicts")[0].at("ways_out"))
    for (const Json& check : way.at("breaks")) {
      ++broken;
      CHECK(told.count(check.at("id").get<std::string>()) == 1);
    }
  CHECK(broken > 0);
}

TEST_CASE("The file of an explanation names what is not eased, as something that it raises is limited") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const auto not_eased = [&](const std::string& limit, const std::string& said) {
    const Outcome outcome = shop.run({"explain", "m.toml", "--limit", limit, "--json", "e.json", "--force"});
    CAPTURE(limit, outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK((said.empty() || outcome.prints(said)));
    return Json::parse(shop.read("e.json")).at("not_eased");
  };
  CHECK(not_eased("energy=1 uJ", "Moves (times, speeds, forces) and loads are taken as they are asked") ==
        Json{"times", "speeds", "forces", "loads"});
  CHECK(not_eased("cycle_time=1 ms", "Times and speeds of moves are taken as they are asked") ==
        Json{"times", "speeds"});
  CHECK(not_eased("mass=1 g", "") == Json::array());
}

TEST_CASE("What an axis asks for and less of which need not be looser is named with the reason, and is no condition") {
  const Workshop shop;
  const auto not_eased = [&](const std::string& require, const std::string& said) {
    shop.write("m.toml", std::string(one_slide) + "[axis.require]\n" + require + "\n");
    const Outcome outcome = shop.run({"explain", "m.toml", "--limit", "mass=1 g", "--json", "e.json", "--force"});
    CAPTURE(require, outcome.out, outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.prints(said));
    return Json::parse(shop.read("e.json")).at("not_eased");
  };
  CHECK(not_eased("enforce = [\"C-ST-RMS\"]", "not keep C-ST-RMS, which it enforces") == Json{"times", "speeds"});
  CHECK(not_eased("enforce = [\"C-CP-RES\"]", "need not keep C-CP-RES, which it enforces") == Json{"loads"});
  CHECK(not_eased("axial_stiffness = \"1 N/um\"", "Forces and loads of x, and loads of what it carries, are taken") ==
        Json{"forces", "loads"});
}

TEST_CASE("A machine that can be built is explained by its choices and prices") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome text = shop.run({"explain", "m.toml"});
  CAPTURE(text.out, text.err);
  CHECK(text.exit_code == 0);
  CHECK(text.prints("The best build by cost: "));
  CHECK(text.prints("Governing check of each axis"));
  CHECK(text.prints("x.motor"));
  CHECK(text.prints("cost nothing on their own"));
  expect_narrow(text.out);
  const Json json = Json::parse(shop.run({"explain", "m.toml", "--json", "-"}).out);
  CHECK(json.at("command") == "explain");
  CHECK(json.at("status") == "optimal");
  // The next best without a part is what solve says of it.
  const double cost = json.at("totals").at("cost").at("value").get<double>();
  std::size_t compared = 0;
  for (const Json& choice : json.at("choices")) {
    if (choice.at("slot") != "motor" && choice.at("slot") != "driver") continue;
    const Outcome other =
        shop.run({"solve", "m.toml", "--without", choice.at("part").get<std::string>(), "--json", "-"});
    CHECK((other.exit_code == 1) == choice.at("forced").get<bool>());
    if (other.exit_code != 0) continue;
    ++compared;
    const double without = Json::parse(other.out).at("totals").at("cost").at("value").get<double>();
    CHECK(choice.at("next_best").get<double>() == Approx(without - cost).margin(1e-6));
  }
  CHECK(compared > 0);
  // A requirement eased as it says saves what it says.
  for (const Json& price : json.at("prices")) {
    if (!price.contains("setting") || price.at("eased_to").is_null() ||
        price.at("setting").get<std::string>().find(".require.") == std::string::npos || price.at("unit") != "1")
      continue;
    std::ostringstream value;
    value.precision(12);
    value << price.at("eased_to").get<double>();
    const Outcome eased = shop.run(
        {"solve", "m.toml", "--set", price.at("setting").get<std::string>() + "=" + value.str(), "--json", "-"});
    REQUIRE(eased.exit_code == 0);
    CHECK(price.at("saving").get<double>() ==
          Approx(cost - Json::parse(eased.out).at("totals").at("cost").at("value").get<double>()).margin(1e-6));
  }
}

TEST_CASE("explain refuses bad input, and says when time is up") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("empty.toml", "");
  CHECK(shop.run({"explain"}).exit_code == 2);
  CHECK(shop.run({"explain", "gone.toml"}).exit_code == 2);
  const Outcome empty = shop.run({"explain", "empty.toml"});
  CHECK(empty.exit_code == 2);
  CHECK(empty.out.empty());
  const Outcome fixed = shop.run({"explain", "m.toml", "--fix", "x.motor=23HS22-2804S"});
  CHECK(fixed.exit_code == 2);
  CHECK(fixed.says("cannot be the motor of axis 'x'"));
  CHECK(shop.run({"explain", "m.toml", "--minimise", "cost,mass"}).says("explain minimises one objective"));
  const Outcome hasty = shop.run({"explain", "m.toml", "--time-limit", "1e-9"});
  CHECK(hasty.exit_code == 3);
  CHECK(hasty.prints("The search was ended before all was found out."));
}

}  // namespace
// Its ramps are best inside their range: nothing holds them there.
TEST_CASE("An optimum inside its bounds is explained too") {
  const Workshop shop;
  const Outcome outcome = shop.run(
      {"explain", MILLWRIGHT_SOURCE_DIR "/problems/bar-feeder.toml", "--minimise", "energy", "--time-limit", "3"});
  INFO(outcome.err);
  CHECK((outcome.exit_code == 0 || outcome.exit_code == 3));
}

// The shipped inserter goes to the board at 500 mm/s along a path; an axis has its share of that.
TEST_CASE("What a machine's own move asks is told as it is written, with where and how to change it") {
  if (sanitized) return;  // some twenty searches, of kinds that the tests above make as well
  const Workshop shop;
  const std::string inserter = MILLWRIGHT_SOURCE_DIR "/problems/inserter.toml";
  const Outcome priced = shop.run({"explain", inserter, "--json", "-"});
  REQUIRE(priced.exit_code == 0);
  bool found = false;
  const Json explained = Json::parse(priced.out);
  for (const Json& price : explained.at("prices")) {
    if (price.at("name") != "speed of move 'to the board'") continue;
    found = true;
    CHECK(price.at("setting") == "moves[0].speed");
    CHECK(price.at("value").get<double>() == Approx(0.5));
    const double to = price.at("eased_to").get<double>();
    const Outcome eased =
        shop.run({"solve", inserter, "--set", "moves[0].speed='" + std::to_string(to) + " m/s'", "--json", "-"});
    REQUIRE(eased.exit_code == 0);
    const auto cost = [](const std::string& text) {
      const Json json = Json::parse(text);
      return json.at("totals").at("cost").at("value").get<double>();
    };
    CHECK(cost(priced.out) - cost(eased.out) == Approx(price.at("saving").get<double>()).margin(1e-6));
  }
  CHECK(found);
}

TEST_CASE("Ways out of several conflicts are not said to be enough for all of them") {
  if (sanitized) return;  // a minute of searches, of kinds that other tests make as well
  const Workshop shop;
  const Outcome outcome = shop.run({"explain",
                                    MILLWRIGHT_SOURCE_DIR "/problems/lifter.toml",
                                    "--set",
                                    "axis.z.require.position_error.limit='0.03 mm'",
                                    "--limit",
                                    "cost=150 USD",
                                    "--json",
                                    "e.json"});
  CAPTURE(outcome.out);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.prints("There are 2 separate conflicts"));
  CHECK(outcome.prints("their builds and prices need not"));
  CHECK(outcome.prints("all together, is too little, proved"));
  const Json json = Json::parse(shop.read("e.json"));
  CHECK(json.at("all_resolved").is_null());
}

// A move that takes longer is no looser where the time of all moves is limited: eased, it would break the limit.
TEST_CASE("Where the time of the cycle is limited the moves stand as they are") {
  const Workshop shop;
  shop.write("m.toml", one_slide);  // its only move takes 20 s
  const Outcome late = shop.run({"explain", "m.toml", "--limit", "cycle_time=19 s", "--json", "-"});
  REQUIRE(late.exit_code == 1);
  const Json conflicts = Json::parse(late.out).at("conflicts");
  REQUIRE(conflicts.size() == 1);
  REQUIRE(conflicts[0].at("conditions").size() == 1);
  CHECK(conflicts[0].at("conditions")[0].at("name") == "--limit cycle_time");
  REQUIRE(conflicts[0].at("ways_out").size() == 1);
  CHECK(conflicts[0].at("ways_out")[0].at("enough") == true);
  CHECK(conflicts[0].at("ways_out")[0].at("to").get<double>() == Approx(20.0));

  // Too fast for any screw; the limit alone could be kept.
  shop.write("m.toml", one_slide_with("time = \"20 s\"", "speed = \"1 m/s\""));
  const Outcome free = shop.run({"explain", "m.toml", "--json", "-"});
  CHECK(free.exit_code == 1);
  const auto says = [](const std::string& text, const std::string& name) {
    const Json explained = Json::parse(text);
    for (const Json& conflict : explained.at("conflicts"))
      for (const Json& member : conflict.at("conditions"))
        if (member.at("name").get<std::string>().starts_with(name)) return true;
    return false;
  };
  CHECK(says(free.out, "speed of"));
  const Outcome fast = shop.run({"explain", "m.toml", "--limit", "cycle_time=2 s", "--json", "-"});
  CHECK(fast.exit_code == 1);
  CHECK_FALSE(says(fast.out, "speed of"));
  CHECK_FALSE(says(fast.out, "--limit"));
}

}  // namespace millwright::app::explain_test
