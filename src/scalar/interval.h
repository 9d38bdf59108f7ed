// SPDX-License-Identifier: Apache-2.0
//
// Closed intervals, rounded outward: the result of every operation contains the real result for every choice of
// operands from their intervals at which the operation is defined. Bounds may be infinite and are never NaN; an
// operation that is defined nowhere on its operands gives the entire line.
//
// Rounding is by the neighbouring double (the compilers do not honour rounding modes). Operations that are exact (sums
// without rounding error, a factor 0, a power of two) are not widened, so that a bound of 0 stays 0.
// Functions beyond the arithmetic operators are in interval_functions.h, which this header includes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "scalar/elementary.h"

namespace millwright::scalar {

namespace rounding {
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();

/// Whether x -+ |x| * beyond_half_ulp is the neighbour of x: not near the ends of the range of double.
inline bool has_plain_neighbours(double size) { return size > 1e-250 && size <= largest; }
/// A little more than half of the last digit's weight, relative to a number: added to it, it rounds to the next one.
inline constexpr double beyond_half_ulp = 0x1.0000000000001p-53;

[[gnu::noinline]] inline double down_at_the_ends(double x) {
  if (!(x > -infinity)) return -infinity;
  if (x == 0.0) return -std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0.0 ? bits - 1 : bits + 1);
}
[[gnu::noinline]] inline double up_at_the_ends(double x) {
  if (!(x < infinity)) return infinity;
  if (x == 0.0) return std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0.0 ? bits + 1 : bits - 1);
}

/// The next double below x; -infinity for -infinity and NaN.
inline double down(double x) {
  const double size = std::fabs(x);
  if (has_plain_neighbours(size)) [[likely]]
    return x - size * beyond_half_ulp;
  return down_at_the_ends(x);
}
/// The next double above x; infinity for infinity and NaN.
inline double up(double x) {
  const double size = std::fabs(x);
  if (has_plain_neighbours(size)) [[likely]]
    return x + size * beyond_half_ulp;
  return up_at_the_ends(x);
}

/// What the rounding of a + b dropped (Knuth's two-sum); NaN or infinite when the sum overflows.
inline double sum_error(double a, double b, double sum) {
  const double part = sum - a;
  return (a - (sum - part)) + (b - part);
}
/// half an ulp and a bit if the error is below zero, else 0: by its sign bit, because a branch on it cannot be
/// foreseen.
inline double beyond_if_negative(double error) {
  const auto sign = static_cast<std::uint64_t>(std::bit_cast<std::int64_t>(error) >> 63);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(beyond_half_ulp) & sign);
}
/// The error of such a sum is known: nothing on the way to it overflows.
inline bool has_known_error(double size) { return size > 1e-250 && size < 1e300; }
/// A sum without error is not widened; one whose error is unknown is.
inline double sum_down(double a, double b) {
  const double sum = a + b;
  const double error = sum_error(a, b, sum);
  const double size = std::fabs(sum);
  if (has_known_error(size)) [[likely]]
    return sum - size * beyond_if_negative(error);
  return error >= 0.0 && error <= largest ? sum : down(sum);
}
inline double sum_up(double a, double b) {
  const double sum = a + b;
  const double error = sum_error(a, b, sum);
  const double size = std::fabs(sum);
  if (has_known_error(size)) [[likely]]
    return sum + size * beyond_if_negative(0.0 - error);  // 0 - 0 has no sign
  return error <= 0.0 && error >= -largest ? sum : up(sum);
}
/// Products of bounds: 0 times infinity is 0, because an infinite bound stands for arbitrarily large finite numbers.
inline double product_down(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : down(a * b); }
inline double product_up(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : up(a * b); }
/// The quotient of a number by itself is exact: a part that just fits is not taken for one that may not.
inline double quotient_down(double a, double b) { return a == 0.0 ? 0.0 : a == b && b - b == 0.0 ? 1.0 : down(a / b); }
inline double quotient_up(double a, double b) { return a == 0.0 ? 0.0 : a == b && b - b == 0.0 ? 1.0 : up(a / b); }
}  // namespace rounding

/// lower <= upper. Conversion from double is exact.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;

  constexpr Interval() = default;
  constexpr Interval(double x)  // NOLINT(google-explicit-constructor): a number is the interval of its own value
      : Interval(x, x) {}
  constexpr Interval(double l, double u)
      : lower(l == l ? l : -rounding::infinity), upper(u == u ? u : rounding::infinity) {}

  /// Of bounds that are known not to be NaN.
  static constexpr Interval of(double l, double u) {
    Interval result;
    result.lower = l;
    result.upper = u;
    return result;
  }
  static constexpr Interval entire() { return {-rounding::infinity, rounding::infinity}; }
  /// The interval between two numbers in any order.
  static constexpr Interval between(double a, double b) { return a <= b ? Interval(a, b) : Interval(b, a); }

  [[nodiscard]] constexpr bool is_entire() const { return lower == -rounding::infinity && upper == rounding::infinity; }
  [[nodiscard]] constexpr bool is_point() const { return lower == upper; }
  [[nodiscard]] constexpr bool is_bounded() const { return lower > -rounding::infinity && upper < rounding::infinity; }

  Interval& operator+=(const Interval& b);
  Interval& operator-=(const Interval& b);
  Interval& operator*=(const Interval& b);
  Interval& operator/=(const Interval& b);
};

