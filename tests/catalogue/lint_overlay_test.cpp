// SPDX-License-Identifier: Apache-2.0
// What lint says of stock, suppliers and offers; prices and sums by hand.
#include "catalogue/lint_overlay.h"

#include "catalogue/lint.h"
#include "catalogue/temporary_folder.h"
#include "catch.h"

namespace lint_overlay_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

/// Folders with two motors at 10 USD and 40 EUR, of which the second is sold by Shop B, and what is said of them.
struct Folders {
  Folders() {
    parts.write(
        "steppers/a.csv",
        "manufacturer,part_number,frame,frame_size [mm],step_angle [deg],holding_torque [N.m],rated_current [A],"
        "phase_resistance [ohm],phase_inductance [mH],rotor_inertia [g.cm2],mass [kg],price,currency,supplier\n"
        "Acme,M1,NEMA17,42.3,1.8,0.4,1.7,1.5,2.8,54,0.28,10,USD,\n"
        "Acme,M2,NEMA23,57,1.8,1.26,2.8,0.9,2.5,300,0.7,40,EUR,Shop B\n");
  }

  /// Findings of the folder of the files, one a line.
  std::string lint(const std::string& file = {}) const {
    text::Diagnostics diagnostics;
    summary = lint_files({file.empty() ? mine.path() : mine.path() / file}, std::nullopt, diagnostics, {parts.path()});
    return text::format(diagnostics);
  }

  TemporaryFolder parts, mine;
  mutable LintSummary summary;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string offers_head = "part_number,supplier,price,currency,price_breaks,pack_size\n";

}  // namespace

TEST_CASE("offers near the catalogue's prices are in order") {
  const Folders folders;
  folders.mine.write("offers.csv", offers_head + "M1,Shop A,2,USD,10: 1.9; 100: 1.5,\nM1,Shop C,50,EUR,,5\n");
  folders.mine.write("suppliers.csv", "supplier,shipping_fee,minimum_order,currency\nShop A,2,20,USD\nShop C,,,\n");
  folders.mine.write("stock.csv", "part_number,owned\nM2,1000\n");
  CHECK(folders.lint().empty());
  CHECK(folders.summary.files == 3);
  CHECK(folders.summary.warnings == 0);
}

TEST_CASE("files of stock, suppliers and offers may have their names in capitals") {
  const Folders folders;
  folders.mine.write("OFFERS.CSV", offers_head + "M1,Shop A,1000,USD,,\n");
  folders.mine.write("Suppliers.csv", "supplier,shipping_fee,minimum_order,currency\nShop A,2,20,USD\n");
  folders.mine.write("STOCK.CSV", "part_number,owned\nM1,1001\n");
  const std::string told = folders.lint();
  CHECK(has(told, "OFFERS.CSV:2:1: warning: M1: price 1000 USD is 100 times too large"));
  CHECK(has(told, "STOCK.CSV:2:1: warning: M1: 1001 pieces are owned [stock]"));
  CHECK(folders.summary.files == 3);
  CHECK(folders.summary.warnings == 2);
}

TEST_CASE("prices far from the catalogue's own, of nothing and breaks that rise are doubted") {
  const Folders folders;
  folders.mine.write("offers.csv",
                     offers_head +
                         "M1,Shop A,1000,USD,,\nM1,Shop C,0,USD,,\nM2,Shop A,6,USD,,\nM2,Shop C,30,USD,10: "
                         "250,\nM1,Shop D,120,USD,,12\nM2,Shop D,450000,IDR,,\n");
  const std::string told = folders.lint();
  CHECK(has(told, "offers.csv:2:1: warning: M1: price 1000 USD is 100 times too large, the catalogue's own is 10"));
  CHECK(has(told, "cents, or the price of a hundred?"));
  CHECK(has(told, "offers.csv:3:1: warning: M1: price is 0 [offer-price]"));
  CHECK(has(told, "offers.csv:4:1: warning: M2: price 6 USD is 6.67 times too small, the catalogue's own is 40"));
  CHECK(has(told, "offers.csv:5:1: warning: M2: from 10 pieces on each costs 250 USD, more than the 30 below that"));
  CHECK(has(told, "offers.csv:6:1: warning: M1: price 120 USD is 12 times too large"));
  CHECK(has(told, "the price of a pack? what stands there is of one piece"));
  CHECK(folders.summary.warnings == 5);  // of rupiah nothing is known
  CHECK(folders.summary.errors == 0);
}

