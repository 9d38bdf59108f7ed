// SPDX-License-Identifier: Apache-2.0
// What a stock file beside a user's parts does to answers, bills and orders.
#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "app/lifter.h"
#include "sanitized.h"

namespace millwright::app::stock_test {
namespace {

/// The cheapest lifter, with the parts of the folder `mine`, whose preferred ones may cost so much more.
Outcome cheapest(const Workshop& shop, const std::string& premium, const std::vector<std::string>& more) {
  std::vector<std::string> words{"solve", lifter, "--catalogue", "mine", "--set", "objective.minimise=cost"};
  words.insert(words.end(), {"--set", "objective.preference=" + premium});
  words.insert(words.end(), more.begin(), more.end());
  return shop.run(words);
}

}  // namespace

TEST_CASE("What is in stock is free, and the order says that it is there") {
  const Workshop shop;
  const Json plain = solved(shop, {});
  const Json bought = motor(plain);
  REQUIRE(bought.at("quantity") == 1);
  CHECK_FALSE(bought.contains("owned"));
  const std::string name = bought.at("part_number");
  shop.write("mine/stock.csv", fmt::format("part_number,owned\n{},3\n", name));
  const Json stocked = solved(shop, {"--catalogue", "mine", "--order", "order.csv"});
  // The lifter takes one motor: nothing is cheaper than the old build without it.
  const Json own = motor(stocked);
  CHECK(own.at("part_number") == name);
  CHECK(own.at("owned") == 1);
  CHECK(own.at("price") == 0);
  CHECK(cost(stocked) == Approx(cost(plain) - bought.at("price").get<double>()).epsilon(1e-9));
  const std::string order = shop.read("order.csv");
  CHECK(order.find("(in stock)") != std::string::npos);
  const Outcome text = shop.run({"solve", lifter, "--catalogue", "mine"});
  CHECK(text.prints("In stock: 1 of "));
}

namespace {

const std::string belt_printer = MILLWRIGHT_SOURCE_DIR "/problems/belt-printer.toml";

/// A catalogue file with one more column.
std::string with_column(const std::string& csv, const std::string& name, const std::string& cell) {
  std::istringstream lines(csv);
  std::string result;
  bool in_head = true;
  for (std::string line; std::getline(lines, line);) {
    const bool is_row = !line.empty() && line.front() != '#';
    result += line + (is_row ? "," + (in_head ? name : cell) : "") + "\n";
    in_head = in_head && !is_row;
  }
  return result;
}

/// The belt printer's build, when its motors may be set to these currents; its bill goes to build.csv.
Json built_at(const Workshop& shop, const std::string& currents, const std::vector<std::string>& more) {
  std::vector<std::string> words{"solve", belt_printer, "--json", "-", "--bom", "build.csv", "--force"};
  for (const char* axis : {"x", "y", "z"})
    words.insert(words.end(), {"--set", fmt::format("axis.{}.motor.current=[{}]", axis, currents)});
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = shop.run(words);
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

std::vector<std::string> drivers_of(const Json& result) {
  std::vector<std::string> drivers;
  for (const Json& part : result.at("build").at("parts"))
    if (part.at("slot") == "driver") drivers.push_back(part.at("part_number"));
  return drivers;
}

}  // namespace

// Of the drivers below 6 USD none gives a sine of 2.5 A: A4988 1 A RMS, DRV8825 1.5 A, TMC2208 1.2 A, TMC2225 1.4 A.
TEST_CASE("No driver is asked for a current it does not give, though drivers are counted or may be off") {
  const Workshop shop;
  const std::vector<std::string> right(3, "TMC2226");
  CHECK(drivers_of(built_at(shop, "\"2.5 A\"", {})) == right);
  shop.write("stocked/stock.csv", "part_number,owned\nTMC2130,1\n");  // 2 A
  CHECK(drivers_of(built_at(shop, "\"2.5 A\"", {"--catalogue", "stocked"})) == right);
  const Outcome weak = shop.run({"solve",
                                 belt_printer,
                                 "--catalogue",
                                 "stocked",
                                 "--set",
                                 "axis.x.motor.current=2.5 A",
                                 "--fix",
                                 "x.driver=A4988"});
  CHECK(weak.exit_code == 2);
  CHECK(weak.says("'A4988' cannot be the driver of axis 'x'"));
  if (sanitized) return;  // the robust search is tested with smaller machines
  // The inertia of every rotor may be off by so much that the best build without this breaks.
  for (const auto& file : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/catalogues/steppers"))
    shop.write("off/steppers/" + file.path().filename().string(),
               with_column(shop.read(file.path().string()), "rotor_inertia_tolerance", "40 %"));
  const Json robust = built_at(shop, "\"2.5 A\"", {"--catalogue", "off", "--robust"});
  CHECK(drivers_of(robust) == right);
  CHECK(robust.at("tolerances").at("robust").at("sets_of_values") > 0);  // the build without them would break
}

TEST_CASE("What is owned and priced in a currency without a rate is said not to be used") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  CHECK_FALSE(shop.run({"solve", "m.toml"}).says("what is owned of them"));
  shop.write("mine/stock.csv", "part_number,owned\nTMC5160T Pro,1\n");  // priced in EUR
  CHECK(shop.run({"solve", "m.toml", "--catalogue", "mine"}).says("what is owned of them ("));
}

TEST_CASE("check sets a current that the driver of the bill gives, where the problem lists one") {
  const Workshop shop;
  (void)built_at(shop, "\"1 A\"", {});
  std::string bom = shop.read("build.csv");
  for (std::size_t at = bom.find("motor_current"); at != std::string::npos; at = bom.find("motor_current")) {
    const std::size_t begin = bom.rfind('\n', at) + 1;
    bom.erase(begin, bom.find('\n', at) + 1 - begin);
  }
  shop.write("open.csv", bom);
  REQUIRE(bom.find("A4988") != std::string::npos);
  const auto current_of = [&](const std::string& currents) {
    const Outcome outcome = shop.run(
        {"check", belt_printer, "open.csv", "--json", "-", "--set", "axis.x.motor.current=[" + currents + "]"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code <= 1);
    const Json result = Json::parse(outcome.out);
    for (const Json& each : result.at("build").at("dimensions"))
      if (each.at("axis") == "x" && each.at("name") == "motor_current") return each.at("value").get<double>();
    return 0.0;
  };
  CHECK(current_of("\"0.3 A\", \"2.5 A\"") == Approx(0.3));
  CHECK(current_of("\"2.5 A\"") == Approx(2.5));  // judged: it gives none of them
}

TEST_CASE("What is not available is left out as by --without, and the answer says where that is written") {
  const Workshop shop;
  const std::string name = motor(solved(shop, {})).at("part_number");
  shop.write("mine/stock.csv", fmt::format("part_number,available\n{},no\n", name));
  const Json result = solved(shop, {"--catalogue", "mine"});
  CHECK(motor(result).at("part_number") != name);
  CHECK(cost(result) == cost(solved(shop, {"--without", name})));
  const Json& without = result.at("steering").at("without");
  REQUIRE(without.size() == 1);
  CHECK(without[0].at("not_available") == "mine/stock.csv:2");
  const Outcome fixed = shop.run({"solve", lifter, "--catalogue", "mine", "--fix", "z.motor=" + name});
  CHECK(fixed.exit_code == 2);
  CHECK(fixed.says("not available"));
}

TEST_CASE("A row of a user's own catalogue may say itself that it is owned or cannot be had") {
  const Workshop shop;
  const Json plain = solved(shop, {});
  const std::string name = motor(plain).at("part_number");
  const std::string row = motor(plain).at("row");  // "catalogues/steppers/x.csv:12"
  const std::string file = MILLWRIGHT_SOURCE_DIR "/" + row.substr(0, row.find(':'));
  std::ifstream shipped(file);
  std::string text, line, header, own;
  while (std::getline(shipped, line)) {
    if (line.rfind("manufacturer,", 0) == 0) header = line;
    if (line.find("," + name + ",") != std::string::npos) own = line;
  }
  REQUIRE_FALSE(own.empty());
  shop.write("mine/steppers/a.csv", header + ",owned_quantity [1]\n" + own + ",1\n");
  CHECK(cost(solved(shop, {"--catalogue", "mine"})) ==
        Approx(cost(plain) - motor(plain).at("price").get<double>()).epsilon(1e-9));
  shop.write("mine/steppers/a.csv", header + ",availability\n" + own + ",unavailable\n");
  CHECK(cost(solved(shop, {"--catalogue", "mine"})) == cost(solved(shop, {"--without", name})));
}

TEST_CASE(
    "A preferred part is chosen where it costs little more, at real prices, and the answer says what it may cost") {
  const Workshop shop;
  const auto driver = [](const Json& result) { return part(result, "driver"); };
  const Json plain = solved(shop, {});
  CHECK_FALSE(plain.at("objective").contains("compared_value"));
  // The next best build with another driver: with just its premium, and a little less.
  const std::string chosen = driver(plain).at("part_number");
  const Json other = solved(shop, {"--without", chosen});
  const std::string name = driver(other).at("part_number");
  const double dearer = cost(other) - cost(plain), price = driver(other).at("price");
  REQUIRE(dearer > 0.0);
  const double needed = dearer / (price - dearer);  // price / (1 + needed) = price - dearer
  REQUIRE(needed < 0.99);
  shop.write("mine/stock.csv", fmt::format("part_number,available\n{},preferred\n", name));
  const auto with = [&](double premium, std::vector<std::string> more) {
    more.insert(more.end(), {"--json", "-"});
    const Outcome outcome = cheapest(shop, fmt::format("{:.6f}", premium), more);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out);
  };
  const Json taken = with(1.01 * needed, {});
  CHECK(driver(taken).at("part_number") == name);
  CHECK(driver(taken).at("preferred") == true);
  CHECK(cost(taken) == Approx(cost(other)).epsilon(1e-9));
  const Json& objective = taken.at("objective");
  CHECK(objective.at("value").get<double>() == Approx(cost(taken)));
  CHECK(objective.at("compared_value").get<double>() ==
        Approx(cost(taken) - price * (1.0 - 1.0 / (1.0 + 1.01 * needed))).epsilon(1e-5));
  CHECK(objective.at("lower_bound").get<double>() <= objective.at("compared_value").get<double>() * (1.0 + 1e-9));
  CHECK(driver(with(0.99 * needed, {})).at("part_number") == chosen);
  CHECK(cost(with(0.99 * needed, {})) == Approx(cost(plain)).epsilon(1e-9));
  // A budget is about real prices.
  const Json limited = with(1.01 * needed, {"--limit", fmt::format("cost={:.4f}", cost(plain) + 0.5 * dearer)});
  CHECK(driver(limited).at("part_number") == chosen);
  const Outcome text = cheapest(shop, fmt::format("{:.6f}", 1.01 * needed), {"--report", "r.html"});
  CHECK(text.prints("preferred parts up to"));
  CHECK(text.prints("  Preferred: "));
  CHECK(text.prints("With its preferred parts it costs at most"));
  CHECK(shop.read("r.html").find("With its preferred parts it costs at most") != std::string::npos);
  CHECK(shop.run({"solve", lifter, "--set", "objective.minimise=cost", "--set", "objective.preference=5"}).exit_code ==
        2);
  // A row may say so of itself, and a stock file takes it back.
  shop.write("mine/stock.csv", fmt::format("part_number,available\n{},yes\n", name));
  CHECK(driver(with(1.01 * needed, {})).at("part_number") == chosen);
}

TEST_CASE("Fronts, next best builds and ranges say how builds with preferred parts were compared") {
  const Workshop shop;
  const Json driver = part(solved(shop, {}), "driver");
  const std::string name = driver.at("part_number");
  shop.write("mine/stock.csv", fmt::format("part_number,available\n{},preferred\n", name));
  const std::string compared =
      "Builds were compared with the prices of preferred parts divided by 1.05; what is shown are the real prices.";
  const auto wrapped_has = [](std::string text, const std::string& words) {
    std::string flat;
    for (const char c : text)
      if (c != '\n' && c != ' ') flat += c;
    std::string wanted;
    for (const char c : words)
      if (c != ' ') wanted += c;
    return flat.find(wanted) != std::string::npos;
  };
  REQUIRE(shop.run({"pareto", lifter, "--catalogue", "mine", "--report", "f.html"}).exit_code == 0);
  const std::string page = shop.read("f.html");
  CHECK(page.find("builds that no other build beats. " + compared) != std::string::npos);
  CHECK(page.find("that no other beats. Point at one for what it changes; click for its sheet. " + compared) !=
        std::string::npos);
  REQUIRE(shop.run({"pareto", lifter, "--catalogue", "mine", "--language", "id", "--report", "i.html"}).exit_code == 0);
  CHECK(shop.read("i.html").find("yang tidak terkalahkan. Rancangan dibandingkan dengan harga komponen pilihan dibagi "
                                 "1.05; yang ditampilkan adalah harga sebenarnya.") != std::string::npos);
  REQUIRE(shop.run({"pareto", lifter, "--report", "p.html"}).exit_code == 0);
  CHECK(shop.read("p.html").find("preferred parts divided") == std::string::npos);
  REQUIRE(shop.run({"solve", lifter, "--catalogue", "mine", "--set", "objective.minimise=cost", "--report", "s.html"})
              .exit_code == 0);
  CHECK(shop.read("s.html").find("proved to be the best build of these catalogues. " + compared) != std::string::npos);
  const Outcome next =
      shop.run({"solve", lifter, "--catalogue", "mine", "--set", "objective.minimise=cost", "--alternatives", "2"});
  CHECK(wrapped_has(next.out, "these are the 2 cheapest builds, each set of parts counted once. " + compared));
  if (millwright::sanitized) return;
  // Of a range the table for programs names what bound and proof are of.
  const Outcome range = cheapest(shop, "0.05:0.25:2", {"--csv", "r.csv", "--report", "r.html", "--json", "r.json"});
  INFO(range.err);
  REQUIRE(range.exit_code == 0);
  CHECK(wrapped_has(range.out,
                    "Compared with the prices of preferred parts divided by 1 + preference; the prices shown are the "
                    "real ones."));
  CHECK(shop.read("r.html").find("Compared with the prices of preferred parts divided by 1 + preference") !=
        std::string::npos);
  const std::string csv = shop.read("r.csv");
  CHECK(csv.find(",cycle_time [s],compared_value,compared_lower_bound,changes,reason\n") != std::string::npos);
  const Json points = Json::parse(shop.read("r.json")).at("points");
  REQUIRE(points.size() == 2);
  for (const Json& point : points) {
    const double premium = point.at("value");
    const Json chosen = part(point, "driver");
    REQUIRE(chosen.at("part_number") == name);
    const double expected = cost(point) - chosen.at("price").get<double>() * (1.0 - 1.0 / (1.0 + premium));
    CHECK(point.at("objective").at("compared_value").get<double>() == Approx(expected).epsilon(1e-6));
    CHECK(csv.find(fmt::format(",{:.12g},{:.12g},",
                               point.at("objective").at("compared_value").get<double>(),
                               point.at("objective").at("lower_bound").get<double>())) != std::string::npos);
  }
}

TEST_CASE("A proof to a wider gap does not claim more than that") {
  const Workshop shop;
  const std::string printer = MILLWRIGHT_SOURCE_DIR "/problems/fdm-printer.toml";
  const std::vector<std::string> asked{"solve", printer, "--gap", "0.3", "--report", "g.html", "--json", "g.json"};
  const Outcome wide = shop.run(asked);
  REQUIRE(wide.exit_code == 0);
  const double gap = Json::parse(shop.read("g.json")).at("objective").at("gap");
  REQUIRE(gap > 0.01);  // else another machine is needed here
  const std::string percent = fmt::format("{:.3g} %", 100.0 * gap);
  CHECK(wide.prints("Proved: no compliant build of these catalogues is cheaper, by more than " + percent + "."));
  CHECK(wide.prints("Cheapest compliant build, to " + percent));
  CHECK(shop.read("g.html").find("The proof is to " + percent) != std::string::npos);
  // A premium that is proved counts what the gap leaves open.
  const Json plain = Json::parse(shop.read("g.json"));
  const std::string motor_name = motor(plain).at("part_number");
  shop.write("mine/stock.csv", fmt::format("part_number,available\n{},preferred\n", motor_name));
  std::vector<std::string> words = asked;
  words.insert(words.end(), {"--catalogue", "mine"});
  const Outcome preferring = shop.run(words);
  REQUIRE(preferring.exit_code == 0);
  const Json result = Json::parse(shop.read("g.json"));
  const double bound = result.at("objective").at("lower_bound");
  CHECK(preferring.prints(
      fmt::format("With its preferred parts it costs at most {:.2f} USD more", cost(result) - bound)));
}

TEST_CASE("A stock file that names an unknown part stops the run at its place") {
  const Workshop shop;
  shop.write("mine/stock.csv", "part_number,owned\n17HS19-2004S,1\n");
  const Outcome outcome = shop.run({"solve", lifter, "--catalogue", "mine"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("mine/stock.csv:2:1"));
  CHECK(outcome.says("17HS19-2004S1"));
}

TEST_CASE("catalogue list says what a folder without parts holds") {
  const Workshop shop;
  shop.write("mine/stock.csv", "part_number,owned\n17HS19-2004S1,1\n# and no other\n");
  shop.write("mine/suppliers.csv", "supplier,shipping_fee,currency\n,5,USD\n");
  const Outcome plain = shop.run({"catalogue", "list"});
  CHECK_FALSE(plain.prints("stock.csv"));
  const Outcome text = shop.run({"catalogue", "list", "--catalogue", "mine"});
  CHECK(text.exit_code == 0);
  CHECK(text.prints("mine: no parts of its own, stock.csv with 1 line, suppliers.csv with 1 line"));
  const Json json = Json::parse(shop.run({"catalogue", "list", "--catalogue", "mine", "--json", "-"}).out);
  CHECK_FALSE(json.at("catalogues").at(0).contains("remarks"));
  const Json& mine = json.at("catalogues").at(1);
  CHECK(mine.at("files") == 0);
  CHECK(mine.at("remarks").at(0).at("file") == "stock.csv");
  CHECK(mine.at("remarks").at(1).at("lines") == 1);
  const Outcome page = shop.run({"solve", lifter, "--catalogue", "mine", "--report", "r.html"});
  CHECK(page.exit_code == 0);
  CHECK(shop.read("r.html").find("0 + stock.csv + suppliers.csv") != std::string::npos);
}

TEST_CASE("A lock notices that the stock changed, came or went") {
  const Workshop shop;
  const std::string stock = "part_number,owned\n17HS19-2004S1,1\n";
  shop.write("mine/stock.csv", stock);
  REQUIRE(shop.run({"solve", lifter, "--catalogue", "mine", "--write-lock", "lock.toml"}).exit_code == 0);
  const std::vector<std::string> locked{"solve", lifter, "--catalogue", "mine", "--locked", "lock.toml"};
  CHECK(shop.run(locked).exit_code == 0);
  shop.write("mine/stock.csv", "part_number,owned\n17HS19-2004S1,2\n");
  const Outcome changed = shop.run(locked);
  CHECK(changed.exit_code == 2);
  CHECK(changed.says("stock.csv changed"));
  shop.write("mine/stock.csv", stock);
  shop.write("more/stock.csv", stock);
  std::vector<std::string> more = locked;
  more.insert(more.end(), {"--catalogue", "more"});
  CHECK(shop.run(more).exit_code == 2);
}

}  // namespace millwright::app::stock_test
