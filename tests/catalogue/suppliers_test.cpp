// SPDX-License-Identifier: Apache-2.0
// suppliers.csv and offers.csv: who sells parts, and for how much.
#include "catalogue/suppliers.h"

#include "catalogue/catalogue.h"
#include "catch.h"
#include "temporary_folder.h"

namespace suppliers_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency,supplier\n"
    "Acme,M1,1.8,1,2,10,USD,\nAcme,M2,1.8,2,2,20,USD,Shop A\nBest,M1,1.8,3,2,30,USD,\n";
const std::string belts =
    "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension [N],price_per_length [1/m],currency\n"
    "generic,B1,GT2,2,6,30,1.5,USD\n";

struct Loaded {
  Loaded(const std::string& suppliers, const std::string& offers, const std::string& stock = {}) {
    shipped.write("steppers/a.csv", motors);
    shipped.write("belts/b.csv", belts);
    if (!suppliers.empty()) overlay.write("suppliers.csv", suppliers);
    if (!offers.empty()) overlay.write("offers.csv", offers);
    if (!stock.empty()) overlay.write("stock.csv", stock);
    catalogue = Catalogue::load({shipped.path(), overlay.path()}, diagnostics);
  }
  [[nodiscard]] std::string said() const { return text::format(diagnostics); }
  [[nodiscard]] bool says(const std::string& words) const { return said().find(words) != std::string::npos; }

  TemporaryFolder shipped, overlay;
  text::Diagnostics diagnostics;
  Catalogue catalogue;
};

const std::string shops = "supplier,shipping_fee,minimum_order,currency\nShop A,12,50,USD\nShop B,5,,EUR\nShop C,,,\n";

}  // namespace

TEST_CASE("An offer is the part once more, by somebody else at another price") {
  const Loaded loaded(
      shops,
      "manufacturer,part_number,supplier,price,price_per_length [1/m],currency,price_basis,price_breaks\n"
      "Acme,M1,Shop A,9,,USD,\"quoted 2026-09-03\",10: 8\n"
      "Acme,M1,Shop B,8.5,,EUR,,\n,B1,Shop C,,1.25,USD,,\n");
  INFO(loaded.said());
  CHECK(loaded.diagnostics.count() == 0);
  CHECK(loaded.catalogue.suppliers().charges("Shop A"));
  CHECK_FALSE(loaded.catalogue.suppliers().charges("Shop C"));
  CHECK_FALSE(loaded.catalogue.suppliers().charges("nobody"));
  const Table& table = loaded.catalogue.with_offers().table(Family::steppers);
  REQUIRE(loaded.catalogue.table(Family::steppers).rows() == 3);
  REQUIRE(table.rows() == 5);
  const Found found = table.find("M1", "Acme");
  REQUIRE(found.rows == std::vector<int>{0, 3, 4});
  CHECK(table.price(0).piece == 10.0);
  CHECK(table.text("supplier", 0).empty());
  CHECK(table.price(3).piece == 9.0);
  CHECK(table.text("supplier", 3) == "Shop A");
  CHECK(table.text("price_basis", 3) == "quoted 2026-09-03");
  CHECK(table.piece_price(3).purchase(10).price == 80.0);
  CHECK(table.piece_price(4).is_plain());
  CHECK(table.price(4).currency == "EUR");
  CHECK(table.number("holding_torque", 4) == 1.0);
  CHECK(table.part_number(1) == "M2");
  const Table& belt = loaded.catalogue.with_offers().table(Family::belts);
  REQUIRE(belt.rows() == 2);
  CHECK(belt.price(1).length == 1.25);
  CHECK(std::isnan(belt.price(1).piece));
}

TEST_CASE("Offers of parts that are dropped go with them, and without offers nothing is copied") {
  Loaded loaded(shops, "part_number,supplier,price,currency\nM2,Shop B,18,USD\n");
  REQUIRE(loaded.catalogue.with_offers().table(Family::steppers).rows() == 4);
  loaded.catalogue.drop(loaded.catalogue.find("M2").parts);
  CHECK(&loaded.catalogue.with_offers() == &loaded.catalogue);
  const Loaded plain("", "");
  CHECK(&plain.catalogue.with_offers() == &plain.catalogue);
}

TEST_CASE("Some parts alone keep their order, their offers and what is owned of them") {
  const Loaded loaded(shops,
                      "manufacturer,part_number,supplier,price,currency\n"
                      "Acme,M2,Shop B,18,USD\nAcme,M1,Shop B,8,USD\n",
                      "part_number,owned\nM2,2\n");
  const Table& all = loaded.catalogue.table(Family::steppers);
  const std::vector<Part> wanted = loaded.catalogue.find("M2").parts;
  REQUIRE(wanted.size() == 1);
  const Catalogue few = loaded.catalogue.only({wanted.front(), {Family::steppers, 0}});
  CHECK(few.rows() == 2);
  const Table& table = few.table(Family::steppers);
  REQUIRE(table.rows() == 2);
  CHECK(table.part_number(0) == all.part_number(0));
  CHECK(table.part_number(1) == "M2");
  CHECK(table.where(1).line == all.where(wanted.front().row).line);
  CHECK(few.find("M2").parts.front().row == 1);
  // One offer each, and M2's owned pieces: its own seller charges for an order.
  const Table& offered = few.with_offers().table(Family::steppers);
  REQUIRE(offered.rows() == 5);
  CHECK(offered.part_number(2) == "M2");
  CHECK(offered.price(2).piece == 18.0);
  CHECK(offered.part_number(3) == "M1");
  CHECK(offered.ownership(4) == Ownership::only);
  CHECK(loaded.catalogue.rows() == all.rows() + loaded.catalogue.table(Family::belts).rows());
  CHECK(loaded.catalogue.only({}).rows() == 0);
}

