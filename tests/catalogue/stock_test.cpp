// SPDX-License-Identifier: Apache-2.0
// stock.csv: what lies in the drawer and what cannot be had.
#include "catalogue/stock.h"

#include "catalogue/catalogue.h"
#include "catch.h"
#include "temporary_folder.h"

namespace stock_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n"
    "Acme,M1,1.8,1,2,10,USD\nAcme,M2,1.8,2,2,20,USD\nBest,M1,1.8,3,2,30,USD\n";
const std::string belts =
    "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension [N],price_per_length [1/m],currency\n"
    "generic,B1,GT2,2,6,30,1.5,USD\n";

struct Loaded {
  explicit Loaded(const std::vector<std::string>& stocks) {
    shipped.write("steppers/a.csv", motors);
    shipped.write("belts/b.csv", belts);
    std::vector<std::filesystem::path> places = {shipped.path()};
    for (std::size_t i = 0; i < stocks.size(); ++i) {
      overlays.write(std::to_string(i) + "/stock.csv", stocks[i]);
      places.push_back(overlays.path() / std::to_string(i));
    }
    catalogue = Catalogue::load(places, diagnostics);
  }
  [[nodiscard]] const StockMark* mark(const char* maker, const char* part) const {
    return catalogue.stock().find(Family::steppers, maker, part);
  }

  TemporaryFolder shipped, overlays;
  text::Diagnostics diagnostics;
  Catalogue catalogue;
};

}  // namespace

TEST_CASE("A stock file marks parts of any maker, and later overlays have the last word") {
  const Loaded loaded(
      {"manufacturer,part_number,owned,available\nAcme,M1,2,\n,M2,,no\n", "part_number,available\nM2,yes\n"});
  INFO(text::format(loaded.diagnostics));
  CHECK(loaded.diagnostics.count() == 0);
  REQUIRE(loaded.mark("Acme", "M1") != nullptr);
  CHECK(loaded.mark("Acme", "M1")->owned == 2.0);
  CHECK(loaded.mark("Acme", "M1")->available);
  CHECK(loaded.mark("Best", "M1") == nullptr);
  REQUIRE(loaded.mark("Acme", "M2") != nullptr);
  CHECK(loaded.mark("Acme", "M2")->available);
}

TEST_CASE("An empty cell of a later stock file leaves what an earlier one says") {
  const Loaded loaded({"part_number,manufacturer,owned,available\nM1,Acme,2,\nM2,Acme,,no\n",
                       "part_number,manufacturer,owned,available\nM1,Acme,,preferred\nM2,Acme,1,\n"});
  INFO(text::format(loaded.diagnostics));
  REQUIRE(loaded.mark("Acme", "M1") != nullptr);
  CHECK(loaded.mark("Acme", "M1")->owned == 2.0);
  CHECK(loaded.mark("Acme", "M1")->preferred);
  REQUIRE(loaded.mark("Acme", "M2") != nullptr);
  CHECK(loaded.mark("Acme", "M2")->owned == 1.0);
  CHECK_FALSE(loaded.mark("Acme", "M2")->available);
}

TEST_CASE("Everything wrong in a stock file is reported at its place") {
  const Loaded loaded(
      {"manufacturer,part_number,owned,available\n"
       "Acme,M3,1,\n"
       ",M1,1,\n"
       "Acme,M1,1.5,\n"
       "Acme,M2,2,maybe\n"
       "Best,M1,,\n"
       "generic,B1,1,\n"
       "Acme,M2,2,no\n"
       "Acme,M2,1,\n"
       "Acme,M2,2,\n"
       "Acme,M1,two,\n"
       "Acme,M1,-1,\n"});
  const std::string text = text::format(loaded.diagnostics);
  INFO(text);
  const auto said = [&](int line, const char* words) {
    for (const text::Diagnostic& each : loaded.diagnostics.all())
      if (each.where.line == line && each.message.find(words) != std::string::npos) return true;
    return false;
  };
  CHECK(said(2, "M3"));
  CHECK(said(3, "M1"));  // of two makers
  CHECK(said(4, "1.5 pieces"));
  CHECK(said(5, "none of yes, no and preferred"));
  CHECK(said(6, "nothing is said"));
  CHECK(said(7, "cut to length"));
  CHECK(said(8, "not available"));
  CHECK(said(10, "twice"));
  CHECK(said(11, "number"));
  CHECK(said(12, "-1 pieces"));
  CHECK(loaded.diagnostics.error_count() >= 10);
}

TEST_CASE("A stock file with an unknown or a missing column is refused") {
  const Loaded unknown({"part_number,onwed\nM2,1\n"});
  CHECK(unknown.diagnostics.error_count() == 1);
  CHECK(text::format(unknown.diagnostics).find("owned") != std::string::npos);
  CHECK(unknown.catalogue.stock().empty());
  const Loaded empty({""});
  CHECK(empty.diagnostics.error_count() == 1);
  const Loaded missing({"owned\n1\n"});
  CHECK(missing.diagnostics.error_count() == 1);
}

TEST_CASE("A folder with nothing but a stock file is an overlay") {
  const Loaded loaded({"part_number,available\nB1,no\n"});
  INFO(text::format(loaded.diagnostics));
  CHECK(loaded.diagnostics.count() == 0);
  const StockMark* mark = loaded.catalogue.stock().find(Family::belts, "generic", "B1");
  REQUIRE(mark != nullptr);
  CHECK_FALSE(mark->available);
}

}  // namespace stock_test
