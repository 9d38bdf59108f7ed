// SPDX-License-Identifier: Apache-2.0
// Bad catalogue files of every kind: what is said, where, and what is advised.
#include "catalogue/read_table.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "catalogue/catalogue.h"
#include "catch.h"
#include "temporary_folder.h"

namespace read_table_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

struct Outcome {
  Table table{Family::steppers};
  std::vector<text::Diagnostic> diagnostics;
  bool has_errors = false;
};

Outcome read(Family family, const std::string& contents) {
  text::Diagnostics diagnostics;
  Outcome outcome;
  outcome.table = read_table(text::SourceText::from_string("x.csv", contents), family, 0, diagnostics);
  drop_duplicates(outcome.table, diagnostics);
  outcome.diagnostics = diagnostics.all();
  outcome.has_errors = diagnostics.has_errors();
  return outcome;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// Checks that exactly one diagnostic of that severity says `message` at line:column with that `hint`.
void expect_one(const Outcome& outcome,
                text::Severity severity,
                int line,
                int column_number,
                const std::string& message,
                const std::string& hint) {
  int found = 0;
  for (const text::Diagnostic& each : outcome.diagnostics) {
    INFO(text::format(each));
    if (each.severity != severity) continue;
    ++found;
    CHECK(each.where.line == line);
    CHECK(each.where.column == column_number);
    CHECK(contains(each.message, message));
    CHECK(contains(each.hint, hint));
  }
  CHECK(found == 1);
}

const std::string header =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.cm],rated_current "
    "[A],price,currency,source,confidence\n";
constexpr auto error = text::Severity::error;
constexpr auto warning = text::Severity::warning;

}  // namespace

TEST_CASE("a sound file is read in SI") {
  const Outcome outcome = read(Family::steppers, "# a comment\n" + header + "Acme,M1,1.8,126,2.8,24.5,USD,shop,high\n");
  REQUIRE(outcome.diagnostics.empty());
  REQUIRE(outcome.table.rows() == 1);
  constexpr Column torque = column(Family::steppers, "holding_torque");
  CHECK(outcome.table.number(torque, 0) == Approx(1.26).epsilon(1e-14));
  CHECK(outcome.table.number("step_angle", 0) == Approx(1.8 * 3.14159265358979323846 / 180).epsilon(1e-14));
  CHECK(std::isnan(outcome.table.number("rotor_inertia", 0)));
  CHECK(outcome.table.text("frame", 0).empty());
  CHECK(outcome.table.price(0).piece == 24.5);
  CHECK(std::isnan(outcome.table.price(0).length));
  CHECK(outcome.table.price(0).currency == "USD");
  CHECK(outcome.table.where(0).line == 3);
  CHECK(outcome.table.where(0, torque).column == 13);
  CHECK(outcome.table.where(0, torque).length == 3);
}

TEST_CASE("letter O in a number is shown at the cell") {
  const Outcome outcome = read(Family::steppers, header + "Acme,M1,1.8,1O5,2.8,24.5,USD,shop,high\n");
  expect_one(outcome, error, 2, 13, "1O5", "105");
  CHECK(outcome.table.empty());
}

TEST_CASE("a header without unit is refused") {
  const Outcome outcome =
      read(Family::steppers,
           "manufacturer,part_number,step_angle [deg],holding_torque,rated_current [A],price,currency\n"
           "Acme,M1,1.8,1,2,3,USD\n");
  expect_one(outcome, error, 1, 43, "no unit", "holding_torque [N.m]");
  CHECK(outcome.table.empty());
}

TEST_CASE("an unknown unit and a wrong dimension are refused at the unit") {
  expect_one(read(Family::steppers,
                  "manufacturer,part_number,step_angle [deg],holding_torque [N.cmm],rated_current [A],price,currency\n"
                  "Acme,M1,1.8,1,2,3,USD\n"),
             error,
             1,
             59,
             "unknown unit 'cmm'",
             "holding_torque [N.m]");
  expect_one(read(Family::steppers,
                  "manufacturer,part_number,step_angle [deg],holding_torque [N/cm],rated_current [A],price,currency\n"
                  "Acme,M1,1.8,1,2,3,USD\n"),
             error,
             1,
             59,
             "does not fit",
             "holding_torque [N.m]");
}

