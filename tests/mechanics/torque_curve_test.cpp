// SPDX-License-Identifier: Apache-2.0
#include "mechanics/torque_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "catch.h"

namespace torque_curve_test {

using millwright::mechanics::least_of;
using millwright::mechanics::PullOutCurve;
using millwright::scalar::Dual;
using millwright::scalar::Interval;

namespace {
PullOutCurve sample() { return PullOutCurve({{60, 0.9}, {10, 1.0}, {20, 1.2}, {100, 0.1}}); }
}  // namespace

// Its hump does not count: on the way there the motor has 1.0 only. From 1.2 at 20 to 0.9 at 60 it is 1.0 again at
// 20 + 40 * 0.2/0.3.
TEST_CASE("a pull-out curve is straight between its points, level outside and where it rose") {
  const PullOutCurve curve = sample();
  CHECK(curve(0.0) == 1.0);
  CHECK(curve(10.0) == 1.0);
  CHECK(curve(15.0) == 1.0);
  CHECK(curve(20.0) == 1.0);
  CHECK(curve(40.0) == 1.0);
  CHECK(curve(20.0 + 40.0 * 0.2 / 0.3) == Approx(1.0).epsilon(1e-12));
  CHECK(curve(50.0) == Approx(0.975));
  CHECK(curve(60.0) == 0.9);
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
  CHECK(hump.upper == 1.0);
  CHECK(hump.lower == Approx(0.7));
  CHECK(curve(Interval(0, 5)).is_point());
  CHECK(curve(Interval(200, 300)).is_point());
  const Interval all = curve(Interval::entire());
  CHECK(all.lower == 0.1);
  CHECK(all.upper == 1.0);
}

// The published line itself, and the least of it at 800 speeds on the way.
TEST_CASE("at every speed a pull-out curve is the least of the published line up to there") {
  std::mt19937 engine(3);
  std::uniform_real_distribution<> torque(0.0, 2.0), step(1.0, 40.0);
  for (int n = 0; n < 300; ++n) {
    std::vector<PullOutCurve::Point> points{{step(engine), torque(engine)}};
    for (int i = 0; i < 2 + n % 7; ++i) points.push_back({points.back().speed + step(engine), torque(engine)});
    const PullOutCurve curve(points);
    double least = points.front().torque;
    std::size_t segment = 0;
    const double first = points.front().speed, last = points.back().speed;
    CHECK(curve(first) == points.front().torque);
    CHECK(curve.last_speed() == last);
    for (int i = 1; i <= 800; ++i) {
      const double speed = std::min(first + (last - first) * i / 800.0, last);
      while (points[segment + 1].speed < speed) least = std::min(least, points[++segment].torque);
      const auto &from = points[segment], &to = points[segment + 1];
      least = std::min(least, from.torque + (speed - from.speed) / (to.speed - from.speed) * (to.torque - from.torque));
      REQUIRE(curve(speed) == Approx(least).margin(1e-12));
    }
    for (std::size_t i = 1; i < curve.points().size(); ++i) {
      CHECK(curve.points()[i].torque <= curve.points()[i - 1].torque);
      CHECK(curve.points()[i].speed > curve.points()[i - 1].speed);
    }
  }
}

TEST_CASE("of several pull-out curves the least is at every speed the least of what each gives") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<> torque(0.0, 2.0), step(1.0, 40.0), share(-0.2, 1.2);
  for (int n = 0; n < 300; ++n) {
    std::vector<PullOutCurve> curves;
    double last = 0.0;
    for (int k = 0; k < 1 + n % 4; ++k) {
      std::vector<PullOutCurve::Point> points{{step(engine), torque(engine)}};
      // Some share a speed.
      for (int i = 0; i < 1 + n % 5; ++i)
        points.push_back({std::ceil(points.back().speed + step(engine)), torque(engine)});
      curves.emplace_back(points);
      last = std::max(last, points.back().speed);
    }
    const PullOutCurve least = least_of(curves);
    CHECK(least.last_speed() == last);
    for (int i = 0; i < 400; ++i) {
      const double speed = std::max(0.0, share(engine) * last);
      double expected = 2.0;
      for (const PullOutCurve& curve : curves) expected = std::min(expected, curve(speed));
      REQUIRE(least(speed) == Approx(expected).margin(1e-12));
    }
  }
  CHECK_THROWS_AS(least_of({}), std::invalid_argument);
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
  const auto kink = sample()(Dual<Interval>::variable(Interval(60.0), 0));
  CHECK(kink.slope[0].upper == Approx(-0.0075));
  CHECK(kink.slope[0].lower == Approx(-0.02));
  CHECK(sample()(Dual<double>::variable(60.0, 0)).slope[0] == Approx(-0.02));
  CHECK(sample()(Dual<double>::variable(20.0, 0)).slope[0] == 0.0);
  const auto end = sample()(Dual<Interval>::variable(Interval(90.0, 100.0), 0));
  CHECK(end.slope[0].upper == 0.0);
}

}  // namespace torque_curve_test
