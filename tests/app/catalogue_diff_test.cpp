// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"
#include "program.h"

namespace catalogue_diff_test {

using namespace millwright::app;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n";

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

nlohmann::json difference(const Workshop& shop, const std::string& a, const std::string& b) {
  return nlohmann::json::parse(shop.run({"catalogue", "diff", a, b, "--json", "-"}).out);
}

/// Of the first part that changed.
nlohmann::json changed_cells(const nlohmann::json& difference) {
  return difference.at("families").at(0).at("changed").at(0).at("cells");
}

}  // namespace

TEST_CASE("catalogue diff tells what changed, in 80 columns and as JSON, and its exit code says whether") {
  const Workshop shop;
  shop.write("old/steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,10,USD\nAcme,M2,1.8,1,2,5,USD\n");
  shop.write("new/steppers/n.csv", motors + "Acme,M3,1.8,1,2,5,USD\nAcme,M1,1.8,1.26,2,11.5,USD\n");
  const Outcome same = shop.run({"catalogue", "diff", "old", "old"});
  CHECK(same.exit_code == 0);
  CHECK(same.prints("No differences: 2 parts the same."));
  const Outcome text = shop.run({"catalogue", "diff", "old", "new"});
  CHECK(text.exit_code == 1);
  CHECK(text.err.empty());
  CHECK(text.prints("10 USD -> 11.5 USD"));
  CHECK(text.prints("+15.0 %"));
  CHECK(text.prints("A old/steppers/m.csv:2   B new/steppers/n.csv:3"));
  CHECK(text.prints("Acme M3  new/steppers/n.csv:2"));
  CHECK(text.prints("Acme M2  old/steppers/m.csv:3"));
  CHECK(longest_line(text.out) <= 80);
  const Outcome files = shop.run({"catalogue", "diff", "old/steppers/m.csv", "new/steppers/n.csv", "--json", "-"});
  CHECK(files.exit_code == 1);
  const auto json = nlohmann::json::parse(files.out);
  CHECK(json.at("command") == "catalogue diff");
  CHECK(json.at("equal") == false);
  const auto& family = json.at("families").at(0);
  CHECK(family.at("family") == "steppers");
  CHECK(family.at("added").at(0).at("part_number") == "M3");
  CHECK(family.at("removed").at(0).at("place") == "old/steppers/m.csv:3:6");
  const auto cell = changed_cells(json).at(0);
  CHECK(cell.at("column") == "price");
  CHECK(cell.at("a") == "10 USD");
  CHECK(cell.at("b") == "11.5 USD");
  CHECK(cell.at("relative_change").get<double>() == Approx(0.15));
  CHECK(cell.at("a_place") == "old/steppers/m.csv:2:20");
}

TEST_CASE("catalogue diff names the points that a curve lost") {
  const Workshop shop;
  const std::string header =
      "manufacturer,part_number,drive_voltage [V],phase_current [A],driver,speed [rpm],torque [N.m],confidence\n";
  const std::string kept = "A,M,24,2,d,300,0.4,high\nA,M,24,2,d,600,0.3,high\n";
  shop.write("old/stepper_curves/c.csv", header + "A,M,24,2,d,60,0.5,high\nA,M,24,2,d,120,0.5,high\n" + kept);
  shop.write("new/stepper_curves/c.csv", header + kept);
  const auto cells = changed_cells(difference(shop, "old", "new"));
  REQUIRE(cells.size() == 2);
  CHECK(cells.at(0).at("point") == "60 rpm");
  CHECK(cells.at(1).at("point") == "120 rpm");
}

TEST_CASE("catalogue diff of one catalogue shows what it does on top of the shipped ones") {
  const Workshop shop;
  shop.write("mine/steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,10,USD\n");
  shop.write("more/steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,12,USD\n");
  const Outcome first = shop.run({"catalogue", "diff", "mine", "--json", "-"});
  CHECK(first.exit_code == 1);
  const auto json = nlohmann::json::parse(first.out);
  CHECK(json.at("families").size() > 10);  // all that is shipped
  CHECK(json.at("families").at(0).at("added").size() == 1);
  CHECK(json.at("families").at(0).at("removed").empty());
  const Outcome second = shop.run({"catalogue", "diff", "more", "--catalogue", "mine"});
  CHECK(second.exit_code == 1);
  CHECK(second.prints("10 USD -> 12 USD"));
  CHECK(second.prints("In all: 1 changed"));
  CHECK(shop.run({"catalogue", "diff", "mine", "--catalogue", "mine"}).exit_code == 0);
  CHECK(shop.run({"catalogue", "diff", "mine", "--family", "belts"}).exit_code == 0);
}

