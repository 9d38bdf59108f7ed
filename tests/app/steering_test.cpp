// SPDX-License-Identifier: Apache-2.0
// --limit, --without and --fix: what they do to the answer, that the answer says so, and what is said of bad ones.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::steering_test {
namespace {

using Json = nlohmann::json;

const char* euros = "title = \"One slide\"\n[currency]\nUSD = 1.0\nEUR = 2.0\n";

Json solved(const Workshop& shop, std::vector<std::string> more, int exit_code = 0) {
  std::vector<std::string> words{"solve", "m.toml", "--json", "-"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = shop.run(words);
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == exit_code);
  return Json::parse(outcome.out);
}

double total(const Json& result, const char* what) { return result.at("totals").at(what).at("value").get<double>(); }

/// The part in a slot; null if there is none.
Json part(const Json& result, const std::string& slot) {
  for (const Json& each : result.at("build").at("parts"))
    if (each.at("slot") == slot) return each;
  return nullptr;
}

Json check(const Json& result, const std::string& id) {
  for (const Json& each : result.at("checks"))
    if (each.at("id") == id) return each;
  return nullptr;
}

TEST_CASE("A budget on the command line is a check, and the tighter of it and the file's holds") {
  const Workshop shop;
  shop.write("m.toml", one_slide_with("title = \"One slide\"\n", euros));
  const Json free = solved(shop, {});
  CHECK_FALSE(free.contains("steering"));
  CHECK(check(free, "C-SYS-COST").is_null());
  const double cost = total(free, "cost");
  const double mass = total(free, "mass");

  // The same amount in the problem's currency, with and without its name, and in another at two for one.
  const std::string euro = std::to_string(0.5 * (cost + 1.0)) + " EUR";
  for (const std::string& limit : {std::to_string(cost + 1.0), std::to_string(cost + 1.0) + " USD", euro}) {
    const Json held = solved(shop, {"--limit", "cost=" + limit});
    CHECK(total(held, "cost") == cost);
    CHECK(check(held, "C-SYS-COST").at("limit").get<double>() == Approx(cost + 1.0).epsilon(1e-7));
    CHECK(held.at("steering").at("limits")[0].at("name") == "cost");
    CHECK(held.at("steering").at("limits")[0].at("unit") == "USD");
  }
  CHECK(solved(shop, {"--limit", "cost=" + std::to_string(0.99 * cost)}, 1).at("status") == "infeasible");

  // Lighter than the cheapest costs more, or is not to be had.
  const Json light = solved(shop, {"--limit", "mass=" + std::to_string(0.97 * mass) + " kg"});
  CHECK(total(light, "mass") <= 0.97 * mass);
  CHECK(total(light, "cost") >= cost);
  CHECK(check(light, "C-SYS-MASS").at("verdict") == "satisfied");

  const std::string limits = "[limits]\ncost = \"100 USD\"\n[objective]";
  std::string text = one_slide_with("title = \"One slide\"\n", euros);
  shop.write("m.toml", text.replace(text.find("[objective]"), 11, limits));
  CHECK(check(solved(shop, {"--limit", "cost=90"}), "C-SYS-COST").at("limit").get<double>() == Approx(90.0));
  CHECK(check(solved(shop, {"--limit", "cost=60 EUR"}), "C-SYS-COST").at("limit").get<double>() == Approx(100.0));
  CHECK(shop.run({"solve", "m.toml", "--limit", "mass=2 kg"}).prints("--limit  mass  2 kg"));
  CHECK(check(solved(shop, {"--limit", "cost=90USD"}), "C-SYS-COST").at("limit").get<double>() == Approx(90.0));
  // Nothing for a euro: the budget is named as one of the reasons.
  const Outcome poor = shop.run({"solve", "m.toml", "--limit", "cost=1 EUR"});
  CHECK(poor.exit_code == 1);
  CHECK(poor.prints("A limit of the whole machine counts too"));
}

TEST_CASE("Time, energy and error of the whole machine are limited like its cost") {
  const Workshop shop;
  const std::string slide =
      std::string(one_slide) + "[axis.require]\nposition_error = { limit = \"1 mm\", over = \"300 mm\" }\n";
  shop.write("m.toml", slide);
  const struct {
    const char *name, *id, *unit;
    double in_si;
  } quantities[] = {{"cycle_time", "C-SYS-CYCLE", "s", 1.0},
                    {"energy", "C-SYS-ENERGY", "J", 1.0},
                    {"position_error", "C-SYS-ERROR", "um", 1e-6}};
  for (const auto& each : quantities) {
    CAPTURE(each.name);
    const double least = total(solved(shop, {"--minimise", each.name}), each.name);
    const auto limit = [&](double value) {
      return fmt::format("{}={:.9f} {}", each.name, value / each.in_si, each.unit);
    };
    const Json held = solved(shop, {"--limit", limit(1.0001 * least)});
    CHECK(total(held, each.name) <= 1.0001 * least * (1.0 + 1e-9));
    CHECK(check(held, each.id).at("limit").get<double>() == Approx(1.0001 * least / each.in_si).epsilon(1e-6));
    CHECK(check(held, each.id).at("verdict") == "satisfied");
    CHECK(held.at("steering").at("limits")[0].at("value").get<double>() == Approx(1.0001 * least).epsilon(1e-6));
    CHECK(held.at("steering").at("limits")[0].at("unit") == (each.in_si == 1.0 ? each.unit : "m"));
    CHECK(solved(shop, {"--limit", limit(0.999 * least)}, 1).at("status") == "infeasible");

    // In the file the same; and a bill is held to it.
    const std::string limits =
        fmt::format("[limits]\n{} = \"{:.9f} {}\"\n[objective]", each.name, 1.0001 * least / each.in_si, each.unit);
    std::string text = slide;
    shop.write("limited.toml", text.replace(text.find("[objective]"), 11, limits));
    const Outcome from_file = shop.run({"solve", "limited.toml", "--bom", "b.csv", "--force", "--json", "-"});
    REQUIRE(from_file.exit_code == 0);
    CHECK(total(Json::parse(from_file.out), "cost") == total(held, "cost"));
    CHECK(shop.run({"check", "limited.toml", "b.csv"}).exit_code == 0);
    const Outcome less = shop.run({"check", "m.toml", "b.csv", "--limit", limit(0.999 * least)});
    CHECK(less.exit_code == 1);
    CHECK(less.prints(each.id));
  }
  CHECK(shop.run({"solve", "m.toml", "--limit", "position_error=0.9 mm"}).prints("--limit  position_error  900 um"));

  // Only where every axis has its budget there is a sum of them.
  shop.write("m.toml", one_slide);
  const Outcome outcome = shop.run({"solve", "m.toml", "--limit", "position_error=0.9 mm"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("1:9: error: position_error: axis 'x' has no error budget"));
  std::string text = one_slide;
  shop.write("m.toml", text.replace(text.find("[objective]"), 11, "[limits]\nposition_error = \"1 mm\"\n[objective]"));
  CHECK(shop.run({"solve", "m.toml"}).says("error: limits: position_error: axis 'x' has no error budget"));
}

// A bill that fails something is shown with ramps with which it fails no more than it must.
TEST_CASE("A limit of the cycle that a ramp keeps is kept where a bill fails another limit") {
  const Workshop shop;
  shop.write("m.toml", one_slide_with("time = \"20 s\"", "speed = \"20 mm/s\""));
  REQUIRE(shop.run({"solve", "m.toml", "--bom", "b.csv"}).exit_code == 0);
  const double least = total(solved(shop, {"--minimise", "cycle_time"}), "cycle_time");
  const std::string cycle = fmt::format("cycle_time={:.9f} s", least + 0.01);
  std::string bill;  // without the ramp, which is found
  std::istringstream lines(shop.read("b.csv"));
  for (std::string line; std::getline(lines, line);)
    if (line.find("acceleration_time") == std::string::npos) bill += line + "\n";
  shop.write("b.csv", bill);
  CHECK(shop.run({"check", "m.toml", "b.csv", "--limit", cycle}).exit_code == 0);
  const Outcome heavy =
      shop.run({"check", "m.toml", "b.csv", "--limit", cycle, "--limit", "mass=0.1 kg", "--json", "-"});
  CHECK(heavy.exit_code == 1);
  const Json result = Json::parse(heavy.out);
  CHECK(check(result, "C-SYS-MASS").at("verdict") == "violated");
  CHECK(check(result, "C-SYS-CYCLE").at("verdict") == "satisfied");

  // A ramp that the bill states is not touched.
  shop.write("b.csv", bill + "x,acceleration_time,,,,,0.3 s,\n");
  const Outcome held = shop.run({"check", "m.toml", "b.csv", "--limit", cycle, "--json", "-"});
  CHECK(held.exit_code == 1);
  const Json late = Json::parse(held.out);
  CHECK(check(late, "C-SYS-CYCLE").at("verdict") == "violated");
  CHECK(total(late, "cycle_time") == Approx(least + 0.2));
}

TEST_CASE("A bill of materials is held to a budget too") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Json build = solved(shop, {"--bom", "b.csv"});
  const std::string less = "cost=" + std::to_string(total(build, "cost") - 0.5);
  const Outcome dear = shop.run({"check", "m.toml", "b.csv", "--limit", less});
  CHECK(dear.exit_code == 1);
  CHECK(dear.prints("C-SYS-COST"));
  CHECK(shop.run({"check", "m.toml", "b.csv", "--limit", "mass=50 kg"}).exit_code == 0);
}

TEST_CASE("An excluded part is nowhere, one after the other") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  std::vector<std::string> words;
  std::vector<std::string> seen;
  double cost = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Json result = solved(shop, words);
    CHECK(total(result, "cost") >= cost);
    cost = total(result, "cost");
    const Json driver = part(result, "driver");
    const auto number = driver.at("part_number").get<std::string>();
    CHECK(std::count(seen.begin(), seen.end(), number) == 0);
    if (i > 0) CHECK(result.at("steering").at("without").size() == seen.size());
    seen.push_back(number);
    // By its number, then by maker and number.
    words.insert(words.end(),
                 {"--without", i == 0 ? number : driver.at("manufacturer").get<std::string>() + " " + number});
  }
  const Outcome text = shop.run({"solve", "m.toml", "--without", seen[0]});
  CHECK(text.prints("--without"));
  const Outcome front = shop.run({"pareto", "m.toml", "--without", seen[0], "--json", "-"});
  REQUIRE(front.exit_code == 0);
  const Json json = Json::parse(front.out);
  for (const Json& point : json.at("front"))
    for (const Json& each : point.at("build").at("parts")) CHECK(each.at("part_number") != seen[0]);
}

