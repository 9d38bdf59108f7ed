// SPDX-License-Identifier: Apache-2.0
// What suppliers, offers and spares do to answers, bills and orders.
#include <fmt/format.h>
#include <cmath>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/lifter.h"
#include "sanitized.h"

namespace millwright::app::suppliers_test {

TEST_CASE("An order from a shop is charged with shipping and minimum, and the order list says so") {
  const Workshop shop;
  const Json plain = solved(shop, {});
  CHECK_FALSE(plain.at("build").contains("orders"));
  const std::string name = motor(plain).at("part_number");
  const double price = motor(plain).at("price");
  REQUIRE(price > 4.0);
  // Half the price in whole cents, 1 for shipping, filled up to a minimum that is half a dollar more: 1.5 are left of
  // what is saved.
  const double there = std::floor(50.0 * price) / 100.0;
  shop.write(
      "mine/suppliers.csv",
      fmt::format("supplier,shipping_fee,minimum_order,currency\nShop A,1,{},USD\nShop B,900,,USD\n", there + 0.5));
  shop.write("mine/offers.csv",
             fmt::format("part_number,supplier,price,currency,price_basis\n{0},Shop A,{1},USD,quoted 2026-09-03\n"
                         "{0},Shop B,0,USD,quoted 2026-09-03\n",
                         name,
                         there));
  const Json offered = solved(shop, {"--catalogue", "mine", "--order", "order.csv", "--report", "page.html"});
  CHECK(motor(offered).at("part_number") == name);
  CHECK(motor(offered).at("supplier") == "Shop A");
  CHECK(motor(offered).at("price").get<double>() == Approx(there));
  CHECK(cost(offered) == Approx(cost(plain) - price + there + 1.5));
  const Json& orders = offered.at("build").at("orders");
  REQUIRE(orders.size() == 1);
  CHECK(orders[0].at("supplier") == "Shop A");
  CHECK(orders[0].at("shipping_fee") == 1);
  CHECK(orders[0].at("top_up").get<double>() == Approx(0.5));
  const std::string order = shop.read("order.csv");
  CHECK(order.find("Shop A") != std::string::npos);
  CHECK(order.find(",,,\"Shipping, Shop A\",,,,,USD,,,1,") != std::string::npos);
  CHECK(order.find(fmt::format("To the minimum order of {:.2f} USD, Shop A", there + 0.5)) != std::string::npos);
  CHECK(order.find("2026-09-03") != std::string::npos);
  CHECK(shop.read("page.html").find("Filling up to the minimum order") != std::string::npos);
  const Outcome text = shop.run({"solve", lifter, "--catalogue", "mine"});
  CHECK(text.prints("Order from Shop A: goods "));
  CHECK(text.prints("shipping 1.00, filled up to the minimum"));
  // What solve writes, check reads back at the same cost.
  REQUIRE(shop.run({"solve", lifter, "--catalogue", "mine", "--bom", "bom.csv", "--quiet"}).exit_code == 0);
  const Outcome checked = shop.run({"check", lifter, "bom.csv", "--catalogue", "mine", "--json", "-"});
  CAPTURE(checked.err);
  REQUIRE(checked.exit_code == 0);
  CHECK(cost(Json::parse(checked.out)) == Approx(cost(offered)));
}

// One EUR is 1.08 USD in the lifter's problem: 2.50 EUR are 2.70 USD, shipping of 1 EUR is 1.08 USD.
TEST_CASE("What was converted is shown with its own price, the rate and its day") {
  const Workshop shop;
  // The motor for a slower lift is listed in USD.
  const std::vector<std::string> slower{"--set", "axis.z.moves[0].time='3 s'"};
  const Json plain = solved(shop, slower);
  CHECK_FALSE(plain.at("build").contains("conversions"));
  CHECK_FALSE(motor(plain).contains("stated_price"));
  const std::string name = motor(plain).at("part_number");
  shop.write("mine/suppliers.csv", "supplier,shipping_fee,minimum_order,currency\nShop A,1,,EUR\n");
  shop.write("mine/offers.csv",
             fmt::format("part_number,supplier,price,currency,price_basis\n{},Shop A,2.5,EUR,quoted\n", name));
  std::vector<std::string> words = slower;
  words.insert(words.end(), {"--catalogue", "mine", "--order", "order.csv", "--report", "page.html"});
  const Json result = solved(shop, words);
  REQUIRE(motor(result).at("supplier") == "Shop A");
  CHECK(motor(result).at("price").get<double>() == Approx(2.7));
  CHECK(motor(result).at("stated_price").at("value").get<double>() == Approx(2.5));
  CHECK(motor(result).at("stated_price").at("unit") == "EUR");
  CHECK(result.at("build").at("orders")[0].at("stated_currency") == "EUR");
  CHECK(result.at("build").at("conversions") ==
        Json::parse(R"([{"currency": "EUR", "rate": 1.08, "into": "USD", "date": "2026-01-15"}])"));
  CHECK(shop.read("order.csv").find("z.motor,,1 EUR = 1.08 USD (2026-01-15)\n") != std::string::npos);
  const std::string page = shop.read("page.html");
  CHECK(page.find("Prices were converted at 1 EUR = 1.08 USD (2026-01-15)") != std::string::npos);
  CHECK(page.find("2.50 EUR") != std::string::npos);
  const Outcome text = shop.run({"solve", lifter, slower[0], slower[1], "--catalogue", "mine"});
  CHECK(text.prints(
      "Converted at 1 EUR = 1.08 USD (2026-01-15): z.motor 2.50 EUR, shipping from\n    Shop A 1.00 EUR\n"));
  const Outcome undated =
      shop.run({"solve", lifter, slower[0], slower[1], "--catalogue", "mine", "--set", "currency.EUR=1.08"});
  CHECK(undated.prints("Converted at 1 EUR = 1.08 USD (date not stated)"));
}

TEST_CASE("A reduction that the problem prices in another currency says so too") {
  const Workshop shop;
  std::ifstream file(MILLWRIGHT_SOURCE_DIR "/problems/rotary-table.toml");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  for (std::size_t at = text.find(" USD\""); at != std::string::npos; at = text.find(" USD\"", at))
    text.replace(at, 4, " EUR");
  shop.write("table.toml", text);
  const Outcome outcome = shop.run({"solve", "table.toml", "--json", "-"});
  REQUIRE(outcome.exit_code == 0);
  const Json chosen = part(Json::parse(outcome.out), "reduction");
  const double stated = chosen.at("stated_price").at("value");
  CHECK(text.find(fmt::format("name = \"{}\"", chosen.at("part_number").get<std::string>())) != std::string::npos);
  CHECK(text.find(fmt::format("price = \"{:.0f} EUR\"", stated)) != std::string::npos);
  CHECK(chosen.at("price").get<double>() == Approx(1.08 * stated));
}

TEST_CASE("A supplier who charges in a currency without a rate is an error") {
  const Workshop shop;
  shop.write("mine/suppliers.csv", "supplier,shipping_fee,currency\n,1,CHF\n");
  const Outcome outcome = shop.run({"solve", lifter, "--catalogue", "mine"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("suppliers.csv:2:"));
  CHECK(outcome.says("the problem gives no rate for CHF"));
}

TEST_CASE("Parts that no rate brings into the choice are warned of") {
  const Workshop shop;
  std::ifstream file(lifter);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t rate = text.find("\nEUR = ");
  REQUIRE(rate != std::string::npos);
  text.erase(rate, text.find('\n', rate + 1) - rate);
  shop.write("no-rate.toml", text);
  const Outcome outcome = shop.run({"solve", "no-rate.toml", "--quiet"});
  CHECK(outcome.exit_code == 0);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("[currency]")), '\n');
  CHECK(outcome.says(fmt::format("no-rate.toml:{}:1: warning", line)));
  CHECK(outcome.says("the problem gives no rate for 'EUR'"));
  CHECK(outcome.says("parts priced in it are not for sale"));
  CHECK_FALSE(shop.run({"solve", lifter, "--quiet"}).says("not for sale"));
  // So are offers of a shop.
  shop.write("shops/suppliers.csv", "supplier,shipping_fee,currency\nShop A,2,USD\n");
  shop.write("shops/offers.csv", "part_number,supplier,price,currency\n23HS45-4204S,Shop A,20,GBP\n");
  const Outcome offer = shop.run({"solve", lifter, "--catalogue", "shops", "--quiet"});
  CHECK(offer.exit_code == 0);
  CHECK(offer.says(
      "the problem gives no rate for 'GBP': the part priced in it is not for sale (23HS45-4204S of Shop A)"));
}

