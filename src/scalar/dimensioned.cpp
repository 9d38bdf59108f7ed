// SPDX-License-Identifier: Apache-2.0
#include "scalar/dimensioned.h"

#include <fmt/format.h>

namespace millwright::scalar {
namespace {

[[noreturn]] void throw_mismatch(const char* operation, const Dimension& a, const Dimension& b) {
  throw DimensionError(fmt::format("{} {} and {}", operation, to_string(a), to_string(b)));
}

[[noreturn]] void throw_not_dimensionless(const char* function, const Dimension& a) {
  throw DimensionError(fmt::format("{} of {}, where a dimensionless number is needed", function, to_string(a)));
}

double dimensionless(const char* function, const Dimensioned& x) {
  if (!(x.dimension == dimension::none)) throw_not_dimensionless(function, x.dimension);
  return x.value;
}

}  // namespace

Dimension shared_dimension(const char* operation, const Dimensioned& a, const Dimensioned& b) {
  if (a.zero_literal) return b.dimension;
  if (!b.zero_literal && !(a.dimension == b.dimension)) throw_mismatch(operation, a.dimension, b.dimension);
  return a.dimension;
}
Dimensioned sharing(const char* operation, double value, const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(value, shared_dimension(operation, a, b));
  result.zero_literal = a.zero_literal && b.zero_literal && value == 0.0;
  return result;
}

Dimensioned operator+(const Dimensioned& a) { return a; }
Dimensioned operator-(const Dimensioned& a) {
  Dimensioned result = a;
  result.value = -a.value;
  return result;
}
Dimensioned operator+(const Dimensioned& a, const Dimensioned& b) {
  return sharing("a sum of", a.value + b.value, a, b);
}
Dimensioned operator-(const Dimensioned& a, const Dimensioned& b) {
  return sharing("a difference of", a.value - b.value, a, b);
}
Dimensioned operator*(const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(a.value * b.value, a.dimension * b.dimension);
  result.zero_literal = a.zero_literal || b.zero_literal;
  return result;
}
Dimensioned operator/(const Dimensioned& a, const Dimensioned& b) {
  Dimensioned result(a.value / b.value, a.dimension / b.dimension);
  result.zero_literal = a.zero_literal;
  return result;
}
Dimensioned& Dimensioned::operator+=(const Dimensioned& b) { return *this = *this + b; }
Dimensioned& Dimensioned::operator-=(const Dimensioned& b) { return *this = *this - b; }
Dimensioned& Dimensioned::operator*=(const Dimensioned& b) { return *this = *this * b; }
Dimensioned& Dimensioned::operator/=(const Dimensioned& b) { return *this = *this / b; }
Dimensioned square(const Dimensioned& x) { return {square(x.value), power(x.dimension, 2.0)}; }
Dimensioned cube(const Dimensioned& x) { return {cube(x.value), power(x.dimension, 3.0)}; }
Dimensioned sqrt(const Dimensioned& x) { return {sqrt(x.value), power(x.dimension, 0.5)}; }
Dimensioned cbrt(const Dimensioned& x) { return {cbrt(x.value), power(x.dimension, 1.0 / 3.0)}; }
Dimensioned pow(const Dimensioned& x, double exponent) {
  return {pow(x.value, exponent), power(x.dimension, exponent)};
}
Dimensioned pow(const Dimensioned& x, const Dimensioned& exponent) {
  return pow(dimensionless("the base of a variable power", x), dimensionless("an exponent", exponent));
}
Dimensioned exp(const Dimensioned& x) { return {exp(dimensionless("exp", x)), dimension::none}; }
Dimensioned log(const Dimensioned& x) { return {log(dimensionless("log", x)), dimension::none}; }
Dimensioned sin(const Dimensioned& x) { return {sin(dimensionless("sin", x)), dimension::none}; }
Dimensioned cos(const Dimensioned& x) { return {cos(dimensionless("cos", x)), dimension::none}; }
Dimensioned tan(const Dimensioned& x) { return {tan(dimensionless("tan", x)), dimension::none}; }
Dimensioned asin(const Dimensioned& x) { return {asin(dimensionless("asin", x)), dimension::none}; }
Dimensioned acos(const Dimensioned& x) { return {acos(dimensionless("acos", x)), dimension::none}; }
Dimensioned atan(const Dimensioned& x) { return {atan(dimensionless("atan", x)), dimension::none}; }
Dimensioned floor_of(const Dimensioned& x) { return {floor_of(dimensionless("floor_of", x)), dimension::none}; }
Dimensioned absolute(const Dimensioned& x) { return {absolute(x.value), x.dimension}; }
Dimensioned smaller(const Dimensioned& a, const Dimensioned& b) {
  return sharing("the smaller of", smaller(a.value, b.value), a, b);
}
Dimensioned larger(const Dimensioned& a, const Dimensioned& b) {
  return sharing("the larger of", larger(a.value, b.value), a, b);
}

}  // namespace millwright::scalar
