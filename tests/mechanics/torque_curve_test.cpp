// SPDX-License-Identifier: Apache-2.0
#include "mechanics/torque_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "catch.h"

namespace torque_curve_test {

using millwright::mechanics::PullOutCurve;
using millwright::scalar::Dual;
using millwright::scalar::Interval;

namespace {
PullOutCurve sample() { return PullOutCurve({{60, 0.9}, {10, 1.0}, {20, 1.2}, {100, 0.1}}); }
}  // namespace

TEST_CASE("a pull-out curve is straight between its points and level outside") {
  const PullOutCurve curve = sample();
  CHECK(curve(0.0) == 1.0);
  CHECK(curve(10.0) == 1.0);
  CHECK(curve(15.0) == Approx(1.1));
  CHECK(curve(20.0) == 1.2);
  CHECK(curve(40.0) == Approx(1.05));
  CHECK(curve(80.0) == Approx(0.5));
  CHECK(curve(100.0) == 0.1);
  CHECK(curve(1e6) == 0.1);
  CHECK(curve.first_speed() == 10.0);
  CHECK(curve.last_speed() == 100.0);
}

TEST_CASE("a pull-out curve that cannot be one is refused") {
  CHECK_THROWS_AS(PullOutCurve({}), std::invalid_argument);
  CHECK_THROWS_AS(PullOutCurve({{1, 1}, {1, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(PullOutCurve({{1, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(PullOutCurve({{1, std::numeric_limits<double>::quiet_NaN()}}), std::invalid_argument);
  CHECK_THROWS_AS(PullOutCurve({{std::numeric_limits<double>::infinity(), 1}}), std::invalid_argument);
}

TEST_CASE("the range of a pull-out curve is what its points and ends span") {
  const PullOutCurve curve = sample();
  const Interval hump = curve(Interval(12, 70));
  CHECK(hump.upper == 1.2);
  CHECK(hump.lower == Approx(0.7));
  CHECK(curve(Interval(0, 5)).is_point());
  CHECK(curve(Interval(200, 300)).is_point());
  const Interval all = curve(Interval::entire());
  CHECK(all.lower == 0.1);
  CHECK(all.upper == 1.2);
}

TEST_CASE("ranges and slopes of a pull-out curve hold for every speed and pair of speeds") {
  std::mt19937 engine(11);
  std::uniform_real_distribution<> speed(0, 130);
  const PullOutCurve curve = sample();
  for (int n = 0; n < 2000; ++n) {
    const auto [low, high] = std::minmax({std::round(speed(engine)), std::round(speed(engine))});
    const auto result = curve(Dual<Interval>::variable(Interval(low, high), 0));
    for (int k = 0; k < 20; ++k) {
      const double a = std::clamp(speed(engine), low, high), b = std::clamp(speed(engine), low, high);
      CHECK(curve(a) >= result.value.lower - 1e-15);
      CHECK(curve(a) <= result.value.upper + 1e-15);
      const Interval allowed = result.slope[0] * (b - a);
      CHECK(curve(b) - curve(a) >= allowed.lower - 1e-14);
      CHECK(curve(b) - curve(a) <= allowed.upper + 1e-14);
    }
    CHECK(contains(result.slope[0], curve(Dual<double>::variable(low, 0)).slope[0]));
  }
}

TEST_CASE("at a kink a pull-out curve has the slopes of both sides") {
  const auto kink = sample()(Dual<Interval>::variable(Interval(20.0), 0));
  CHECK(kink.slope[0].upper == Approx(0.02));
  CHECK(kink.slope[0].lower == Approx(-0.0075));
  CHECK(sample()(Dual<double>::variable(20.0, 0)).slope[0] == Approx(-0.0075));
  const auto end = sample()(Dual<Interval>::variable(Interval(90.0, 100.0), 0));
  CHECK(end.slope[0].upper == 0.0);
}

}  // namespace torque_curve_test
