// SPDX-License-Identifier: Apache-2.0
// Motion profiles against a controller simulated in small steps, and against each other.
#include "mechanics/motion.h"

#include <cmath>

#include "catch.h"
#include "formula_samples.h"
#include "mechanics/s_curve.h"

namespace motion_test {

using namespace millwright::mechanics;
using formula_samples::Random;
using millwright::scalar::Interval;

namespace {

struct Move {
  double distance, speed, acceleration, jerk;
};

Move random_move(Random& random) {
  return {std::pow(10.0, random.uniform(-4.0, 0.0)),
          std::pow(10.0, random.uniform(-2.0, 0.3)),
          std::pow(10.0, random.uniform(-1.0, 1.0)),
          std::pow(10.0, random.uniform(0.0, 3.0))};
}

}  // namespace

TEST_CASE("a jerk-limited move reaches its distance within its limits") {
  Random random("jerk-limited move");
  int simulated = 0;
  for (int i = 0; i < 300; ++i) {
    const Move m = random_move(random);
    const double total = motion::s_curve_time(m.distance, m.speed, m.acceleration, m.jerk);
    const auto position = [&](double t) {
      return motion::s_curve_position(t, m.distance, m.speed, m.acceleration, m.jerk);
    };
    CHECK(std::abs(position(-1.0)) <= 1e-13 * m.distance);
    CHECK(position(total) == Approx(m.distance).epsilon(1e-9));
    CHECK(position(2.0 * total) == Approx(m.distance).epsilon(1e-9));
    CHECK(position(0.5 * total) == Approx(0.5 * m.distance).epsilon(1e-9));
    // Speed and acceleration by differences of the position; peak values are those the formulas say.
    const double peak = motion::s_curve_peak_speed(m.distance, m.speed, m.acceleration, m.jerk);
    if (total > 12.0 * motion::speed_up_time(peak, m.acceleration, m.jerk)) continue;  // all cruise: too coarse
    ++simulated;
    const int steps = 8000;
    const double dt = total / steps;
    double speed_peak = 0.0, acceleration_peak = 0.0, square_speed = 0.0, square_acceleration = 0.0;
    for (int k = 0; k <= steps; ++k) {
      const double t = k * dt, before = position(t - dt), here = position(t), after = position(t + dt);
      const double speed = (after - before) / (2.0 * dt), acceleration = (after - 2.0 * here + before) / (dt * dt);
      speed_peak = std::max(speed_peak, speed);
      acceleration_peak = std::max(acceleration_peak, acceleration);
      square_speed += speed * speed / steps;
      square_acceleration += acceleration * acceleration / steps;
    }
    INFO(m.distance << " " << m.speed << " " << m.acceleration << " " << m.jerk);
    const auto args = [&](auto formula) { return formula(m.distance, m.speed, m.acceleration, m.jerk); };
    CHECK(speed_peak == Approx(args([](auto... x) { return motion::s_curve_peak_speed(x...); })).epsilon(0.005));
    CHECK(acceleration_peak ==
          Approx(args([](auto... x) { return motion::s_curve_peak_acceleration(x...); })).epsilon(0.02));
    CHECK(std::sqrt(square_speed) ==
          Approx(args([](auto... x) { return motion::s_curve_rms_speed(x...); })).epsilon(0.005));
    CHECK(std::sqrt(square_acceleration) ==
          Approx(args([](auto... x) { return motion::s_curve_rms_acceleration(x...); })).epsilon(0.02));
  }
  CHECK(simulated > 50);
}

TEST_CASE("jerk only costs time, and without limit of jerk the trapezoid is left") {
  Random random("jerk costs time");
  for (int i = 0; i < 1000; ++i) {
    const Move m = random_move(random);
    const double trapezoid = motion::trapezoidal_time(m.distance, m.speed, m.acceleration, m.acceleration);
    CHECK(motion::s_curve_time(m.distance, m.speed, m.acceleration, m.jerk) >= trapezoid * (1.0 - 1e-12));
    CHECK(motion::s_curve_time(m.distance, m.speed, m.acceleration, 1e12) == Approx(trapezoid).epsilon(1e-6));
  }
}

TEST_CASE("the required acceleration makes the move take exactly its time") {
  Random random("required acceleration");
  int possible = 0;
  for (int i = 0; i < 1000; ++i) {
    const Move m = random_move(random);
    const double time = random.uniform(0.01, 5.0);
    const double acceleration = motion::required_acceleration(m.distance, time, m.speed);
    if (m.speed * time <= m.distance) {
      CHECK(acceleration == std::numeric_limits<double>::infinity());
      continue;
    }
    ++possible;
    CHECK(motion::trapezoidal_time(m.distance, m.speed, acceleration, acceleration) == Approx(time).epsilon(1e-9));
  }
  CHECK(possible > 300);
}

TEST_CASE("ranges of move times are as tight as their corners") {
  Random random("tight times");
  for (int i = 0; i < 200; ++i) {
    const Move m = random_move(random);
    const double w = random.uniform(1.0, 2.0);
    const auto around = [&](double x) { return Interval(x / w, x * w); };
    const Interval range =
        motion::s_curve_time(around(m.distance), around(m.speed), around(m.acceleration), around(m.jerk));
    CHECK(range.lower ==
          Approx(motion::s_curve_time(m.distance / w, m.speed * w, m.acceleration * w, m.jerk * w)).epsilon(1e-9));
    CHECK(range.upper ==
          Approx(motion::s_curve_time(m.distance * w, m.speed / w, m.acceleration / w, m.jerk / w)).epsilon(1e-9));
    const Interval trapezoid =
        motion::trapezoidal_time(around(m.distance), around(m.speed), around(m.acceleration), around(m.acceleration));
    CHECK(trapezoid.upper ==
          Approx(motion::trapezoidal_time(m.distance * w, m.speed / w, m.acceleration / w, m.acceleration / w))
              .epsilon(1e-9));
  }
}

}  // namespace motion_test
