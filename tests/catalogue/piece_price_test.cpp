// SPDX-License-Identifier: Apache-2.0
// Price breaks and packs, by hand.
#include "catalogue/piece_price.h"

#include "catalogue/catalogue.h"
#include "catch.h"
#include "temporary_folder.h"

namespace piece_price_test {

using namespace millwright;
using namespace millwright::catalogue;

TEST_CASE("Price breaks are read as they are written, or not at all") {
  const auto breaks = parse_price_breaks("10: 4.50; 100:3.9");
  REQUIRE(breaks);
  REQUIRE(breaks->size() == 2);
  CHECK((*breaks)[0].pieces == 10.0);
  CHECK((*breaks)[0].price == 4.5);
  CHECK((*breaks)[1].pieces == 100.0);
  CHECK((*breaks)[1].price == 3.9);
  for (const char* bad :
       {"10", "10: x", "0: 1", "1.5: 1", "10: 4; 10: 3", "10: 4; 5: 3", "10: -1", "10: 4;; 20: 3", "10: inf"})
    CHECK_FALSE(parse_price_breaks(bad));
}

TEST_CASE("An order takes whole packs, and more than needed where that costs less") {
  PiecePrice price{5.0, {{10, 4.0}}, 1.0};
  CHECK(price.purchase(0).price == 0.0);
  CHECK(price.purchase(7).price == 35.0);
  CHECK(price.purchase(8).price == 40.0);  // 8 * 5 = 10 * 4: no more than needed
  CHECK(price.purchase(8).pieces == 8.0);
  CHECK(price.purchase(9).price == 40.0);  // ten for 40 instead of nine for 45
  CHECK(price.purchase(9).pieces == 10.0);
  CHECK(price.purchase(12).price == 48.0);
  CHECK(price.least(20) == 4.0);
  CHECK(price.least(8) == 5.0);
  CHECK(price.least(9) == Approx(40.0 / 9.0));
  CHECK(price.is_plain_up_to(8));
  CHECK_FALSE(price.is_plain_up_to(9));
  price.pack = 4.0;
  CHECK(price.purchase(1).pieces == 4.0);
  CHECK(price.purchase(1).price == 20.0);
  CHECK(price.purchase(5).pieces == 8.0);   // 40; three packs at 4 are 48
  CHECK(price.purchase(9).pieces == 12.0);  // 48
  CHECK(price.purchase(9).price == 48.0);
}

TEST_CASE("What a row says of its own stock is checked too") {
  const TemporaryFolder folder;
  folder.write(
      "drivers/a.csv",
      "manufacturer,part_number,peak_current [A],maximum_voltage [V],price,owned_quantity [1],availability,currency\n"
      "A,D1,2,30,5,1.5,,USD\n"
      "A,D2,2,30,5,2,unavailable,USD\n"
      "A,D3,2,30,5,,in stock,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  const std::string text = text::format(diagnostics);
  INFO(text);
  CHECK(diagnostics.error_count() == 1);
  CHECK(text.find("a.csv:2:") != std::string::npos);
  CHECK(text.find("a.csv:4:") != std::string::npos);
  CHECK(text.find("changes nothing") != std::string::npos);
  CHECK(catalogue.table(Family::drivers).rows() == 2);
}

TEST_CASE("Price breaks and packs that make no sense are refused at their place") {
  const TemporaryFolder folder;
  folder.write(
      "drivers/a.csv",
      "manufacturer,part_number,peak_current [A],maximum_voltage [V],price,price_breaks,pack_size [1],currency\n"
      "A,D1,2,30,5,10 4.5,,USD\n"
      "A,D2,2,30,5,10: 4.5,2.5,USD\n"
      "A,D3,2,30,5,10: 4.5,5,USD\n");
  folder.write("belts/b.csv",
               "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension "
               "[N],price_per_length [1/m],price_breaks,currency\nA,B1,GT2,2,6,30,1.5,10: 1,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  const std::string text = text::format(diagnostics);
  INFO(text);
  CHECK(diagnostics.error_count() == 3);
  CHECK(text.find("a.csv:2:") != std::string::npos);
  CHECK(text.find("a.csv:3:") != std::string::npos);
  CHECK(text.find("b.csv:2:") != std::string::npos);
  const Table& drivers = catalogue.table(Family::drivers);
  REQUIRE(drivers.find("D3").rows.size() == 1);
  const PiecePrice price = drivers.piece_price(drivers.find("D3").rows.front());
  CHECK(price.pack == 5.0);
  CHECK(price.purchase(6).pieces == 10.0);
  CHECK(price.purchase(6).price == 45.0);
}

}  // namespace piece_price_test
