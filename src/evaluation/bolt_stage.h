// SPDX-License-Identifier: Apache-2.0
//
// A joint of screws as a stage of the solver. One slot: the screw, taken as often as all joints of the group need it.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/bolted_joint.h"

namespace millwright::evaluation {

class BoltStage final : public ElementStage<BoltStage> {
 public:
  BoltStage(const machine::Axis& axis,
            const machine::Member& member,
            AxisPlace place,
            const catalogue::Catalogue& catalogue,
            const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::BoltedJoint<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;
  [[nodiscard]] const machine::BoltedJointData& data() const { return data_; }

 private:
  machine::BoltedJointData data_;
  AxisPlace place_;
};

extern template machine::BoltedJoint<double> BoltStage::design(const Selection<double>&) const;

extern template class ElementStage<BoltStage>;

}  // namespace millwright::evaluation
