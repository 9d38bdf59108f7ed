// SPDX-License-Identifier: Apache-2.0
//
// Slopes against central differences (computed with long double points would be no better: steps of 1e-6 give 1e-8),
// second derivatives against hand derivations, slopes over boxes against slopes at samples.
#include "scalar/dual.h"

#include <random>

#include "catch.h"
#include "scalar/interval.h"

namespace dual_test {

namespace {

using namespace millwright::scalar;

/// One lambda per function; every one is called with double, Dual and Dual<Interval>.
template <class Visitor>
void for_each_function(Visitor&& visit) {
  visit("x + 2", [](const auto& x) { return x + 2.0; });
  visit("2 - x", [](const auto& x) { return 2.0 - x; });
  visit("x x", [](const auto& x) { return x * x; });
  visit("3 x", [](const auto& x) { return 3 * x; });
  visit("1/x", [](const auto& x) { return 1.0 / x; });
  visit("x/(1+x)", [](const auto& x) { return x / (1.0 + x); });
  visit("x/7", [](const auto& x) { return x / 7.0; });
  visit("sqrt", [](const auto& x) { return sqrt(x); });
  visit("cbrt", [](const auto& x) { return cbrt(x); });
  visit("square", [](const auto& x) { return square(x); });
  visit("cube", [](const auto& x) { return cube(x); });
  visit("x^2.3", [](const auto& x) { return pow(x, 2.3); });
  visit("x^-2", [](const auto& x) { return pow(x, -2); });
  visit("x^x", [](const auto& x) { return pow(x, x); });
  visit("2^x", [](const auto& x) { return exp(x * log(2.0)); });
  visit("exp", [](const auto& x) { return exp(-x); });
  visit("log", [](const auto& x) { return log(x); });
  visit("sin", [](const auto& x) { return sin(x); });
  visit("cos", [](const auto& x) { return cos(x); });
  visit("tan", [](const auto& x) { return tan(x); });
  visit("asin", [](const auto& x) { return asin(x); });
  visit("acos", [](const auto& x) { return acos(x); });
  visit("atan", [](const auto& x) { return atan(x); });
  visit("absolute", [](const auto& x) { return absolute(x - 0.4); });
  visit("smaller", [](const auto& x) { return smaller(x, square(x) + 0.16); });
  visit("larger", [](const auto& x) { return larger(2.0 * x, 1.0); });
  visit("where_below", [](const auto& x) { return where_below(x, 0.5, square(x), x - 0.25); });
  visit("where_below, lambdas", [](const auto& x) {
    return where_below(
        x, 0.5, [](const auto& below) { return square(below); }, [&] { return x - 0.25; });
  });
}

bool same(const Interval& a, const Interval& b) { return a.lower == b.lower && a.upper == b.upper; }
bool no_nan(const Interval& x) { return x.lower <= x.upper; }

}  // namespace

TEST_CASE("slopes agree with central differences") {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> inside(0.05, 0.95);
  for_each_function([&](const char* name, const auto& f) {
    for (int i = 0; i < 200; ++i) {
      const double x = inside(random);
      if (std::fabs(x - 0.5) < 1e-5 || std::fabs(x - 0.4) < 1e-5 || std::fabs(x - 0.2) < 1e-5 ||
          std::fabs(x - 0.8) < 1e-5)
        continue;
      const double step = 1e-6;
      const double expected = (f(x + step) - f(x - step)) / (2.0 * step);
      const auto result = f(Dual<>::variable(x, 0));
      CAPTURE(name, x);
      CHECK(result.value == f(x));
      CHECK(result.slope[0] == Approx(expected).epsilon(1e-6).margin(1e-8));
    }
  });
}

TEST_CASE("slopes over a box contain the slopes at its points") {
  std::mt19937_64 random{8};
  std::uniform_real_distribution<double> inside(0.01, 0.99);
  for_each_function([&](const char* name, const auto& f) {
    for (int i = 0; i < 300; ++i) {
      const Interval box = Interval::between(inside(random), inside(random));
      const Dual<Interval> range = f(Dual<Interval>::variable(box, 0));
      for (int j = 0; j < 20; ++j) {
        const double x = std::uniform_real_distribution<double>(box.lower, box.upper)(random);
        const Dual<> at = f(Dual<>::variable(x, 0));
        // The slope at a point is itself rounded, so it may miss a degenerate range by its last bits.
        const double slack = 1e-13 * (1.0 + std::fabs(at.slope[0]));
        const bool inside_range =
            at.slope[0] >= range.slope[0].lower - slack && at.slope[0] <= range.slope[0].upper + slack;
        if (contains(range.value, at.value) && inside_range) continue;
        FAIL(name << " over [" << box.lower << ", " << box.upper << "] at " << x);
      }
    }
  });
}

TEST_CASE("several variables, by the product rule") {
  using D = Dual<double, 3>;
  const D x = D::variable(2.0, 0);
  const D y = D::variable(3.0, 1);
  const D z = D::variable(5.0, 2);
  const D f = x * square(y) / z;  // df/dx = y²/z, df/dy = 2xy/z, df/dz = -xy²/z²
  CHECK(f.value == Approx(3.6));
  CHECK(f.slope[0] == Approx(1.8));
  CHECK(f.slope[1] == Approx(2.4));
  CHECK(f.slope[2] == Approx(-0.72));
  const D g = pow(x, y);  // d/dx = y x^(y-1) = 12, d/dy = x^y ln x
  CHECK(g.slope[0] == Approx(12.0));
  CHECK(g.slope[1] == Approx(8.0 * std::log(2.0)));
}

TEST_CASE("second derivatives") {
  using Second = Dual<Dual<double>>;
  const auto at = [](double x) { return Second(Dual<>::variable(x, 0), {Dual<>(1.0)}); };
  CHECK(sin(at(0.7)).slope[0].slope[0] == Approx(-std::sin(0.7)));
  CHECK(pow(at(2.0), 3.0).slope[0].slope[0] == Approx(12.0));                        // 6x
  CHECK(sqrt(at(4.0)).slope[0].slope[0] == Approx(-1.0 / 32.0));                     // -x^(-3/2)/4
  CHECK((1.0 / at(2.0)).slope[0].slope[0] == Approx(0.25));                          // 2/x³
  CHECK((at(2.0) * exp(at(2.0))).slope[0].slope[0] == Approx(4.0 * std::exp(2.0)));  // (2+x)e^x
  CHECK(tan(at(0.5)).slope[0].slope[0] == Approx(2.0 * std::tan(0.5) / square(std::cos(0.5))));
  CHECK(log(at(3.0)).slope[0].slope[0] == Approx(-1.0 / 9.0));
  CHECK(where_below(at(2.0), 3.0, cube(at(2.0)), 0.0).slope[0].slope[0] == Approx(12.0));
  CHECK(smaller(square(at(2.0)), 100.0).slope[0].slope[0] == Approx(2.0));
  CHECK(absolute(-square(at(2.0))).slope[0].slope[0] == Approx(2.0));
}

TEST_CASE("second derivatives over a box") {
  using Second = Dual<Dual<Interval>>;
  const Second x(Dual<Interval>::variable(Interval(1, 2), 0), {Dual<Interval>(1.0)});
  const Interval curvature = cube(x).slope[0].slope[0];  // 6x
  CHECK(curvature.lower == Approx(6.0));
  CHECK(curvature.upper == Approx(12.0));
}

TEST_CASE("a tie takes the first argument, a limit the branch above") {
  const Dual<> x = Dual<>::variable(1.0, 0);
  CHECK(smaller(x, 1.0).slope[0] == 1.0);
  CHECK(smaller(1.0, x).slope[0] == 0.0);
  CHECK(larger(x, 1.0).slope[0] == 1.0);
  CHECK(larger(1.0, x).slope[0] == 0.0);
  CHECK(where_below(x, 1.0, 5.0 * x, 7.0 * x).slope[0] == 7.0);
  CHECK(absolute(x - 1.0).slope[0] == 1.0);
}

TEST_CASE("a variable that is not involved keeps slope 0 at a pole") {
  using D = Dual<double, 2>;
  const D zero = D::variable(0.0, 0);
  CHECK(sqrt(zero).slope[1] == 0.0);
  CHECK(std::isinf(sqrt(zero).slope[0]));
  CHECK(acos(1.0 + zero).slope[1] == 0.0);
  CHECK(pow(D(0.0), 0.0).slope[0] == 0.0);
  CHECK(pow(zero, 1.0).slope[0] == 1.0);
  CHECK(pow(D(0.0), D::variable(2.0, 1)).slope[1] == 0.0);
}

TEST_CASE("a variable that is not involved keeps slope 0 over a box with a pole in it") {
  using D = Dual<Interval, 2>;
  for (const Interval& box : {Interval(0, 1), Interval(-1, 0), Interval(-1, 2), Interval(0, rounding::infinity)}) {
    CAPTURE(box.lower, box.upper);
    const D x = D::variable(box, 0);
    const D other = D::variable(Interval(1, 2), 1);
    CHECK(same((1.0 / x).slope[1], Interval(0)));
    CHECK(same((D(Interval(3, 4)) / x).slope[1], Interval(0)));
    CHECK_FALSE((other / x).slope[0].is_bounded());
    CHECK(same(sqrt(absolute(x)).slope[1], Interval(0)));
    CHECK(same(log(x).slope[1], Interval(0)));
    CHECK(same(pow(x, -1.0).slope[1], Interval(0)));
  }
}

TEST_CASE("intervals at poles and outside domains never give NaN") {
  const Interval boxes[] = {Interval(0),
                            Interval(1),
                            Interval(-1),
                            Interval(0, 1),
                            Interval(-1, 1),
                            Interval(-2, -1),
                            Interval(2, 3),
                            Interval::entire(),
                            Interval(0, rounding::infinity),
                            Interval(-0.0, 0.0),
                            Interval(1e308, rounding::infinity),
                            Interval(1.5, 1.6)};
  for_each_function([&](const char* name, const auto& f) {
    for (const Interval& box : boxes) {
      const Dual<Interval> y = f(Dual<Interval>::variable(box, 0));
      CAPTURE(name, box.lower, box.upper);
      CHECK(no_nan(y.value));
      CHECK(no_nan(y.slope[0]));
    }
  });
  CHECK(sqrt(Dual<Interval>::variable(0.0, 0)).slope[0].is_entire());
  CHECK(acos(Dual<Interval>::variable(Interval(-1, 1), 0)).slope[0].upper < 0.0);
  CHECK(acos(Dual<Interval>::variable(Interval(-1, 1), 0)).slope[0].lower == -rounding::infinity);
}

TEST_CASE("branches over a box") {
  using D = Dual<Interval>;
  const D x = D::variable(Interval(0, 2), 0);
  SECTION("certain") {
    CHECK(same(smaller(x, 3.0).slope[0], Interval(1)));
    CHECK(same(larger(x, 3.0).slope[0], Interval(0)));
    CHECK(same(absolute(x + 1.0).slope[0], Interval(1)));
    CHECK(same(where_below(x, 3.0, 5.0 * x, 7.0 * x).slope[0], Interval(5)));
  }
  SECTION("open: hull of slopes, tight values") {
    CHECK(same(smaller(x, 1.0).value, Interval(0, 1)));
    CHECK(same(smaller(x, 1.0).slope[0], Interval(0, 1)));
    CHECK(same(larger(x, 1.0).value, Interval(1, 2)));
    CHECK(same(absolute(x - 1.0).slope[0], Interval(-1, 1)));
    CHECK(contains(where_below(x, 1.0, 5.0 * x, 7.0 * x - 2.0).slope[0], Interval(5, 7)));
  }
  SECTION("a jump has no bounded slope") {
    // 0 below 1 and -1 from there on: the mean slope from 0.9 to 1.1 is -5, from 0.999 to 1.001 it is -500.
    CHECK(step_below(x, 1.0, 0.0, -1.0).slope[0].is_entire());
    CHECK(same(step_below(x, 3.0, 0.0, -1.0).slope[0], Interval(0)));
    CHECK(same(floor_of(x).slope[0], Interval(0, rounding::infinity)));
    CHECK(same(floor_of(x / 4.0).slope[0], Interval(0)));
  }
  SECTION("a lambda sees its side only") {
    // sqrt(1 - x) below 1 and 0 above: the whole box would leave the domain of the root.
    const auto root = [](const D& below) { return sqrt(1.0 - below); };
    CHECK(where_below(x, 1.0, root, 0.0).value.upper == Approx(1.0));
  }
}

}  // namespace dual_test
