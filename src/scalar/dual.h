// SPDX-License-Identifier: Apache-2.0
//
// Forward differentiation: a value with its slopes with respect to N variables.
//
// B is double (values and exact derivatives), Interval (the range of both over a box), or Dual itself (second
// derivatives). A slope of exactly 0 stays 0 whatever it is multiplied with: a variable that is not involved gives no
// NaN where another one meets a pole. For B = Interval a slope that is undefined is the entire line.
#pragma once

#include <array>

#include "scalar/interval.h"

namespace millwright::scalar {

template <class B = double, int N = 1>
struct Dual;

/// Scalars that stand for a range of values, so that a branch may go either way.
template <class B>
concept Enclosing = std::is_constructible_v<B, Interval>;

namespace slopes {
inline double product(double slope, double factor) { return slope == 0.0 ? 0.0 : slope * factor; }
/// Slopes of 0 and 1, those of constants and variables, are not widened by rounding.
template <class Factor>
Interval product(const Interval& slope, const Factor& factor) {
  if (slope.is_point() && slope.lower == 1.0) return factor;
  return slope * factor;
}
template <class B, int N, class Factor>
Dual<B, N> product(const Dual<B, N>& slope, const Factor& factor) {
  return slope * factor;
}
inline double part_from_zero(double x) { return x; }
inline Interval part_from_zero(const Interval& x) { return larger(x, Interval(0.0)); }
template <class B, int N>
Dual<B, N> part_from_zero(const Dual<B, N>& x) {
  return x;
}
/// 1 + tan², without pretending to be positive across a pole, where the tangent jumps.
inline double of_tangent(double t) { return 1.0 + t * t; }
inline Interval of_tangent(const Interval& t) { return t.is_entire() ? t : 1.0 + square(t); }
template <class B, int N>
Dual<B, N> of_tangent(const Dual<B, N>& t) {
  return 1.0 + square(t);
}
inline double of_absolute(double x) { return x < 0.0 ? -1.0 : 1.0; }
inline Interval of_absolute(const Interval& x) {
  return {x.lower < 0.0 ? -1.0 : 1.0, x.upper > 0.0 || x.lower >= 0.0 ? 1.0 : -1.0};
}
template <class B, int N>
Dual<B, N> of_absolute(const Dual<B, N>& x) {
  return of_absolute(x.value);
}
inline double of_floor(double) { return 0.0; }
inline Interval of_floor(const Interval& x) {
  return {0.0, std::floor(x.lower) == std::floor(x.upper) ? 0.0 : rounding::infinity};
}
template <class B, int N>
Dual<B, N> of_floor(const Dual<B, N>& x) {
  return of_floor(x.value);
}
}  // namespace slopes

template <class B, int N>
struct Dual {
  using Slopes = std::array<B, N>;
  B value{};
  Slopes slope{};

  constexpr Dual() = default;
  template <class Number>
  requires std::is_convertible_v<Number, B>
  constexpr Dual(const Number& constant)  // NOLINT(google-explicit-constructor): a constant has slope 0
      : value(constant) {}
  constexpr Dual(const B& v, const Slopes& s) : value(v), slope(s) {}

  /// The variable with number `index`: slope 1 with respect to itself.
  static constexpr Dual variable(const B& at, int index) {
    Dual x(at);
    x.slope[static_cast<std::size_t>(index)] = B(1.0);
    return x;
  }

  /// A function of this number: its value and its derivative here.
  [[nodiscard]] Dual chain(const B& function, const B& derivative) const {
    Dual result(function);
    for (std::size_t i = 0; i < slope.size(); ++i) result.slope[i] = slopes::product(slope[i], derivative);
    return result;
  }

