// SPDX-License-Identifier: Apache-2.0
//
// A set of motors (each with its driver) at one supply voltage, on any scalar: hulls of their readings, and their
// available torque at a speed. Bounds of the torque over many motors come from a table (torque_table.h), so that the
// hull over a set is a few comparisons. Of sets of a few motors the torque is worked out at the speed asked for.
#pragma once

#include <span>
#include <vector>

#include "evaluation/drive_tables.h"
#include "evaluation/motor_torque.h"
#include "evaluation/torque_table.h"
#include "machine/axis_motion.h"
#include "machine/requirement.h"
#include "scalar/scalars.h"

namespace millwright::evaluation {

class MotorSet {
 public:
  /// `speeds`: the angular speeds [rad/s] that can occur on the axis, ascending edges of the ranges of the torque
  /// table.
  MotorSet(std::vector<MotorPair> pairs,
           const machine::Requirements& require,
           std::size_t voltages,
           std::vector<double> speeds);

  [[nodiscard]] const std::vector<MotorPair>& pairs() const { return pairs_; }
  [[nodiscard]] std::size_t voltages() const { return numbers_.size(); }

  /// Adds to the readings of a set of motors what is read of it here: fields, shaft, mass, torque in each range of
  /// speed. Ranges of figures (MotorPair::ranges) count where one motor alone is asked for.
  void read(std::size_t voltage, std::span<const solver::Row> rows, std::vector<scalar::Interval>& readings) const;

  template <class T>
  [[nodiscard]] machine::MotorReading<T> reading(const RowsAlive& alive, std::size_t voltage) const {
    machine::MotorReading<T> result;
    std::size_t field = 0;
    const auto read = [&](T& x) {
      x = hull_of<T>(alive, first_reading + field, [&](solver::Row row) { return numbers_of(voltage, row)[field]; });
      ++field;
    };
    visit_motor_reading(result, read);
    if (machine::wants_everything<T>(require_)) visit_shown_motor_reading(result, read);
    return result;
  }

  template <class T>
  [[nodiscard]] T shaft(const RowsAlive& alive) const {
    return hull_of<T>(alive, shaft_reading, [&](solver::Row row) { return pairs_[row].shaft; });
  }
  /// Of one motor [kg], without its driver.
  template <class T>
  [[nodiscard]] T mass(const RowsAlive& alive) const {
    return hull_of<T>(alive, mass_reading, [&](solver::Row row) { return pairs_[row].mass; });
  }

  template <class T>
  [[nodiscard]] T torque(const RowsAlive& alive, std::size_t voltage, const T& angular_speed) const {
    if constexpr (std::is_same_v<T, scalar::Interval>) {
      const MotorPair& first = pairs_[alive.front()];
      if (alive.size() == 1 && !first.ranges().empty()) return available_torque(first.ranges()[voltage], angular_speed);
    }
    if (alive.size() == 1) return available_torque<T>(pairs_[alive.front()], voltage, angular_speed);
    if constexpr (std::is_same_v<T, scalar::Interval>) {
      return torque_bounds(alive, voltage, angular_speed);
    } else if constexpr (std::is_same_v<T, scalar::Dual<scalar::Interval, 1>>) {
      // Torque never rises with speed; by how much it falls differs from motor to motor.
      T result(torque_bounds(alive, voltage, angular_speed.value));
      const scalar::Interval& slope = angular_speed.slope[0];
      if (slope.lower != 0.0 || slope.upper != 0.0) result.slope[0] = scalar::Interval::entire();
      return result;
    } else {
      return available_torque<T>(pairs_[alive.front()], voltage, angular_speed);
    }
  }

 private:
  static constexpr std::size_t fields = machine::motor_reading_fields + machine::shown_motor_reading_fields;
  static constexpr std::size_t width = fields + 2;           // shaft and mass stand behind them
  static constexpr std::size_t first_reading = total_count;  // the motors' own table has no fields
  static constexpr std::size_t shaft_reading = first_reading + fields;
  static constexpr std::size_t mass_reading = shaft_reading + 1;
  static constexpr std::size_t torque_reading = mass_reading + 1;  // of the first range of speed

  [[nodiscard]] const double* numbers_of(std::size_t voltage, solver::Row row) const {
    return numbers_[voltage].data() + row * width;
  }
  [[nodiscard]] scalar::Interval torque_bounds(const RowsAlive& alive,
                                               std::size_t voltage,
                                               const scalar::Interval& speed) const;
  /// Fields, shaft and mass of a motor with ranges.
  void read_ranges(std::size_t voltage, const MotorPair& pair, std::vector<scalar::Interval>& readings) const;

  std::vector<MotorPair> pairs_;
  machine::Requirements require_;
  std::vector<std::vector<double>> numbers_;  ///< per voltage, row by row: long tables are read by these alone
  TorqueTable torques_;
};

}  // namespace millwright::evaluation