TEST_CASE("Spares are priced and ordered, and weigh nothing") {
  const Workshop shop;
  const Json plain = solved(shop, {});
  const Json result = solved(shop, {"--set", "spares.motor=2", "--order", "order.csv"});
  const Json own = motor(result);
  CHECK(own.at("spares") == 2);
  CHECK(own.at("quantity") == 1);
  CHECK(own.at("price").get<double>() == Approx(3.0 * own.at("unit_price").get<double>()));
  CHECK(cost(result) > cost(plain));
  CHECK(cost(result) <= cost(plain) + 2.0 * motor(plain).at("price").get<double>() + 1e-9);
  CHECK(shop.read("order.csv").find("z.motor and 2 spare") != std::string::npos);
  const Outcome text = shop.run({"solve", lifter, "--set", "spares.motor=2"});
  CHECK(text.prints("Spare: 2 more of "));
  const Outcome wrong = shop.run({"solve", lifter, "--set", "spares.motr=2"});
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.says("did you mean 'motor'?"));
}

// The motor of a lighter and slower lift, with a tolerance of its torque that its check does not have room for.
TEST_CASE("A tolerance breaks a build, and decides a robust one, whoever sells the part") {
  const Workshop shop;
  shop.write("mine/steppers/motor.csv",
             "manufacturer,part_number,frame,frame_size [mm],body_length [mm],shaft_diameter [mm],step_angle [deg],"
             "holding_torque [N.m],holding_torque_tolerance [%],rated_current [A],current_kind,phase_resistance [ohm],"
             "phase_inductance [mH],rotor_inertia [g.cm2],mass [kg],price,price_source,currency\n"
             "StepperOnline,23HS45-4204S,NEMA23,57,113,10,1.8,3,8,4.2,phase,0.88,3.4,800,1.6,18.7,quoted,USD\n");
  shop.write("shops/suppliers.csv", "supplier,shipping_fee,minimum_order,currency\nShop A,2,,USD\n");
  shop.write("shops/offers.csv", "part_number,supplier,price,currency\n23HS45-4204S,Shop A,10,USD\n");
  std::vector<std::string> words{
      "--set", "axis.z.payload_mass='12 kg'", "--set", "axis.z.moves[0].time='1.8 s'", "--catalogue", "mine"};
  const Json one = solved(shop, words);
  words.insert(words.end(), {"--catalogue", "shops"});
  const Json several = solved(shop, words);
  REQUIRE(motor(one).at("part_number") == "23HS45-4204S");
  REQUIRE(motor(several).at("supplier") == "Shop A");
  for (const Json* each : {&one, &several}) {
    REQUIRE(each->at("tolerances").at("verdict") == "broken");
    CHECK(each->at("tolerances").at("figures").size() == 1);
    CHECK(each->at("tolerances").at("breaks")[0].at("check") == "C-ST-TORQUE");
  }
  CHECK(several.at("tolerances").at("breaks")[0].at("from") == one.at("tolerances").at("breaks")[0].at("from"));
  // Another motor then, which nobody else sells.
  const Json robust = solved(shop, {"--catalogue", "mine", "--robust"});
  CHECK(motor(robust).at("part_number") != "23HS45-4204S");
  CHECK(cost(robust) > cost(one));
  if (millwright::sanitized) return;
  const Json robust_of_several = solved(shop, {"--catalogue", "mine", "--catalogue", "shops", "--robust"});
  CHECK(cost(robust_of_several) == Approx(cost(robust)));
  CHECK(robust_of_several.at("tolerances").at("verdict") == "compliant");
}

TEST_CASE("What is owned goes first also where its supplier charges for the rest of the line") {
  const Workshop shop;
  const Json plain = solved(shop, {"--set", "spares.supply=1"});
  shop.write("mine/stock.csv",
             "part_number,owned\n" + part(plain, "supply").at("part_number").get<std::string>() + ",1\n");
  const Json owned = solved(shop, {"--set", "spares.supply=1", "--catalogue", "mine"});
  CHECK(cost(owned) < cost(plain));
  shop.write("mine/suppliers.csv", "supplier,shipping_fee,minimum_order,currency\n,1,,USD\n");
  const Json charged = solved(shop, {"--set", "spares.supply=1", "--catalogue", "mine"});
  CHECK(cost(charged) == Approx(cost(owned) + 1.0));  // one order, of all that is not owned
}

}  // namespace millwright::app::suppliers_test