  friend Dual operator+(const Dual& a) { return a; }
  friend Dual operator-(const Dual& a) {
    Dual result(-a.value);
    for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = -a.slope[i];
    return result;
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual result(a.value + b.value);
    for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = a.slope[i] + b.slope[i];
    return result;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual result(a.value - b.value);
    for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = a.slope[i] - b.slope[i];
    return result;
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual result(a.value * b.value);
    for (std::size_t i = 0; i < a.slope.size(); ++i) {
      result.slope[i] = slopes::product(a.slope[i], b.value) + slopes::product(b.slope[i], a.value);
    }
    return result;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual result(a.value / b.value);
    for (std::size_t i = 0; i < a.slope.size(); ++i) {
      result.slope[i] = quotient(a.slope[i] - slopes::product(b.slope[i], result.value), b.value);
    }
    return result;
  }
  friend Dual operator+(const Dual& a, double b) { return {a.value + b, a.slope}; }
  friend Dual operator+(double a, const Dual& b) { return {a + b.value, b.slope}; }
  friend Dual operator-(const Dual& a, double b) { return {a.value - b, a.slope}; }
  friend Dual operator-(double a, const Dual& b) { return a + (-b); }
  friend Dual operator*(const Dual& a, double b) {
    Dual result(a.value * b);
    for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = slopes::product(a.slope[i], b);
    return result;
  }
  friend Dual operator*(double a, const Dual& b) { return b * a; }
  friend Dual operator/(const Dual& a, double b) {
    Dual result(a.value / b);
    for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = quotient(a.slope[i], B(b));
    return result;
  }
  friend Dual operator/(double a, const Dual& b) {
    const B ratio = a / b.value;
    return b.chain(ratio, -ratio / b.value);
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual square(const Dual& x) { return x.chain(square(x.value), 2.0 * x.value); }
  friend Dual cube(const Dual& x) { return x.chain(cube(x.value), 3.0 * square(x.value)); }
  friend Dual sqrt(const Dual& x) {
    const B root = sqrt(x.value);
    return x.chain(root, 0.5 / root);
  }
  friend Dual cbrt(const Dual& x) {
    const B root = cbrt(x.value);
    return x.chain(root, 1.0 / (3.0 * square(root)));
  }
  friend Dual exp(const Dual& x) {
    const B y = exp(x.value);
    return x.chain(y, y);
  }
  friend Dual log(const Dual& x) { return x.chain(log(x.value), 1.0 / slopes::part_from_zero(x.value)); }
  friend Dual sin(const Dual& x) { return x.chain(sin(x.value), cos(x.value)); }
  friend Dual cos(const Dual& x) { return x.chain(cos(x.value), -sin(x.value)); }
  friend Dual tan(const Dual& x) {
    const B y = tan(x.value);
    return x.chain(y, slopes::of_tangent(y));
  }
  friend Dual asin(const Dual& x) { return x.chain(asin(x.value), 1.0 / sqrt(1.0 - square(x.value))); }
  friend Dual acos(const Dual& x) { return x.chain(acos(x.value), -1.0 / sqrt(1.0 - square(x.value))); }
  friend Dual atan(const Dual& x) { return x.chain(atan(x.value), 1.0 / (1.0 + square(x.value))); }
  /// At 0 the slope from above is taken.
  friend Dual absolute(const Dual& x) { return x.chain(absolute(x.value), slopes::of_absolute(x.value)); }
  /// The slope is 0, and over a range with a step in it any slope upwards.
  friend Dual floor_of(const Dual& x) { return x.chain(floor_of(x.value), slopes::of_floor(x.value)); }

  friend Dual pow(const Dual& x, double exponent) {
    if (exponent == 0.0) return Dual(pow(x.value, exponent));
    if (exponent == 1.0) return x;
    return x.chain(pow(x.value, exponent), exponent * pow(x.value, exponent - 1.0));
  }
  friend Dual pow(const Dual& x, const Dual& exponent) {
    const B y = pow(x.value, exponent.value);
    const B by_base = exponent.value * pow(x.value, exponent.value - 1.0);
    const B by_exponent = growth(y, x.value);
    Dual result(y);
    for (std::size_t i = 0; i < x.slope.size(); ++i) {
      result.slope[i] = slopes::product(x.slope[i], by_base) + slopes::product(exponent.slope[i], by_exponent);
    }
    return result;
  }

  /// Of equals the first, with its slopes.
  friend Dual smaller(const Dual& a, const Dual& b) {
    const Side side = side_of(b, a);
    if (side == Side::below) return b;
    return side == Side::above ? a : either(smaller(a.value, b.value), a, b);
  }
  friend Dual larger(const Dual& a, const Dual& b) {
    const Side side = side_of(a, b);
    if (side == Side::below) return b;
    return side == Side::above ? a : either(larger(a.value, b.value), a, b);
  }
  /// At the limit itself the branch above is taken.
  template <class Below, class Above>
  friend Dual where_below(const Dual& x, const Dual& limit, const Below& below, const Above& above) {
    return branch(x, limit, below, above, false);
  }
  template <class Below, class Above>
  friend Dual step_below(const Dual& x, const Dual& limit, const Below& below, const Above& above) {
    return branch(x, limit, below, above, true);
  }
  friend Side side_of(const Dual& x, const Dual& limit) { return side_of(x.value, limit.value); }
  friend Dual hull(const Dual& a, const Dual& b) requires Enclosing<B> { return either(hull(a.value, b.value), a, b); }

 private:
  static B quotient(const B& slope, const B& divisor) {
    if constexpr (std::is_same_v<B, double>) {
      return slope == 0.0 ? 0.0 : slope / divisor;
    } else if constexpr (std::is_same_v<B, Interval>) {
      return slope.is_point() && slope.lower == 0.0 ? slope : slope / divisor;
    } else {
      return slope / divisor;
    }
  }
  /// value * log(base), the derivative of base^exponent by the exponent; 0 where the power is 0.
  static B growth(const B& y, const B& base) {
    if constexpr (std::is_same_v<B, double>) {
      return y == 0.0 ? 0.0 : y * log(base);
    } else {
      return y * log(base);
    }
  }
  static Dual either(const B& y, const Dual& a, const Dual& b) {
    Dual result(y);
    if constexpr (Enclosing<B>) {
      for (std::size_t i = 0; i < a.slope.size(); ++i) result.slope[i] = hull(a.slope[i], b.slope[i]);
    }
    return result;
  }
  template <class Below, class Above>
  static Dual branch(const Dual& x, const Dual& limit, const Below& below, const Above& above, bool jumps) {
    const Side side = side_of(x, limit);
    if (side == Side::below) return branch_value(below, x);
    if (side == Side::above) return branch_value(above, x);
    if constexpr (Enclosing<B>) {
      const Dual low(smaller(x.value, limit.value), x.slope);
      const Dual high(larger(x.value, limit.value), x.slope);
      Dual result = hull(Dual(branch_value(below, low)), Dual(branch_value(above, high)));
      if (jumps) {
        for (std::size_t i = 0; i < result.slope.size(); ++i) {
          result.slope[i] = hull(result.slope[i], (x.slope[i] - limit.slope[i]) * B(Interval::entire()));
        }
      }
      return result;
    } else {
      return branch_value(above, x);
    }
  }
};

template <class B, int N>
struct Constants<Dual<B, N>> {
  static Dual<B, N> pi() { return Dual<B, N>(Constants<B>::pi()); }
  static Dual<B, N> in_unit(double value, const Dimension& dimension) {
    return Dual<B, N>(Constants<B>::in_unit(value, dimension));
  }
};

}  // namespace millwright::scalar
