// SPDX-License-Identifier: Apache-2.0
//
// A set of motors (each with its driver) at one supply voltage, on any scalar: hulls of their readings, and their
// available torque at a speed. Bounds of the torque over many motors come from a table: for each motor and each of a
// few speed ranges the interval of its torque there, worked out when it is first asked for, so that the hull over a set
// is a few comparisons, and a design that is only evaluated costs nothing. Of sets of a few motors the torque is worked
// out at the speed asked for.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "evaluation/drive_tables.h"
#include "machine/axis_motion.h"
#include "machine/motor.h"
#include "machine/requirement.h"
#include "scalar/scalars.h"

namespace millwright::evaluation {

/// Available torque of one motor: its published curve where that governs, else (and above the curve) the winding model.
template <class T>
T available_torque(const MotorPair& pair, std::size_t voltage, const T& angular_speed) {
  using namespace scalar;
  const machine::MotorFigures<double>& figures = pair.at_voltage[voltage];
  const auto model = [&] {
    machine::MotorFigures<T> f;
    f.holding_torque = in_unit<T>(figures.holding_torque, dimension::torque);
    f.rated_current = in_unit<T>(figures.rated_current, dimension::current);
    f.resistance = in_unit<T>(figures.resistance, dimension::resistance);
    f.inductance = in_unit<T>(figures.inductance, dimension::inductance);
    f.rotor_teeth = T(figures.rotor_teeth);
    f.voltage = in_unit<T>(figures.voltage, dimension::voltage);
    const double current = std::min(figures.driver_peak_current, figures.asked_current);
    return machine::modelled_torque(f, in_unit<T>(current, dimension::current), angular_speed);
  };
  const mechanics::PullOutCurve* curve = pair.curve[voltage].get();
  if (curve == nullptr) return model();
  const T last = in_unit<T>(curve->points().back().torque, dimension::torque);
  // The curve may end above the model: there the torque jumps down.
  return step_below(
      angular_speed,
      in_unit<T>(curve->last_speed(), dimension::angular_speed),
      [&] { return (*curve)(angular_speed); },
      [&] { return smaller(model(), last); });
}

/// The same over the figures of one motor that are intervals.
template <class T>
T available_torque(const MotorRanges& ranges, const T& angular_speed) {
  using namespace scalar;
  const machine::MotorFigures<Interval>& figures = ranges.figures;
  machine::MotorFigures<T> f;
  f.holding_torque = T(figures.holding_torque);
  f.rated_current = T(figures.rated_current);
  f.resistance = T(figures.resistance);
  f.inductance = T(figures.inductance);
  f.rotor_teeth = T(figures.rotor_teeth);
  f.voltage = T(figures.voltage);
  const T current = T(smaller(figures.driver_peak_current, figures.asked_current));
  const auto model = [&] { return machine::modelled_torque(f, current, angular_speed); };
  std::optional<T> result;
  const auto take = [&](const T& torque) { result = result ? hull(*result, torque) : torque; };
  if (ranges.model_may_govern) take(model());
  for (const MotorRanges::Curve& curve : ranges.curves)
    for (const mechanics::PullOutCurve* end : {&curve.lowest, &curve.highest})
      take(step_below(
          angular_speed,
          T(end->last_speed()),
          [&] { return (*end)(angular_speed); },
          [&] { return smaller(model(), T(end->points().back().torque)); }));
  return result.value();
}

class MotorSet {
 public:
  /// `speeds`: the angular speeds [rad/s] that can occur on the axis, ascending edges of the ranges of the torque
  /// table. (Below and above them there is one range more.)
  MotorSet(MotorTable motors, const machine::Requirements& require, std::size_t voltages, std::vector<double> speeds);

  [[nodiscard]] const MotorTable& motors() const { return motors_; }
  [[nodiscard]] std::size_t voltages() const { return readings_.size(); }

  /// Adds to the readings of a set of motors what is read of it here: fields, shaft, mass, torque in each range of
  /// speed. Ranges of figures (MotorPair::ranges) count where one motor alone is asked for.
  void read(std::size_t voltage, std::span<const solver::Row> rows, std::vector<scalar::Interval>& readings) const;

