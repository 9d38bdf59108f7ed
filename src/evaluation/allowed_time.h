// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>

namespace millwright::evaluation {

/// The time that an answer may take, in seconds from when this is made (infinity: any).
class AllowedTime {
 public:
  explicit AllowedTime(double seconds) : seconds_(seconds), begin_(std::chrono::steady_clock::now()) {}

  [[nodiscard]] double used() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  [[nodiscard]] double left() const { return std::max(0.0, seconds_ - used()); }

 private:
  double seconds_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace millwright::evaluation