TEST_CASE("A fixed part, setting and voltage are in the answer, which says so") {
  const Workshop shop;
  shop.write("m.toml", one_slide_with("[\"24 V\"]", "[\"12 V\", \"24 V\"]"));
  const Json free = solved(shop, {});
  const Json fixed = solved(shop,
                            {"--fix",
                             "x.motor=17HS4401S",
                             "--fix",
                             "machine.supply=Mean Well LRS-50-24",
                             "--fix",
                             "x.acceleration_time=200 ms",
                             "--fix",
                             "x.motor=Usongshine 17HS4401S"});
  CHECK(part(fixed, "motor").at("part_number") == "17HS4401S");
  CHECK(part(fixed, "supply").at("part_number") == "LRS-50-24");
  CHECK(total(fixed, "cost") >= total(free, "cost"));
  std::map<std::string, double> settings;
  for (const Json& line : fixed.at("build").at("dimensions")) settings[line.at("name")] = line.at("value");
  CHECK(settings.at("acceleration_time") == 0.2);
  CHECK(settings.at("supply_voltage") == 24.0);
  const Json& said = fixed.at("steering").at("fixed");
  REQUIRE(said.size() == 3);
  CHECK(said[0] ==
        Json{{"axis", "x"}, {"slot", "motor"}, {"manufacturer", "Usongshine"}, {"part_number", "17HS4401S"}});
  CHECK(said[2] == Json{{"axis", "x"}, {"name", "acceleration_time"}, {"value", 0.2}, {"unit", "s"}});

  // With the motor at a current of its own, every voltage by itself is no better than both.
  double least = 1e9;
  for (const char* voltage : {"12 V", "24 V"}) {
    const Json at =
        solved(shop, {"--fix", std::string("machine.supply_voltage=") + voltage, "--fix", "x.motor_current=1 A"});
    least = std::min(least, total(at, "cost"));
  }
  CHECK(total(solved(shop, {"--fix", "x.motor_current=1 A"}), "cost") == least);
  CHECK(shop.run({"pareto", "m.toml", "--fix", "x.motor=17HS4401S"}).exit_code == 0);
}