TEST_CASE("fees above all that is sold, and a stock like a shop's, are doubted") {
  const Folders folders;
  folders.mine.write("offers.csv", offers_head + "M1,Shop A,12,USD,,\nM2,Shop A,38,EUR,,\n");
  // One of each is 50 at Shop A and 40 at Shop B: 50.01 is above the first, 401 above ten of the second.
  folders.mine.write("suppliers.csv",
                     "supplier,shipping_fee,minimum_order,currency\nShop A,50.01,500,USD\nShop B,40,401,EUR\n");
  folders.mine.write("stock.csv", "part_number,owned\nM1,1001\n");
  const std::string told = folders.lint();
  CHECK(has(told,
            "suppliers.csv:2:1: warning: a shipping fee of 50.01 USD is more than one of each of all that is sold"));
  CHECK(has(told, "suppliers.csv:3:1: warning: a minimum order of 401 EUR is more than 10 of each"));
  CHECK(has(told, "stock.csv:2:1: warning: M1: 1001 pieces are owned [stock]"));
  CHECK(folders.summary.warnings == 3);
}

TEST_CASE("errors of the files are told by lint too, and one file finds its neighbours") {
  const Folders folders;
  folders.mine.write("offers.csv", offers_head + "M9,Shop A,12,USD,,\nM1,Shop A,12,USD,,\n");
  folders.mine.write("suppliers.csv", "supplier,shipping_fee,currency\nShop A,5,USD\n");
  folders.mine.write("stock.csv", "part_number,owned\nM1,two\n");
  const std::string told = folders.lint();
  CHECK(has(told, "offers.csv:2:1: error: no part 'M9' in the catalogues"));
  CHECK(has(told, "stock.csv:2:4: error: "));
  CHECK(folders.summary.errors == 2);
  CHECK(has(folders.lint("stock.csv"), "stock.csv:2:4: error: "));
  CHECK(folders.summary.files == 1);
  CHECK_FALSE(has(folders.lint("suppliers.csv"), "sells no part"));
  CHECK(folders.summary.files == 2);
}

TEST_CASE("terms of cutting that no seller has are doubted, as a family's own columns are") {
  const Folders folders;
  folders.parts.write(
      "steel_sections/a.csv",
      "manufacturer,part_number,kind,height [mm],width [mm],area [mm2],mass_per_length [kg/m],second_moment_x [mm4],"
      "second_moment_y [mm4],material,elastic_modulus [MPa],price_per_length [1/m],currency\n"
      "Acme,B20,square tube,20,20,200,1.6,10000,10000,steel,200000,50,USD\n");
  folders.mine.write("offers.csv",
                     "part_number,supplier,price_per_length [1/m],currency,stock_length [mm],"
                     "cutting_loss [mm],cut_price\n"
                     "B20,Shop A,50,USD,3000,3,2\n"      // in order
                     "B20,Shop B,50,USD,300000,3,2\n"    // longer than any bar
                     "B20,Shop C,50,USD,3000,60,2\n"     // wider than any saw
                     "B20,Shop D,50,USD,3000,3,800\n");  // more than five bars of 150
  const std::string told = folders.lint();
  CHECK(has(told, "offers.csv:3:1: warning: B20: stock_length 300000 mm is outside the plausible 100 to 20000"));
  CHECK(has(told, "offers.csv:4:1: warning: B20: cutting_loss 60 mm is outside the plausible 0 to 50"));
  CHECK(has(told, "offers.csv:5:1: warning: B20: cut_price 800 USD is more than 5 bars cost there, 750"));
  CHECK(folders.summary.warnings == 3);
  CHECK(folders.summary.errors == 0);
}

}  // namespace lint_overlay_test
