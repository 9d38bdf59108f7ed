// SPDX-License-Identifier: Apache-2.0
//
// A number that knows its dimension and refuses to be added to, compared with, or fed to a function that wants another.
#pragma once

#include "scalar/elementary.h"

namespace millwright::scalar {

/// Value in SI and its dimension. A literal is dimensionless; the literal 0 fits every dimension.
struct Dimensioned {
  double value = 0.0;
  Dimension dimension;
  bool zero_literal = false;  ///< a 0 written in a formula, as the start of a sum or as a limit

  Dimensioned() : zero_literal(true) {}
  Dimensioned(double literal)  // NOLINT(google-explicit-constructor): formulas mix with literals
      : value(literal), zero_literal(literal == 0.0) {}
  Dimensioned(double v, const Dimension& d) : value(v), dimension(d) {}

  Dimensioned& operator+=(const Dimensioned& b);
  Dimensioned& operator-=(const Dimensioned& b);
  Dimensioned& operator*=(const Dimensioned& b);
  Dimensioned& operator/=(const Dimensioned& b);
};

/// "a sum of N·m and m" and the like. Defined in dimension.cpp, to keep the text out of the hot headers.
[[noreturn]] void throw_mismatch(const char* operation, const Dimension& a, const Dimension& b);
[[noreturn]] void throw_not_dimensionless(const char* function, const Dimension& a);

/// The dimension two numbers share. Throws DimensionError if they do not.
inline Dimension shared_dimension(const char* operation, const Dimensioned& a, const Dimensioned& b) {
  if (a.zero_literal) return b.dimension;
  if (!b.zero_literal && !(a.dimension == b.dimension)) throw_mismatch(operation, a.dimension, b.dimension);
  return a.dimension;
}
inline Dimensioned sharing(const char* operation, double value, const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(value, shared_dimension(operation, a, b));
  result.zero_literal = a.zero_literal && b.zero_literal && value == 0.0;
  return result;
}
inline double dimensionless(const char* function, const Dimensioned& x) {
  if (!(x.dimension == dimension::none)) throw_not_dimensionless(function, x.dimension);
  return x.value;
}

inline Dimensioned operator+(const Dimensioned& a) { return a; }
inline Dimensioned operator-(const Dimensioned& a) {
  Dimensioned result = a;
  result.value = -a.value;
  return result;
}
inline Dimensioned operator+(const Dimensioned& a, const Dimensioned& b) {
  return sharing("a sum of", a.value + b.value, a, b);
}
inline Dimensioned operator-(const Dimensioned& a, const Dimensioned& b) {
  return sharing("a difference of", a.value - b.value, a, b);
}
inline Dimensioned operator*(const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(a.value * b.value, a.dimension * b.dimension);
  result.zero_literal = a.zero_literal || b.zero_literal;
  return result;
}
inline Dimensioned operator/(const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(a.value / b.value, a.dimension / b.dimension);
  result.zero_literal = a.zero_literal;
  return result;
}
inline Dimensioned& Dimensioned::operator+=(const Dimensioned& b) { return *this = *this + b; }
inline Dimensioned& Dimensioned::operator-=(const Dimensioned& b) { return *this = *this - b; }
inline Dimensioned& Dimensioned::operator*=(const Dimensioned& b) { return *this = *this * b; }
inline Dimensioned& Dimensioned::operator/=(const Dimensioned& b) { return *this = *this / b; }

inline Dimensioned square(const Dimensioned& x) { return {square(x.value), power(x.dimension, 2.0)}; }
inline Dimensioned cube(const Dimensioned& x) { return {cube(x.value), power(x.dimension, 3.0)}; }
inline Dimensioned sqrt(const Dimensioned& x) { return {sqrt(x.value), power(x.dimension, 0.5)}; }
inline Dimensioned cbrt(const Dimensioned& x) { return {cbrt(x.value), power(x.dimension, 1.0 / 3.0)}; }
inline Dimensioned pow(const Dimensioned& x, double exponent) {
  return {pow(x.value, exponent), power(x.dimension, exponent)};
}
/// Both dimensionless: the dimension of a result must not depend on a value.
inline Dimensioned pow(const Dimensioned& x, const Dimensioned& exponent) {
  return pow(dimensionless("the base of a variable power", x), dimensionless("an exponent", exponent));
}
inline Dimensioned exp(const Dimensioned& x) { return {exp(dimensionless("exp", x)), dimension::none}; }
inline Dimensioned log(const Dimensioned& x) { return {log(dimensionless("log", x)), dimension::none}; }
inline Dimensioned sin(const Dimensioned& x) { return {sin(dimensionless("sin", x)), dimension::none}; }
inline Dimensioned cos(const Dimensioned& x) { return {cos(dimensionless("cos", x)), dimension::none}; }
inline Dimensioned tan(const Dimensioned& x) { return {tan(dimensionless("tan", x)), dimension::none}; }
inline Dimensioned asin(const Dimensioned& x) { return {asin(dimensionless("asin", x)), dimension::none}; }
inline Dimensioned acos(const Dimensioned& x) { return {acos(dimensionless("acos", x)), dimension::none}; }
inline Dimensioned atan(const Dimensioned& x) { return {atan(dimensionless("atan", x)), dimension::none}; }
/// Whole numbers are counts: rounding a length down would depend on the unit.
inline Dimensioned floor_of(const Dimensioned& x) { return {floor_of(dimensionless("floor_of", x)), dimension::none}; }
inline Dimensioned absolute(const Dimensioned& x) { return {absolute(x.value), x.dimension}; }
inline Dimensioned smaller(const Dimensioned& a, const Dimensioned& b) {
  return sharing("the smaller of", smaller(a.value, b.value), a, b);
}
inline Dimensioned larger(const Dimensioned& a, const Dimensioned& b) {
  return sharing("the larger of", larger(a.value, b.value), a, b);
}
/// Both branches are evaluated, so that both have their dimensions checked.
template <class Below, class Above>
Dimensioned where_below(const Dimensioned& x, const Dimensioned& limit, const Below& below, const Above& above) {
  static_cast<void>(shared_dimension("a comparison of", x, limit));
  const Dimensioned low = branch_value(below, x);
  const Dimensioned high = branch_value(above, x);
  return sharing("branches in", x.value < limit.value ? low.value : high.value, low, high);
}
template <class Below, class Above>
Dimensioned step_below(const Dimensioned& x, const Dimensioned& limit, const Below& below, const Above& above) {
  return where_below(x, limit, below, above);
}

template <>
struct Constants<Dimensioned> {
  static Dimensioned pi() { return {std::numbers::pi, dimension::angular}; }
  static Dimensioned in_unit(double value, const Dimension& dimension) { return {value, dimension}; }
};

}  // namespace millwright::scalar
