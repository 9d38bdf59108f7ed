// SPDX-License-Identifier: Apache-2.0
//
// One formula with every elementary function runs on every scalar of the list and gives the same value.
#include "scalar/scalars.h"

#include "catch.h"

namespace millwright::mechanics {
using namespace scalar;
template <class T>
T formula(const T& a, const T& b) {
  T sum = 0.0;
  sum += a;
  sum -= b;
  sum *= 2.0;
  sum /= 4;
  return named("s", sum) + 1.0 - (2 - a) + a * 3 + 4.0 * b - a / 2.0 + 1 / b + pow(a, 2) + pow(a, 1.5) + pow(a, b) +
         pow(2.0, b) + sqrt(a) + cbrt(a) + square(a) + cube(b) + exp(a) + log(b) + sin(a) + cos(a) + tan(a) + asin(a) +
         acos(a) + atan(b) + absolute(-a) + floor_of(3.5 * b) + smaller(a, 1.0) + larger(0.1, b) + smaller(a, b) +
         where_below(a, b, a, b) +
         where_below(
             a, 0.5, [&] { return a; }, 7.0) +
         step_below(a, 1, 1, 2) + where_below(1.0, 2.0, a, 3.0) + pi<T>() + in_unit<T>(2.0, dimension::none) + (+a) -
         (-b);
}
#define instantiate(T) template T formula(const T&, const T&);
MILLWRIGHT_FOR_EACH_SCALAR(instantiate)
#undef instantiate
}  // namespace millwright::mechanics

namespace scalars_test {

namespace {

using namespace millwright::scalar;

double value_of(double x) { return x; }
double value_of(const Interval& x) { return middle(x); }
template <class T>
double value_of(const T& x) {
  return value_of(x.value);
}

template <class T>
concept Comparable = requires(const T& a) {
  a < a;
};

}  // namespace

TEST_CASE("every scalar gives the value of double") {
  const double expected = millwright::mechanics::formula(0.3, 0.7);
  int count = 0;
  for_each_scalar([&]<class T>() {
    CHECK(value_of(millwright::mechanics::formula(T(0.3), T(0.7))) == Approx(expected).epsilon(1e-12));
    ++count;
  });
  CHECK(count == AllScalars::size);
  CHECK(count == 6);
}

TEST_CASE("the standard names work beside the global ones") {
  // Tests and tools see ::sqrt(double) too; the call must stay unambiguous and mean the same.
  CHECK(sqrt(2.0) == std::sqrt(2.0));
  CHECK(pow(2.0, 3) == 8.0);
}

TEST_CASE("only double compares, so a hidden branch does not compile") {
  STATIC_REQUIRE(Comparable<double>);
  STATIC_REQUIRE_FALSE(Comparable<Dual<>>);
  STATIC_REQUIRE_FALSE(Comparable<Interval>);
  STATIC_REQUIRE_FALSE(Comparable<Dual<Interval>>);
  STATIC_REQUIRE_FALSE(Comparable<Traced>);
  STATIC_REQUIRE_FALSE(Comparable<Dimensioned>);
}

TEST_CASE("what counts as a scalar") {
  STATIC_REQUIRE(Scalar<double>);
  STATIC_REQUIRE(Scalar<Dual<Interval, 5>>);
  STATIC_REQUIRE(Scalar<const Dual<Dual<double>>&>);
  STATIC_REQUIRE_FALSE(Scalar<int>);
  STATIC_REQUIRE_FALSE(Scalar<Dual<int>>);
}

TEST_CASE("branches of double") {
  CHECK(smaller(1.0, 2.0) == 1.0);
  CHECK(larger(1.0, 2.0) == 2.0);
  CHECK(std::isnan(smaller(NAN, 1.0)));
  CHECK(std::isnan(smaller(1.0, NAN)));
  CHECK(std::isnan(larger(NAN, 1.0)));
  CHECK(std::isnan(larger(1.0, NAN)));
  CHECK(where_below(1.0, 1.0, 5.0, 6.0) == 6.0);
  // Only the branch taken is evaluated.
  CHECK(where_below(
            0.0, 1.0, [] { return 2.0; }, []() -> double { throw 1; }) == 2.0);
}

}  // namespace scalars_test
