// SPDX-License-Identifier: Apache-2.0
//
// Containment is checked against 80-bit long double arithmetic, which is an independent and more exact computation;
// tight ranges against values derived by hand.
#include "scalar/interval.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "catch.h"

namespace interval_test {

using namespace millwright::scalar;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double huge = std::numeric_limits<double>::max();

class Boxes {
 public:
  double number() {
    static const double special[] = {0.0,
                                     -0.0,
                                     1.0,
                                     -1.0,
                                     tiny,
                                     -tiny,
                                     huge,
                                     -huge,
                                     2.0,
                                     0.5,
                                     1e-308,
                                     1.5707963267948966,
                                     3.141592653589793,
                                     -1.5707963267948966,
                                     6.283185307179586,
                                     710.0,
                                     -746.0,
                                     1e16};
    switch (pick(6)) {
      case 0:
        return special[pick(std::size(special))];
      case 1:
        return sign() * std::pow(10.0, real(-320.0, 308.0));
      case 2:
        return real(-1.0, 1.0);
      case 3:
        return std::floor(real(-6.0, 7.0));
      default:
        return sign() * std::pow(10.0, real(-3.0, 3.0));
    }
  }
  Interval box() {
    const double a = number();
    switch (pick(8)) {
      case 0:
        return a;
      case 1:
        return {a, inf};
      case 2:
        return {-inf, a};
      case 3:
        return Interval::between(a, std::nextafter(a, inf));
      case 4:
        return Interval::between(a, a * real(0.9, 1.1));
      default:
        return Interval::between(a, number());
    }
  }
  double sample(const Interval& x) {
    const double low = std::max(x.lower, -huge);
    const double high = std::min(x.upper, huge);
    switch (pick(6)) {
      case 0:
        return low;
      case 1:
        return high;
      case 2:
        return std::clamp(number(), low, high);
      case 3:
        return std::clamp(std::nextafter(low, inf), low, high);
      default: {
        const double t = real(0.0, 1.0);
        return std::clamp(low * (1.0 - t) + high * t, low, high);
      }
    }
  }
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  double real(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  double sign() { return pick(2) == 0 ? -1.0 : 1.0; }

 private:
  std::mt19937_64 random_{20240607};
};

bool holds(const Interval& range, long double x) {
  return static_cast<long double>(range.lower) <= x && x <= static_cast<long double>(range.upper);
}
bool same(const Interval& a, const Interval& b) { return a.lower == b.lower && a.upper == b.upper; }
std::string failure(const char* function, const Interval& x, double at, const Interval& range) {
  return fmt::format("{} of [{}, {}] at {}: not in [{}, {}]", function, x.lower, x.upper, at, range.lower, range.upper);
}
bool valid(const Interval& range) { return range.lower <= range.upper; }  // false for NaN

using Exact = long double;
struct OneArgument {
  const char* name;
  std::function<Interval(const Interval&)> range;
  std::function<Exact(Exact)> exact;
};
const OneArgument one_argument[] = {
    {"sqrt", [](const Interval& x) { return sqrt(x); }, [](Exact x) { return std::sqrt(x); }},
    {"cbrt", [](const Interval& x) { return cbrt(x); }, [](Exact x) { return std::cbrt(x); }},
    {"square", [](const Interval& x) { return square(x); }, [](Exact x) { return x * x; }},
    {"cube", [](const Interval& x) { return cube(x); }, [](Exact x) { return x * x * x; }},
    {"exp", [](const Interval& x) { return exp(x); }, [](Exact x) { return std::exp(x); }},
    {"log", [](const Interval& x) { return log(x); }, [](Exact x) { return x == 0 ? NAN : std::log(x); }},
    {"sin", [](const Interval& x) { return sin(x); }, [](Exact x) { return std::sin(x); }},
    {"cos", [](const Interval& x) { return cos(x); }, [](Exact x) { return std::cos(x); }},
    {"tan", [](const Interval& x) { return tan(x); }, [](Exact x) { return std::tan(x); }},
    {"asin", [](const Interval& x) { return asin(x); }, [](Exact x) { return std::asin(x); }},
    {"acos", [](const Interval& x) { return acos(x); }, [](Exact x) { return std::acos(x); }},
    {"atan", [](const Interval& x) { return atan(x); }, [](Exact x) { return std::atan(x); }},
    {"absolute", [](const Interval& x) { return absolute(x); }, [](Exact x) { return std::fabs(x); }},
    {"floor_of", [](const Interval& x) { return floor_of(x); }, [](Exact x) { return std::floor(x); }},
    {"-x", [](const Interval& x) { return -x; }, [](Exact x) { return -x; }},
    {"3 x", [](const Interval& x) { return 3.0 * x; }, [](Exact x) { return 3 * x; }},
    {"x 4", [](const Interval& x) { return x * 4.0; }, [](Exact x) { return 4 * x; }},
    {"-x/8", [](const Interval& x) { return x / -8.0; }, [](Exact x) { return x / -8; }},
    {"x 2^-1074", [](const Interval& x) { return x * tiny; }, [](Exact x) { return x * static_cast<Exact>(tiny); }},
    {"x/10", [](const Interval& x) { return x / 10.0; }, [](Exact x) { return x / 10; }},
    {"1/x", [](const Interval& x) { return 1.0 / x; }, [](Exact x) { return x == 0 ? NAN : 1 / x; }},
};

struct TwoArguments {
  const char* name;
  std::function<Interval(const Interval&, const Interval&)> range;
  std::function<Exact(Exact, Exact)> exact;
};
const TwoArguments two_arguments[] = {
    {"+", [](const Interval& a, const Interval& b) { return a + b; }, [](Exact a, Exact b) { return a + b; }},
    {"-", [](const Interval& a, const Interval& b) { return a - b; }, [](Exact a, Exact b) { return a - b; }},
    {"*", [](const Interval& a, const Interval& b) { return a * b; }, [](Exact a, Exact b) { return a * b; }},
    {"/",
     [](const Interval& a, const Interval& b) { return a / b; },
     [](Exact a, Exact b) { return b == 0 ? NAN : a / b; }},
    {"smaller",
     [](const Interval& a, const Interval& b) { return smaller(a, b); },
     [](Exact a, Exact b) { return std::min(a, b); }},
    {"larger",
     [](const Interval& a, const Interval& b) { return larger(a, b); },
     [](Exact a, Exact b) { return std::max(a, b); }},
    {"where_below",
     [](const Interval& a, const Interval& b) { return where_below(a, b, -a, 2.0 * b); },
     [](Exact a, Exact b) { return a < b ? -a : 2 * b; }},
    {"where_below, clipped",
     [](const Interval& a, const Interval& b) {
       return where_below(
           a, b, [](const Interval& x) { return square(x); }, [](const Interval& x) { return x - 7.0; });
     },
     [](Exact a, Exact b) { return a < b ? a * a : a - 7; }},
};

}  // namespace

TEST_CASE("neighbouring doubles are those of the library") {
  Boxes boxes;
  for (int i = 0; i < 10000; ++i) {
    const double x = boxes.number();
    if (rounding::up(x) != std::nextafter(x, inf)) FAIL(x);
    if (rounding::down(x) != std::nextafter(x, -inf)) FAIL(x);
  }
  CHECK(rounding::up(inf) == inf);
  CHECK(rounding::down(inf) == huge);
  CHECK(rounding::up(-inf) == -huge);
  CHECK(rounding::up(huge) == inf);
  CHECK(rounding::up(NAN) == inf);
  CHECK(rounding::down(NAN) == -inf);
}

TEST_CASE("functions of one interval contain every sample") {
  Boxes boxes;
  for (const OneArgument& f : one_argument) {
    INFO(f.name);
    for (int i = 0; i < 8000; ++i) {
      const Interval x = boxes.box();
      const Interval range = f.range(x);
      if (!valid(range)) FAIL("no interval");
      for (int j = 0; j < 12; ++j) {
        const double at = boxes.sample(x);
        const Exact exact = f.exact(at);
        if (!std::isnan(exact) && !holds(range, exact)) FAIL(failure(f.name, x, at, range));
      }
    }
  }
}

TEST_CASE("functions of two intervals contain every sample") {
  Boxes boxes;
  for (const TwoArguments& f : two_arguments) {
    INFO(f.name);
    for (int i = 0; i < 15000; ++i) {
      const Interval a = boxes.box();
      const Interval b = boxes.pick(10) == 0 ? a : boxes.box();
      const Interval range = f.range(a, b);
      if (!valid(range)) FAIL("no interval");
      for (int j = 0; j < 12; ++j) {
        const double x = boxes.sample(a);
        const double y = boxes.sample(b);
        const Exact exact = f.exact(x, y);
        if (!std::isnan(exact) && !holds(range, exact)) FAIL(failure(f.name, a, x, range) << failure("", b, y, range));
      }
    }
  }
}

TEST_CASE("powers contain every sample") {
  Boxes boxes;
  const double exponents[] = {
      0, 1, 2, 3, 4, 7, -1, -2, -3, 0.5, -0.5, 1.0 / 3.0, 1.5, 2.7, 10.0 / 3.0, 100, -100, 1e300};
  for (int i = 0; i < 40000; ++i) {
    const Interval x = boxes.box();
    const double p = boxes.pick(3) == 0 ? boxes.number() : exponents[boxes.pick(std::size(exponents))];
    const Interval range = pow(x, p);
    const Interval exponent = boxes.pick(2) == 0 ? boxes.box() : Interval::between(p, p + 0.25);
    const Interval wide = pow(x, exponent);
    if (!valid(range)) FAIL("no interval");
    if (!valid(wide)) FAIL("no interval");
    for (int j = 0; j < 8; ++j) {
      const double at = boxes.sample(x);
      const double q = boxes.sample(exponent);
      const Exact exact = std::pow(static_cast<Exact>(at), static_cast<Exact>(p));
      const bool defined = !std::isnan(exact) && !(at == 0.0 && p < 0.0);
      if (defined && !holds(range, exact)) FAIL(failure("power", x, at, range) << " exponent " << p);
      const Exact exact_wide = std::pow(static_cast<Exact>(at), static_cast<Exact>(q));
      const bool defined_wide = !std::isnan(exact_wide) && !(at == 0.0 && q <= 0.0);
      if (defined_wide && !holds(wide, exact_wide))
        FAIL(failure("power", x, at, wide) << failure(", exponent", exponent, q, wide));
    }
  }
}

TEST_CASE("degenerate arguments give narrow results") {
  Boxes boxes;
  for (const OneArgument& f : one_argument) {
    for (int i = 0; i < 500; ++i) {
      const double x = boxes.real(-0.99, 0.99);
      const Interval range = f.range(x);
      if (range.is_entire() || magnitude(range) < 1e-300) continue;  // outside the domain, or subnormal
      CAPTURE(f.name, x, range.lower, range.upper);
      CHECK(width(range) <= 12.0 * 2.3e-16 * magnitude(range));
    }
  }
}

TEST_CASE("whole multiples above a range have whole ends in units of 1, and contain those of its numbers in any unit") {
  Boxes boxes;
  for (int i = 0; i < 20000; ++i) {
    const double unit = boxes.pick(2) == 0 ? 1.0 : boxes.real(0.01, 3.0);
    const double low = boxes.pick(3) == 0 ? std::round(boxes.real(0.0, 50.0)) : boxes.real(0.0, 50.0);
    const Interval x(low, boxes.pick(2) == 0 ? low : low + boxes.real(0.0, 5.0));
    const Interval whole = up_to_whole(x, Interval(unit));
    CAPTURE(x.lower, x.upper, unit, whole.lower, whole.upper);
    for (const double at : {x.lower, boxes.sample(x), x.upper})
      if (!contains(whole, up_to_whole(at, unit))) FAIL("not contained: " << at);
    if (unit != 1.0) continue;
    const bool exact = whole.lower == std::ceil(x.lower) && whole.upper == std::ceil(x.upper);
    if (!exact) FAIL("not the whole numbers above its ends");
  }
  CHECK(up_to_whole(5.2, 1.0) == 6.0);
  CHECK(up_to_whole(6.0, 1.0) == 6.0);
  CHECK(up_to_whole(Interval(5.2, 5.9), Interval(1.0)).is_point());
}

TEST_CASE("ranges known by hand") {
  const auto is = [](const Interval& x, double lower, double upper) {
    CAPTURE(x.lower, x.upper);
    return x.lower == Approx(lower).epsilon(1e-14).margin(1e-300) &&
           x.upper == Approx(upper).epsilon(1e-14).margin(1e-300);
  };
  CHECK(is(square(Interval(-2, 3)), 0, 9));  // x * x would give [-6, 9]
  CHECK(is(Interval(-2, 3) * Interval(-2, 3), -6, 9));
  CHECK(is(cube(Interval(-2, 3)), -8, 27));
  CHECK(is(pow(Interval(-2, 3), 4), 0, 81));
  CHECK(is(sqrt(Interval(-4, 9)), 0, 3));
  CHECK(is(log(Interval(-4, 1)), -inf, 0));
  CHECK(is(sin(Interval(0, 2)), 0, 1));
  CHECK(is(sin(Interval(3, 6)), -1, std::sin(3.0)));
  CHECK(is(cos(Interval(-1, 2)), std::cos(2.0), 1));
  CHECK(is(cos(Interval(0, 100)), -1, 1));
  CHECK(is(tan(Interval(-1, 1)), -std::tan(1.0), std::tan(1.0)));
  CHECK(is(asin(Interval(-5, 0.5)), -M_PI / 2, M_PI / 6));
  CHECK(is(acos(Interval(0.5, 5)), 0, M_PI / 3));
  CHECK(is(absolute(Interval(-3, 2)), 0, 3));
  CHECK(is(floor_of(Interval(-1.5, 2.5)), -2, 2));
  CHECK(is(Interval(1, 2) / Interval(0, 4), 0.25, inf));
  CHECK(is(Interval(1, 2) / Interval(-4, 0), -inf, -0.25));
  CHECK(is(Interval(-2, -1) / Interval(0, 4), -inf, -0.25));
  CHECK(is(Interval(-2, -1) / Interval(-4, -0.0), 0.25, inf));
  CHECK(is(1.0 / Interval(2, 4), 0.25, 0.5));
  CHECK(is(pow(Interval(0, 4), -0.5), 0.5, inf));
  CHECK(is(where_below(Interval(0, 2), 1.0, Interval(5, 6), Interval(8, 9)), 5, 9));
  CHECK(is(where_below(Interval(0, 0.5), 1.0, Interval(5, 6), Interval(8, 9)), 5, 6));
  CHECK(is(where_below(Interval(1, 2), 1.0, Interval(5, 6), Interval(8, 9)), 8, 9));
}

TEST_CASE("what is defined nowhere is the entire line") {
  CHECK((Interval(1, 2) / Interval(-1, 1)).is_entire());
  CHECK((Interval(1, 2) / Interval(0, 0)).is_entire());
  CHECK((Interval(1, 2) / 0.0).is_entire());
  CHECK((Interval(0, 0) / Interval(0, 0)).is_entire());
  CHECK(sqrt(Interval(-2, -1)).is_entire());
  CHECK(log(Interval(-2, 0)).is_entire());
  CHECK(asin(Interval(1.5, 2)).is_entire());
  CHECK(acos(Interval(-3, -2)).is_entire());
  CHECK(pow(Interval(-2, -1), 0.5).is_entire());
  CHECK(pow(Interval(0, 0), -1.0).is_entire());
  CHECK(tan(Interval(1, 2)).is_entire());
  CHECK(tan(Interval(0, 1e12)).is_entire());
  CHECK(Interval(NAN).is_entire());
  CHECK(same(Interval(inf) - Interval(inf), Interval::entire()));
  CHECK(pow(Interval(1, 2), NAN).is_entire());
}

TEST_CASE("exact operations do not widen") {
  const auto exactly = [](const Interval& x, double lower, double upper) {
    return x.lower == lower && x.upper == upper;
  };
  CHECK(exactly(Interval(0, 3) + 4.0, 4, 7));
  CHECK(exactly(Interval(0.1, 0.3) + 0.0, 0.1, 0.3));
  CHECK(exactly(Interval(0.1, 0.3) * 2.0, 0.2, 0.6));
  CHECK(exactly(Interval(0.1, 0.3) * 1.0, 0.1, 0.3));
  CHECK(exactly(-1.0 * Interval(0.1, 0.3), -0.3, -0.1));
  CHECK(exactly(Interval(0.1, 0.3) / 4.0, 0.025, 0.075));
  CHECK(exactly(Interval(0, 0) * Interval::entire(), 0, 0));
  CHECK(exactly(0.0 * Interval::entire(), 0, 0));
  CHECK((Interval(0, 0.3) * Interval(0.1, 0.7)).lower == 0.0);
  CHECK((Interval(0, 0.3) / Interval(0.1, 0.7)).lower == 0.0);
  CHECK(sqrt(Interval(0, 2)).lower == 0.0);
  // 0.1 + 0.2 as doubles is inexact: the sum lies strictly between two neighbouring doubles.
  CHECK_FALSE((Interval(0.1) + Interval(0.2)).is_point());
}

TEST_CASE("pi lies strictly inside its interval") {
  // The digits of pi after the double nearest to it: pi - 3.141592653589793116 = 1.2246e-16 (sin of that double).
  CHECK(pi<Interval>().lower == std::numbers::pi);
  CHECK(pi<Interval>().upper == std::nextafter(std::numbers::pi, 4.0));
  CHECK(std::sin(std::numbers::pi) > 0.0);
}

TEST_CASE("sets of intervals") {
  CHECK(same(hull(Interval(1, 2), Interval(4, 5)), Interval(1, 5)));
  CHECK_FALSE(intersect(Interval(1, 2), Interval(3, 4)).has_value());
  CHECK(same(*intersect(Interval(1, 3), Interval(2, 4)), Interval(2, 3)));
  CHECK(same(*intersect(Interval(1, 2), Interval(2, 4)), Interval(2)));
  CHECK(certainly_below(Interval(1, 2), Interval(2.5, 3)));
  CHECK_FALSE(certainly_below(Interval(1, 2), Interval(2, 3)));
  CHECK(possibly_below(Interval(1, 2), Interval(1.5, 1.6)));
  CHECK_FALSE(possibly_below(Interval(2, 3), Interval(1, 2)));
  CHECK(width(Interval(1, 3)) == 2.0);
  CHECK(width(Interval::entire()) == inf);
  CHECK(middle(Interval(1, 3)) == 2.0);
  Boxes boxes;
  for (int i = 0; i < 5000; ++i) {
    const Interval x = boxes.box();
    if (!contains(x, middle(x)) || !std::isfinite(middle(x))) FAIL(failure("middle", x, middle(x), x));
  }
  CHECK(contains(Interval(huge, inf), middle(Interval(huge, inf))));
  CHECK(middle(Interval(-huge, huge)) == 0.0);
}

}  // namespace interval_test
