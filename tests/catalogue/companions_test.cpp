// SPDX-License-Identifier: Apache-2.0
// What a file says about single figures: their own source, confidence and tolerance.
#include "catalogue/companions.h"

#include <cmath>

#include "catalogue/listing.h"
#include "catalogue/read_table.h"
#include "catch.h"

namespace companions_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

struct Outcome {
  Table table{Family::steppers};
  std::vector<text::Diagnostic> diagnostics;
};

/// One motor with a rotor inertia of 280 g.cm2 and these further columns.
Outcome read(const std::string& columns, const std::string& cells) {
  text::Diagnostics diagnostics;
  const std::string text =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.cm],rated_current [A],rotor_inertia "
      "[g.cm2],inertia_basis,price,currency,source,confidence," +
      columns + "\nAcme,M1,1.8,126,2.8,280,family_estimate +-25 %,24.5,USD,shop,low," + cells + "\n";
  Outcome outcome;
  outcome.table = read_table(text::SourceText::from_string("x.csv", text), Family::steppers, 0, diagnostics);
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

constexpr Column inertia = column(Family::steppers, "rotor_inertia");
constexpr Column torque = column(Family::steppers, "holding_torque");

double half_width(const std::string& columns, const std::string& cells) {
  const Outcome outcome = read(columns, cells);
  REQUIRE(outcome.diagnostics.empty());
  return outcome.table.half_width(0, inertia);
}

void expect_error(const std::string& columns,
                  const std::string& cells,
                  int line,
                  const std::string& message,
                  const std::string& hint) {
  const Outcome outcome = read(columns, cells);
  REQUIRE(outcome.diagnostics.size() == 1);
  const text::Diagnostic& only = outcome.diagnostics.front();
  INFO(text::format(only));
  CHECK(only.severity == text::Severity::error);
  CHECK(only.where.line == line);
  CHECK(only.message.find(message) != std::string::npos);
  CHECK(only.hint.find(hint) != std::string::npos);
}

}  // namespace

TEST_CASE("a tolerance is a share of the figure or a width in its unit") {
  constexpr double unit = 1e-7;                                   // g.cm2 in kg.m2
  CHECK(half_width("x_mine", "1") == Approx(0.25 * 280 * unit));  // of the basis
  CHECK(half_width("rotor_inertia_tolerance", "8 %") == Approx(0.08 * 280 * unit));
  CHECK(half_width("rotor_inertia_tolerance", "+-8%") == Approx(0.08 * 280 * unit));
  CHECK(half_width("rotor_inertia_tolerance", "0.08") == Approx(0.08 * 280 * unit));
  CHECK(half_width("rotor_inertia_tolerance", "20 g.cm2") == Approx(20 * unit));
  CHECK(half_width("rotor_inertia_tolerance [%]", "8") == Approx(0.08 * 280 * unit));
  CHECK(half_width("rotor_inertia_tolerance [kg.cm2]", "0.02") == Approx(20 * unit));
  CHECK(half_width("rotor_inertia_tolerance", "") == Approx(0.25 * 280 * unit));
}

TEST_CASE("the figure's own source and confidence count before those of the row") {
  const Outcome outcome = read("rotor_inertia_source,rotor_inertia_confidence,holding_torque_confidence",
                               "measured by pendulum,high,medium");
  REQUIRE(outcome.diagnostics.empty());
  const Table& table = outcome.table;
  CHECK(table.standing(0, inertia) == Standing::published);
  CHECK_FALSE(table.is_estimate(0, inertia));
  CHECK(std::isnan(table.tolerance(0, inertia)));  // that of the basis was the estimate's
  CHECK(table.figure_source(0, inertia) == "measured by pendulum");
  CHECK_FALSE(table.is_estimate(0, torque));  // of the row: low
  CHECK(table.is_estimate(0, column(Family::steppers, "rated_current")));
  const PartSheet sheet = show(table, 0);
  const auto figure = std::find_if(
      sheet.figures.begin(), sheet.figures.end(), [](const Figure& each) { return each.column == "rotor_inertia"; });
  REQUIRE(figure != sheet.figures.end());
  CHECK(figure->basis == "measured by pendulum");
  CHECK(figure->confidence == "high");
}

TEST_CASE("companions that belong to nothing are errors") {
  expect_error("rotor_inertai_tolerance", "8 %", 1, "no figure 'rotor_inertai'", "rotor_inertia");
  expect_error("mass_source", "catalogue", 1, "without the column 'mass'", "mass [kg]");
  expect_error("frame_source", "catalogue", 1, "no figure 'frame'", "");
  expect_error("step_angle_tolerance", "5 %", 1, "takes no tolerance", "counts");
  expect_error("price_tolerance", "5 %", 1, "takes no tolerance", "prices");
  expect_error("rotor_inertia_tolerance [mm]", "5", 1, "rotor_inertia_tolerance", "[%]");
}

TEST_CASE("cells that are no tolerance are errors at the cell") {
  expect_error("rotor_inertia_tolerance", "wide", 2, "is no tolerance", "25 %");
  expect_error("rotor_inertia_tolerance", "-5 %", 2, "is no tolerance", "25 %");
  expect_error("rotor_inertia_tolerance", "25", 2, "as large as the figure", "25 %");
  expect_error("rotor_inertia_tolerance", "3 mm", 2, "tolerance '3 mm'", "25 %");
  expect_error("rotor_inertia_tolerance [%]", "5 %", 2, "has a unit", "plain number");
}

TEST_CASE("the confidence of a figure is high, medium or low too") {
  expect_error("rotor_inertia_confidence", "hgih", 2, "rotor_inertia_confidence: 'hgih' is no confidence", "'high'");
  const Outcome outcome = read("rotor_inertia_confidence", "Low");
  REQUIRE(outcome.diagnostics.empty());
  CHECK(outcome.table.figure_confidence(0, inertia) == "low");
}

TEST_CASE("tables keep what companions say when rows are dropped and added") {
  text::Diagnostics diagnostics;
  const std::string head =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current "
      "[A],price,currency,source,confidence";
  const auto table = [&](const std::string& text) {
    return read_table(text::SourceText::from_string("x.csv", text), Family::steppers, 0, diagnostics);
  };
  Table below = table(head + ",holding_torque_tolerance\nA,1,1.8,1,2,3,USD,s,high,10 %\nA,2,1.8,2,2,3,USD,s,high,\n");
  below.overlay(table(head + "\nA,3,1.8,4,2,3,USD,s,high\n"));
  below.overlay(table(head + ",holding_torque_tolerance\nA,4,1.8,8,2,3,USD,s,high,0.5 N.m\n"));
  REQUIRE(diagnostics.all().empty());
  REQUIRE(below.rows() == 4);
  CHECK(below.half_width(0, torque) == Approx(0.1));
  CHECK(std::isnan(below.half_width(1, torque)));
  CHECK(std::isnan(below.half_width(2, torque)));
  CHECK(below.half_width(3, torque) == Approx(0.5));
  below.keep_only({false, true, true, true});
  CHECK(std::isnan(below.half_width(0, torque)));
  CHECK(below.half_width(2, torque) == Approx(0.5));
}

}  // namespace companions_test
