// SPDX-License-Identifier: Apache-2.0
//
// The functions a formula may use, for double. Every other scalar offers the same ones, found by argument-dependent
// lookup, so that a formula is one template that calls them unqualified:
//
//     namespace millwright::mechanics::beam {
//     using namespace scalar;
//     template <class T> T section_modulus(const T& diameter) { return pi<T>() * cube(diameter) / 32.0; }
//     }
//
// Rules for formulas: arithmetic among T and with double literals (a literal is dimensionless; a literal 0 fits every
// dimension, so that a sum may start from it). No comparison operators: branches are `smaller`, `larger`,
// `where_below`, `step_below`.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include "scalar/dimension.h"

namespace millwright::scalar {

/// How a scalar represents constants. Specialised by the scalars for which conversion from double is not enough.
template <class T>
struct Constants {
  static T pi() { return T(std::numbers::pi); }
  static T in_unit(double value, const Dimension&) { return T(value); }
};

template <class T>
T pi() {
  return Constants<T>::pi();
}

/// A constant with a dimension, its value in SI: 1 mm is `in_unit<T>(1e-3, dimension::length)`.
template <class T>
T in_unit(double value, const Dimension& dimension) {
  return Constants<T>::in_unit(value, dimension);
}

/// An intermediate result with a symbol of its own. Traced prints it as its own line, every other scalar ignores it.
template <class T>
T named(const char* /*symbol*/, const T& x) {
  return x;
}

// The library's own functions, not wrappers: unqualified calls stay unambiguous where the global names are visible too.
using std::acos;
using std::asin;
using std::atan;
using std::cbrt;
using std::cos;
using std::exp;
using std::log;
using std::sin;
using std::sqrt;
using std::tan;
/// Out of line: compilers replace powers of a constant base or exponent by other functions (clang pow(2, x) by exp2),
/// and the same formula would give other last bits on Traced than on double.
double power_of(double x, double exponent);
template <class X, class Exponent>
requires(std::is_arithmetic_v<X>&& std::is_arithmetic_v<Exponent>) double pow(X x, Exponent exponent) {
  return power_of(static_cast<double>(x), static_cast<double>(exponent));
}
inline double square(double x) { return x * x; }
inline double cube(double x) { return x * x * x; }
inline double absolute(double x) { return std::fabs(x); }
/// The largest whole number not above x.
inline double floor_of(double x) { return std::floor(x); }
/// The lesser of the two, the first of equals; NaN if either is NaN.
inline double smaller(double a, double b) { return b < a || b != b ? b : a; }
/// The greater of the two, the first of equals; NaN if either is NaN.
inline double larger(double a, double b) { return b > a || b != b ? b : a; }

/// The least whole multiple of a unit (above 0) that is not below x. An interval is told without any rounding in units
/// of 1: of equal whole numbers none is taken for a little less than another.
template <class T>
T up_to_whole(const T& x, const T& unit) {
  return -floor_of(-x / unit) * unit;
}

/// One side of a branch: a value, a lambda without argument, or a lambda of x, which a scalar that stands for a range
/// calls with the part of x that lies on this side.
template <class T, class Branch>
auto branch_value(const Branch& branch, const T& x) {
  if constexpr (std::is_invocable_v<const Branch&, const T&>) {
    return branch(x);
  } else if constexpr (std::is_invocable_v<const Branch&>) {
    return branch();
  } else {
    return branch;
  }
}

template <class T, class Branch>
using BranchValue = decltype(branch_value(std::declval<const Branch&>(), std::declval<const T&>()));

/// x < limit ? below : above. Each branch is a value or a lambda (see branch_value). For the scalars that stand for a
/// range both branches count while x may lie on either side; the branches must then meet at the limit, or slopes over
/// the range are wrong: use `step_below` for a function that jumps.
template <class Below, class Above>
auto where_below(double x, double limit, const Below& below, const Above& above)
    -> std::common_type_t<double, BranchValue<double, Below>, BranchValue<double, Above>> {
  if (x < limit) return branch_value(below, x);
  return branch_value(above, x);
}

/// The same for a function that jumps at the limit: slopes over a range that contains the limit are unbounded.
template <class Below, class Above>
auto step_below(double x, double limit, const Below& below, const Above& above) {
  return where_below(x, limit, below, above);
}

}  // namespace millwright::scalar