inline bool contains(const Interval& a, double x) { return a.lower <= x && x <= a.upper; }
inline bool contains(const Interval& outer, const Interval& inner) {
  return outer.lower <= inner.lower && inner.upper <= outer.upper;
}
/// The smallest interval that contains both.
inline Interval hull(const Interval& a, const Interval& b) {
  return {a.lower < b.lower ? a.lower : b.lower, a.upper > b.upper ? a.upper : b.upper};
}
/// What both contain; nothing if they are disjoint.
inline std::optional<Interval> intersect(const Interval& a, const Interval& b) {
  const double lower = a.lower > b.lower ? a.lower : b.lower;
  const double upper = a.upper < b.upper ? a.upper : b.upper;
  if (lower > upper) return std::nullopt;
  return Interval(lower, upper);
}
inline double width(const Interval& a) { return rounding::sum_up(a.upper, -a.lower); }
/// A finite number inside the interval, its midpoint if it is bounded.
inline double middle(const Interval& a) {
  if (a.is_bounded()) return smaller(larger(0.5 * a.lower + 0.5 * a.upper, a.lower), a.upper);
  if (a.is_entire()) return 0.0;
  if (a.lower == -rounding::infinity) return a.upper > 0.0 ? 0.0 : larger(2.0 * a.upper - 1.0, -rounding::largest);
  return a.lower < 0.0 ? 0.0 : smaller(2.0 * a.lower + 1.0, rounding::largest);
}
/// The largest absolute value.
inline double magnitude(const Interval& a) { return larger(std::fabs(a.lower), std::fabs(a.upper)); }
/// The smallest absolute value.
inline double mignitude(const Interval& a) { return a.lower > 0.0 ? a.lower : a.upper < 0.0 ? -a.upper : 0.0; }

/// Every number of a is below every number of b.
inline bool certainly_below(const Interval& a, const Interval& b) { return a.upper < b.lower; }
/// Some number of a is below some number of b.
inline bool possibly_below(const Interval& a, const Interval& b) { return a.lower < b.upper; }

inline Interval operator+(const Interval& a) { return a; }
inline Interval operator-(const Interval& a) { return Interval::of(-a.upper, -a.lower); }
// Left to itself the compiler calls these operators; inlined, a search (the front of the router) is a twentieth
// faster and the program a hundredth larger.

/// Where a sum is near the ends of the range of double, or 0.
[[gnu::noinline]] inline Interval sum_of_any_size(const Interval& a, const Interval& b) {
  return Interval::of(rounding::sum_down(a.lower, b.lower), rounding::sum_up(a.upper, b.upper));
}
[[gnu::always_inline]] inline Interval operator+(const Interval& a, const Interval& b) {
  const double lower = a.lower + b.lower;
  const double upper = a.upper + b.upper;
  const double low_size = std::fabs(lower);
  const double high_size = std::fabs(upper);
  if (rounding::has_known_error(low_size) && rounding::has_known_error(high_size)) [[likely]] {
    return Interval::of(
        lower - low_size * rounding::beyond_if_negative(rounding::sum_error(a.lower, b.lower, lower)),
        upper + high_size * rounding::beyond_if_negative(0.0 - rounding::sum_error(a.upper, b.upper, upper)));
  }
  return sum_of_any_size(a, b);
}
[[gnu::always_inline]] inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

/// Where a factor may be negative, or the product is near the ends of the range of double.
[[gnu::noinline]] inline Interval product_of_any_sign(const Interval& a, const Interval& b) {
  using rounding::product_down;
  using rounding::product_up;
  if (a.lower >= 0.0) {
    if (b.lower >= 0.0) return {product_down(a.lower, b.lower), product_up(a.upper, b.upper)};
    if (b.upper <= 0.0) return {product_down(a.upper, b.lower), product_up(a.lower, b.upper)};
    return {product_down(a.upper, b.lower), product_up(a.upper, b.upper)};
  }
  if (a.upper <= 0.0) {
    if (b.lower >= 0.0) return {product_down(a.lower, b.upper), product_up(a.upper, b.lower)};
    if (b.upper <= 0.0) return {product_down(a.upper, b.upper), product_up(a.lower, b.lower)};
    return {product_down(a.lower, b.upper), product_up(a.lower, b.lower)};
  }
  if (b.lower >= 0.0) return {product_down(a.lower, b.upper), product_up(a.upper, b.upper)};
  if (b.upper <= 0.0) return {product_down(a.upper, b.lower), product_up(a.lower, b.lower)};
  return {smaller(product_down(a.lower, b.upper), product_down(a.upper, b.lower)),
          larger(product_up(a.lower, b.lower), product_up(a.upper, b.upper))};
}
[[gnu::always_inline]] inline Interval operator*(const Interval& a, const Interval& b) {
  if (a.lower > 0.0 && b.lower > 0.0) [[likely]] {
    const double lower = a.lower * b.lower;
    const double upper = a.upper * b.upper;
    if (rounding::has_plain_neighbours(lower) && upper <= rounding::largest) [[likely]] {
      return Interval::of(lower - lower * rounding::beyond_half_ulp, upper + upper * rounding::beyond_half_ulp);
    }
  }
  return product_of_any_sign(a, b);
}

