// SPDX-License-Identifier: Apache-2.0
// What changed between two catalogues. Expected values are read off the rows by hand.
#include "catalogue/difference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "catch.h"
#include "temporary_folder.h"

namespace difference_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],mass "
    "[kg],price,currency,source\n";
const std::string curves =
    "manufacturer,part_number,drive_voltage [V],phase_current [A],driver,speed [rpm],torque [N.m],confidence\n";
const std::string curve = "A,M,24,2,d,60,1,high\nA,M,24,2,d,120,0.9,high\nA,M,24,2,d,240,0.5,high\n";

Catalogue load(const TemporaryFolder& folder) {
  text::Diagnostics diagnostics;
  Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE_FALSE(diagnostics.has_errors());
  return catalogue;
}

/// Both sides and what differs, of one family.
struct Sides {
  Sides(Family family, const std::string& file, const std::string& a_text, const std::string& b_text) {
    const TemporaryFolder a_folder, b_folder;
    a_folder.write(file, a_text);
    b_folder.write(file, b_text);
    a = load(a_folder);
    b = load(b_folder);
    found = difference(a.table(family), b.table(family));
  }
  Catalogue a, b;
  FamilyDifference found{Family::steppers, {}, {}, {}, 0};
};

Sides of_motors(const std::string& a, const std::string& b) {
  return {Family::steppers, "steppers/m.csv", motors + a, motors + b};
}

Sides of_curves(const std::string& a, const std::string& b) {
  return {Family::stepper_curves, "stepper_curves/c.csv", curves + a, curves + b};
}

std::string told(const CellChange& cell) {
  return changed_column(cell) + (cell.point.empty() ? "" : " at " + cell.point) + ": " + cell.a + " -> " + cell.b;
}

std::vector<std::string> told(const std::vector<CellChange>& cells) {
  std::vector<std::string> lines;
  for (const CellChange& cell : cells) lines.push_back(told(cell));
  return lines;
}

}  // namespace

TEST_CASE("other units, other order of rows and columns and other files are no difference") {
  const TemporaryFolder a, b;
  a.write("steppers/m.csv", motors + "Acme,M1,1.8,1.26,2,0.3,10,USD,here\nAcme,M2,0.9,0.4,1.5,0.0625,7,USD,there\n");
  a.write("stepper_curves/c.csv", curves + curve);
  b.write("steppers/second.csv",
          "price;currency;part_number;manufacturer;holding_torque [N.cm];step_angle [rad];rated_current [mA];mass "
          "[g];source\n7;USD;M2;Acme;40;0.015707963267948967;1500;62.5;there\n");
  b.write("steppers/first.csv",
          "source,mass [g],manufacturer,part_number,step_angle [deg],holding_torque [N.cm],rated_current "
          "[A],price,currency\nhere,300,Acme,M1,1.8,126,2,10,USD\n");
  b.write("stepper_curves/c.csv",
          "confidence,manufacturer,part_number,drive_voltage [mV],phase_current [mA],driver,speed [rev/s],torque "
          "[N.cm]\nhigh,A,M,24000,2000,d,4,50\nhigh,A,M,24000,2000,d,1,100\nhigh,A,M,24000,2000,d,2,90\n");
  const Catalogue in_a = load(a), in_b = load(b);
  const auto changes = difference(in_a, in_b);
  REQUIRE(changes.size() == 2);
  for (const FamilyDifference& family : changes) {
    INFO(declaration(family.family).name);
    for (const PartChange& part : family.changed)
      for (const CellChange& cell : part.cells) UNSCOPED_INFO(told(cell));
    CHECK(family.equal());
  }
  CHECK(changes[0].same == 2);
  CHECK(changes[1].same == 1);
  CHECK(difference(in_a, in_b, Family::stepper_curves).size() == 1);
}

