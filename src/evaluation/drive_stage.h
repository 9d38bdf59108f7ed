// SPDX-License-Identifier: Apache-2.0
//
// What all drives have as stages of the solver: motors with their drivers in one slot, reductions in the last, a ramp
// time, and a place on an axis of several equal drives.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

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

  /// Motors turn as fast as their voltage lets them.
  [[nodiscard]] bool own_reads_shared(std::size_t slot) const { return slot == Derived::motor_slot; }

  /// Motors and reductions are looked up by their rows; of the other slots the derived stage says what it reads of a
  /// row by its number (`own_row_kind`).
  [[nodiscard]] std::optional<std::size_t> row_kind_of(std::size_t slot, solver::Row row) const {
    const auto& derived = static_cast<const Derived&>(*this);
    if constexpr (requires { derived.own_row_kind(slot, row); })
      if (slot != Derived::motor_slot && !reduction_.is(slot)) return derived.own_row_kind(slot, row);
    return std::nullopt;
  }

  /// The most that any of its motors turns its flange by [N.m].
  [[nodiscard]] double largest_flange_torque() const {
    double largest = 0.0;
    for (solver::Row row = 0; row < motors_->pairs().size(); ++row)
      for (std::size_t voltage = 0; voltage < motors_->voltages(); ++voltage)
        largest = std::max(largest, flange_torque(reading_of(row, voltage)).upper);
    return largest;
  }
  /// `force` [N]: what every screw of the joints that hold its motors bears, whatever the torque.
  void set_harmless_motor_force(double force) { place_.harmless_motor_force = force; }

  /// Writes what its motor really does to the joint that holds it over what the search was told.
  void tell_flange(const Selection<double>& s, std::vector<double>& state) const {
    if (!place_.motor_force_state) return;
    const FlangeLoad<double> load = flange_load(static_cast<const Derived&>(*this).design(s), s);
    state[*place_.motor_force_state] = load.force;
    state[*place_.motor_torque_state] = load.torque;
  }

 protected:
  template <class T>
  struct FlangeLoad {
    T force, torque;
  };

  /// With both phases full on a motor holds more than it turns by.
  template <class T>
  [[nodiscard]] static T flange_torque(const machine::MotorReading<T>& motor) {
    using scalar::larger;
    return larger(motor.holding_torque, motor.static_torque);
  }
  [[nodiscard]] machine::MotorReading<scalar::Interval> reading_of(const solver::Row& row, std::size_t voltage) const {
    return motors_->template reading<scalar::Interval>(RowsAlive(std::span(&row, 1)), voltage);
  }

  /// What one motor does to the joint that holds it: its weight and what pulls sideways at its shaft, and the most that
  /// it turns its flange by.
  template <class T, class Drive>
  [[nodiscard]] FlangeLoad<T> flange_load(const Drive& drive, const Selection<T>& s) const {
    using namespace scalar;
    T force = motors_->template mass<T>(s.rows[Derived::motor_slot]) *
              in_unit<T>(machine::standard_gravity, dimension::acceleration);
    if constexpr (requires { shaft_pull(drive); }) force = force + shaft_pull(drive);
    return {force, flange_torque(drive.motor)};
  }

  /// Loads that no screw of the joint fails by are handed on as none: motors are not to be compared by what matters to
  /// nobody.
  template <class T, class Drive>
  void hand_on_flange(const Drive& drive, const Selection<T>& s, solver::Answer<T>& out) const {
    using namespace scalar;
    if (!place_.motor_force_state) return;
    const FlangeLoad<T> load = flange_load(drive, s);
    const T harmless(place_.harmless_motor_force);
    out.handed_on[*place_.motor_force_state] = step_below(load.force, harmless, T(0.0), load.force);
    out.handed_on[*place_.motor_torque_state] = step_below(load.force, harmless, T(0.0), load.torque);
  }

  DriveStage(const machine::Axis& axis, AxisPlace place, const PriceBook& prices)
      : place_(place),
        drives_(axis.mechanism.drives),
        load_share_(axis.mechanism.load_share),
        acceleration_time_(axis.acceleration_time),
        reduction_(axis, prices) {}

  /// Their slot is the next. `speeds`: as MotorSet's.
  void take_motors(MotorTable motors, const machine::Axis& axis, std::size_t voltages, std::vector<double> speeds) {
    motors_ = std::make_unique<MotorSet>(std::move(motors.pairs), axis.require, voltages, std::move(speeds));
    this->tables_.push_back(std::move(motors.table));
  }

  AxisPlace place_;
  double drives_ = 1.0;
  double load_share_ = 1.0;  ///< of mass and forces, on the drive that is looked at
  machine::Range acceleration_time_;
  ReductionSlot reduction_;
  std::unique_ptr<MotorSet> motors_;
};

}  // namespace millwright::evaluation
