// SPDX-License-Identifier: Apache-2.0
//
// What is charged at the end of the chain, because it hangs on what all stages take: a component of the state counts it
// in whole numbers, and a table says what the last stage charges for each.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scalar/scalars.h"

namespace millwright::evaluation {

struct LateCharge {
  std::optional<std::size_t> shop;  ///< where it is bought, if that is one of Shops
  std::size_t state = 0;            ///< where the state vector counts
  std::vector<double> charge;       ///< [counted], in the problem's currency
  double preference = 1.0;          ///< of it, where builds are compared (PriceBook::preference)
  scalar::Interval any, any_step;   ///< of all of them, and from one to the next: for ranges too long to look through

  /// After the table has been filled.
  void summarise() {
    const auto [least, most] = std::minmax_element(charge.begin(), charge.end());
    any = {*least, *most};
    any_step = scalar::Interval(0.0);
    for (std::size_t n = 0; n + 1 < charge.size(); ++n) {
      const double step = charge[n + 1] - charge[n];
      any_step = n == 0 ? scalar::Interval(step)
                        : scalar::Interval(std::min(any_step.lower, step), std::max(any_step.upper, step));
    }
  }
};

namespace detail {

struct Counted {
  std::size_t least = 0, most = 0;
  [[nodiscard]] bool is_long() const { return most - least > 100; }
};

/// The whole numbers in [lower, upper], which are whole but for rounding.
inline Counted counted_between(const LateCharge& of, double lower, double upper) {
  constexpr double rounding = 1e-6;
  const double last = static_cast<double>(of.charge.size() - 1);
  const double least = std::min(std::max(std::floor(lower + rounding), 0.0), last);
  const double most = std::min(std::max(std::ceil(upper - rounding), least), last);
  return {static_cast<std::size_t>(least), static_cast<std::size_t>(most)};
}

/// How much the next one costs, over these numbers and their neighbours.
inline scalar::Interval next_step(const LateCharge& of, Counted counted) {
  if (counted.is_long()) return of.any_step;
  scalar::Interval range(0.0);
  bool any = false;
  const std::size_t first = counted.least == 0 ? 0 : counted.least - 1;
  for (std::size_t n = first; n + 1 < of.charge.size() && n <= counted.most; ++n) {
    const double step = of.charge[n + 1] - of.charge[n];
    range = any ? scalar::Interval(std::min(range.lower, step), std::max(range.upper, step)) : scalar::Interval(step);
    any = true;
  }
  return range;
}

}  // namespace detail

/// What is charged at the end for so many.
inline double charge(const LateCharge& of, double counted) {
  return of.charge[detail::counted_between(of, counted, counted).least];
}

inline scalar::Interval charge(const LateCharge& of, const scalar::Interval& counted) {
  const detail::Counted range = detail::counted_between(of, counted.lower, counted.upper);
  if (range.is_long()) return of.any;
  const auto first = of.charge.begin();
  const auto [least, most] = std::minmax_element(first + static_cast<std::ptrdiff_t>(range.least),
                                                 first + static_cast<std::ptrdiff_t>(range.most) + 1);
  return {*least, *most};
}

/// The slope is the price of the next one: with it the charge is a broken line through the whole numbers.
template <class B>
scalar::Dual<B, 1> charge(const LateCharge& of, const scalar::Dual<B, 1>& counted) {
  scalar::Dual<B, 1> result(charge(of, counted.value));
  if constexpr (std::is_same_v<B, scalar::Interval>)
    result.slope[0] =
        counted.slope[0] * detail::next_step(of, detail::counted_between(of, counted.value.lower, counted.value.upper));
  else
    result.slope[0] =
        counted.slope[0] * middle(detail::next_step(of, detail::counted_between(of, counted.value, counted.value)));
  return result;
}

}  // namespace millwright::evaluation