TEST_CASE("each changed cell is told in the column's unit, with both places") {
  const Sides sides =
      of_motors("Acme,M0,1.8,1,2,0.3,1,USD,here\nAcme,M1,1.8,1.26,2,,10,USD,here\nAcme,M2,1.8,1,2,0.2,5,USD,here\n",
                "Acme,M2,1.8,1,2,0.2,5,EUR,here\nAcme,M1,1.8,1.2,2,0.3,12.5,USD,\"there, "
                "now\"\nAcme,M0,1.8,1,2,0.3,1,USD,here\n");
  CHECK(sides.found.added.empty());
  CHECK(sides.found.removed.empty());
  CHECK(sides.found.same == 1);
  REQUIRE(sides.found.changed.size() == 2);
  const PartChange& m1 = sides.found.changed[0];
  CHECK(sides.a.table(Family::steppers).part_number(m1.a_row) == "M1");
  CHECK(sides.b.table(Family::steppers).part_number(m1.b_row) == "M1");
  // In the order of the columns: those of every family first.
  CHECK(told(m1.cells) == std::vector<std::string>{"price: 10 USD -> 12.5 USD",
                                                   "source: here -> there, now",
                                                   "holding_torque: 1.26 N.m -> 1.2 N.m",
                                                   "mass:  -> 0.3 kg"});
  CHECK(m1.cells[0].relative == Approx(0.25));
  CHECK(std::isnan(m1.cells[1].relative));
  CHECK(m1.cells[2].relative == Approx(-0.06 / 1.26));
  CHECK(std::isnan(m1.cells[3].relative));
  CHECK(m1.cells[0].a_where.line == 3);
  CHECK(m1.cells[0].a_where.column == 21);
  CHECK(m1.cells[0].b_where.line == 3);
  CHECK(m1.cells[0].b_where.column == 23);
  // Another currency: both prices are told nowhere but in it, and 5 USD against 5 EUR is no relative change.
  CHECK(told(sides.found.changed[1].cells) == std::vector<std::string>{"currency: USD -> EUR"});
}

TEST_CASE("of a price in another currency no relative change is told") {
  const Sides sides = of_motors("Acme,M1,1.8,1,2,0.3,10,USD,s\n", "Acme,M1,1.8,1,2,0.3,9,EUR,s\n");
  REQUIRE(sides.found.changed.size() == 1);
  CHECK(told(sides.found.changed[0].cells) ==
        std::vector<std::string>{"price: 10 USD -> 9 EUR", "currency: USD -> EUR"});
  CHECK(std::isnan(sides.found.changed[0].cells[0].relative));
}

TEST_CASE("values within 1e-12 are the same, and beyond it they are told with the digits that differ") {
  CHECK(same_value(1.0, 1.0 + 5e-13));
  CHECK_FALSE(same_value(1.0, 1.0 + 5e-12));
  CHECK(same_value(0.0, 0.0));
  CHECK_FALSE(same_value(0.0, 1e-300));
  CHECK(same_value(std::nan(""), std::nan("")));
  CHECK_FALSE(same_value(std::nan(""), 0.0));
  const Sides sides = of_motors("A,M1,1.8,1.0000000000001,2,1,1,USD,s\nA,M2,1.8,1.000000000001,2,1,10000000,USD,s\n",
                                "A,M1,1.8,1,2,1,1,USD,s\nA,M2,1.8,1,2,1,10000000.000001,USD,s\n");
  CHECK(sides.found.same == 1);  // 1e-13 off
  REQUIRE(sides.found.changed.size() == 1);
  REQUIRE(sides.found.changed[0].cells.size() == 1);  // 1e-12 off is on the limit; 1e-13 off is the same
  CHECK(declaration(sides.found.changed[0].cells[0].column).name == "holding_torque");
  CHECK(sides.found.changed[0].cells[0].a != sides.found.changed[0].cells[0].b);
}

