// SPDX-License-Identifier: Apache-2.0
//
// A number that remembers how it was computed: the same value, bit for bit, as double gives, its dimension, and the
// expression as it stands in the formula, for the calculation sheet.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scalar/elementary.h"
#include "scalar/unit.h"

namespace millwright::scalar {

struct Expression;  // traced.cpp

class Traced {
 public:
  double value = 0.0;
  Dimension dimension;  ///< not checked here: Dimensioned does that for every formula

  Traced() = default;
  Traced(double literal) : value(literal) {}  // NOLINT(google-explicit-constructor): formulas mix with literals
  // In traced.cpp: formulas consist of temporaries, and each would be compiled with the counting of references.
  Traced(const Traced& other);
  Traced(Traced&& other) noexcept;
  Traced& operator=(const Traced& other);
  Traced& operator=(Traced&& other) noexcept;
  ~Traced();

  /// An argument of a formula: prints as its symbol, or as its value in `display`.
  static Traced leaf(std::string symbol, double value, const Dimension& dimension, const Unit& display);
  static Traced leaf(std::string symbol, double value, const Unit& display);

  Traced& operator+=(const Traced& b);
  Traced& operator-=(const Traced& b);
  Traced& operator*=(const Traced& b);
  Traced& operator/=(const Traced& b);

  /// Nothing for a literal.
  [[nodiscard]] const std::shared_ptr<const Expression>& expression() const { return expression_; }
  Traced(double v, const Dimension& d, std::shared_ptr<const Expression> expression);

 private:
  std::shared_ptr<const Expression> expression_;
};

Traced operator+(const Traced& a);
Traced operator-(const Traced& a);
Traced operator+(const Traced& a, const Traced& b);
Traced operator-(const Traced& a, const Traced& b);
Traced operator*(const Traced& a, const Traced& b);
Traced operator/(const Traced& a, const Traced& b);
Traced sqrt(const Traced& x);
Traced cbrt(const Traced& x);
Traced square(const Traced& x);
Traced cube(const Traced& x);
Traced pow(const Traced& x, double exponent);
Traced pow(const Traced& x, const Traced& exponent);
Traced exp(const Traced& x);
Traced log(const Traced& x);
Traced sin(const Traced& x);
Traced cos(const Traced& x);
Traced tan(const Traced& x);
Traced asin(const Traced& x);
Traced acos(const Traced& x);
Traced atan(const Traced& x);
Traced absolute(const Traced& x);
Traced floor_of(const Traced& x);
/// Prints as min(a, b).
Traced smaller(const Traced& a, const Traced& b);
/// Prints as max(a, b).
Traced larger(const Traced& a, const Traced& b);
/// Prints as its symbol from here on; its own expression becomes a line of the derivation.
Traced named(const char* symbol, const Traced& x);

/// Only the branch taken is evaluated and printed.
template <class Below, class Above>
Traced where_below(const Traced& x, const Traced& limit, const Below& below, const Above& above) {
  if (x.value < limit.value) return branch_value(below, x);
  return branch_value(above, x);
}
template <class Below, class Above>
Traced step_below(const Traced& x, const Traced& limit, const Below& below, const Above& above) {
  return where_below(x, limit, below, above);
}

template <>
struct Constants<Traced> {
  static Traced pi();
  static Traced in_unit(double value, const Dimension& dimension);
};

/// One line of a calculation: symbol = expression = substituted = value in unit.
struct DerivationLine {
  std::string symbol;
  std::string expression;   ///< `4 · F / (π · d²)`
  std::string substituted;  ///< `4 · 80 N / (π · (2.5 mm)²)`
  double value = 0.0;       ///< in SI
  Unit unit;                ///< to print the value in
};

/// The lines that lead to `result`, which is called `symbol` and printed in `unit`: named intermediate results first,
/// each before its first use. An expression too long for a line is broken into intermediate results z₁, z₂, ...
std::vector<DerivationLine> derivation(const Traced& result, const std::string& symbol, const Unit& unit);
/// The same with the unit an engineer would choose.
std::vector<DerivationLine> derivation(const Traced& result, const std::string& symbol);

/// `σ = 4 · F / (π · d²) = 4 · 80 N / (π · (2.5 mm)²) = 16.3 MPa`
std::string to_string(const DerivationLine& line);

}  // namespace millwright::scalar
