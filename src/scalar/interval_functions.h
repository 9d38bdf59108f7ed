// SPDX-License-Identifier: Apache-2.0
//
// The elementary functions and branches of Interval. Arguments outside a function's domain are clipped to it.
//
// The mathematical library is not correctly rounded. The GNU library documents errors of at most 1 ulp on x86-64 for
// the functions used here except cbrt (4 ulp), so results are widened by 2 (5 for cbrt); sqrt is correctly rounded.
#pragma once

#include <initializer_list>

#include "scalar/interval.h"

namespace millwright::scalar {

namespace rounding {
template <int Steps>
double lowered(double x) {
  for (int i = 0; i < Steps; ++i) x = down(x);
  return x;
}
template <int Steps>
double raised(double x) {
  for (int i = 0; i < Steps; ++i) x = up(x);
  return x;
}
inline Interval library(double lower, double upper) { return {lowered<2>(lower), raised<2>(upper)}; }
/// For results that are never negative.
inline Interval library_from_zero(double lower, double upper) {
  return {larger(lowered<2>(lower), 0.0), raised<2>(upper)};
}
inline constexpr double pi_below = std::numbers::pi;  // the double next to pi lies below it
inline constexpr double pi_above = 0x1.921fb54442d19p+1;

/// Whether the interval may contain offset + k * period for a whole k. Errs on the side of yes.
inline bool may_contain_multiple(const Interval& x, double offset, double period) {
  const double first = (x.lower - offset) / period;
  const double last = (x.upper - offset) / period;
  const double slack = 4e-16 * (std::fabs(first) + std::fabs(last) + 4.0);
  return std::floor(last + slack) >= std::ceil(first - slack);
}
/// Beyond this the position within a period is not resolved; sine and cosine of a range are [-1, 1] there.
inline constexpr double periodic_limit = 1e9;
}  // namespace rounding

template <>
struct Constants<Interval> {
  static Interval pi() { return {rounding::pi_below, rounding::pi_above}; }
  static Interval in_unit(double value, const Dimension&) { return {value, value}; }
};

inline Interval square(const Interval& x) {
  if (x.lower > 0.0) return x * x;
  const double low = mignitude(x);
  const double high = magnitude(x);
  return {larger(rounding::product_down(low, low), 0.0), rounding::product_up(high, high)};
}
inline Interval cube(const Interval& x) {
  if (x.lower > 0.0) return x * x * x;
  using rounding::down;
  using rounding::up;
  const auto low = [](double v) {
    return v >= 0.0 ? rounding::product_down(larger(rounding::product_down(v, v), 0.0), v)
                    : rounding::product_down(rounding::product_up(v, v), v);
  };
  return {low(x.lower), -low(-x.upper)};
}
inline Interval sqrt(const Interval& x) {
  if (x.upper < 0.0) return Interval::entire();
  const double lower = x.lower > 0.0 ? rounding::down(std::sqrt(x.lower)) : 0.0;
  return {lower, x.upper > 0.0 ? rounding::up(std::sqrt(x.upper)) : 0.0};
}
inline Interval cbrt(const Interval& x) {
  const double lower = x.lower == 0.0 ? 0.0 : rounding::lowered<5>(std::cbrt(x.lower));
  return {lower, x.upper == 0.0 ? 0.0 : rounding::raised<5>(std::cbrt(x.upper))};
}
inline Interval exp(const Interval& x) {
  if (x.lower == 0.0 && x.upper == 0.0) return {1.0, 1.0};
  return {larger(rounding::lowered<2>(std::exp(x.lower)), 0.0), rounding::raised<2>(std::exp(x.upper))};
}
inline Interval log(const Interval& x) {
  if (x.upper <= 0.0) return Interval::entire();
  const double lower = x.lower > 0.0 ? rounding::lowered<2>(std::log(x.lower)) : -rounding::infinity;
  return {x.lower == 1.0 ? 0.0 : lower, x.upper == 1.0 ? 0.0 : rounding::raised<2>(std::log(x.upper))};
}

/// Sine (peak at pi/2, trough at -pi/2) and cosine (peak at 0, trough at pi).
template <class Function>
Interval periodic(const Interval& x, double peak, double trough, Function function) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const bool resolved = x.lower >= -rounding::periodic_limit && x.upper <= rounding::periodic_limit;
  if (!x.is_bounded() || (!resolved && !x.is_point()) || x.upper - x.lower >= turn) return {-1.0, 1.0};
  const double a = function(x.lower);
  const double b = x.is_point() ? a : function(x.upper);
  const bool inside = resolved && !x.is_point();
  const bool high = inside && rounding::may_contain_multiple(x, peak, turn);
  const bool low = inside && rounding::may_contain_multiple(x, trough, turn);
  return {low ? -1.0 : larger(rounding::lowered<2>(smaller(a, b)), -1.0),
          high ? 1.0 : smaller(rounding::raised<2>(larger(a, b)), 1.0)};
}
inline Interval sin(const Interval& x) {
  if (x.lower == 0.0 && x.upper == 0.0) return {0.0, 0.0};
  constexpr double quarter = 0.5 * std::numbers::pi;
  return periodic(x, quarter, -quarter, [](double v) { return std::sin(v); });
}
inline Interval cos(const Interval& x) {
  return periodic(x, 0.0, std::numbers::pi, [](double v) { return std::cos(v); });
}
/// The entire line across a pole.
inline Interval tan(const Interval& x) {
  constexpr double half_turn = std::numbers::pi;
  const bool resolved = x.lower >= -rounding::periodic_limit && x.upper <= rounding::periodic_limit;
  if (x.is_point() && x.is_bounded()) {
    if (x.lower == 0.0) return {0.0, 0.0};
    return rounding::library(std::tan(x.lower), std::tan(x.lower));
  }
  if (!resolved || x.upper - x.lower >= half_turn) return Interval::entire();
  if (rounding::may_contain_multiple(x, 0.5 * half_turn, half_turn)) return Interval::entire();
  const double lower = x.lower == 0.0 ? 0.0 : rounding::lowered<2>(std::tan(x.lower));
  return {lower, x.upper == 0.0 ? 0.0 : rounding::raised<2>(std::tan(x.upper))};
}
inline Interval asin(const Interval& x) {
  if (x.upper < -1.0 || x.lower > 1.0) return Interval::entire();
  const double low = larger(x.lower, -1.0);
  const double high = smaller(x.upper, 1.0);
  const double lower = low == 0.0 ? 0.0 : rounding::lowered<2>(std::asin(low));
  return {lower, high == 0.0 ? 0.0 : rounding::raised<2>(std::asin(high))};
}
inline Interval acos(const Interval& x) {
  if (x.upper < -1.0 || x.lower > 1.0) return Interval::entire();
  if (x.lower == 1.0) return {0.0, 0.0};
  return rounding::library_from_zero(std::acos(smaller(x.upper, 1.0)), std::acos(larger(x.lower, -1.0)));
}
inline Interval atan(const Interval& x) {
  const double lower = x.lower == 0.0 ? 0.0 : rounding::lowered<2>(std::atan(x.lower));
  return {lower, x.upper == 0.0 ? 0.0 : rounding::raised<2>(std::atan(x.upper))};
}

