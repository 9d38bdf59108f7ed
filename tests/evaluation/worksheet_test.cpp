// SPDX-License-Identifier: Apache-2.0
// The calculation behind every check of a design, and what is drawn of its drives.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "catch.h"
#include "evaluation/drive_drawing.h"
#include "evaluation/hand_worked.h"
#include "evaluation/machines.h"
#include "evaluation/synthesis.h"
#include "machine/bill_of_materials.h"
#include "scalar/expression.h"
#include "scalar/unit.h"
#include "shipped_machines.h"
#include "text/source_text.h"

namespace worksheet_test {

using namespace millwright;
using evaluation::Check;
using evaluation::Design;
using evaluation::ElementWorksheet;
using evaluation::MotionPoint;

namespace {

/// The bill of materials that is shipped with a machine, as designed.
Design shipped_build(const std::string& name) {
  const std::string folder = std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/";
  machine::Problem problem = shipped_problem(name);
  std::vector<std::filesystem::path> places{std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues"};
  for (const std::string& overlay : problem.catalogues) places.emplace_back(folder + overlay);
  const catalogue::Catalogue catalogue = catalogue_of(places);
  text::Diagnostics diagnostics;
  const auto text = text::SourceText::load(folder + name + "-bom.csv", diagnostics);
  const auto bom = machine::read_bill_of_materials(text, problem, diagnostics);
  REQUIRE(bom);
  evaluation::SearchOptions how;
  how.worksheets = true;
  const evaluation::BomCheck outcome = evaluation::check(problem, catalogue, *bom, false, how);
  REQUIRE(outcome.problems.empty());
  return outcome.design;
}

/// Bit by bit; what is not a number is so on both sides.
bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

/// The lines that lead to the limit of a check of the first drive.
std::string limit_text(const Design& design, const std::string& id) {
  for (const ElementWorksheet& sheet : design.worksheet->elements)
    for (const evaluation::CheckSides& sides : sheet.checks)
      if (sides.id == id) {
        std::string text;
        for (const scalar::DerivationLine& line : scalar::derivation(sides.capacity, "limit"))
          text += scalar::to_string(line) + "\n";
        return text;
      }
  FAIL("no check " << id);
  return {};
}

void collect_symbols(const scalar::ExpressionPointer& expression,
                     std::set<const scalar::Expression*>& seen,
                     std::set<std::string>& symbols) {
  if (expression == nullptr || !seen.insert(expression.get()).second) return;
  if (expression->kind == scalar::Expression::Kind::leaf) symbols.insert(expression->symbol);
  for (const scalar::ExpressionPointer& operand : expression->operands) collect_symbols(operand, seen, symbols);
}

MotionPoint at(const std::vector<MotionPoint>& points, double time) {
  for (const MotionPoint& point : points)
    if (std::abs(point.time - time) < 1e-12) return point;
  FAIL("no point at " << time << " s");
  return {};
}

machine::MotionData motion(machine::Move move, double inclination = 0.0) {
  machine::MotionData data;
  data.moves = {std::move(move)};
  data.inclination = inclination;
  return data;
}

}  // namespace

// The checks were computed on double; the worksheet computes on numbers that remember their formulas, from the figures
// of the catalogues on. Both must end at the same bits, or the sheet would explain something else.
TEST_CASE("Both sides of every check of the shipped machines are recomputed, bit by bit") {
  std::set<std::string> elements;
  for (const char* name : millwright::shipped_machines) {
    const Design design = shipped_build(name);
    REQUIRE(design.worksheet != nullptr);
    std::size_t explained = 0;
    for (const ElementWorksheet& sheet : design.worksheet->elements) {
      std::vector<const Check*> checks;
      for (const Check& check : design.checks)
        if (check.axis == sheet.axis && check.element == sheet.element) checks.push_back(&check);
      INFO(name << " " << sheet.axis << " " << sheet.element);
      REQUIRE(checks.size() == sheet.checks.size());
      for (std::size_t i = 0; i < checks.size(); ++i) {
        INFO(checks[i]->id);
        CHECK(checks[i]->id == sheet.checks[i].id);
        std::string reason;
        const auto unit = scalar::Unit::parse(checks[i]->unit, reason);
        const auto shown = [&](double si) { return unit ? unit->from_si(si) : si; };
        CHECK(same(shown(sheet.checks[i].demand.value), checks[i]->value));
        CHECK(same(shown(sheet.checks[i].capacity.value), checks[i]->limit));
        ++explained;
      }
      elements.insert(sheet.element);
    }
    CHECK(explained == design.checks.size());
  }
  CHECK(elements.count("drive") + elements.count("guide") + elements.count("supply") + elements.count("whole") == 4);
}

// 200 kHz have the dimension of an angular speed, but 200 000 rad/s would be 31.8 kHz.
TEST_CASE("Pulse rates are counted in hertz on the sheets") {
  const Design design = shipped_build("lifter");
  for (const char* id : {"C-ST-STEPRATE", "C-SYS-SPEED"}) {
    const std::string limit = limit_text(design, id);
    INFO(limit);
    CHECK(limit.find("200 kHz") != std::string::npos);
    CHECK(limit.find("200000") == std::string::npos);
  }
}

TEST_CASE("Every figure with a symbol is given on its sheet or derived there") {
  std::set<std::string> read_off;
  for (const char* name : millwright::shipped_machines)
    for (const Design design = shipped_build(name); const ElementWorksheet& sheet : design.worksheet->elements) {
      std::set<std::string> given, used;
      for (const evaluation::GivenFigure& figure : sheet.given) given.insert(figure.symbol);
      std::set<const scalar::Expression*> seen;
      for (const evaluation::CheckSides& sides : sheet.checks) {
        collect_symbols(sides.demand.expression(), seen, used);
        collect_symbols(sides.capacity.expression(), seen, used);
      }
      for (const evaluation::DerivedFigure& figure : sheet.derived)
        collect_symbols(figure.value.expression(), seen, used);
      for (const std::string& symbol : used) {
        INFO(name << " " << sheet.axis << " " << sheet.element << ": " << symbol);
        CHECK(given.count(symbol) == 1);
        if (symbol.starts_with("T_po")) read_off.insert(symbol);
      }
    }
  CHECK(read_off.count("T_po,1") == 1);
}

TEST_CASE("A brake that holds more than the motor's magnets is named as what sets the limit") {
  const Design design = shipped_build("lifter");  // 2 N.m over the default 1.5
  for (const Check& check : design.checks)
    if (check.id == "C-ST-BACK") CHECK(check.requirement == "brake_factor");
  CHECK(limit_text(design, "C-ST-BACK").find("2 N·m / 1.5") != std::string::npos);
}

TEST_CASE("The cut's force and feed, and the power that the supply is asked for, are derived") {
  const machine::Problem problem = shipped_problem("router");
  const Design design = shipped_build("router");
  std::map<std::string, double> derived;
  for (const ElementWorksheet& sheet : design.worksheet->elements)
    for (const evaluation::DerivedFigure& figure : sheet.derived)
      derived[sheet.axis + " " + figure.move + " " + figure.symbol] = figure.value.value;
  std::size_t cuts = 0;
  std::vector<std::pair<std::string, double>> powers;
  for (const machine::Axis& axis : problem.axes) {
    for (const machine::Move& move : axis.moves) {
      if (!move.cutting) continue;
      ++cuts;
      CHECK(same(derived[axis.name + " " + move.name + " F_c"], move.force));
      CHECK(same(derived[axis.name + " " + move.name + " v_f"], move.speed.value()));
    }
    powers.insert(
        powers.end(), static_cast<std::size_t>(axis.mechanism.drives), {axis.name, derived[axis.name + "  P_in"]});
  }
  CHECK(cuts > 0);
  std::vector<std::pair<std::string, double>> given;
  for (const ElementWorksheet& sheet : design.worksheet->elements)
    for (const evaluation::GivenFigure& figure : sheet.given)
      if (!figure.axis.empty()) given.emplace_back(figure.axis, figure.value);
  std::sort(powers.begin(), powers.end());
  std::sort(given.begin(), given.end());
  CHECK(given == powers);
}

TEST_CASE("A design has no worksheet unless it is asked for") {
  const evaluation::MachineModel model(problem_of_text(hand_worked::axis_text("horizontal", "", "")),
                                       hand_worked::parts());
  CHECK(hand_worked::design_of(model, {}).worksheet == nullptr);
}

// 57 and 42.3 mm, of the makers' NEMA 23 and NEMA 17 motors.
TEST_CASE("Motors are drawn with the flanges that the catalogue states") {
  const auto sizes_are = [](const Design& design, std::size_t drives, double size) {
    REQUIRE(design.worksheet != nullptr);
    REQUIRE(design.worksheet->drives.size() == drives);
    for (const auto& drive : design.worksheet->drives) CHECK(drive.motor_size == Approx(size));
  };
  sizes_are(shipped_build("lifter"), 1, 0.057);
  sizes_are(shipped_build("sander"), 3, 0.0423);
}

// 300 mm in 2 s with ramps of 0.5 s: 300/(2 - 0.5) = 200 mm/s; 50 mm in each ramp, 200 mm between them in 1 s.
TEST_CASE("A trapezoid is drawn with its dwell") {
  machine::Move move;
  move.distance = 0.3;
  move.time = 2.0;
  move.dwell = 3.0;
  const auto points = evaluation::motion_over_time(motion(move), 0.5);
  CHECK(at(points, 0.0).speed == 0.0);
  CHECK(at(points, 0.25).speed == Approx(0.1));
  CHECK(at(points, 0.25).position == Approx(0.0125));
  CHECK(at(points, 0.5).speed == Approx(0.2));
  CHECK(at(points, 0.5).position == Approx(0.05));
  CHECK(at(points, 1.5).position == Approx(0.25));
  CHECK(at(points, 2.0).speed == Approx(0.0).margin(1e-15));
  CHECK(at(points, 2.0).position == Approx(0.3));
  CHECK(points.back().time == Approx(5.0));
  CHECK(points.back().position == Approx(0.3));
  CHECK(evaluation::motion_over_time(motion(move), 0.5, 1.0).back().time == Approx(3.0));
}

TEST_CASE("Against gravity a move goes up and down again") {
  machine::Move move;
  move.distance = 0.1;
  move.speed = 0.1;
  const auto points = evaluation::motion_over_time(motion(move, std::acos(0.0)), 0.2);
  // 0.1 m at 0.1 m/s with ramps of 0.2 s: 1.2 s each way.
  CHECK(at(points, 1.2).position == Approx(0.1));
  CHECK(points.back().time == Approx(2.4));
  CHECK(points.back().position == Approx(0.0).margin(1e-12));
  const auto lowest = std::min_element(
      points.begin(), points.end(), [](const MotionPoint& a, const MotionPoint& b) { return a.speed < b.speed; });
  CHECK(lowest->speed == Approx(-0.1));
}

// Ramps of 1 s to 0.1 m/s with 0.5 m/s^3: sqrt(1 - 4 * 0.1/0.5) = 0.4472 s are even, 0.2764 s on either side change.
// The ramp is point symmetric: half the speed in the middle, and the way of an even ramp, 0.05 m.
TEST_CASE("A jerk-limited ramp is round") {
  machine::Move move;
  move.distance = 0.3;
  move.speed = 0.1;
  move.jerk = 0.5;
  const auto points = evaluation::motion_over_time(motion(move), 1.0);
  CHECK(at(points, 0.5).speed == Approx(0.05));
  CHECK(at(points, 1.0).speed == Approx(0.1));
  CHECK(at(points, 1.0).position == Approx(0.05).epsilon(1e-3));
  CHECK(at(points, 0.25).speed == Approx(0.5 * 0.5 * 0.25 * 0.25));  // half the jerk times the time squared
  CHECK(points.back().position == Approx(0.3).epsilon(1e-3));
  CHECK(points.back().time == Approx(4.0));
}

}  // namespace worksheet_test
