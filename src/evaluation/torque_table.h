// SPDX-License-Identifier: Apache-2.0
//
// Bounds of the available torque of motors in a few ranges of speed, so that the hull over many motors is a few
// comparisons. What a motor does is worked out when it is first asked for: a design that is only evaluated costs next
// to nothing. Numbers of single precision, rounded outward, are exact enough for sets of motors and half as long to
// read.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "evaluation/drive_tables.h"
#include "machine/modelled_torques.h"
#include "scalar/scalars.h"
#include "solver/stage.h"

namespace millwright::evaluation {

class TorqueTable {
 public:
  /// `pairs` must stay where they are. `speeds` [rad/s]: ascending edges of the ranges, at least two; the table adds a
  /// range from standstill and one beyond the last edge, since sets of parts seem to ask for speeds that no part alone
  /// does, and profiles ask for every speed from nothing on.
  TorqueTable(std::span<const MotorPair> pairs, std::size_t voltages, std::vector<double> speeds);

  [[nodiscard]] std::size_t ranges() const { return speeds_.size() - 1; }
  /// Whether all these speeds lie in ranges of the table.
  [[nodiscard]] bool covers(const scalar::Interval& speed) const {
    return speed.lower >= speeds_.front() && speed.upper <= speeds_.back();
  }
  /// The range that a speed lies in, the nearest one if it lies in none.
  [[nodiscard]] std::size_t range_of(double speed) const;

  /// The hull of torques [N.m] over `rows` (at least one) in one range.
  [[nodiscard]] scalar::Interval hull(std::span<const solver::Row> rows, std::size_t voltage, std::size_t range) const;
  /// Appends that of every range.
  void read(std::span<const solver::Row> rows, std::size_t voltage, std::vector<scalar::Interval>& readings) const;

  /// Calls with each of the rows (at least one), but of neighbours with the same torque with one: most drivers of a
  /// motor give it the same current.
  template <class Visit>
  void visit_unlike(std::span<const solver::Row> rows, Visit&& visit) const {
    visit(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i)
      if (entry_[rows[i]] != entry_[rows[i - 1]]) visit(rows[i]);
  }

 private:
  /// The least torque in each range, then the most in each with its sign turned: of both the least over rows is sought.
  [[nodiscard]] const float* bounds_of(std::size_t voltage, solver::Row row) const;
  void work_out(const MotorPair& pair, std::size_t voltage, float* bounds) const;

  std::span<const MotorPair> pairs_;
  std::vector<double> speeds_;
  machine::ModelledTorques modelled_;               ///< at the edges
  std::vector<solver::Row> entry_;                  ///< [row]: what is known of a motor at a current is known once
  std::vector<solver::Row> row_of_;                 ///< [entry]: the first row
  std::unique_ptr<std::atomic<bool>[]> known_;      ///< [voltage, entry]: whether it has been worked out
  std::unique_ptr<float[]> bounds_;                 ///< [voltage, entry, 2 * ranges()], as bounds_of gives them
  mutable std::array<std::mutex, 16> working_out_;  ///< by the number of the entry
};

}  // namespace millwright::evaluation
