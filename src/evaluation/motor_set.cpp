// SPDX-License-Identifier: Apache-2.0
#include "evaluation/motor_set.h"

#include <optional>

namespace millwright::evaluation {

using machine::Requirement;
using scalar::Interval;

MotorSet::MotorSet(std::vector<MotorPair> pairs,
                   const machine::Requirements& require,
                   std::size_t voltages,
                   std::vector<double> speeds)
    : pairs_(std::move(pairs)), require_(require), numbers_(voltages), torques_(pairs_, voltages, std::move(speeds)) {
  for (std::size_t v = 0; v < voltages; ++v) {
    std::vector<double>& numbers = numbers_[v];
    numbers.reserve(pairs_.size() * width);
    for (const MotorPair& pair : pairs_) {
      const double margin = require(pair.is_modelled(v) ? require.margin_of_model() : Requirement::torque_margin);
      machine::MotorReading<double> reading = machine::motor_reading(pair.figures_at(v), margin);
      const auto keep = [&](const double& x) { numbers.push_back(x); };
      visit_motor_reading(reading, keep);
      visit_shown_motor_reading(reading, keep);
      keep(pair.shaft);
      keep(pair.mass);
    }
  }
}

void MotorSet::read_ranges(std::size_t voltage, const MotorPair& pair, std::vector<Interval>& readings) const {
  const MotorRanges& ranges = pair.ranges()[voltage];
  const double published = require_(Requirement::torque_margin);
  const double estimated = require_(require_.margin_of_model());
  Interval margin = ranges.model_may_govern ? estimated : published;
  if (ranges.model_may_govern && !ranges.published.empty()) margin = hull(margin, published);
  machine::MotorReading<Interval> reading = machine::motor_reading(ranges.figures, margin);
  const auto keep = [&](const Interval& x) { readings.push_back(x); };
  visit_motor_reading(reading, keep);
  visit_shown_motor_reading(reading, keep);
  readings.emplace_back(pair.shaft);
  readings.push_back(ranges.mass);
}

void MotorSet::read(std::size_t voltage, std::span<const solver::Row> rows, std::vector<Interval>& readings) const {
  const MotorPair& only = pairs_[rows.front()];
  if (rows.size() == 1 && !only.ranges().empty()) {  // its torque is asked for at a speed
    read_ranges(voltage, only, readings);
    return;
  }
  append_ranges(
      rows, width, [&](solver::Row row) { return numbers_of(voltage, row); }, readings);
  torques_.read(rows, voltage, readings);
}

Interval MotorSet::torque_bounds(const RowsAlive& alive, std::size_t voltage, const Interval& speed) const {
  // A range of the table may hold more torques of one motor than there lie between two: a few are asked one by one.
  constexpr std::size_t few = 8;
  if (alive.size() <= few || !torques_.covers(speed)) {
    std::optional<Interval> result;
    torques_.visit_unlike(alive.rows, [&](solver::Row row) {
      const Interval torque = available_torque<Interval>(pairs_[row], voltage, speed);
      result = result ? hull(*result, torque) : torque;
    });
    return result.value();
  }
  const auto of_range = [&](std::size_t range) {
    if (torque_reading + range < alive.readings.size()) return alive.readings[torque_reading + range];
    return torques_.hull(alive.rows, voltage, range);
  };
  const std::size_t last = torques_.range_of(speed.upper);
  std::size_t range = torques_.range_of(speed.lower);
  Interval result = of_range(range);
  while (range < last) result = hull(result, of_range(++range));
  return result;
}

}  // namespace millwright::evaluation