/// Exact for a power of two as long as nothing overflows or becomes subnormal.
[[gnu::noinline]] inline Interval product_with_any_number(const Interval& a, double b) {
  const bool power_of_two = (std::bit_cast<std::uint64_t>(b) & 0x000fffffffffffffULL) == 0;
  if (power_of_two) {
    const auto exact = [](double product, double factor) {
      const double size = std::fabs(product);
      return factor == 0.0 || (size >= std::numeric_limits<double>::min() && size <= rounding::largest);
    };
    const double first = a.lower * b;
    const double second = a.upper * b;
    if (exact(first, a.lower) && exact(second, a.upper) && b != 0.0) return Interval::between(first, second);
  }
  return a * Interval(b);
}
[[gnu::always_inline]] inline Interval operator*(const Interval& a, double b) {
  const bool power_of_two = (std::bit_cast<std::uint64_t>(b) & 0x000fffffffffffffULL) == 0;
  if (a.lower > 0.0 && b > 0.0 && !power_of_two) [[likely]]
    return a * Interval::of(b, b);
  return product_with_any_number(a, b);
}
inline Interval operator*(double a, const Interval& b) { return b * a; }

/// By an interval with 0 inside: the entire line; with 0 at its end: a half line, if the dividend keeps its sign.
[[gnu::noinline]] inline Interval quotient_of_any_sign(const Interval& a, const Interval& b) {
  using rounding::quotient_down;
  using rounding::quotient_up;
  if (b.lower > 0.0) {
    return {quotient_down(a.lower, a.lower >= 0.0 ? b.upper : b.lower),
            quotient_up(a.upper, a.upper >= 0.0 ? b.lower : b.upper)};
  }
  if (b.upper < 0.0) {
    return {quotient_down(a.upper, a.upper >= 0.0 ? b.upper : b.lower),
            quotient_up(a.lower, a.lower >= 0.0 ? b.lower : b.upper)};
  }
  if ((b.lower < 0.0 && b.upper > 0.0) || b.lower == b.upper) return Interval::entire();
  const bool positive = b.upper > 0.0;
  const double end = positive ? b.upper : b.lower;
  if (a.lower >= 0.0) {
    return positive ? Interval(quotient_down(a.lower, end), rounding::infinity)
                    : Interval(-rounding::infinity, quotient_up(a.lower, end));
  }
  if (a.upper <= 0.0) {
    return positive ? Interval(-rounding::infinity, quotient_up(a.upper, end))
                    : Interval(quotient_down(a.upper, end), rounding::infinity);
  }
  return Interval::entire();
}
[[gnu::always_inline]] inline Interval operator/(const Interval& a, const Interval& b) {
  if (a.lower > 0.0 && b.lower > 0.0) [[likely]] {
    const double lower = a.lower / b.upper;
    const double upper = a.upper / b.lower;
    // Quotients of equal numbers are exact.
    if (rounding::has_plain_neighbours(lower) && upper <= rounding::largest && a.lower != b.upper && a.upper != b.lower)
        [[likely]] {
      return Interval::of(lower - lower * rounding::beyond_half_ulp, upper + upper * rounding::beyond_half_ulp);
    }
  }
  return quotient_of_any_sign(a, b);
}
inline Interval operator/(const Interval& a, double b) {
  const bool power_of_two = (std::bit_cast<std::uint64_t>(b) & 0x000fffffffffffffULL) == 0;
  const double size = std::fabs(b);
  if (power_of_two && size > 1e-300 && size < 1e300) return a * (1.0 / b);
  return a / Interval(b);
}

inline Interval& Interval::operator+=(const Interval& b) { return *this = *this + b; }
inline Interval& Interval::operator-=(const Interval& b) { return *this = *this - b; }
inline Interval& Interval::operator*=(const Interval& b) { return *this = *this * b; }
inline Interval& Interval::operator/=(const Interval& b) { return *this = *this / b; }

}  // namespace millwright::scalar

#include "scalar/interval_functions.h"  // IWYU pragma: export