TEST_CASE("a speed in hertz is not a speed in rpm") {
  const Outcome outcome = read(Family::stepper_curves,
                               "manufacturer,part_number,drive_voltage [V],phase_current [A],speed [Hz],torque [N.m]\n"
                               "Acme,M1,24,2,5,1\n");
  expect_one(outcome, error, 1, 69, "does not fit", "speed [rpm]");
}

TEST_CASE("an unknown column is a warning with the nearest known one") {
  const Outcome outcome =
      read(Family::steppers,
           "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency,"
           "rotor_inertai [g.cm2]\nAcme,M1,1.8,1,2,3,USD,20\n");
  expect_one(outcome, warning, 1, 97, "rotor_inertai", "rotor_inertia");
  CHECK(outcome.table.rows() == 1);
}

TEST_CASE("a missing required column, price or currency is an error at the header") {
  expect_one(read(Family::steppers,
                  "manufacturer,part_number,step_angle [deg],rated_current [A],price,currency\nA,M,1.8,2,3,USD\n"),
             error,
             1,
             1,
             "holding_torque",
             "holding_torque [N.m]");
  expect_one(read(Family::belts,
                  "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension "
                  "[N],price,currency\nA,M,GT2,2,6,30,3,USD\n"),
             error,
             1,
             1,
             "price_per_length",
             "price_per_length [1/m]");
}

TEST_CASE("a missing value in a required column is shown where it should stand") {
  expect_one(read(Family::steppers, header + "Acme,M1,1.8,,2.8,24.5,USD,shop,high\n"),
             error,
             2,
             13,
             "holding_torque is missing",
             "");
  expect_one(read(Family::steppers, header + ",M1,1.8,1,2.8,24.5,USD,shop,high\n"),
             error,
             2,
             1,
             "manufacturer is missing",
             "generic");
  expect_one(read(Family::steppers, header + "Acme,M1,1.8,1,2.8,24.5,,shop,high\n"), error, 2, 24, "currency", "USD");
}

TEST_CASE("an unknown price is a warning, a free part is none") {
  expect_one(read(Family::steppers, header + "Acme,M1,1.8,1,2.8,,USD,shop,high\n"),
             warning,
             2,
             19,
             "price is not known",
             "0 if you own it");
  const Outcome owned = read(Family::steppers, header + "Acme,M1,1.8,1,2.8,0,USD,shop,high\n");
  CHECK(owned.diagnostics.empty());
  CHECK(owned.table.price(0).piece == 0.0);
}

TEST_CASE("negative and zero figures that cannot be are refused") {
  expect_one(read(Family::steppers, header + "Acme,M1,1.8,1,-2.8,5,USD,shop,high\n"),
             error,
             2,
             15,
             "rated_current is negative",
             "");
  expect_one(
      read(Family::steppers, header + "Acme,M1,1.8,1,2.8,-5,USD,shop,high\n"), error, 2, 19, "price is negative", "");
  expect_one(
      read(Family::steppers, header + "Acme,M1,0,1,2.8,5,USD,shop,high\n"), error, 2, 9, "step_angle is zero", "");
}

TEST_CASE("a duplicate part names both places") {
  const Outcome outcome = read(
      Family::steppers,
      header + "Acme,M1,1.8,100,2,10,USD,x,high\nBest,M1,1.8,100,2,10,USD,x,high\nAcme,M1,1.8,99,2,10,USD,x,high\n");
  expect_one(outcome, error, 4, 6, "duplicate part 'M1' of 'Acme'", "overlay");
  REQUIRE(outcome.diagnostics.front().related);
  CHECK(outcome.diagnostics.front().related->line == 2);
  CHECK(outcome.table.rows() == 2);
}

