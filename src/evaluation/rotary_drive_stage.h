// SPDX-License-Identifier: Apache-2.0
//
// A rotary table as a stage of the solver. Slots: motor (with driver) and, if any is stated, reduction. One variable,
// the ramp time, if it is not fixed. It turns the inertia that the problem states; its mass and that of its motor
// burden its parent.
#pragma once

#include <memory>

#include "evaluation/screw_drive_stage.h"
#include "machine/rotary_drive_constraints.h"

namespace millwright::evaluation {

class RotaryDriveStage final : public ElementStage<RotaryDriveStage> {
 public:
  RotaryDriveStage(const machine::Axis& axis,
                   AxisPlace place,
                   const std::vector<double>& voltages,
                   const catalogue::Catalogue& catalogue,
                   const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::RotaryDrive<T> design(const Selection<T>& selection) const;
  /// What motor and reduction read of their rows.
  void read_more(std::span<const solver::Row> shared,
                 std::size_t slot,
                 std::span<const solver::Row> rows,
                 std::vector<scalar::Interval>& readings) const {
    if (slot == motor_slot) motors_->read(shared.empty() ? 0 : shared.front(), rows, readings);
    if (reduction_.is(slot)) reduction_.read(rows, readings);
  }
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

  [[nodiscard]] const MotorSet& motors() const { return *motors_; }
  [[nodiscard]] const machine::GearedDriveData& data() const { return data_; }

  enum SlotIndex : std::size_t { motor_slot };

 private:
  machine::GearedDriveData data_;
  double inertia_ = 0.0;
  AxisPlace place_;
  ReductionSlot reduction_;
  machine::Range acceleration_time_;
  std::unique_ptr<MotorSet> motors_;
};

extern template machine::RotaryDrive<double> RotaryDriveStage::design(const Selection<double>&) const;

extern template class ElementStage<RotaryDriveStage>;

}  // namespace millwright::evaluation