TEST_CASE("parts that came and went ascend by name whatever the order of rows") {
  const Sides sides = of_motors("B,M9,1.8,1,2,1,1,USD,s\nA,M2,1.8,1,2,1,1,USD,s\nA,M1,1.8,1,2,1,1,USD,s\n",
                                "C,M1,1.8,1,2,1,1,USD,s\nA,M2,1.8,1,2,1,1,USD,s\nA,M3,1.8,1,2,1,1,USD,s\n");
  const auto names = [](const Table& table, const std::vector<int>& rows) {
    std::vector<std::string> list;
    for (const int row : rows) list.push_back(part_title(table, row));
    return list;
  };
  CHECK(names(sides.b.table(Family::steppers), sides.found.added) == std::vector<std::string>{"A M3", "C M1"});
  CHECK(names(sides.a.table(Family::steppers), sides.found.removed) == std::vector<std::string>{"A M1", "B M9"});
  CHECK(sides.found.same == 1);
}

TEST_CASE("a family that one side lacks came or went as a whole") {
  const TemporaryFolder a, b;
  a.write("steppers/m.csv", motors + "Acme,M1,1.8,1,2,1,1,USD,s\n");
  a.write("stepper_curves/c.csv", curves + curve);
  b.write("steppers/m.csv", motors + "Acme,M1,1.8,1,2,1,1,USD,s\n");
  const Catalogue in_a = load(a), in_b = load(b);
  const auto there = difference(in_a, in_b), back = difference(in_b, in_a);
  REQUIRE(there.size() == 2);
  REQUIRE(back.size() == 2);
  CHECK(there[0].equal());
  CHECK(there[1].removed.size() == 1);  // one curve, three rows
  CHECK(there[1].added.empty());
  CHECK(back[1].added.size() == 1);
  CHECK(back[1].removed.empty());
}

TEST_CASE("a torque curve is one part: its points are told, and another voltage is another curve") {
  const Sides sides = of_curves(curve + "A,M,48,2,d,60,1.5,high\n",
                                "A,M,24,2,d,60,1,high\nA,M,24,2,d,120,0.72,high\nA,M,24,2,d,300,0.4,high\n"
                                "A,M,36,2,d,60,1.5,high\n");
  REQUIRE(sides.found.changed.size() == 1);
  const PartChange& part = sides.found.changed[0];
  CHECK(part.a_points == 3);
  CHECK(part.b_points == 3);
  CHECK(told(part.cells) == std::vector<std::string>{"torque at 120 rpm: 0.9 N.m -> 0.72 N.m",
                                                     "torque at 240 rpm: 0.5 N.m -> ",
                                                     "torque at 300 rpm:  -> 0.4 N.m"});
  CHECK(part.cells[0].relative == Approx(-0.2));
  CHECK(part.cells[1].a_where.line == 4);
  CHECK_FALSE(part.cells[1].b_where.text);
  REQUIRE(sides.found.added.size() == 1);
  CHECK(part_title(sides.b.table(Family::stepper_curves), sides.found.added[0]) == "A M (36 V, 2 A, d)");
  REQUIRE(sides.found.removed.size() == 1);
  CHECK(part_title(sides.a.table(Family::stepper_curves), sides.found.removed[0]) == "A M (48 V, 2 A, d)");
}

TEST_CASE("points that went are told each, also where as many stayed") {
  const Sides sides =
      of_curves("A,M,24,2,d,60,0.5,high\nA,M,24,2,d,120,0.5,high\nA,M,24,2,d,300,0.4,high\nA,M,24,2,d,600,0.3,high\n",
                "A,M,24,2,d,300,0.4,high\nA,M,24,2,d,600,0.3,high\n");
  REQUIRE(sides.found.changed.size() == 1);
  CHECK(told(sides.found.changed[0].cells) ==
        std::vector<std::string>{"torque at 60 rpm: 0.5 N.m -> ", "torque at 120 rpm: 0.5 N.m -> "});
}

