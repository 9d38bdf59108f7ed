// SPDX-License-Identifier: Apache-2.0
//
// Rotary table: the motor turns the table, directly or through a reduction that the problem states. Its travel is an
// angle; what has to be accelerated is the inertia of table and workpiece.
#pragma once

#include <span>

#include "machine/geared_drive.h"

namespace millwright::machine {

template <class T>
struct RotaryDrive : GearedDrive<T> {
  T table_inertia{};  ///< kg.m2, with what stands on it

  void derive() {
    using namespace scalar;
    this->derive_gears(named("J", table_inertia), T(1.0), in_unit<T>(0.0, dimension::inertia));
  }
};

/// Error budget of the axis [rad]: play, wind-up of a reduction and motor lag systematically, steps at random.
template <class T>
T position_error_budget(const RotaryDrive<T>& d) {
  using namespace scalar;
  const std::array<T, 3> systematic{
      named("e_r", reversal_error(d)), named("e_w", reduction_windup(d)), named("e_s", motor_lag(d))};
  const std::array<T, 2> random = step_errors(d);
  return mechanics::accuracy::mixed_error(std::span<const T>(systematic), std::span<const T>(random));
}

}  // namespace millwright::machine
