// SPDX-License-Identifier: Apache-2.0
#include "scalar/traced.h"

#include <random>

#include "catch.h"

namespace millwright::mechanics {
// As a formula header would be written.
using namespace scalar;
template <class T>
T spring_stress(const T& force, const T& mean_diameter, const T& wire_diameter) {
  const T index = named("C", mean_diameter / wire_diameter);
  const T factor = named("K_W", (4.0 * index - 1.0) / (4.0 * index - 4.0) + 0.615 / index);
  return factor * 8.0 * force * mean_diameter / (pi<T>() * cube(wire_diameter));
}
template <class T>
T everything(const T& a, const T& b) {
  T sum = 0.0;
  for (int i = 1; i < 4; ++i) sum += a / i;
  const T branch = where_below(
      a, b, [&] { return a - b; }, [&] { return b / (a + 1.0); });
  return named("q", sum * branch) + sqrt(absolute(a)) * cbrt(b) - pow(absolute(a), 1.3) / exp(-b) + sin(a) * cos(b) +
         tan(a) + asin(a / 10.0) + acos(b / 10.0) + atan(a) + smaller(a, b) + larger(a, 2.0) + log(absolute(b) + 1.0) -
         floor_of(a) + pow(2.0, b) * square(a) * cube(b) + pi<T>() * 1e-3 * step_below(a, 0.1, a, b) +
         pow(absolute(a), b) - (-a);
}
}  // namespace millwright::mechanics

