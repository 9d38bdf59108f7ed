// SPDX-License-Identifier: Apache-2.0
//
// The largest or smallest of several values of any scalar.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "scalar/scalars.h"

namespace millwright::machine {

/// The largest of what is taken. Bounds and derivatives go through `larger`; a traced value keeps only the winner, so
/// that a calculation sheet shows the phase that governs and not a chain of comparisons.
template <class T>
class Largest {
 public:
  void take(const T& value) {
    using namespace scalar;
    if constexpr (!std::is_same_v<T, Traced>) {
      largest_ = largest_ ? T(larger(*largest_, value)) : value;
    } else if (!largest_ || value.value > largest_->value) {
      largest_ = value;
    }
  }
  /// Something must have been taken.
  [[nodiscard]] const T& value() const { return *largest_; }

 private:
  std::optional<T> largest_;
};

/// The largest of a list, which must not be empty.
template <class T>
T largest(const std::vector<T>& values) {
  Largest<T> result;
  for (const T& value : values) result.take(value);
  return result.value();
}

/// The smallest of a list, as `largest`.
template <class T>
T smallest(const std::vector<T>& values) {
  Largest<T> negative;
  for (const T& value : values) negative.take(-value);
  return -negative.value();
}

}  // namespace millwright::machine
