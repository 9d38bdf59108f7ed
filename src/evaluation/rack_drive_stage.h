// SPDX-License-Identifier: Apache-2.0
//
// A rack drive as a stage of the solver. Slots: rack, pinion, motor (with driver) and, if any is stated, reduction.
// One variable, the ramp time, if it is not fixed.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/rack_drive_constraints.h"

namespace millwright::evaluation {

class RackDriveStage final : public DriveStage<RackDriveStage> {
 public:
  RackDriveStage(const machine::Axis& axis,
                 AxisPlace place,
                 const std::vector<double>& voltages,
                 const catalogue::Catalogue& catalogue,
                 const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::RackDrive<T> design(const Selection<T>& selection) const;
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
  [[nodiscard]] const machine::GearedDriveData& data() const { return data_; }

  /// Everything is read as figures.
  [[nodiscard]] static std::optional<std::size_t> own_row_kind(std::size_t /*slot*/, solver::Row /*row*/) { return 0; }

  enum SlotIndex : std::size_t { rack_slot, pinion_slot, motor_slot };

 private:
  machine::GearedDriveData data_;
};

extern template machine::RackDrive<double> RackDriveStage::design(const Selection<double>&) const;

extern template class ElementStage<RackDriveStage>;

}  // namespace millwright::evaluation
