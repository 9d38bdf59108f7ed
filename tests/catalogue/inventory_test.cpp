// SPDX-License-Identifier: Apache-2.0
// Files with their digests, as GNU sha256sum printed them; parts as they are recorded.
#include "catalogue/inventory.h"

#include "catalogue/figures.h"
#include "catch.h"
#include "temporary_folder.h"

namespace inventory_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n";
const std::string belts =
    "\xEF\xBB\xBFmanufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension [N],price_per_length "
    "[1/m],currency\r\n";

}  // namespace

TEST_CASE("the inventory has the digests that sha256sum prints, with byte order mark and CR LF") {
  const TemporaryFolder lower, upper;
  lower.write("steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,10,USD\nAcme,M2,1.8,1,2,5,USD\n");
  lower.write("belts/x.csv", belts + "generic,B1,GT2,2,6,30,1.5,USD\r\n");
  const auto single = upper.write("steppers.csv", motors + "Acme,M1,1.8,1.26,2,12,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({lower.path(), single}, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(diagnostics.count() == 0);
  const Inventory all = inventory(catalogue);
  REQUIRE(all.files.size() == 3);
  CHECK(all.files[0].name == "belts/x.csv");
  CHECK(all.files[0].sha256 == "43eb665017d843863578432dd8528ea6c714ff72af0689b8f88459034dc3d9df");
  CHECK(all.files[0].rows == 1);
  CHECK(all.files[1].name == "steppers/m.csv");
  CHECK(all.files[1].sha256 == "585d87a25baf55b7a628e0799f73c839441d5b5d494f2226f372653ef3aaab4b");
  CHECK(all.files[1].rows == 1);  // M1 is replaced
  CHECK(all.files[1].layer == 0);
  CHECK(all.files[2].name == "steppers.csv");
  CHECK(all.files[2].sha256 == "f6fbeebcaa65a00b88289fda918c127738ddf93871e437aba4fd5b7c4c8020dd");
  CHECK(all.files[2].layer == 1);
  REQUIRE(all.layers.size() == 2);
  // cd lower; sha256sum belts/x.csv steppers/m.csv | sha256sum
  CHECK(all.layers[0].sha256 == "d9a0ff060e19768ce22efb18d69bac55bd8d4b11018d221b6332de02d0d3e713");
  CHECK(all.layers[0].files == 2);
  CHECK(all.layers[0].rows == 2);
  CHECK(all.layers[1].sha256 == "2b1619936b2f5909168622710e47203426f4f46ab1403e02aebb49e021cb7428");
}

TEST_CASE("files that only say something of parts are in the inventory, not among those that hold them") {
  const TemporaryFolder lower, upper;
  lower.write("steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,10,USD\n");
  upper.write("stock.csv", "part_number,owned\nM1,2\n");
  upper.write("suppliers.csv", "supplier,shipping_fee,currency\nShop A,5,USD\nShop B,6,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({lower.path(), upper.path()}, diagnostics);
  const Inventory all = inventory(catalogue);
  REQUIRE(all.layers.size() == 2);
  CHECK(all.layers[0].remarks.empty());
  CHECK(all.layers[1].files == 0);
  REQUIRE(all.layers[1].remarks.size() == 2);
  CHECK(all.layers[1].remarks[0].name == "stock.csv");
  CHECK(all.layers[1].remarks[0].lines == 1);
  // printf 'part_number,owned\nM1,2\n' | sha256sum
  CHECK(all.layers[1].remarks[0].sha256 == "17e1f8afd539df4a0393edde6f6d1b0708665ee22489076399f1e403103625cc");
  CHECK(all.layers[1].remarks[1].name == "suppliers.csv");
  CHECK(all.layers[1].remarks[1].lines == 2);
}

TEST_CASE("figures of a part: prices, numbers and words, but nothing that only says where they come from") {
  const TemporaryFolder folder;
  folder.write("steppers/m.csv",
               "manufacturer,part_number,frame,step_angle [deg],holding_torque [N.cm],torque_basis,rated_current "
               "[A],price,currency,price_basis,source,confidence,note\n"
               "Acme,M1,NEMA17,1.8,126,datasheet,2,10,USD,shop 2026,here,high,careful\n");
  folder.write("stepper_curves/c.csv",
               "manufacturer,part_number,drive_voltage [V],phase_current [A],speed [rpm],torque [N.m]\n"
               "Acme,M1,24,2,300,0.5\nAcme,M1,24,2,60,1\nAcme,M1,48,2,60,1.1\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  REQUIRE(diagnostics.count() == 0);
  const auto told = [](const Table& table, const std::vector<int>& rows) {
    std::vector<std::string> lines;
    for (const NamedFigure& figure : figures_of(table, rows)) lines.push_back(figure.name + " = " + figure.value);
    return lines;
  };
  const Table& table = catalogue.table(Family::steppers);
  CHECK(told(table, rows_of_part(table, "Acme", "M1", "Acme M1")) ==
        std::vector<std::string>{"price = 10 USD",
                                 "currency = USD",
                                 "frame = NEMA17",
                                 "step_angle = 1.8 deg",
                                 "holding_torque = 1.26 N.m",
                                 "rated_current = 2 A"});
  const Table& points = catalogue.table(Family::stepper_curves);
  CHECK(told(points, rows_of_part(points, "Acme", "M1", "Acme M1 (24 V, 2 A)")) ==
        std::vector<std::string>{"torque at 60 rpm = 1 N.m", "torque at 300 rpm = 0.5 N.m"});
  CHECK(rows_of_part(points, "Acme", "M1", "Acme M1 (36 V, 2 A)").empty());
}

TEST_CASE("figures that say the same") {
  CHECK(same_figure("1.26 N.m", "1.26 N.m"));
  CHECK(same_figure("1.26 N.m", "1.2600000000002 N.m"));
  CHECK_FALSE(same_figure("1.26 N.m", "1.2600000002 N.m"));
  CHECK_FALSE(same_figure("9 USD", "9 EUR"));
  CHECK_FALSE(same_figure("NEMA17", "NEMA23"));
  CHECK(same_figure("8", "8.0"));
  CHECK(relative_note("10 USD", "12.5 USD") == " (+25.0 %)");
  CHECK(relative_note("10 USD", "12.5 EUR").empty());
  CHECK(relative_note("yes", "no").empty());
  CHECK(relative_note("0 USD", "1 USD").empty());
}

}  // namespace inventory_test
