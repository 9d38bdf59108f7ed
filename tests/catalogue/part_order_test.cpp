// SPDX-License-Identifier: Apache-2.0
// The order of a table's parts, which does not hang on where they stand.

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "catalogue/catalogue.h"
#include "catch.h"
#include "table_of.h"
#include "temporary_folder.h"

namespace part_order_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string curves =
    "manufacturer,part_number,drive_voltage [V],phase_current [A],driver,speed [rpm],torque [N.m],confidence\n";

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency,supplier\n";

std::vector<int> order_of(const Table& table) {
  const std::span<const int> rows = table.rows_in_order();
  return {rows.begin(), rows.end()};
}

/// All that is said of each of its parts, in order.
std::vector<std::string> in_order(const Table& table) {
  std::vector<std::string> result;
  for (const int row : table.rows_in_order()) {
    result.push_back(fmt::format("{}", static_cast<int>(table.ownership(row))));
    for (std::size_t index = 0; index < column_count(table.family()); ++index) {
      const Column column{table.family(), static_cast<std::uint8_t>(index)};
      result.back() += declaration(column).kind == Kind::text ? fmt::format(" {}", table.text(column, row))
                                                              : fmt::format(" {}", table.number(column, row));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("Parts are ordered by maker, then number, then by what else is said of them") {
  const Table table = table_of(Family::stepper_curves,
                               curves +
                                   "Best,M1,24,2,d,60,1,high\n"       // 0
                                   "Acme,M10,24,2,d,60,1,high\n"      // 1
                                   "Acme,M4,24,2,d,120,0.9,high\n"    // 2
                                   "Acme,M4,24,2,d,60,0.5,high\n"     // 3
                                   "Acme,M4,12,2,d,240,0.5,high\n");  // 4
  CHECK(order_of(table) == std::vector<int>{1, 4, 3, 2, 0});
  CHECK(order_of(Table(Family::stepper_curves)).empty());
}

TEST_CASE("What is not known comes last") {
  Table table = table_of(Family::steppers, motors + "Acme,M1,1.8,1,2,,USD,\n");
  table.append(table_of(Family::steppers, motors + "Acme,M1,1.8,1,2,10,USD,\n"));
  CHECK(order_of(table) == std::vector<int>{1, 0});
}

TEST_CASE("The order is that of the table as it is now") {
  Table table = table_of(Family::steppers, motors + "Acme,M2,1.8,1,2,5,USD,\nAcme,M3,1.8,1,2,5,USD,\n");
  CHECK(order_of(table) == std::vector<int>{0, 1});
  table.append(table_of(Family::steppers, motors + "Acme,M1,1.8,1,2,5,USD,\nAcme,M3,1.8,1,2,4,USD,\n"));
  CHECK(order_of(table) == std::vector<int>{2, 0, 3, 1});
  Table dearer = table;
  dearer.set_number(3, column(Family::steppers, "price"), 6.0);
  CHECK(order_of(dearer) == std::vector<int>{2, 0, 1, 3});
  CHECK(order_of(table) == std::vector<int>{2, 0, 3, 1});
  table.keep_only({true, false, true, false});
  CHECK(order_of(table) == std::vector<int>{1, 0});
}

TEST_CASE("What differs in nothing keeps its order") {
  const std::string row = "Acme,M1,24,2,d,60,1,high\n";
  Table table = table_of(Family::stepper_curves, curves + row);
  table.append(table_of(Family::stepper_curves, curves + row));
  CHECK(order_of(table) == std::vector<int>{0, 1});
}

TEST_CASE("No order of rows, files or offers changes the order of the parts") {
  std::mt19937 random(11);
  std::vector<std::string> parts, offers;
  for (int i = 0; i < 12; ++i) {
    const std::string name = fmt::format("{},M{}", i % 3 == 0 ? "Acme" : "Best", i);
    parts.push_back(fmt::format("{},1.8,{},2,{},USD,{}\n", name, 1 + i % 2, 10 + i % 4, i % 4 == 0 ? "Shop A" : ""));
    if (i % 2 == 0) offers.push_back(fmt::format("{},Shop B,{},USD\n", name, 9 + i % 3));
    if (i % 5 == 0) offers.push_back(fmt::format("{},Shop C,{},USD\n", name, 8 + i % 2));
  }
  std::vector<std::string> expected;
  for (int round = 0; round < 50; ++round) {
    std::shuffle(parts.begin(), parts.end(), random);
    std::shuffle(offers.begin(), offers.end(), random);
    const auto half = static_cast<std::ptrdiff_t>(1 + random() % (parts.size() - 1));
    const TemporaryFolder folder;
    folder.write("steppers/a.csv", fmt::format("{}{}", motors, fmt::join(parts.begin(), parts.begin() + half, "")));
    folder.write("steppers/b.csv", fmt::format("{}{}", motors, fmt::join(parts.begin() + half, parts.end(), "")));
    folder.write("suppliers.csv", "supplier,shipping_fee,currency\nShop A,5,USD\nShop B,6,USD\nShop C,7,USD\n");
    folder.write("offers.csv",
                 fmt::format("manufacturer,part_number,supplier,price,currency\n{}", fmt::join(offers, "")));
    text::Diagnostics diagnostics;
    const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
    INFO(text::format(diagnostics));
    REQUIRE_FALSE(diagnostics.has_errors());
    const std::vector<std::string> found = in_order(catalogue.with_offers().table(Family::steppers));
    REQUIRE(found.size() == parts.size() + offers.size());
    if (expected.empty()) expected = found;
    CHECK(found == expected);
  }
}

}  // namespace part_order_test