  template <class T>
  [[nodiscard]] machine::MotorReading<T> reading(const RowsAlive& alive, std::size_t voltage) const {
    machine::MotorReading<T> result;
    std::size_t field = 0;
    const auto read = [&](T& x) {
      x = hull_of<T>(
          alive, first_reading + field, [&](solver::Row row) { return readings_[voltage][row * fields + field]; });
      ++field;
    };
    visit_motor_reading(result, read);
    if (machine::wants_everything<T>(require_)) visit_shown_motor_reading(result, read);
    return result;
  }

  template <class T>
  [[nodiscard]] T shaft(const RowsAlive& alive) const {
    return hull_of<T>(alive, shaft_reading, [&](solver::Row row) { return motors_.pairs[row].shaft; });
  }
  /// Of one motor [kg]; what stands of a pair of motor and driver is the motor: the driver is in its cabinet.
  template <class T>
  [[nodiscard]] T mass(const RowsAlive& alive) const {
    return hull_of<T>(alive, mass_reading, [&](solver::Row row) { return motors_.table.candidate(row).standing_mass; });
  }

  template <class T>
  [[nodiscard]] T torque(const RowsAlive& alive, std::size_t voltage, const T& angular_speed) const {
    if constexpr (std::is_same_v<T, scalar::Interval>) {
      const MotorPair& first = motors_.pairs[alive.front()];
      if (alive.size() == 1 && !first.ranges.empty()) return available_torque(first.ranges[voltage], angular_speed);
    }
    if (alive.size() == 1) return available_torque<T>(motors_.pairs[alive.front()], voltage, angular_speed);
    if constexpr (std::is_same_v<T, scalar::Interval>) {
      return torque_bounds(alive, voltage, angular_speed);
    } else if constexpr (std::is_same_v<T, scalar::Dual<scalar::Interval, 1>>) {
      // Torque never rises with speed; by how much it falls differs from motor to motor.
      T result(torque_bounds(alive, voltage, angular_speed.value));
      const scalar::Interval& slope = angular_speed.slope[0];
      if (slope.lower != 0.0 || slope.upper != 0.0) result.slope[0] = scalar::Interval::entire();
      return result;
    } else {
      return available_torque<T>(motors_.pairs[alive.front()], voltage, angular_speed);
    }
  }

 private:
  static constexpr std::size_t fields = machine::motor_reading_fields + machine::shown_motor_reading_fields;
  static constexpr std::size_t first_reading = total_count;  // the motors' own table has no fields
  static constexpr std::size_t shaft_reading = first_reading + fields;
  static constexpr std::size_t mass_reading = shaft_reading + 1;
  static constexpr std::size_t torque_reading = mass_reading + 1;  // of the first range of speed

  [[nodiscard]] scalar::Interval torque_bounds(const RowsAlive& alive,
                                               std::size_t voltage,
                                               const scalar::Interval& speed) const;

  /// Fields and shaft of a motor with ranges.
  void read_ranges(std::size_t voltage, const MotorPair& pair, std::vector<scalar::Interval>& readings) const;

  MotorTable motors_;
  machine::Requirements require_;
  std::vector<std::vector<double>> readings_;  ///< per voltage
  std::vector<double> speeds_;
  /// The torque in each range of speed of one motor.
  struct TorqueRanges {
    std::once_flag known;
    std::vector<scalar::Interval> torque;
  };
  [[nodiscard]] const std::vector<scalar::Interval>& torque_ranges(std::size_t voltage, solver::Row row) const;
  /// The hull of value(row); of neighbours with the same torque one is asked, since most drivers of a motor give it the
  /// same current.
  template <class Value>
  [[nodiscard]] scalar::Interval hull_of_torques(std::span<const solver::Row> rows, Value&& value) const;
  [[nodiscard]] scalar::Interval torque_in_range(std::span<const solver::Row> rows,
                                                 std::size_t voltage,
                                                 std::size_t range) const;
  mutable std::vector<TorqueRanges> torque_table_;  ///< voltage * rows + row
  std::vector<solver::Row> torque_row_;             ///< [row]: the first with the same motor at the same current
};

}  // namespace millwright::evaluation
