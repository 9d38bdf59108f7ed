// SPDX-License-Identifier: Apache-2.0
//
// Counts per second. Pulse rates and frequencies have the dimension of angular speeds, and numbers that remember their
// formulas would show them as such: 200 kHz are no 200 000 rad/s.
#pragma once

#include <memory>
#include <type_traits>

#include "scalar/expression.h"
#include "scalar/scalars.h"

namespace millwright::machine {

/// A constant that counts something per second; Traced prints it in Hz or kHz.
template <class T>
T in_hertz(double value) {
  using namespace scalar;
  if constexpr (std::is_same_v<T, Traced>) {
    const Unit unit = Unit::of(value < 1e3 ? "Hz" : "kHz");
    return {value,
            dimension::frequency,
            std::make_shared<const Expression>(
                Expression{Expression::Kind::quantity, value, dimension::frequency, "", unit, {}})};
  } else {
    return in_unit<T>(value, dimension::frequency);
  }
}

}  // namespace millwright::machine
