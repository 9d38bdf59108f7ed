// SPDX-License-Identifier: Apache-2.0
//
// A rotary table as a stage of the solver. Slots: motor (with driver) and, if any is stated, reduction. One variable,
// the ramp time, if it is not fixed. It turns the inertia that the problem states; its mass and that of its motor
// burden its parent.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/rotary_drive_constraints.h"

namespace millwright::evaluation {

class RotaryDriveStage final : public DriveStage<RotaryDriveStage> {
 public:
  RotaryDriveStage(const machine::Axis& axis,
                   AxisPlace place,
                   const std::vector<double>& voltages,
                   const catalogue::Catalogue& catalogue,
                   const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::RotaryDrive<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

  [[nodiscard]] const machine::GearedDriveData& data() const { return data_; }

  enum SlotIndex : std::size_t { motor_slot };

 private:
  machine::GearedDriveData data_;
  double inertia_ = 0.0;
};

extern template machine::RotaryDrive<double> RotaryDriveStage::design(const Selection<double>&) const;

extern template class ElementStage<RotaryDriveStage>;

}  // namespace millwright::evaluation
