// SPDX-License-Identifier: Apache-2.0
//
// Rotary table: the motor turns the table, directly or through a reduction that the problem states. Its travel is an
// angle; what has to be accelerated is the inertia of table and workpiece.
#pragma once

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

/// Errors of the axis [rad].
template <class T>
ErrorBudget<T> error_budget(const RotaryDrive<T>& d) {
  ErrorBudget<T> budget;
  add_gear_errors(d, reversal_error(d), budget);
  return budget;
}

}  // namespace millwright::machine
