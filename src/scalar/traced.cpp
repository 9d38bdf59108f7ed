// SPDX-License-Identifier: Apache-2.0
#include "scalar/traced.h"

#include "scalar/expression.h"

namespace millwright::scalar {
namespace {

using Kind = Expression::Kind;

ExpressionPointer pointer_to(const Traced& x) {
  if (x.expression() != nullptr) return x.expression();
  return std::make_shared<const Expression>(Expression{Kind::number, x.value, x.dimension, "", Unit(), {}});
}

Traced node(Kind kind,
            double value,
            const Dimension& dimension,
            std::string symbol,
            std::initializer_list<const Traced*> operands) {
  Expression expression{kind, value, dimension, std::move(symbol), Unit(), {}};
  expression.operands.reserve(operands.size());
  for (const Traced* operand : operands) expression.operands.push_back(pointer_to(*operand));
  return {value, dimension, std::make_shared<const Expression>(std::move(expression))};
}

Traced function(const char* symbol, double value, const Dimension& dimension, const Traced& x) {
  if (x.expression() == nullptr) return Traced(value);
  return node(Kind::function, value, dimension, symbol, {&x});
}

bool is_literal(const Traced& x) { return x.expression() == nullptr; }
bool is_zero_literal(const Traced& x) { return is_literal(x) && x.value == 0.0; }

/// The literal 0 has no dimension of its own (see Dimensioned).
const Dimension& shared_dimension(const Traced& a, const Traced& b) {
  return is_zero_literal(a) ? b.dimension : a.dimension;
}

/// The same number under a new value: what 0 + x is.
Traced revalued(double value, const Traced& x) { return {value, x.dimension, x.expression()}; }

}  // namespace

Traced::Traced(double v, const Dimension& d, std::shared_ptr<const Expression> expression)
    : value(v), dimension(d), expression_(std::move(expression)) {}
Traced::Traced(const Traced& other) = default;
Traced::Traced(Traced&& other) noexcept = default;
Traced& Traced::operator=(const Traced& other) = default;
Traced& Traced::operator=(Traced&& other) noexcept = default;
Traced::~Traced() = default;

Traced Traced::leaf(std::string symbol, double value, const Dimension& dimension, const Unit& display) {
  const Unit unit = display.dimension() == dimension ? display : readable_unit(dimension, value);
  return {value,
          dimension,
          std::make_shared<const Expression>(Expression{Kind::leaf, value, dimension, std::move(symbol), unit, {}})};
}
Traced Traced::leaf(std::string symbol, double value, const Unit& display) {
  return leaf(std::move(symbol), value, display.dimension(), display);
}

Traced& Traced::operator+=(const Traced& b) { return *this = *this + b; }
Traced& Traced::operator-=(const Traced& b) { return *this = *this - b; }
Traced& Traced::operator*=(const Traced& b) { return *this = *this * b; }
Traced& Traced::operator/=(const Traced& b) { return *this = *this / b; }

Traced operator+(const Traced& a) { return a; }
Traced operator-(const Traced& a) {
  if (is_literal(a)) return Traced(-a.value);
  return node(Kind::negate, -a.value, a.dimension, "", {&a});
}
Traced operator+(const Traced& a, const Traced& b) {
  const double sum = a.value + b.value;
  if (is_zero_literal(a)) return revalued(sum, b);
  if (is_zero_literal(b)) return revalued(sum, a);
  if (is_literal(a) && is_literal(b)) return Traced(sum);
  return node(Kind::add, sum, shared_dimension(a, b), "", {&a, &b});
}
Traced operator-(const Traced& a, const Traced& b) {
  const double difference = a.value - b.value;
  if (is_zero_literal(b)) return revalued(difference, a);
  if (is_literal(a) && is_literal(b)) return Traced(difference);
  return node(Kind::subtract, difference, shared_dimension(a, b), "", {&a, &b});
}
Traced operator*(const Traced& a, const Traced& b) {
  const double product = a.value * b.value;
  if (is_literal(a) && is_literal(b)) return Traced(product);
  return node(Kind::multiply, product, a.dimension * b.dimension, "", {&a, &b});
}
Traced operator/(const Traced& a, const Traced& b) {
  const double ratio = a.value / b.value;
  if (is_literal(a) && is_literal(b)) return Traced(ratio);
  return node(Kind::divide, ratio, a.dimension / b.dimension, "", {&a, &b});
}

Traced sqrt(const Traced& x) { return function("√", sqrt(x.value), power(x.dimension, 0.5), x); }
Traced cbrt(const Traced& x) { return function("∛", cbrt(x.value), power(x.dimension, 1.0 / 3.0), x); }
Traced exp(const Traced& x) { return function("exp", exp(x.value), dimension::none, x); }
Traced log(const Traced& x) { return function("ln", log(x.value), dimension::none, x); }
Traced sin(const Traced& x) { return function("sin", sin(x.value), dimension::none, x); }
Traced cos(const Traced& x) { return function("cos", cos(x.value), dimension::none, x); }
Traced tan(const Traced& x) { return function("tan", tan(x.value), dimension::none, x); }
Traced asin(const Traced& x) { return function("asin", asin(x.value), dimension::none, x); }
Traced acos(const Traced& x) { return function("acos", acos(x.value), dimension::none, x); }
Traced atan(const Traced& x) { return function("atan", atan(x.value), dimension::none, x); }
Traced absolute(const Traced& x) { return function("|", absolute(x.value), x.dimension, x); }
Traced floor_of(const Traced& x) { return function("⌊", floor_of(x.value), x.dimension, x); }

Traced square(const Traced& x) {
  const Traced two = 2.0;
  if (is_literal(x)) return Traced(square(x.value));
  return node(Kind::power, square(x.value), power(x.dimension, 2.0), "", {&x, &two});
}
Traced cube(const Traced& x) {
  const Traced three = 3.0;
  if (is_literal(x)) return Traced(cube(x.value));
  return node(Kind::power, cube(x.value), power(x.dimension, 3.0), "", {&x, &three});
}
Traced pow(const Traced& x, double exponent) {
  const Traced exponent_literal = exponent;
  const double value = pow(x.value, exponent);
  if (is_literal(x)) return Traced(value);
  return node(Kind::power, value, power(x.dimension, exponent), "", {&x, &exponent_literal});
}
Traced pow(const Traced& x, const Traced& exponent) {
  if (is_literal(exponent)) return pow(x, exponent.value);
  const double value = pow(x.value, exponent.value);
  return node(Kind::power, value, power(x.dimension, exponent.value), "", {&x, &exponent});
}
Traced smaller(const Traced& a, const Traced& b) {
  const double least = smaller(a.value, b.value);
  if (is_literal(a) && is_literal(b)) return Traced(least);
  return node(Kind::function, least, shared_dimension(a, b), "min", {&a, &b});
}
Traced larger(const Traced& a, const Traced& b) {
  const double most = larger(a.value, b.value);
  if (is_literal(a) && is_literal(b)) return Traced(most);
  return node(Kind::function, most, shared_dimension(a, b), "max", {&a, &b});
}

Traced named(const char* symbol, const Traced& x) { return node(Kind::named, x.value, x.dimension, symbol, {&x}); }

Traced Constants<Traced>::pi() { return node(Kind::constant, std::numbers::pi, dimension::none, "π", {}); }
Traced Constants<Traced>::in_unit(double value, const Dimension& dimension) {
  const Unit unit = readable_unit(dimension, value);
  return {
      value, dimension, std::make_shared<const Expression>(Expression{Kind::quantity, value, dimension, "", unit, {}})};
}

}  // namespace millwright::scalar
