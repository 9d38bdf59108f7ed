// SPDX-License-Identifier: Apache-2.0
//
// Torques of sets of motors over any range of speed, from standstill to beyond what the axis can ask for.
#include "evaluation/motor_set.h"

#include <algorithm>
#include <numeric>
#include <random>

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
  const MotorSet set(motor_table(catalogue, axis, voltages, prices), axis.require, 2, {5.0, 20.0, 80.0, 300.0});
  const auto motors = static_cast<Row>(set.motors().pairs.size());
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
        return evaluation::available_torque<double>(set.motors().pairs[row], voltage, at);
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

}  // namespace motor_set_test