inline Interval absolute(const Interval& x) { return {mignitude(x), magnitude(x)}; }
inline Interval floor_of(const Interval& x) { return {std::floor(x.lower), std::floor(x.upper)}; }
inline Interval up_to_whole(const Interval& x, const Interval& unit) {
  if (unit.lower == 1.0 && unit.upper == 1.0) return {std::ceil(x.lower), std::ceil(x.upper)};
  return up_to_whole<Interval>(x, unit);
}
inline Interval smaller(const Interval& a, const Interval& b) {
  return {smaller(a.lower, b.lower), smaller(a.upper, b.upper)};
}
inline Interval larger(const Interval& a, const Interval& b) {
  return {larger(a.lower, b.lower), larger(a.upper, b.upper)};
}

/// Whole exponents take negative bases; for any other exponent the base is clipped at 0.
inline Interval pow(const Interval& x, double exponent) {
  if (exponent == 0.0) return {1.0, 1.0};
  if (exponent == 1.0) return x;
  if (exponent == 2.0) return square(x);
  if (exponent == 0.5) return sqrt(x);
  if (exponent == 4.0) return square(square(x));  // products take a tenth of the time of the library's power
  if (exponent == 3.0 && x.lower > 0.0) return x * square(x);
  if (exponent != exponent) return Interval::entire();
  const bool whole = exponent == std::floor(exponent) && std::fabs(exponent) < rounding::infinity;
  const auto raise = [exponent](double v) { return std::pow(v, exponent); };
  if (whole && exponent < 0.0 && x.lower <= 0.0) return 1.0 / pow(x, -exponent);
  if (whole && x.lower < 0.0) {
    const bool even = std::fmod(exponent, 2.0) == 0.0;
    if (even) return rounding::library_from_zero(raise(mignitude(x)), raise(magnitude(x)));
    const double upper = x.upper == 0.0 ? 0.0 : rounding::raised<2>(raise(x.upper));
    return {rounding::lowered<2>(raise(x.lower)), upper};
  }
  if (x.upper < 0.0) return Interval::entire();
  const double low = larger(x.lower, 0.0) + 0.0;  // never -0, whose powers are infinite with either sign
  if (exponent > 0.0 && x.upper == 0.0) return {0.0, 0.0};
  if (exponent > 0.0) return rounding::library_from_zero(raise(low), raise(x.upper));
  if (x.upper == 0.0) return Interval::entire();
  return rounding::library_from_zero(raise(x.upper), raise(low));
}
inline Interval pow(const Interval& x, const Interval& exponent) {
  if (exponent.is_point()) return pow(x, exponent.lower);
  const bool whole_possible = std::floor(exponent.upper) >= std::ceil(exponent.lower);
  if (x.upper < 0.0 || (x.lower < 0.0 && whole_possible)) return Interval::entire();
  const double low = larger(x.lower, 0.0) + 0.0;  // never -0, whose powers are infinite with either sign
  // exponent * log(x) is bilinear, so the extremes lie in the corners.
  const double corners[] = {std::pow(low, exponent.lower),
                            std::pow(low, exponent.upper),
                            std::pow(x.upper, exponent.lower),
                            std::pow(x.upper, exponent.upper)};
  double least = corners[0];
  double most = corners[0];
  for (const double corner : corners) {
    least = smaller(least, corner);
    most = larger(most, corner);
  }
  return rounding::library_from_zero(least, most);
}

/// On which side of a limit a number lies.
enum class Side { below, above, either };
inline Side side_of(double x, double limit) { return x < limit ? Side::below : Side::above; }
inline Side side_of(const Interval& x, const Interval& limit) {
  if (x.upper < limit.lower) return Side::below;
  return x.lower >= limit.upper ? Side::above : Side::either;
}

template <class Below, class Above>
Interval where_below(const Interval& x, const Interval& limit, const Below& below, const Above& above) {
  switch (side_of(x, limit)) {
    case Side::below:
      return branch_value(below, x);
    case Side::above:
      return branch_value(above, x);
    case Side::either:
      break;
  }
  const Interval lower_part(x.lower, smaller(x.upper, limit.upper));
  const Interval upper_part(larger(x.lower, limit.lower), x.upper);
  return hull(branch_value(below, lower_part), branch_value(above, upper_part));
}
template <class Below, class Above>
Interval step_below(const Interval& x, const Interval& limit, const Below& below, const Above& above) {
  return where_below(x, limit, below, above);
}

}  // namespace millwright::scalar
