// SPDX-License-Identifier: Apache-2.0
//
// A belt drive as a stage of the solver. Slots: belt, drive pulley, idler, motor (with driver) and, if any is stated,
// reduction. One variable, the ramp time.
#pragma once

#include "evaluation/belt_tables.h"
#include "evaluation/screw_drive_stage.h"
#include "machine/belt_drive_constraints.h"

namespace millwright::evaluation {

class BeltDriveStage final : public DriveStage<BeltDriveStage> {
 public:
  BeltDriveStage(const machine::Axis& axis,
                 AxisPlace place,
                 const std::vector<double>& voltages,
                 const catalogue::Catalogue& catalogue,
                 const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::BeltDrive<T> design(const Selection<T>& selection) const;
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
  [[nodiscard]] bool may_misfit(std::size_t slot_a, std::size_t slot_b) const override;
  [[nodiscard]] double combinations(std::span<const std::vector<solver::Row>> rows) const override;
  [[nodiscard]] const machine::GearedDriveData& data() const { return data_; }

  /// What runs together is looked up.
  [[nodiscard]] std::optional<std::size_t> own_row_kind(std::size_t slot, solver::Row row) const;

  enum SlotIndex : std::size_t { belt_slot, pulley_slot, idler_slot, motor_slot };

 private:
  machine::GearedDriveData data_;
  BeltTables belts_;  ///< what fits; its tables are the stage's
};

extern template machine::BeltDrive<double> BeltDriveStage::design(const Selection<double>&) const;

extern template class ElementStage<BeltDriveStage>;

}  // namespace millwright::evaluation