TEST_CASE("what changed alike at every point of a curve is told once") {
  std::string low = curve;
  for (std::size_t at = 0; (at = low.find("high")) != std::string::npos;) low.replace(at, 4, "low");
  low.replace(low.find(",0.9,"), 5, ",0.8,");
  const Sides sides = of_curves(curve, low);
  REQUIRE(sides.found.changed.size() == 1);
  CHECK(told(sides.found.changed[0].cells) ==
        std::vector<std::string>{"confidence: high -> low", "torque at 120 rpm: 0.9 N.m -> 0.8 N.m"});
}

TEST_CASE("random catalogues: the same parts came, went and changed as by looking every name up") {
  std::mt19937 random(20261122);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 20; ++round) {
    std::map<std::string, std::string> a, b;  // name: price
    for (auto* side : {&a, &b})
      for (int i = 0; i < 60; ++i)
        (*side)[std::string(1, static_cast<char>('A' + pick(3))) + ",M" + std::to_string(pick(30))] =
            std::to_string(1 + pick(3));
    const auto text = [&](const std::map<std::string, std::string>& side) {
      std::vector<std::string> rows;
      for (const auto& [name, price] : side) rows.push_back(name + ",1.8,1,2,1," + price + ",USD,s\n");
      std::shuffle(rows.begin(), rows.end(), random);
      std::string all;
      for (const std::string& row : rows) all += row;
      return all;
    };
    const Sides sides = of_motors(text(a), text(b));
    std::size_t added = 0, removed = 0, changed = 0;
    for (const auto& [name, price] : b) added += a.count(name) == 0 ? 1 : 0;
    for (const auto& [name, price] : a) {
      if (b.count(name) == 0)
        ++removed;
      else
        changed += b.at(name) != price ? 1 : 0;
    }
    CHECK(sides.found.added.size() == added);
    CHECK(sides.found.removed.size() == removed);
    CHECK(sides.found.changed.size() == changed);
    CHECK(static_cast<std::size_t>(sides.found.same) == a.size() - removed - changed);
  }
}

TEST_CASE("what is said of a figure alone is a change of the figure's provenance") {
  const std::string head =
      "manufacturer,part_number,mass [kg],mass_source,mass_confidence,mass_tolerance,holding_torque [N.m],step_angle "
      "[deg],rated_current [A],price,"
      "currency\n";
  const auto sides = [&](const std::string& a, const std::string& b) {
    return Sides(Family::steppers,
                 "steppers/m.csv",
                 head + "Acme,M1," + a + ",1.2,1.8,2,9,USD\n",
                 head + "Acme,M1," + b + ",1.2,1.8,2,9,USD\n");
  };
  const Sides changed = sides("0.5,list,low,10 %", "0.5,scales,high,0.01 kg");  // 0.01 of 0.5: 2 %
  REQUIRE(changed.found.changed.size() == 1);
  CHECK(told(changed.found.changed.front().cells) == std::vector<std::string>{"mass_source: list -> scales",
                                                                              "mass_confidence: low -> high",
                                                                              "mass_tolerance: 10 % -> 2 %"});
  // Each stands at its own cell: "Acme,M1,0.5,list,low,10 %".
  const auto& cells = changed.found.changed.front().cells;
  CHECK(cells[0].a_where.column == 13);
  CHECK(cells[1].a_where.column == 18);
  CHECK(cells[1].b_where.column == 20);  // scales is longer than list
  CHECK(cells[2].a_where.column == 22);
  const Sides gone = sides("0.5,list,low,10 %", "0.6,,,");
  REQUIRE(gone.found.changed.size() == 1);
  CHECK(told(gone.found.changed.front().cells) ==
        std::vector<std::string>{
            "mass: 0.5 kg -> 0.6 kg", "mass_source: list -> ", "mass_confidence: low -> ", "mass_tolerance: 10 % -> "});
  CHECK(sides("0.5,list,low,10 %", "0.5,list,low,0.1").found.equal());
  CHECK(sides("0.5,list,low,10 %", "0.5,list,low,0.05 kg").found.equal());
}

}  // namespace difference_test
