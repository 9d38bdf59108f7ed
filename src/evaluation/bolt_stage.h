// SPDX-License-Identifier: Apache-2.0
//
// A joint of screws as a stage of the solver. One slot: the screw, taken as often as all joints of the group need it.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/bolted_joint.h"

namespace millwright::evaluation {

class BoltStage final : public ElementStage<BoltStage> {
 public:
  /// `is_last`: no further joint holds the same motors or carriages.
  BoltStage(const machine::Axis& axis,
            const machine::Member& member,
            AxisPlace place,
            bool is_last,
            const catalogue::Catalogue& catalogue,
            const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::BoltedJoint<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;
  [[nodiscard]] const machine::BoltedJointData& data() const { return data_; }
  /// A force [N] that every screw of the table bears on a joint that holds a motor, as any smaller one, beside this
  /// torque [N.m] or any smaller one; 0 if there is none.
  [[nodiscard]] double harmless_force(double torque) const;

 private:
  /// Without its loads.
  template <class T>
  [[nodiscard]] machine::BoltedJoint<T> joint_of(const RowsAlive& screws) const;
  [[nodiscard]] bool all_bear(double force, double torque) const;

  machine::BoltedJointData data_;
  AxisPlace place_;
  bool is_last_ = true;
};

extern template machine::BoltedJoint<double> BoltStage::design(const Selection<double>&) const;

extern template class ElementStage<BoltStage>;

}  // namespace millwright::evaluation