TEST_CASE("points of a torque curve are distinguished by their speed") {
  const std::string curve =
      "manufacturer,part_number,drive_voltage [V],phase_current [A],driver,speed [rpm],torque [N.m]\n";
  CHECK(read(Family::stepper_curves, curve + "A,M,24,2,d,60,1\nA,M,24,2,d,120,0.9\n").diagnostics.empty());
  expect_one(read(Family::stepper_curves, curve + "A,M,24,2,d,60,1\nA,M,24,2,d,60,0.9\n"),
             error,
             3,
             3,
             "duplicate point",
             "driver");
  CHECK(read(Family::stepper_curves, curve + "A,M,24,2,d,60,1\nA,M,24,2,e,60,0.9\n").diagnostics.empty());
}

TEST_CASE("a flag is yes or no") {
  const std::string belt_free =
      "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque [N.m],price,currency,backlash_free\n";
  const Outcome outcome =
      read(Family::couplings,
           belt_free + "A,C1,5,8,1,2,USD,yes\nA,C2,5,8,1,2,USD,0\nA,C3,5,8,1,2,USD,\nA,C4,5,8,1,2,USD,maybe\n");
  expect_one(outcome, error, 5, 18, "'maybe'", "yes or no");
  constexpr Column free = column(Family::couplings, "backlash_free");
  REQUIRE(outcome.table.rows() == 3);
  CHECK(outcome.table.flag(free, 0) == true);
  CHECK(outcome.table.flag(free, 1) == false);
  CHECK_FALSE(outcome.table.flag(free, 2).has_value());
}

TEST_CASE("a confidence is high, medium or low, in whatever case, and nothing else") {
  const Outcome outcome = read(Family::steppers,
                               header +
                                   "Acme,M1,1.8,100,2,10,USD,s,HIGH\nAcme,M2,1.8,100,2,10,USD,s,Low\n"
                                   "Acme,M3,1.8,100,2,10,USD,s,mediun\nAcme,M4,1.8,100,2,10,USD,s,\n"
                                   "Acme,M5,1.8,100,2,10,USD,s,so so\n");
  REQUIRE(outcome.diagnostics.size() == 2);
  CHECK(outcome.diagnostics[0].where.line == 4);
  CHECK(outcome.diagnostics[0].where.column == 28);
  CHECK(outcome.diagnostics[0].message == "confidence: 'mediun' is no confidence");
  CHECK(outcome.diagnostics[0].hint.find("did you mean 'medium'?") == 0);
  CHECK(outcome.diagnostics[1].where.line == 6);
  CHECK(outcome.diagnostics[1].hint.find("write high, medium or low") == 0);
  REQUIRE(outcome.table.rows() == 3);
  CHECK(outcome.table.confidence(0) == "high");
  CHECK(outcome.table.confidence(1) == "low");
  CHECK(outcome.table.confidence(2).empty());
}

