// SPDX-License-Identifier: Apache-2.0
// Torque curves of one motor that were measured with several drivers or step modes, at the same voltage and current.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "evaluation/drive_tables.h"
#include "evaluation/machines.h"
#include "evaluation/price_book.h"
#include "evaluation/tiny_catalogue.h"

namespace motor_curves_test {

using namespace millwright;
using Points = std::vector<std::pair<double, double>>;  ///< r/min, N.m

namespace {

const char* const header =
    "manufacturer,part_number,drive_voltage [V],phase_current [A],current_kind,driver,step_mode,speed [rpm],torque "
    "[N.m],currency,price_basis,evidence,source,confidence\n";

std::string rows(const std::string& kind, const std::string& driver, const std::string& mode, const Points& points) {
  std::string out;
  for (const auto& [speed, torque] : points)
    out +=
        fmt::format("tiny,M23L,24,4,{},{},{},{},{},USD,test,computed,test,high\n", kind, driver, mode, speed, torque);
  return out;
}

double on_line(const Points& points, double speed) {
  if (speed <= points.front().first) return points.front().second;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [s, t] = points[i - 1];
    const auto& [to, u] = points[i];
    if (speed <= to) return t + (speed - s) / (to - s) * (u - t);
  }
  return points.back().second;
}

/// What the curve of M23L lets it do at these speeds [r/min], with an overlay of curves; empty without a curve.
std::vector<double> torques(const std::string& overlay, const std::vector<double>& speeds) {
  static const TinyCatalogue tiny;
  const TemporaryFolder folder;
  folder.write("stepper_curves/own.csv", header + overlay);
  const catalogue::Catalogue parts = catalogue_of({tiny.path(), folder.path()});
  const machine::Problem problem = shipped_problem("sander");
  machine::Axis axis = problem.axes.front();
  axis.motor = {};
  const evaluation::PriceBook prices(problem, parts);
  std::vector<double> found;
  for (const auto& pair : motor_table(parts, axis, {24.0}, prices).pairs) {
    const auto* const curve = pair.curve_at(0);
    if (curve == nullptr || parts.table(catalogue::Family::steppers).part_number(pair.motor) != "M23L") continue;
    found.clear();
    for (const double speed : speeds) found.push_back((*curve)(speed * std::acos(-1.0) / 30.0));
  }
  return found;
}

}  // namespace

TEST_CASE(
    "Of curves of one motor with several drivers the least counts at every speed, not the line through all points") {
  const Points weak{{0, 2.0}, {1500, 0.2}}, flat{{100, 1.4}, {450, 1.4}}, other{{0, 1.9}, {600, 1.5}, {1200, 0.3}};
  const std::vector<double> speeds{0, 60, 100, 300, 449, 450, 451, 600, 800, 1000, 1200, 1400, 1500, 2000};
  const auto expect = [&](const std::string& overlay, const std::vector<Points>& measured) {
    const std::vector<double> found = torques(overlay, speeds);
    REQUIRE(found.size() == speeds.size());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      double least = 1e9;
      for (const Points& points : measured) least = std::min(least, on_line(points, speeds[i]));
      CAPTURE(speeds[i]);
      CHECK(found[i] == Approx(least).epsilon(1e-9));
    }
  };
  expect(rows("phase", "D1", "half", weak), {weak});
  expect(rows("phase", "D1", "half", weak) + rows("phase", "D2", "half", flat), {weak, flat});
  // Two drivers, and a step mode besides; two share a speed.
  expect(rows("phase", "D2", "half", other) + rows("phase", "D1", "half", weak) + rows("phase", "D2", "full", flat),
         {weak, flat, other});
  // What states the kind of its current in some rows only is one curve all the same.
  expect(rows("phase", "D1", "half", {{0, 2.0}}) + rows("", "D1", "half", {{1500, 0.2}}), {weak});
  // A single point is no curve, nor is it one of another driver's.
  expect(rows("phase", "D1", "half", weak) + rows("phase", "D3", "half", {{700, 0.01}}), {weak});
  CHECK(
      torques(rows("phase", "D3", "half", {{700, 0.01}}) + rows("phase", "D4", "half", {{900, 0.01}}), speeds).empty());
}

}  // namespace motor_curves_test