TEST_CASE("catalogue diff refuses what it cannot compare, all in one go") {
  const Workshop shop;
  std::filesystem::create_directory(shop.path("empty"));
  shop.write("twice/steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,10,USD\nAcme,M1,1.8,1.2,2,10,USD\n");
  const Outcome outcome = shop.run({"catalogue", "diff", "empty", "twice", "--family", "stepers"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.says("the catalogue 'empty' is empty"));
  CHECK(outcome.says("twice/steppers/m.csv:3:6: error"));
  CHECK(outcome.says("steppers"));
  CHECK(outcome.says("3 errors"));
  const Outcome missing = shop.run({"catalogue", "diff", "nowhere", "twice", "--catalogue", "empty"});
  CHECK(missing.exit_code == 2);
  CHECK(missing.says("nowhere: error"));
  CHECK(missing.says("--catalogue: both catalogues are named"));
}

TEST_CASE("catalogue diff tells what changed in stock, suppliers and offers, of whatever parts") {
  const Workshop shop;
  shop.write("old/stock.csv", "manufacturer,part_number,owned,available\nAcme,M1,2,\nAcme,M2,,no\n,M4,1,\n");
  shop.write("new/stock.csv", "part_number,manufacturer,available,owned\nM1,Acme,,2.0\nM2,Acme,preferred,\nM5,,no,\n");
  shop.write("old/offers.csv", "part_number,supplier,price,currency\nM1,Shop A,8.90,USD\nM1,Shop B,9,USD\n");
  shop.write("new/offers.csv", "part_number,supplier,price,currency\nM1,Shop A,9.10,USD\nM1,Shop B,9.00,USD\n");
  shop.write("old/suppliers.csv", "supplier,shipping_fee,currency\n,5,USD\n");
  shop.write("new/suppliers.csv", "supplier,shipping_fee,currency\n,5,USD\n");
  const Outcome text = shop.run({"catalogue", "diff", "old", "new"});
  CHECK(text.exit_code == 1);
  CHECK(text.err.empty());
  CHECK(text.prints("stock.csv: 1 added, 1 removed, 1 changed, 1 the same"));
  CHECK(text.prints("no -> preferred"));
  CHECK(text.prints("M5  new/stock.csv:4"));
  CHECK(text.prints("M4  old/stock.csv:4"));
  CHECK(text.prints("offers.csv: 1 changed, 1 the same"));
  CHECK(text.prints("M1, Shop A"));
  CHECK(text.prints("8.90 -> 9.10"));
  CHECK_FALSE(text.prints("suppliers.csv"));
  CHECK(text.prints("In all: 1 added, 1 removed, 2 changed, 3 the same."));
  CHECK(longest_line(text.out) <= 80);
  const Outcome same = shop.run({"catalogue", "diff", "old", "old"});
  CHECK(same.exit_code == 0);
  CHECK(same.prints("No differences: 6 lines of stock, suppliers and offers the same."));
  const auto json = difference(shop, "old", "new");
  CHECK(json.at("equal") == false);
  const auto& files = json.at("files");
  REQUIRE(files.size() == 3);
  CHECK(files.at(0).at("file") == "stock.csv");
  const auto& changed = files.at(0).at("changed").at(0);
  CHECK(changed.at("line") == "Acme M2");
  CHECK(changed.at("cells").at(0).at("column") == "available");
  CHECK(changed.at("cells").at(0).at("a") == "no");
  CHECK(changed.at("b_place") == "new/stock.csv:3:1");
  CHECK(files.at(1).at("same") == 1);
  CHECK(files.at(2).at("changed").at(0).at("cells").at(0).at("b") == "9.10");
  // A family is of parts alone.
  CHECK(shop.run({"catalogue", "diff", "old", "new", "--family", "steppers"}).exit_code == 0);
}

TEST_CASE("catalogue diff of an overlay without parts shows what it says of the shipped ones") {
  const Workshop shop;
  shop.write("mine/stock.csv", "part_number,owned\n17HS4401S,2\n");
  shop.write("more/stock.csv", "part_number,owned\n17HS4401S,3\n");
  const Outcome first = shop.run({"catalogue", "diff", "mine"});
  CHECK(first.exit_code == 1);
  CHECK(first.prints("17HS4401S  mine/stock.csv:2"));
  const Outcome second = shop.run({"catalogue", "diff", "more", "--catalogue", "mine"});
  CHECK(second.exit_code == 1);
  CHECK(second.prints("2 -> 3"));
  CHECK(second.prints("In all: 1 changed"));
  CHECK(shop.run({"catalogue", "diff", "mine", "--catalogue", "mine"}).exit_code == 0);
  // There the part must exist.
  shop.write("wrong/stock.csv", "part_number,owned\n17HS4401X,2\n");
  CHECK(shop.run({"catalogue", "diff", "wrong"}).exit_code == 2);
  shop.write("twice/stock.csv", "part_number,owned\nM1,2\nM1,3\n");
  const Outcome twice = shop.run({"catalogue", "diff", "twice", "mine"});
  CHECK(twice.exit_code == 2);
  CHECK(twice.says("twice/stock.csv:3:1: error: M1 stands in this file twice"));
  shop.write("nameless/offers.csv", "supplier,price\nShop A,2\n");
  const Outcome nameless = shop.run({"catalogue", "diff", "nameless", "mine"});
  CHECK(nameless.exit_code == 2);
  CHECK(nameless.says("offers.csv has no column part_number"));
}

TEST_CASE("catalogue diff does not take bad cells of stock, suppliers and offers for texts") {
  const Workshop shop;
  shop.write("good/stock.csv", "part_number,owned,available\nM1,2,\n");
  shop.write("bad/stock.csv", "part_number,owned,available\nM1,two,\nM2,1,maybe\nM3,-1,\nM4,,\n");
  shop.write("bad/suppliers.csv", "supplier,shipping_fee,currency\nShop A,free,USD\nShop A,1,usd\n");
  shop.write("bad/offers.csv",
             "part_number,supplier,price,currency\nM1,Shop A,cheap,USD\nM1,,3,USD\nM2,Shop A,3,\nM2,Shop A,3,EUR\n");
  for (const auto& sides : {std::pair("good", "bad"), std::pair("bad", "good")}) {
    const Outcome outcome = shop.run({"catalogue", "diff", sides.first, sides.second});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.says("bad/stock.csv:2:4: error"));
    CHECK(outcome.says("bad/stock.csv:3:6: error: available: 'maybe' is none of yes, no and preferred"));
    CHECK(outcome.says("bad/stock.csv:4:4: error: -1 pieces cannot be owned"));
    CHECK(outcome.says("nothing is said about this part"));
    CHECK(outcome.says("bad/suppliers.csv:2:8: error"));
    CHECK(outcome.says("'Shop A' stands in this file twice"));
    CHECK(outcome.says("'usd' is not a currency"));
    CHECK(outcome.says("bad/offers.csv:2:11: error"));
    CHECK(outcome.says("supplier is missing"));
    CHECK(outcome.says("bad/offers.csv:4:13: error: currency is missing"));
    CHECK(outcome.says("'Shop A' offers M2 twice"));
    CHECK(outcome.says("11 errors"));
  }
  shop.write("good/offers.csv", "part_number,supplier,price,currency\nM1,Shop A,3,USD\n");
  shop.write("unknown/offers.csv", "part_number,supplier,price,currency,prise\nM1,Shop A,3,USD,4\n");
  CHECK(shop.run({"catalogue", "diff", "good", "unknown"}).says("did you mean 'price'?"));
}

TEST_CASE("catalogue diff --json gives what is said of a figure its own cell") {
  const Workshop shop;
  const std::string head =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],holding_torque_source,holding_torque_confidence,"
      "rated_current [A],price,currency\n";
  shop.write("old/steppers/m.csv", head + "Acme,M1,1.8,1.26,list,low,2,10,USD\n");
  shop.write("new/steppers/m.csv", head + "Acme,M1,1.8,1.26,scales,high,2,10,USD\n");
  const auto cells = changed_cells(difference(shop, "old", "new"));
  REQUIRE(cells.size() == 2);
  CHECK(cells.at(0).at("column") == "holding_torque_source");
  CHECK(cells.at(0).at("a_place") == "old/steppers/m.csv:2:18");
  CHECK(cells.at(1).at("column") == "holding_torque_confidence");
  CHECK(cells.at(1).at("b") == "high");
  CHECK(cells.at(1).at("b_place") == "new/steppers/m.csv:2:25");
}

}  // namespace catalogue_diff_test
