// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scalar/elementary.h"

/// The common form of every constraint: a ratio that is at most 1 when the constraint holds.
namespace millwright::mechanics::utilisation {

using namespace scalar;

/// Demand over capacity: at most 1 when satisfied. A capacity of 0 or less counts as 1e9, so that designs without
/// capacity can still be ranked. Valid: capacity above 0. [millwright_derivations, definition]
template <class T>
T of_maximum(const T& demand, const T& capacity) {
  return step_below(
      T(0.0), capacity, [&]() -> T { return demand / capacity; }, T(1e9));
}

/// Required value over actual value (life, safety, stiffness, frequency): at most 1 when satisfied. An actual value of
/// 0 or less counts as 1e9. Valid: actual value above 0. [millwright_derivations, definition]
template <class T>
T of_minimum(const T& required, const T& actual) {
  return step_below(
      T(0.0), actual, [&]() -> T { return required / actual; }, T(1e9));
}

}  // namespace millwright::mechanics::utilisation
