// SPDX-License-Identifier: Apache-2.0
//
// A screw drive as a stage of the solver. Slots: screw (with its nut), motor (with its driver), coupling,
// support_fixed, support_free and reduction, as far as the axis has them. One variable, the ramp time, if it is not
// fixed.
#pragma once

#include "evaluation/drive_stage.h"
#include "machine/geared_drive.h"
#include "machine/screw_drive_constraints.h"

namespace millwright::evaluation {

machine::MotionData motion_of(const machine::Axis& axis);
/// The same for the most loaded of the axis's drives: its share of the forces.
machine::MotionData drive_motion_of(const machine::Axis& axis);
bool gravity_acts(const machine::Axis& axis);
/// What a belt, rack or rotary drive is judged by.
machine::GearedDriveData geared_drive_data(const machine::Axis& axis);
/// Slowest and fastest constant speed of the axis's moves over its ramp times [m/s].
std::pair<double, double> constant_speed_range(const machine::Axis& axis);
/// Edges of equal ratio between two positive numbers.
std::vector<double> log_spaced(double from, double to);

class ScrewDriveStage final : public DriveStage<ScrewDriveStage> {
 public:
  ScrewDriveStage(const machine::Axis& axis,
                  AxisPlace place,
                  const std::vector<double>& voltages,
                  const catalogue::Catalogue& catalogue,
                  const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::ScrewDrive<T> design(const Selection<T>& selection) const;
  /// Of screws their kind as a number too.
  void read_more(std::span<const solver::Row> shared,
                 std::size_t slot,
                 std::span<const solver::Row> rows,
                 std::vector<scalar::Interval>& readings) const {
    if (slot == screw_slot) readings.push_back(kinds_of(rows));
    DriveStage::read_more(shared, slot, rows, readings);
  }
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

  [[nodiscard]] bool fits(std::span<const solver::Row> shared,
                          std::size_t slot_a,
                          solver::Row row_a,
                          std::size_t slot_b,
                          solver::Row row_b) const override;
  [[nodiscard]] solver::FitKey fit_key(std::span<const solver::Row> shared,
                                       std::size_t slot,
                                       solver::Row row,
                                       std::size_t other_slot) const override;
  [[nodiscard]] const machine::ScrewDriveData& data() const { return data_; }
  [[nodiscard]] const ScrewTable& screws() const { return screws_; }
  /// The readings of a screw with its nut, from its figures and not from the table.
  [[nodiscard]] machine::ScrewReading<double> reading_anew(solver::Row screw) const {
    return machine::screw_reading(screws_.figures(screw), screws_.site(screw));
  }

  /// Kinds of screws; everything else is read as figures.
  [[nodiscard]] std::optional<std::size_t> own_row_kind(std::size_t slot, solver::Row row) const {
    return slot == screw_slot ? static_cast<std::size_t>(screws_.kinds[row]) : 0;
  }

  enum SlotIndex : std::size_t { screw_slot, motor_slot };

 private:
  [[nodiscard]] scalar::Interval kinds_of(std::span<const solver::Row> screws) const {
    return range_of(screws, [&](solver::Row row) { return static_cast<double>(screws_.kinds[row]); });
  }
  [[nodiscard]] machine::ScrewKind kind_of(const RowsAlive& screws) const;
  [[nodiscard]] bool coupling_fits(double shaft, solver::Row coupling) const;
  [[nodiscard]] bool free_support_fits(solver::Row screw, solver::Row support) const;

  machine::ScrewDriveData data_;
  ScrewTable screws_;  ///< but for their table, which is with those of the other slots
  std::optional<std::size_t> coupling_slot_, free_slot_;
  std::size_t fixed_slot_ = 0;
};

extern template machine::ScrewDrive<double> ScrewDriveStage::design(const Selection<double>&) const;

extern template class ElementStage<ScrewDriveStage>;

}  // namespace millwright::evaluation