/// The complaint about these words of a command line, exit code 2 and no output.
void refuses(const std::vector<std::string>& more, const std::vector<std::string>& complaints) {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  std::vector<std::string> words{"solve", "m.toml"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = shop.run(words);
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  for (const std::string& complaint : complaints) {
    CAPTURE(complaint);
    CHECK(outcome.says(complaint));
  }
}

TEST_CASE("Bad budgets are all reported at once, each at its word") {
  refuses({"--limit", "cost=4OO", "--limit", "mas=3 kg", "--limit", "mass=3"},
          {"1:14: error: cost: '4OO' is not a number",
           "letter O",
           "1:9: error: there is no limit of 'mas'",
           "hint: did you mean 'mass'?",
           "1:14: error: mass: a unit is missing",
           "3 errors"});
  refuses({"--limit", "cost=-4", "--limit", "cost=5"},
          {"cost: must not be negative",
           "hint: write for example --limit cost='400 USD'",
           "1:9: error: the limit of cost is given twice",
           "note: first given here"});
  refuses({"--limit", "cost=5 GBP"}, {"1:16: error: cost: the problem has no rate for 'GBP'", "its currencies: USD"});
  refuses({"--limit", "cost=400EURO"}, {"1:17: error: cost: the problem has no rate for 'EURO'"});
  refuses({"--limit", "cost=1,200 USD"}, {"1:14: error: cost: '1,200' is not a number", "decimals have a point"});
  refuses({"--limit", "mass=3 s"}, {"1:16: error: mass: 's' (s) does not fit: 'kg' (kg) is wanted"});
  refuses({"--limit", "cost"}, {"1:9: error: '=' is missing", "hint: write --limit cost='400 USD'"});
  refuses({"--limit", "mass="}, {"error: there is nothing behind '='"});
}

TEST_CASE("Parts that cannot be excluded are named with what was meant") {
  refuses({"--without", "17HS4401X", "--without", "Acme LRS-50-24", "--without", "S235JR", "--without", " "},
          {"1:11: error: no part '17HS4401X' in the catalogues",
           "hint: did you mean '17hs4401'?",
           "error: no part 'LRS-50-24' by 'Acme'",
           "hint: it is made by Mean Well",
           "error: 'S235JR' is a material",
           "error: no part is named"});
  refuses({"--without", "Mean Wel LRS-50-25"}, {"hint: did you mean 'Mean Well LRS-50-24'?"});
  const Workshop shop;
  shop.write("m.toml", one_slide);
  solved(shop, {"--bom", "b.csv"});
  const Outcome named = shop.run({"check", "m.toml", "b.csv", "--without", "A4988"});
  CHECK(named.exit_code == 2);
  CHECK(named.says("error: 'A4988' is excluded by --without"));
  shop.write("mine/stock.csv", "part_number,owned,available\nA4988,,no\n");
  const Outcome marked = shop.run({"check", "m.toml", "b.csv", "--catalogue", "mine"});
  CHECK(marked.exit_code == 2);
  CHECK(marked.says("error: 'A4988' is not available, as mine/stock.csv:2 says"));
  CHECK_FALSE(marked.says("--without"));
}

TEST_CASE("A reduction is fixed by its name, as the problem or as a bill of materials writes it") {
  const Workshop shop;
  const std::string problem = MILLWRIGHT_SOURCE_DIR "/problems/rotary-table.toml";
  const auto chosen = [&](const std::string& reduction) {
    const Outcome outcome = shop.run({"solve", problem, "--json", "-", "--fix", "a.reduction=" + reduction});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return part(Json::parse(outcome.out), "reduction").at("part_number").get<std::string>();
  };
  CHECK(chosen("3:1 belt") == "3:1 belt");
  CHECK(chosen("generic 3:1 belt") == "3:1 belt");
  const Outcome unknown = shop.run({"solve", problem, "--fix", "a.reduction=generic 7:1 belt"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.says("error: axis 'a' states no reduction 'generic 7:1 belt'"));
  for (const char* name : {"3:1 belt", "generic 3:1 belt"}) {
    const Outcome left_out = shop.run({"solve", problem, "--without", name});
    CHECK(left_out.exit_code == 2);
    CHECK(left_out.says(std::string("error: '") + name + "' is stated by the problem"));
    CHECK(left_out.says("--fix a.reduction=..."));
  }
}

TEST_CASE("What cannot be fixed is said at the word") {
  refuses({"--fix", "x.motr=17HS4401S", "--fix", "y.motor=17HS4401S", "--fix", "x.motor=17HS4401X", "--fix", "x"},
          {"1:9: error: axis 'x' has no 'motr'",
           "hint: did you mean 'motor'?",
           "1:7: error: the problem has no axis 'y'",
           "hint: axes: machine, x",
           "1:15: error: x.motor: no part '17HS4401X'",
           "1:7: error: '=' is missing"});
  refuses({"--fix", "motor=17HS4401S"}, {"error: 'motor' names no slot of an axis"});
  refuses({"--fix", "x.motor=17HS4401S", "--fix", "x.motor=17HE08-1004S"},
          {"1:15: error: x.motor is fixed twice, and differently", "note: first fixed here"});
  refuses({"--fix", "x.motor=17HS4401S", "--without", "17HS4401S"}, {"error: x.motor: '17HS4401S' is excluded"});
  refuses({"--fix", "x.acceleration_time=3"}, {"1:27: error: x.acceleration_time: a unit is missing"});
  refuses({"--fix", "x.acceleration_time=3 s"},
          {"error: x.acceleration_time: 3 s is not within the problem's range", "hint: it goes from 0.1 s to 0.3 s"});
  refuses({"--fix", "machine.supply_voltage=36 V"}, {"error: supply voltage 36 V is not among those of the problem"});
  // A motor of another frame than the problem asks for, and a screw where a driver belongs.
  refuses({"--fix", "x.motor=23HS22-2804S", "--fix", "x.driver=T10-2"},
          {"1:15: error: '23HS22-2804S' cannot be the motor of axis 'x'",
           "1:16: error: 'T10-2' cannot be the driver of axis 'x'"});
  // Each could be: the nut runs on another screw.
  refuses({"--fix", "x.screw=T10-2", "--fix", "x.nut=T8x8 brass flange"},
          {"1:13: error: 'T10-2' as screw, 'T8x8 brass flange' as nut of axis 'x': they do not run together",
           "hint: each can be had with another one"});
}

TEST_CASE("Alternatives are distinct, ascending, and each is what solve finds when those before are not to be had") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Json alone = solved(shop, {});
  CHECK_FALSE(alone.contains("alternatives"));
  const Json result = solved(shop, {"--alternatives", "6"});
  CHECK(result.at("status") == "optimal");
  CHECK(result.at("builds_asked") == 6);
  CHECK(result.at("builds_proved") == 6);
  for (const char* key : {"totals", "build", "checks", "objective"}) CHECK(result.at(key) == alone.at(key));
  const Json& others = result.at("alternatives");
  REQUIRE(others.size() == 5);
  double cost = total(result, "cost");
  std::vector<Json> seen{result.at("build").at("parts")};
  for (const Json& other : others) {
    CHECK(total(other, "cost") >= cost);
    cost = total(other, "cost");
    const Json& parts = other.at("build").at("parts");
    double price = 0.0;
    for (const Json& each : parts) price += each.at("price").get<double>();
    CHECK(price == Approx(cost));
    CHECK(std::count(seen.begin(), seen.end(), parts) == 0);
    seen.push_back(parts);
    CHECK_FALSE(other.at("changes").empty());
    for (const Json& each : other.at("checks")) CHECK((each.at("kind") == "soft" || each.at("verdict") != "violated"));
    // What is said to differ does.
    for (const Json& change : other.at("changes"))
      CHECK(part(other, change.at("name")).at("part_number") != part(result, change.at("name")).at("part_number"));
  }
  // The cheapest without any one part of the best build, over all its parts, is the second best.
  double second = 1e9;
  for (const Json& each : result.at("build").at("parts")) {
    if (each.at("slot") == "nut") continue;  // more than one screw has it
    const Outcome without =
        shop.run({"solve", "m.toml", "--json", "-", "--without", each.at("part_number").get<std::string>()});
    if (without.exit_code == 0) second = std::min(second, total(Json::parse(without.out), "cost"));
  }
  CHECK(second == Approx(total(others[0], "cost")));

  // A mass objective, a budget and a fixed part together.
  const Json light =
      solved(shop, {"--alternatives", "4", "--minimise", "mass", "--fix", "x.motor=17HS4401S", "--limit", "cost=60"});
  double mass = total(light, "mass");
  REQUIRE(light.at("alternatives").size() == 3);
  for (const Json& other : light.at("alternatives")) {
    CHECK(total(other, "mass") >= mass);
    mass = total(other, "mass");
    CHECK(total(other, "cost") <= 60.0);
    CHECK(part(other, "motor").at("part_number") == "17HS4401S");
  }
}

TEST_CASE("Alternatives as text: one line a build, the same for every number of threads, and what is proved of them") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome one = shop.run({"solve", "m.toml", "--alternatives", "3", "--threads", "1"});
  const Outcome two = shop.run({"solve", "m.toml", "--alternatives", "3", "--threads", "2"});
  CHECK(one.exit_code == 0);
  CHECK(one.prints("Alternatives\n"));
  CHECK(one.prints("Proved: no compliant build of these catalogues is cheaper.\n"));
  CHECK(one.prints("Proved: these are the 3 cheapest builds, each set of parts counted once.\n"));
  CHECK(one.out.substr(0, one.out.find("\ntime")) == two.out.substr(0, two.out.find("\ntime")));

  // With everything but the coupling decided there are few.
  std::vector<std::string> words{"solve", "m.toml", "--alternatives", "100"};
  const Json best = solved(shop, {});
  for (const Json& each : best.at("build").at("parts"))
    if (each.at("slot") != "coupling")
      words.insert(words.end(),
                   {"--fix",
                    each.at("axis").get<std::string>() + "." + each.at("slot").get<std::string>() + "=" +
                        each.at("manufacturer").get<std::string>() + " " + each.at("part_number").get<std::string>()});
  const Outcome few = shop.run(words);
  CAPTURE(few.err);
  CHECK(few.exit_code == 0);
  CHECK(few.prints("Proved: there are only "));
  CHECK_FALSE(few.prints("x.motor 1"));

  CHECK(shop.run({"solve", "m.toml", "--alternatives", "0"}).exit_code == 2);
  CHECK(shop.run({"solve", "m.toml", "--alternatives", "101"}).exit_code == 2);
  CHECK(shop.run({"pareto", "m.toml", "--alternatives", "3"}).says("there is no option '--alternatives'"));
}

TEST_CASE("Alternatives that a time limit cuts short say how far they are proved") {
  const Workshop shop;
  const Outcome outcome = shop.run({"solve",
                                    MILLWRIGHT_SOURCE_DIR "/problems/sander.toml",
                                    "--alternatives",
                                    "20",
                                    "--time-limit",
                                    "0.001",
                                    "--json",
                                    "-"});
  CHECK(outcome.exit_code == 3);
  const Json json = Json::parse(outcome.out);
  CHECK(json.at("status") == "limit");
  if (json.contains("builds_proved")) CHECK(json.at("builds_proved") == 0);
}

}  // namespace
}  // namespace millwright::app::steering_test
