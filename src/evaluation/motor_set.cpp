// SPDX-License-Identifier: Apache-2.0
#include "evaluation/motor_set.h"

#include <algorithm>
#include <map>

namespace millwright::evaluation {

using machine::Requirement;
using scalar::Interval;

namespace {

/// With a range from standstill and one beyond the end: sets of parts seem to ask for speeds that no part alone does,
/// and profiles ask for every speed from nothing on.
std::vector<double> with_outer_ranges(std::vector<double> edges) {
  constexpr double beyond = 4.0;  // mostly sets of pinions ask for no more than that
  if (edges.front() > 0.0) edges.insert(edges.begin(), 0.0);
  edges.push_back(beyond * edges.back());
  return edges;
}

}  // namespace

MotorSet::MotorSet(MotorTable motors,
                   const machine::Requirements& require,
                   std::size_t voltages,
                   std::vector<double> speeds)
    : motors_(std::move(motors)),
      require_(require),
      speeds_(with_outer_ranges(std::move(speeds))),
      torque_table_(voltages * motors_.pairs.size()) {
  std::map<std::pair<int, double>, solver::Row> first_with;  // (motor, current)
  for (solver::Row row = 0; row < motors_.pairs.size(); ++row) {
    const machine::MotorFigures<double>& figures = motors_.pairs[row].at_voltage.front();
    const int motor = motors_.table.candidate(row).parts.front().row;
    const double current = std::min(figures.driver_peak_current, figures.asked_current);
    torque_row_.push_back(first_with.try_emplace({motor, current}, row).first->second);
  }
  readings_.resize(voltages);
  for (std::size_t v = 0; v < voltages; ++v) {
    for (const MotorPair& pair : motors_.pairs) {
      // A margin that the problem states holds for curve and model alike; else the model, an estimate, gets the smaller
      // share.
      const bool estimate = pair.curve[v] == nullptr;
      const double margin =
          require(estimate && !require.given(Requirement::torque_margin) ? Requirement::torque_margin_estimate
                                                                         : Requirement::torque_margin);
      machine::MotorReading<double> reading = machine::motor_reading(pair.at_voltage[v], margin);
      const auto keep = [&](const double& x) { readings_[v].push_back(x); };
      visit_motor_reading(reading, keep);
      visit_shown_motor_reading(reading, keep);
    }
  }
}

const std::vector<Interval>& MotorSet::torque_ranges(std::size_t voltage, solver::Row any_row) const {
  const solver::Row row = torque_row_[any_row];
  TorqueRanges& of_motor = torque_table_[voltage * motors_.pairs.size() + row];
  std::call_once(of_motor.known, [&] {
    for (std::size_t r = 0; r + 1 < speeds_.size(); ++r)
      of_motor.torque.push_back(
          available_torque<Interval>(motors_.pairs[row], voltage, Interval(speeds_[r], speeds_[r + 1])));
  });
  return of_motor.torque;
}

template <class Value>
Interval MotorSet::hull_of_torques(std::span<const solver::Row> rows, Value&& value) const {
  solver::Row last = torque_row_[rows.front()];
  Interval result = value(last);
  for (const solver::Row row : rows.subspan(1)) {
    if (torque_row_[row] == last) continue;
    last = torque_row_[row];
    result = hull(result, value(last));
  }
  return result;
}

Interval MotorSet::torque_in_range(std::span<const solver::Row> rows, std::size_t voltage, std::size_t range) const {
  return hull_of_torques(rows, [&](solver::Row row) { return torque_ranges(voltage, row)[range]; });
}

void MotorSet::read_ranges(std::size_t voltage, const MotorPair& pair, std::vector<Interval>& readings) const {
  const MotorRanges& ranges = pair.ranges[voltage];
  const double published = require_(Requirement::torque_margin);
  const double estimated = require_(require_.given(Requirement::torque_margin) ? Requirement::torque_margin
                                                                               : Requirement::torque_margin_estimate);
  Interval margin = ranges.model_may_govern ? estimated : published;
  if (ranges.model_may_govern && !ranges.curves.empty()) margin = hull(margin, published);
  machine::MotorReading<Interval> reading = machine::motor_reading(ranges.figures, margin);
  const auto keep = [&](const Interval& x) { readings.push_back(x); };
  visit_motor_reading(reading, keep);
  visit_shown_motor_reading(reading, keep);
  readings.emplace_back(pair.shaft);
}

void MotorSet::read(std::size_t voltage, std::span<const solver::Row> rows, std::vector<Interval>& readings) const {
  const MotorPair& only = motors_.pairs[rows.front()];
  if (rows.size() == 1 && !only.ranges.empty()) {  // its torque is asked for at a speed
    read_ranges(voltage, only, readings);
    readings.push_back(range_of_total(motors_.table.candidate(rows.front()), Total::standing_mass));
    return;
  }
  append_ranges(
      rows, fields, [&](solver::Row row) { return readings_[voltage].data() + row * fields; }, readings);
  append_ranges(
      rows, 1, [&](solver::Row row) { return &motors_.pairs[row].shaft; }, readings);
  append_ranges(
      rows, 1, [&](solver::Row row) { return &motors_.table.candidate(row).standing_mass; }, readings);
  // Motor by motor: what is known of one lies together.
  solver::Row last = torque_row_[rows.front()];
  const std::vector<Interval>& of_first = torque_ranges(voltage, last);
  const std::size_t first = readings.size();
  readings.insert(readings.end(), of_first.begin(), of_first.end());
  for (const solver::Row row : rows.subspan(1)) {
    if (torque_row_[row] == last) continue;
    last = torque_row_[row];
    const std::vector<Interval>& of_row = torque_ranges(voltage, last);
    for (std::size_t range = 0; range < of_row.size(); ++range)
      readings[first + range] = hull(readings[first + range], of_row[range]);
  }
}

Interval MotorSet::torque_bounds(const RowsAlive& alive, std::size_t voltage, const Interval& speed) const {
  // A range of the table may hold more torques of one motor than there lie between two: a few are asked one by one.
  constexpr std::size_t few = 8;
  const std::size_t ranges = speeds_.size() - 1;
  if (alive.size() <= few || speed.lower < speeds_.front() || speed.upper > speeds_.back()) {
    return hull_of_torques(
        alive.rows, [&](solver::Row row) { return available_torque<Interval>(motors_.pairs[row], voltage, speed); });
  }
  const auto range_of = [&](double x) {
    const auto above = std::upper_bound(speeds_.begin(), speeds_.end(), x);
    return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - speeds_.begin() - 1, 0)), ranges - 1);
  };
  const std::size_t first = range_of(speed.lower);
  const std::size_t last = range_of(speed.upper);
  const auto of_range = [&](std::size_t range) {
    if (torque_reading + range < alive.readings.size()) return alive.readings[torque_reading + range];
    return torque_in_range(alive, voltage, range);
  };
  Interval result = of_range(first);
  for (std::size_t range = first + 1; range <= last; ++range) result = hull(result, of_range(range));
  return result;
}

}  // namespace millwright::evaluation