TEST_CASE("nothing at all, a header alone and noise are errors") {
  CHECK(read(Family::steppers, "").has_errors);
  CHECK(read(Family::steppers, "# only a comment\n").has_errors);
  expect_one(read(Family::steppers, header), error, 1, 1, "empty", "");
  std::mt19937 random(20260101);
  for (int round = 0; round < 200; ++round) {
    std::string noise(1 + random() % 3000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    CHECK(read(static_cast<Family>(random() % family_count), noise).has_errors);
  }
}

TEST_CASE("everything wrong is reported at once, and good rows remain") {
  const Outcome outcome = read(Family::steppers,
                               header +
                                   "Acme,M1,1.8,x,2,10,USD,s,high\nAcme,M2,1.8,1,-2,10,USD,s,high\nAcme,M3,1.8,1,2,10,"
                                   "USD,s,high\nAcme,,1.8,1,2,10,US,s,high\n");
  CHECK(outcome.diagnostics.size() == 4);
  REQUIRE(outcome.table.rows() == 1);
  CHECK(outcome.table.part_number(0) == "M3");
}

TEST_CASE("texts with quotes and separators survive, and places hold after them") {
  const Outcome outcome = read(Family::steppers,
                               header +
                                   "\"Acme, Inc.\",\"M\"\"1\"\"\",1.8,100,2,10,USD,\"says \"\"so\"\", twice\",high\n"
                                   "\"B \"\"x\"\"\",M2,1.8,100,2,10,USD,s,high\n");
  REQUIRE(outcome.diagnostics.empty());
  REQUIRE(outcome.table.rows() == 2);
  CHECK(outcome.table.manufacturer(0) == "Acme, Inc.");
  CHECK(outcome.table.part_number(0) == "M\"1\"");
  CHECK(outcome.table.text("source", 0) == "says \"so\", twice");
  CHECK(outcome.table.manufacturer(1) == "B \"x\"");
  CHECK(outcome.table.where(0, column(Family::steppers, "holding_torque")).column == 27);
  CHECK(outcome.table.where(1, column(Family::steppers, "holding_torque")).column == 18);
}

TEST_CASE("spreadsheet exports with semicolons and decimal commas are understood") {
  const Outcome outcome = read(
      Family::steppers,
      "\xEF\xBB\xBFmanufacturer;part_number;step_angle [deg];holding_torque [N.cm];rated_current [A];price;currency\r\n"
      "Acme;M1;1,8;100,5;2;10,25;EUR\r\n");
  REQUIRE(outcome.diagnostics.empty());
  CHECK(outcome.table.number("holding_torque", 0) == Approx(1.005).epsilon(1e-14));
  CHECK(outcome.table.price(0).piece == 10.25);
  CHECK(outcome.table.where(0, column(Family::steppers, "price")).column == 21);
}

TEST_CASE("a gigabyte of binary noise as a catalogue is refused") {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  std::string noise(1U << 20U, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  const auto file = folder.write("steppers/noise.csv", noise);
  std::filesystem::resize_file(file, 1ULL << 30U);
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  CHECK(diagnostics.error_count() == 1);
  CHECK(catalogue.rows() == 0);
}

TEST_CASE("columns that no file has cost memory once, and one of them that is set stays the only one") {
  Outcome outcome = read(Family::steppers, header + "Acme,M1,1.8,100,2,10,USD,x,high\nAcme,M2,1.8,90,2,9,USD,x,high\n");
  REQUIRE(outcome.diagnostics.empty());
  Table& table = outcome.table;
  constexpr Column mass = column(Family::steppers, "mass"), inertia = column(Family::steppers, "rotor_inertia");
  CHECK(table.numbers(mass).data() == table.numbers(inertia).data());
  REQUIRE(table.numbers(mass).size() == 2);
  CHECK(std::isnan(table.number(mass, 1)));
  table.set_number(1, mass, 0.5);
  CHECK(table.number(mass, 1) == 0.5);
  CHECK(std::isnan(table.number(mass, 0)));
  CHECK(std::isnan(table.number(inertia, 1)));
  table.keep_only({false, true});
  CHECK(table.number(mass, 0) == 0.5);
  REQUIRE(table.numbers(inertia).size() == 1);
  table.append(read(Family::steppers, header + "Acme,M3,1.8,80,2,8,USD,x,high\n").table);
  REQUIRE(table.numbers(mass).size() == 2);
  CHECK(std::isnan(table.number(mass, 1)));
  REQUIRE(table.numbers(inertia).size() == 2);
}

TEST_CASE("rows beyond the first thousands are read, judged and placed like the first") {
  // 10,000 rows, of which each thousandth is wrong: in turn no number, a negative one, no part number, a bad
  // confidence. The maker is the same up to row 6000.
  std::string contents = header;
  const std::string wrong[] = {"Acme,W,1.8,1O0,2,10,USD,x,high",
                               "Acme,W,1.8,100,-2,10,USD,x,high",
                               "Acme,,1.8,100,2,10,USD,x,high",
                               "Acme,W,1.8,100,2,10,USD,x,sure"};
  const int columns[] = {12, 16, 6, 27};
  for (int row = 0; row < 10000; ++row)
    contents += row % 1000 == 999 ? wrong[row / 1000 % 4] + "\n"
                                  : (row < 6000 ? "Acme" : "Other") + (",M" + std::to_string(row)) + ",1.8," +
                                        std::to_string(row + 1) + ",2,10,USD,\"a \"\"b\"\"\"," +
                                        (row == 7000 ? "Low" : "high") + "\n";
  const Outcome outcome = read(Family::steppers, contents);
  REQUIRE(outcome.diagnostics.size() == 10);
  for (int i = 0; i < 10; ++i) {
    CHECK(outcome.diagnostics[static_cast<std::size_t>(i)].where.line == 1000 * (i + 1) + 1);
    CHECK(outcome.diagnostics[static_cast<std::size_t>(i)].where.column == columns[i % 4]);
  }
  const Table& table = outcome.table;
  REQUIRE(table.rows() == 9990);
  for (const int row : {0, 4094, 4095, 4096, 5998, 6000, 6993, 8200, 9998}) {
    const int kept = row - row / 1000;
    CHECK(table.part_number(kept) == "M" + std::to_string(row));
    CHECK(table.manufacturer(kept) == (row < 6000 ? "Acme" : "Other"));
    CHECK(table.text("currency", kept) == "USD");
    CHECK(table.text("source", kept) == "a \"b\"");
    CHECK(table.text("confidence", kept) == "high");
    CHECK(table.number("holding_torque", kept) == Approx(0.01 * (row + 1)));
    CHECK(table.where(kept).line == row + 2);
  }
  CHECK(table.text("confidence", 7000 - 7) == "low");
}

TEST_CASE("a text that is the same in all rows stays that of its rows whatever becomes of the table") {
  const auto table_of = [](const std::string& maker, int from, int rows) {
    std::string contents = header;
    for (int row = from; row < from + rows; ++row)
      contents += maker + ",M" + std::to_string(row) + ",1.8,100,2,10,USD,from " + maker + ",high\n";
    return read(Family::steppers, contents).table;
  };
  const auto makers = [](const Table& table) {
    std::string all;
    for (int row = 0; row < table.rows(); ++row)
      all += fmt::format("{}{}|", table.part_number(row), table.text("source", row));
    return all;
  };
  Table table = table_of("A", 0, 3);
  table.keep_only({true, false, true});
  CHECK(makers(table) == "M0from A|M2from A|");
  table.append(table_of("B", 5, 2));
  CHECK(makers(table) == "M0from A|M2from A|M5from B|M6from B|");
  table.append(Table(Family::steppers));
  Table upper = table_of("A", 2, 1);
  upper.append(table_of("C", 7, 1));
  table.overlay(std::move(upper));
  CHECK(makers(table) == "M0from A|M5from B|M6from B|M2from A|M7from C|");
  table.keep_only({false, false, false, true, false});
  CHECK(makers(table) == "M2from A|");
  Table one = table_of("D", 1, 2);
  one.append(Table(Family::steppers));
  CHECK(makers(one) == "M1from D|M2from D|");
  one.keep_only({false, false});
  one.append(table_of("E", 3, 2));
  CHECK(makers(one) == "M3from E|M4from E|");
  one.append_offers({{0, 8.0, std::nan(""), std::nan(""), "Shop", "EUR", "shop", "", false, {}}});
  CHECK(makers(one) == "M3from E|M4from E|M3from E|");
  CHECK(one.text("currency", 0) == "USD");
  CHECK(one.text("currency", 2) == "EUR");
  CHECK(one.text("supplier", 1).empty());
}

TEST_CASE("a table asked for a column it does not have says so") {
  const Table table(Family::steppers);
  CHECK_THROWS_AS(table.numbers(column(Family::belts, "pitch")), std::logic_error);
  CHECK_THROWS_AS(table.numbers(column(Family::steppers, "frame")), std::logic_error);
  CHECK_THROWS_AS(column(Family::steppers, "holding_torqe"), std::logic_error);
}

}  // namespace read_table_test
