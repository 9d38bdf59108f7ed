// SPDX-License-Identifier: Apache-2.0
//
// A screw drive as a stage of the solver. Slots: screw (with its nut), motor (with its driver), coupling,
// support_fixed, support_free and reduction, as far as the axis has them. One variable, the ramp time, if it is not
// fixed.
#pragma once

#include <memory>

#include "evaluation/element_stage.h"
#include "evaluation/motor_set.h"
#include "evaluation/price_book.h"
#include "evaluation/reduction_slot.h"
#include "machine/geared_drive.h"
#include "machine/screw_drive_constraints.h"
#include "machine/tool_chain.h"

namespace millwright::evaluation {

/// Where an axis stands in the machine: its load and its parent's in the state vector.
struct AxisPlace {
  std::size_t load_state = 0;
  std::optional<std::size_t> parent_load_state;
  std::optional<machine::ToolPlace> tool;  ///< where compliance counts
  /// Of the tool's compliance along x, y and z, where it is asked for.
  std::array<std::optional<std::size_t>, 3> compliance_state;
  std::optional<std::size_t> error_state;  ///< of the position error along the axis, where it is asked for at the tool
};

/// Adds what an element gives way under the tool.
template <class T, class Element>
void add_compliance(const AxisPlace& place, const Element& element, solver::Answer<T>& out) {
  using scalar::dimension::stiffness;
  if (!place.tool) return;
  const machine::Compliance<T> compliance = tool_compliance(element, *place.tool);
  for (std::size_t i = 0; i < compliance.size(); ++i)
    if (place.compliance_state[i])
      out.handed_on[*place.compliance_state[i]] =
          out.handed_on[*place.compliance_state[i]] +
          machine::whole_steps(compliance[i], place.tool->step[i], scalar::dimension::none / stiffness);
}

/// Adds what a drive gives way under the tool, and its own position error.
template <class T, class Drive>
void add_to_tool(const AxisPlace& place, const Drive& drive, solver::Answer<T>& out) {
  add_compliance(place, drive, out);
  if (!place.error_state) return;
  T& sum = out.handed_on[*place.error_state];
  sum = sum + machine::whole_steps(error_budget(drive, machine::UnderForce::no).total(),
                                   place.tool->error_step,
                                   scalar::dimension::length);
}

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

class ScrewDriveStage final : public ElementStage<ScrewDriveStage> {
 public:
  ScrewDriveStage(const machine::Axis& axis,
                  AxisPlace place,
                  const std::vector<double>& voltages,
                  const catalogue::Catalogue& catalogue,
                  const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::ScrewDrive<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

  [[nodiscard]] bool fits(std::span<const solver::Row> shared,
                          std::size_t slot_a,
                          solver::Row row_a,
                          std::size_t slot_b,
                          solver::Row row_b) const override;
  [[nodiscard]] const MotorSet& motors() const { return *motors_; }
  [[nodiscard]] const machine::ScrewDriveData& data() const { return data_; }
  /// The readings of a screw with its nut, from its figures and not from the table.
  [[nodiscard]] machine::ScrewReading<double> reading_anew(solver::Row screw) const {
    return machine::screw_reading(screws_.figures[screw], screws_.sites[screw]);
  }

  enum SlotIndex : std::size_t { screw_slot, motor_slot };

 private:
  [[nodiscard]] bool coupling_fits(double shaft, solver::Row coupling) const;
  [[nodiscard]] bool free_support_fits(solver::Row screw, solver::Row support) const;

  machine::ScrewDriveData data_;
  AxisPlace place_;
  double drives_ = 1.0;
  double load_share_ = 1.0;  ///< of mass and forces, on the drive that is looked at
  machine::Range acceleration_time_;
  ScrewTable screws_;
  ReductionSlot reduction_;
  std::unique_ptr<MotorSet> motors_;
  std::optional<std::size_t> coupling_slot_, free_slot_;
  std::size_t fixed_slot_ = 0;
};

extern template machine::ScrewDrive<double> ScrewDriveStage::design(const Selection<double>&) const;

}  // namespace millwright::evaluation
