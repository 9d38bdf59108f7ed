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

// Nothing here is hot, and every formula is compiled for this scalar too: out of line, the compiler is done sooner.

/// The dimension two numbers share. Throws DimensionError if they do not.
Dimension shared_dimension(const char* operation, const Dimensioned& a, const Dimensioned& b);
Dimensioned sharing(const char* operation, double value, const Dimensioned& a, const Dimensioned& b);
Dimensioned operator+(const Dimensioned& a);
Dimensioned operator-(const Dimensioned& a);
Dimensioned operator+(const Dimensioned& a, const Dimensioned& b);
Dimensioned operator-(const Dimensioned& a, const Dimensioned& b);
Dimensioned operator*(const Dimensioned& a, const Dimensioned& b);
Dimensioned operator/(const Dimensioned& a, const Dimensioned& b);
Dimensioned square(const Dimensioned& x);
Dimensioned cube(const Dimensioned& x);
Dimensioned sqrt(const Dimensioned& x);
Dimensioned cbrt(const Dimensioned& x);
Dimensioned pow(const Dimensioned& x, double exponent);
/// Both dimensionless: the dimension of a result must not depend on a value.
Dimensioned pow(const Dimensioned& x, const Dimensioned& exponent);
Dimensioned exp(const Dimensioned& x);
Dimensioned log(const Dimensioned& x);
Dimensioned sin(const Dimensioned& x);
Dimensioned cos(const Dimensioned& x);
Dimensioned tan(const Dimensioned& x);
Dimensioned asin(const Dimensioned& x);
Dimensioned acos(const Dimensioned& x);
Dimensioned atan(const Dimensioned& x);
/// Whole numbers are counts: rounding a length down would depend on the unit.
Dimensioned floor_of(const Dimensioned& x);
Dimensioned absolute(const Dimensioned& x);
Dimensioned smaller(const Dimensioned& a, const Dimensioned& b);
Dimensioned larger(const Dimensioned& a, const Dimensioned& b);

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
