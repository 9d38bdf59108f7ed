// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "scalar/elementary.h"

/// The arithmetic between two formulas of a calculation, so that every line of it can be stated and checked: sums,
/// shares, ratios of quantities in whatever unit.
namespace millwright::mechanics::arithmetic {

using namespace scalar;

/// A quantity taken over as it stands. [millwright_derivations, definition]
template <class T>
T value(const T& value) {
  return value;
}

/// Sum of like quantities. [millwright_derivations, definition]
template <class T>
T sum(std::span<const T> values) {
  return sum_of(values.size(), [&](std::size_t i) { return values[i]; });
}

/// Difference of like quantities. [millwright_derivations, definition]
template <class T>
T difference(const T& minuend, const T& subtrahend) {
  return minuend - subtrahend;
}

/// Mean of two like quantities. [millwright_derivations, definition]
template <class T>
T mean(const T& first, const T& second) {
  return (first + second) / 2.0;
}

/// A quantity times a pure number (design power, permitted share). [millwright_derivations, definition]
template <class T>
T multiple(const T& value, const T& factor) {
  return value * factor;
}

/// A quantity divided by a pure number (safety factor, inertia ratio). [millwright_derivations, definition]
template <class T>
T quotient(const T& value, const T& divisor) {
  return value / divisor;
}

/// Ratio of like quantities. [millwright_derivations, definition]
template <class T>
T ratio(const T& numerator, const T& denominator) {
  return numerator / denominator;
}

}  // namespace millwright::mechanics::arithmetic
