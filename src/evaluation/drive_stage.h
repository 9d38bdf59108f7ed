// SPDX-License-Identifier: Apache-2.0
//
// What all drives have as stages of the solver: motors with their drivers in one slot, reductions in the last, a ramp
// time, and a place on an axis of several equal drives.
#pragma once

#include <memory>

#include "evaluation/axis_place.h"
#include "evaluation/element_stage.h"
#include "evaluation/motor_set.h"
#include "evaluation/price_book.h"
#include "evaluation/reduction_slot.h"
#include "machine/problem.h"

namespace millwright::evaluation {

/// CRTP base. Derived has `motor_slot`, and makes its motors once it knows how fast they turn.
template <class Derived>
class DriveStage : public ElementStage<Derived> {
 public:
  [[nodiscard]] const MotorSet& motors() const { return *motors_; }

  /// What motor and reduction read of their rows.
  void read_more(std::span<const solver::Row> shared,
                 std::size_t slot,
                 std::span<const solver::Row> rows,
                 std::vector<scalar::Interval>& readings) const {
    if (slot == Derived::motor_slot) motors_->read(shared.empty() ? 0 : shared.front(), rows, readings);
    if (reduction_.is(slot)) reduction_.read(rows, readings);
  }

 protected:
  DriveStage(const machine::Axis& axis, AxisPlace place, const PriceBook& prices)
      : place_(place),
        drives_(axis.mechanism.drives),
        load_share_(axis.mechanism.load_share),
        acceleration_time_(axis.acceleration_time),
        reduction_(axis, prices) {}

  AxisPlace place_;
  double drives_ = 1.0;
  double load_share_ = 1.0;  ///< of mass and forces, on the drive that is looked at
  machine::Range acceleration_time_;
  ReductionSlot reduction_;
  std::unique_ptr<MotorSet> motors_;
};

}  // namespace millwright::evaluation
