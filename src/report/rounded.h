// SPDX-License-Identifier: Apache-2.0
//
// Of a bound no more may be printed than was proved: lower bounds are rounded down, and what they leave open up.
#pragma once

#include <cmath>

namespace millwright::report {

/// The next multiple of a step that is not above a value, but for the rounding of binary numbers.
inline double rounded_down(double value, double step) {
  constexpr double rounding = 1e-12, most = 1e-6;
  const double steps = value / step;
  if (!std::isfinite(steps)) return value;
  return step * std::floor(steps + std::fmin(rounding * std::fabs(steps), most));
}

inline double rounded_up(double value, double step) { return 0.0 - rounded_down(-value, step); }

/// Of so many significant digits what one unit of the last of them is.
inline double last_digit(double value, int digits) {
  return value == 0.0 || !std::isfinite(value)
             ? 1.0
             : std::pow(10.0, std::floor(std::log10(std::fabs(value))) - (digits - 1));
}

}  // namespace millwright::report