namespace traced_test {

namespace {

using namespace millwright;
using namespace millwright::scalar;

Traced leaf(const char* symbol, double value, const char* unit = "") {
  return Traced::leaf(symbol, value, Unit::of(unit));
}
std::string symbols(const Traced& x) { return derivation(x, "y").back().expression; }
std::string numbers(const Traced& x) { return derivation(x, "y").back().substituted; }

}  // namespace

TEST_CASE("the calculation of a spring prints as in a book") {
  const Traced stress = mechanics::spring_stress(leaf("F", 80.0, "N"), leaf("D", 0.02, "mm"), leaf("d", 0.0025, "mm"));
  const auto lines = derivation(stress, "τ", Unit::of("MPa"));
  REQUIRE(lines.size() == 3);
  CHECK(to_string(lines[0]) == "C = D / d = 20 mm / 2.5 mm = 8");
  CHECK(to_string(lines[1]) ==
        "K_W = (4 · C - 1) / (4 · C - 4) + 0.615 / C = (4 · 8 - 1) / (4 · 8 - 4) + 0.615 / 8 = 1.184");
  CHECK(to_string(lines[2]) ==
        "τ = K_W · 8 · F · D / (π · d³) = 1.184 · 8 · 80 N · 20 mm / (π · (2.5 mm)³) = 308.7 MPa");
  // Wahl: C = 8, K_W = 31/28 + 0.615/8 = 1.184018; 8 F D K_W/(pi d³) = 15.155429/(4.9087e-8) Pa
  CHECK(lines[2].value == Approx(1.1840179 * 8 * 80 * 0.02 / (3.14159265 * 1.5625e-8)).epsilon(1e-6));
}

TEST_CASE("values equal those of double bit for bit") {
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> number(-8.0, 8.0);
  for (int i = 0; i < 2000; ++i) {
    const double a = number(random);
    const double b = number(random);
    const double expected = mechanics::everything(a, b);
    const double traced = mechanics::everything(leaf("a", a), leaf("b", b)).value;
    if (!(traced == expected || (std::isnan(traced) && std::isnan(expected)))) FAIL(a << ", " << b);
  }
}

TEST_CASE("parentheses only where needed") {
  const Traced a = leaf("a", 2.0);
  const Traced b = leaf("b", 3.0);
  const Traced c = leaf("c", -4.0);
  CHECK(symbols(a + b - c) == "a + b - c");
  CHECK(symbols(a - (b - c)) == "a - (b - c)");
  CHECK(symbols(a - (b + c)) == "a - (b + c)");
  CHECK(symbols((a + b) * c) == "(a + b) · c");
  CHECK(symbols(a * b / c) == "a · b / c");
  CHECK(symbols(a / (b * c)) == "a / (b · c)");
  CHECK(symbols(a / (b / c)) == "a / (b / c)");
  CHECK(symbols(a * (b / c)) == "a · b / c");
  CHECK(symbols(-(a + b)) == "-(a + b)");
  CHECK(symbols(-a * b) == "(-a) · b");
  CHECK(symbols(a - (-b)) == "a - (-b)");
  CHECK(symbols(a + (-b) * c) == "a + (-b) · c");
  CHECK(symbols(square(a + b)) == "(a + b)²");
  CHECK(symbols(square(square(a))) == "(a²)²");
  CHECK(symbols(square(-a)) == "(-a)²");
  CHECK(symbols(a * square(b)) == "a · b²");
  CHECK(symbols(pow(a, -2)) == "a⁻²");
  CHECK(symbols(pow(a, 12)) == "a¹²");
  CHECK(symbols(pow(a, 1.5)) == "a^1.5");
  CHECK(symbols(pow(a, -1.5)) == "a^(-1.5)");
  CHECK(symbols(pow(a, b / 3.0)) == "a^(b / 3)");
  CHECK(symbols(pow(2.0, a)) == "2^a");
  CHECK(symbols(sqrt(a + b)) == "√(a + b)");
  CHECK(symbols(absolute(a - b)) == "|a - b|");
  CHECK(symbols(floor_of(a)) == "⌊a⌋");
  CHECK(symbols(log(a)) == "ln(a)");
  CHECK(symbols(smaller(a, 2.0 * b)) == "min(a, 2 · b)");
  CHECK(symbols(larger(a, b)) == "max(a, b)");
  CHECK(numbers(a * c) == "2 · (-4)");
  CHECK(numbers(c * a) == "(-4) · 2");
  CHECK(numbers(a + c) == "2 + (-4)");
  CHECK(numbers(square(c)) == "(-4)²");
  CHECK(symbols(a - -4.0) == "a - (-4)");
}

TEST_CASE("a branch prints the side taken") {
  const Traced a = leaf("a", 2.0);
  const Traced b = leaf("b", 3.0);
  CHECK(symbols(where_below(a, b, a + 1.0, b + 1.0)) == "a + 1");
  CHECK(symbols(where_below(b, a, a + 1.0, b + 1.0)) == "b + 1");
  CHECK(symbols(where_below(
            a, 2.0, [&] { return a; }, [](const Traced& x) { return 2 * x; })) == "2 · a");
}

TEST_CASE("a sum that starts from 0 does not print it") {
  Traced sum = 0.0;
  sum += leaf("a", 1.0, "mm");
  sum += leaf("b", 2.0, "mm");
  CHECK(symbols(sum) == "a + b");
  CHECK(sum.dimension == dimension::length);
}

TEST_CASE("units follow the numbers") {
  const Traced torque = leaf("F", 1200.0, "kN") * leaf("r", 0.0105, "mm");
  CHECK(torque.dimension == dimension::torque);
  CHECK(to_string(derivation(torque, "T").back()) == "T = F · r = 1.2 kN · 10.5 mm = 12.6 N·m");
  const Traced speed = leaf("n", Unit::of("rpm").to_si(3000.0), "rpm") * leaf("r", 0.05, "mm");
  CHECK(numbers(speed) == "3000 rpm · 50 mm");
  CHECK(to_string(derivation(leaf("x", 0.3, "%") * 1.0, "y").back()) == "y = x · 1 = 30% · 1 = 0.3");
  CHECK(symbols(leaf("l", 0.1, "mm") / in_unit<Traced>(1e-3, dimension::length)) == "l / 1 mm");
}

TEST_CASE("a result that is a number or a symbol") {
  CHECK(to_string(derivation(Traced(2.5), "k").back()) == "k = 2.5");
  CHECK(to_string(derivation(leaf("a", 0.002, "mm"), "k").back()) == "k = a = 2 mm");
  CHECK(to_string(derivation(named("q", leaf("a", 2.0) + 1.0), "k").back()) == "k = a + 1 = 2 + 1 = 3");
}

TEST_CASE("a symbol defined twice is one line if both agree and counted if not") {
  const auto doubled = [](const Traced& x) { return named("d", 2.0 * x); };
  const Traced a = leaf("a", 2.0);
  const Traced b = leaf("b", 3.0);
  CHECK(derivation(doubled(a) + doubled(a), "y").size() == 2);
  const auto lines = derivation(doubled(a) + doubled(b), "y");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].symbol != lines[1].symbol);
  CHECK(lines[2].expression == lines[0].symbol + " + " + lines[1].symbol);
}

TEST_CASE("shared and deep expressions stay printable") {
  Traced x = leaf("x", 1.0000001);
  for (int i = 0; i < 200; ++i) x = x * x;  // written out: 2^200 factors
  std::size_t length = 0;
  for (const DerivationLine& line : derivation(x, "y")) length += line.expression.size();
  CHECK(length < 100000);
  Traced sum = 0.0;
  const Traced step = leaf("s", 1.0);
  for (int i = 0; i < 2000; ++i) sum += step;
  const auto lines = derivation(sum, "y");
  CHECK(lines.back().value == 2000.0);
  for (const DerivationLine& line : lines) CHECK(line.expression.size() < 400);
}

}  // namespace traced_test
