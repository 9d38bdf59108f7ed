// SPDX-License-Identifier: Apache-2.0
//
// Torques of sets of motors over any range of speed, from standstill to beyond what the axis can ask for, and the
// tables that they are read from.
#include "evaluation/motor_set.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "catch.h"
#include "evaluation/machines.h"

namespace motor_set_test {

using namespace millwright;
using evaluation::MotorSet;
using scalar::Interval;
using solver::Row;

TEST_CASE("Torques of sets of motors contain those of each motor at every speed") {
  const machine::Problem problem = shipped_problem("sander");
  const catalogue::Catalogue& catalogue = shipped_catalogue();
  const evaluation::PriceBook prices(problem, catalogue);
  const std::vector<double> voltages{24.0, 48.0};
  const machine::Axis& axis = problem.axes.front();
  const MotorSet set(motor_table(catalogue, axis, voltages, prices).pairs, axis.require, 2, {5.0, 20.0, 80.0, 300.0});
  const auto motors = static_cast<Row>(set.pairs().size());
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::size_t outside = 0, loose = 0;
  for (int n = 0; n < 400; ++n) {
    std::vector<Row> rows;
    const std::size_t wanted = 2 + random() % 60;
    for (std::size_t i = 0; i < wanted; ++i) rows.push_back(static_cast<Row>(random() % motors));
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    const std::size_t voltage = random() % 2;
    // From nothing, within one range or several, beyond the last edge, and beyond what is tabled beyond it.
    const double from = random() % 3 == 0 ? 0.0 : uniform(0.0, 400.0);
    const Interval speed(from, random() % 4 == 0 ? uniform(from, 3000.0) : uniform(from, from + 50.0));
    std::vector<Interval> readings(evaluation::total_count);
    set.read(voltage, rows, readings);
    const Interval torque = set.torque<Interval>({rows, readings}, voltage, speed);
    const Interval unread = set.torque<Interval>(rows, voltage, speed);
    double most = 0.0;
    for (const Row row : rows) {
      const auto torque_at = [&](double at) {
        return evaluation::available_torque<double>(set.pairs()[row], voltage, at);
      };
      for (const double part : {0.0, 0.3, 1.0}) {
        const double at =
            torque_at(std::clamp(speed.lower + part * (speed.upper - speed.lower), speed.lower, speed.upper));
        outside += torque.lower <= at && at <= torque.upper ? 0 : 1;
        most = std::max(most, at);
      }
      most = std::max(most, torque_at(0.2 * speed.lower));
    }
    CHECK(unread.lower == torque.lower);
    CHECK(unread.upper == torque.upper);
    loose += torque.upper > 1.001 * most ? 1 : 0;  // at a fifth of the least speed some motor has as much
  }
  CHECK(outside == 0);
  // From standstill on is one range: all of it is asked of the table, whatever the part of it.
  std::vector<Row> many(20);
  std::iota(many.begin(), many.end(), Row{0});
  const Interval slowest = set.torque<Interval>(many, 0, Interval(0.0, 4.9));
  const Interval slower = set.torque<Interval>(many, 0, Interval(0.5, 1.0));
  CHECK(slower.lower == slowest.lower);
  CHECK(slower.upper == slowest.upper);
  CHECK(loose < 40);
}

TEST_CASE("The torque table holds of every motor what it does in each range, and hardly more") {
  const machine::Problem problem = shipped_problem("sander");
  const catalogue::Catalogue& catalogue = shipped_catalogue();
  const evaluation::PriceBook prices(problem, catalogue);
  const std::vector<double> voltages{24.0, 48.0};
  machine::Axis axis = problem.axes.front();
  axis.motor.currents = {0.7, 1.0, 2.8};  // motors with several currents of their own, drivers that give less
  const auto pairs = motor_table(catalogue, axis, voltages, prices).pairs;
  const std::vector<double> edges{0.0, 5.0, 20.0, 80.0, 300.0, 1200.0};  // with what the table adds at both ends
  const evaluation::TorqueTable table(pairs, voltages.size(), {5.0, 20.0, 80.0, 300.0});
  REQUIRE(table.ranges() + 1 == edges.size());
  CHECK(table.covers(Interval(0.0, 1200.0)));
  CHECK(!table.covers(Interval(300.0, 1200.1)));
  std::size_t outside = 0, loose = 0, governed = 0, kept_together = 0;
  for (Row row = 0; row < pairs.size(); ++row) {
    for (std::size_t v = 0; v < voltages.size(); ++v) {
      std::vector<Interval> read;
      table.read(std::span(&row, 1), v, read);
      REQUIRE(read.size() == table.ranges());
      governed += pairs[row].curve_at(v) != nullptr ? 1 : 0;
      for (std::size_t r = 0; r < table.ranges(); ++r) {
        const double slow = evaluation::available_torque<double>(pairs[row], v, edges[r]);
        const double fast = evaluation::available_torque<double>(pairs[row], v, edges[r + 1]);
        const double middle = evaluation::available_torque<double>(pairs[row], v, 0.5 * (edges[r] + edges[r + 1]));
        outside += read[r].lower <= fast && middle <= read[r].upper && read[r].lower <= middle && slow <= read[r].upper
                       ? 0
                       : 1;
        const double room = 1e-6 * (std::abs(slow) + std::abs(fast));
        if (pairs[row].curve_at(v) == nullptr) loose += read[r].lower < fast - room || read[r].upper > slow + room;
        const Interval hull = table.hull(std::span(&row, 1), v, r);
        CHECK((hull.lower == read[r].lower && hull.upper == read[r].upper));
      }
    }
  }
  CHECK(outside == 0);
  CHECK(loose == 0);
  CHECK(governed > 0);
  // Neighbours are kept together exactly where motor and current are the same.
  for (Row row = 1; row < pairs.size(); ++row) {
    const auto current = [&](Row of) {
      return std::min(pairs[of].figures_at(0).driver_peak_current, pairs[of].figures_at(0).asked_current);
    };
    const std::vector<Row> both{row - 1, row};
    int visited = 0;
    table.visit_unlike(both, [&](Row) { ++visited; });
    const bool same = pairs[row].motor == pairs[row - 1].motor && current(row) == current(row - 1);
    CHECK(visited == (same ? 1 : 2));
    kept_together += same ? 1 : 0;
  }
  CHECK(kept_together > 10);
}

TEST_CASE("Tables of candidates keep readings and totals of every row through all changes") {
  evaluation::SlotTable table("slot", 2);
  const auto add = [&](double price, double riding, double standing, double a, double b) {
    evaluation::CandidateDraft candidate;
    candidate.price = price;
    candidate.mass = riding + standing;
    candidate.riding_mass = riding;
    candidate.standing_mass = standing;
    table.add(std::move(candidate), std::vector<double>{a, b});
  };
  add(10.0, 1.0, 2.0, 0.1, 0.2);
  add(20.0, 3.0, 4.0, 0.3, 0.4);
  add(30.0, 5.0, 6.0, 0.5, 0.6);
  table.multiply(2.0);
  table.add_to_price(2, 0.5);
  table.filter([](std::size_t row) { return row != 1; });
  REQUIRE(table.rows() == 2);
  using enum evaluation::Total;
  const std::vector<std::vector<double>> expected{{0.1, 0.2, 20.0, 6.0, 2.0, 4.0, 6.0},
                                                  {0.5, 0.6, 60.5, 22.0, 10.0, 12.0, 22.0}};
  for (std::size_t row = 0; row < 2; ++row) {
    CHECK(std::vector<double>(table.numbers(row), table.numbers(row) + table.width()) == expected[row]);
    CHECK(table.reading(row, 1) == expected[row][1]);
    CHECK(table.total(row, price) == expected[row][2]);
    CHECK(table.total(row, mass) == expected[row][3]);
    CHECK(table.total(row, riding_mass) == expected[row][4]);
    CHECK(table.total(row, standing_mass) == expected[row][5]);
    CHECK(table.total(row, burden) == expected[row][6]);
    CHECK(table.candidate(row).price == expected[row][2]);
  }
}

TEST_CASE("Tables of candidates keep what few of them have, and the words that others gave them") {
  evaluation::SlotTable table("slot", 0);
  {
    const std::string slot = "a slot with a name that is too long to stand in a string itself",
                      stated = "by the problem";
    for (int row = 0; row < 6; ++row) {
      evaluation::CandidateDraft candidate;
      for (int part = 0; part < row % 3; ++part) {
        evaluation::PartUse use;
        use.slot = slot;
        use.row = 10 * row + part;
        use.price = use.mass = row;
        if (row == 4) use.stated = stated;
        candidate.parts.push_back(use);
      }
      if (row == 2) candidate.form = "form";
      if (row == 4) candidate.settings = {{"current", 2.0, "A"}};
      if (row == 4) candidate.ranges = evaluation::candidate_ranges({}, 1.0, {1.0, 2.0}, scalar::Interval(3.0));
      table.add(std::move(candidate), {});
    }
  }
  CHECK(table.candidate(5).parts.size() == 2);
  table.cover(4, {1, 2});
  CHECK(table.covered_by(4).size() == 2);
  CHECK(table.covered_by(3).empty());
  CHECK(table.covered_by(5).empty());
  table.multiply(3.0);
  table.filter([](std::size_t row) { return row >= 2 && row != 3; });
  const evaluation::SlotTable copy = std::exchange(table, evaluation::SlotTable());
  REQUIRE(copy.rows() == 3);
  CHECK(copy.has_ranges());
  const std::size_t parts[] = {2, 1, 2}, rows[] = {2, 4, 5};
  for (std::size_t row = 0; row < 3; ++row) {
    INFO(row);
    const evaluation::Candidate candidate = copy.candidate(row);
    REQUIRE(candidate.parts.size() == parts[row]);
    for (std::size_t part = 0; part < parts[row]; ++part) {
      const evaluation::PartUse& use = candidate.parts[part];
      CHECK(use.slot == "a slot with a name that is too long to stand in a string itself");
      CHECK(use.row == static_cast<int>(10 * rows[row] + part));
      CHECK(use.stated == (rows[row] == 4 ? "by the problem" : ""));
      CHECK(use.quantity == 3.0);
      CHECK(use.price == 3.0 * static_cast<double>(rows[row]));
    }
    CHECK(candidate.form == (rows[row] == 2 ? "form" : ""));
    CHECK(candidate.settings.size() == (rows[row] == 4 ? 1U : 0U));
    const scalar::Interval riding = copy.range(row, evaluation::Total::riding_mass);
    CHECK(riding.lower == Approx(rows[row] == 4 ? 3.0 : 0.0));
    CHECK(riding.upper == Approx(rows[row] == 4 ? 6.0 : 0.0));
  }
}

}  // namespace motor_set_test