TEST_CASE("Pieces that are owned of what a charging supplier sells are a row of their own") {
  const Loaded loaded(shops, "", "part_number,owned\nM2,2\n");
  const Table& table = loaded.catalogue.with_offers().table(Family::steppers);
  REQUIRE(table.rows() == 4);
  CHECK(table.ownership(1) == Ownership::usual);
  CHECK(table.ownership(3) == Ownership::only);
  CHECK(table.part_number(3) == "M2");
  CHECK(table.text("supplier", 3).empty());
}

TEST_CASE("Everything wrong with suppliers and offers is reported at its place") {
  const Loaded loaded(
      "supplier,shipping_fee,minimum_order,currency\nShop A,-1,,USD\nShop B,5,,\nShop C,5,,dollars\nShop D,,,\nShop "
      "D,,,\n",
      "manufacturer,part_number,supplier,price,price_per_length [1/m],currency,price_breaks,pack_size\n"
      "Acme,M3,Shop A,1,,USD,,\n"
      ",M1,Shop A,1,,USD,,\n"
      "Acme,M1,,1,,USD,,\n"
      "Acme,M1,Shop A,,,USD,,\n"
      "Acme,M1,Shop A,1,2,USD,,\n"
      "Acme,M1,Shop B,1,,USD,ten,1.5\n"
      "Acme,M2,Shop A,1,,USD,,\n"
      ",B1,Shop A,,1,USD,10: 1,\n");
  CHECK(loaded.says("suppliers.csv:2:8: error: shipping_fee cannot be -1"));
  CHECK(loaded.says("suppliers.csv:3:11: error: currency is missing"));
  CHECK(loaded.says("suppliers.csv:4:11: error: 'dollars' is not a currency"));
  CHECK(loaded.says("suppliers.csv:6:1: error: 'Shop D' stands in this file twice"));
  CHECK(loaded.says("offers.csv:2:6: error: no part 'M3' in the catalogues"));
  CHECK(loaded.says("offers.csv:3:2: error: part number 'M1' is ambiguous"));
  CHECK(loaded.says("offers.csv:4:9: error: supplier is missing"));
  CHECK(loaded.says("offers.csv:5:16: error: price is missing"));
  CHECK(loaded.says("offers.csv:6:18: error: stepper motors have no price_per_length"));
  CHECK(loaded.says("offers.csv:7:23: error: 'ten' are no price breaks"));
  CHECK(loaded.says("offers.csv:7:27: error: pack_size is 1.5 pieces"));
  CHECK(loaded.says("offers.csv:8:9: error: the catalogue says itself what it costs from 'Shop A'"));
  CHECK(loaded.says("offers.csv:9:2: error: timing belts are not sold by the piece alone"));
}

TEST_CASE("Names of suppliers that do not meet are warned of, and too many that charge are refused") {
  const Loaded loaded("supplier,shipping_fee,currency\nShop A,1,USD\nShop Q,1,USD\n",
                      "part_number,manufacturer,supplier,price,currency\nM1,Acme,Shop QQ,1,USD\n");
  CHECK(loaded.diagnostics.error_count() == 0);
  CHECK(loaded.says("suppliers.csv:3:1: warning: 'Shop Q' sells no part of the catalogues"));
  CHECK(loaded.says("warning: suppliers.csv has no 'Shop QQ'"));
  CHECK(loaded.says("did you mean 'Shop Q'?"));
  std::string many = "supplier,shipping_fee,currency\n", offers = "part_number,manufacturer,supplier,price,currency\n";
  for (std::size_t i = 0; i <= Suppliers::most_charging; ++i) {
    many += "Shop " + std::to_string(i) + ",1,USD\n";
    offers += "M1,Acme,Shop " + std::to_string(i) + ",1,USD\n";
  }
  const Loaded crowd(many, offers);
  CHECK(crowd.diagnostics.error_count() == 1);
  CHECK(crowd.says("more than 6 suppliers charge shipping or a minimum"));
}

TEST_CASE("A column that the files do not have is refused with the nearest") {
  const Loaded loaded("supplier,shiping_fee,currency\nShop A,1,USD\n", "part_number,price,currency\nM1,1,USD\n");
  CHECK(loaded.says("suppliers.csv:1:10: error: suppliers.csv has no column 'shiping_fee'"));
  CHECK(loaded.says("did you mean 'shipping_fee'?"));
  CHECK(loaded.says("offers.csv has no column supplier"));
}

}  // namespace suppliers_test
