// SPDX-License-Identifier: Apache-2.0
#include "mechanics/stepper.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "mechanics/stepper_sizing.h"

namespace stepper_test {

using namespace millwright;
using namespace millwright::mechanics;
using scalar::Dual;
using scalar::Interval;

namespace {

struct Motor {
  double voltage, resistance, inductance, rotor_teeth, torque_constant, current, speed;
};

double pull_out(const Motor& m) {
  return stepper::pull_out_torque(
      m.voltage, m.resistance, m.inductance, m.rotor_teeth, m.torque_constant, m.current, m.speed);
}

/// The largest torque over all current vectors that the driver and the supply allow, by trying them: for each angle of
/// the voltage vector at full voltage, and for each angle of the current vector at full current.
double pull_out_by_trial(const Motor& m) {
  const double x = m.rotor_teeth * m.speed * m.inductance, e = m.torque_constant * m.speed;
  const double z2 = m.resistance * m.resistance + x * x;
  constexpr int steps = 200000;
  double best = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / steps;
    {
      const double v_d = m.voltage * std::cos(angle), v_q = m.voltage * std::sin(angle) - e;
      const double i_d = (m.resistance * v_d + x * v_q) / z2, i_q = (m.resistance * v_q - x * v_d) / z2;
      if (std::hypot(i_d, i_q) <= m.current * (1.0 + 1e-9)) best = std::max(best, i_q);
    }
    const double i_d = m.current * std::cos(angle), i_q = m.current * std::sin(angle);
    const double v_d = m.resistance * i_d - x * i_q, v_q = m.resistance * i_q + x * i_d + e;
    if (std::hypot(v_d, v_q) <= m.voltage * (1.0 + 1e-9)) best = std::max(best, i_q);
  }
  return m.torque_constant * best;
}

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(engine_); }
  double scaled(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  Motor motor() {
    return {scaled(8, 80),
            scaled(0.2, 8),
            scaled(5e-4, 2e-2),
            between(0, 1) < 0.8 ? 50.0 : 100.0,
            scaled(0.05, 1.5),
            scaled(0.3, 8),
            scaled(1, 600)};
  }

 private:
  std::mt19937 engine_;
};

struct BoxOfMotors {
  Interval v, r, l, n, k, i, w;
  Interval torque() const { return stepper::pull_out_torque(v, r, l, n, k, i, w); }
  Motor draw(Draw& random) const {
    const auto in = [&](const Interval& x) {
      const double share = random.between(-0.2, 1.2);  // the ends come up often
      return x.lower + std::clamp(share, 0.0, 1.0) * (x.upper - x.lower);
    };
    return {in(v), in(r), in(l), in(n), in(k), in(i), in(w)};
  }
};

BoxOfMotors box_around(const Motor& m, Draw& random, double widest) {
  const auto wide = [&](double x) {
    const double share = random.between(0, 1) < 0.3 ? 0.0 : random.between(0.0, widest);
    return Interval(x, x * (1.0 + share));
  };
  return {wide(m.voltage),
          wide(m.resistance),
          wide(m.inductance),
          Interval(m.rotor_teeth),
          wide(m.torque_constant),
          wide(m.current),
          wide(m.speed)};
}

}  // namespace

TEST_CASE("pull-out torque is the best over every angle of current and voltage") {
  Draw random(1);
  int working = 0;
  for (int n = 0; n < 150; ++n) {
    const Motor motor = random.motor();
    const double torque = pull_out(motor), tried = pull_out_by_trial(motor);
    const double scale = motor.torque_constant * motor.current;
    INFO("V " << motor.voltage << " R " << motor.resistance << " L " << motor.inductance << " K "
              << motor.torque_constant << " I " << motor.current << " w " << motor.speed);
    CHECK(torque == Approx(tried).margin(2e-4 * scale));
    if (torque > 0.0) ++working;
  }
  CHECK(working > 75);
}

TEST_CASE("pull-out torque is continuous where its cases meet") {
  // At the corner speed the current limit ends; the torque must not jump there, nor anywhere on a fine walk.
  for (const double voltage : {24.0, 48.0}) {
    Motor motor{voltage, 1.13, 0.0054, 50, 0.4798, 3.96, 0};
    const double corner = stepper::corner_speed(voltage, 1.13, 0.0054, 50.0, 0.4798, 3.96);
    motor.speed = corner * (1.0 - 1e-9);
    CHECK(pull_out(motor) == Approx(0.4798 * 3.96).epsilon(1e-12));
    motor.speed = corner * (1.0 + 1e-9);
    CHECK(pull_out(motor) == Approx(0.4798 * 3.96).epsilon(1e-8));
    double before = 0.4798 * 3.96;
    for (double speed = 0.01; speed < 1500; speed += 0.01) {
      motor.speed = speed;
      const double torque = pull_out(motor);
      REQUIRE(torque <= before * (1.0 + 1e-12));
      REQUIRE(before - torque < 1e-2);
      before = torque;
    }
  }
}

TEST_CASE("without field weakening there is never more torque") {
  Draw random(2);
  for (int n = 0; n < 2000; ++n) {
    const Motor m = random.motor();
    const double limited = stepper::quadrature_torque(
        m.voltage, m.resistance, m.inductance, m.rotor_teeth, m.torque_constant, m.current, m.speed);
    CHECK(limited <= pull_out(m) * (1.0 + 1e-9) + 1e-12);
    CHECK(limited >= 0.0);
  }
}

TEST_CASE("the range of the pull-out torque contains every motor of the box") {
  Draw random(3);
  for (int n = 0; n < 3000; ++n) {
    const BoxOfMotors box = box_around(random.motor(), random, n % 2 == 0 ? 0.1 : 3.0);
    const Interval range = box.torque();
    REQUIRE(range.is_bounded());
    REQUIRE(range.lower >= 0.0);
    for (int k = 0; k < 30; ++k) {
      const double torque = pull_out(box.draw(random));
      // The sampled value itself is rounded: allow it one part in 1e12 of the torque at standstill.
      const double rounding = 1e-12 * box.k.upper * box.i.upper;
      if (torque < range.lower - rounding || torque > range.upper + rounding) {
        INFO(torque << " not in [" << range.lower << ", " << range.upper << "]");
        REQUIRE(false);
      }
    }
  }
}

TEST_CASE("for one motor the range over voltage, current and speed is exact") {
  Draw random(4);
  for (int n = 0; n < 1000; ++n) {
    const Motor m = random.motor();
    const Interval v(m.voltage, 1.3 * m.voltage), i(m.current, 1.5 * m.current), w(0.3 * m.speed, m.speed);
    const Interval range = stepper::pull_out_torque(
        v, Interval(m.resistance), Interval(m.inductance), Interval(m.rotor_teeth), Interval(m.torque_constant), i, w);
    Motor least = m, most{v.upper, m.resistance, m.inductance, m.rotor_teeth, m.torque_constant, i.upper, w.lower};
    // Where two circles touch, rounding of the inputs shows by its square root.
    const double slack = 1e-6 * m.torque_constant * i.upper;
    CHECK(range.lower == Approx(pull_out(least)).margin(slack));
    CHECK(range.upper == Approx(pull_out(most)).margin(slack));
  }
}

TEST_CASE("the range of the pull-out torque closes in on the motor with the box") {
  Draw random(5);
  double worst = 0.0;
  for (int n = 0; n < 500; ++n) {
    const Motor m = random.motor();
    const auto wide = [](double x, double share) { return Interval(x, x * (1.0 + share)); };
    const auto width_of = [&](double share) {
      return width(stepper::pull_out_torque(wide(m.voltage, share),
                                            wide(m.resistance, share),
                                            wide(m.inductance, share),
                                            Interval(m.rotor_teeth),
                                            wide(m.torque_constant, share),
                                            wide(m.current, share),
                                            wide(m.speed, share))) /
             (m.torque_constant * m.current);
    };
    CHECK(width_of(0.01) < 0.3);
    CHECK(width_of(1e-6) < 3e-3);
    worst = std::max(worst, width_of(0.01));
  }
  CHECK(worst > 0.0);
}

TEST_CASE("slopes of the pull-out torque over a box contain the differences and keep their sign") {
  Draw random(6);
  for (int n = 0; n < 2000; ++n) {
    const BoxOfMotors box = box_around(random.motor(), random, n % 2 == 0 ? 0.1 : 1.0);
    const auto range = stepper::pull_out_torque_and_slopes(box.v, box.r, box.l, box.n, box.k, box.i, box.w);
    CHECK(range.slope[0].lower >= 0.0);
    CHECK(range.slope[1].upper <= 0.0);
    CHECK(range.slope[5].lower >= 0.0);
    CHECK(range.slope[6].upper <= 0.0);
    // By the mean value theorem the difference of two motors of the box that differ in one respect is the difference
    // of that argument times some slope in the range.
    for (int k = 0; k < 20; ++k) {
      const Motor a = box.draw(random), b = box.draw(random);
      double Motor::*const field[] = {&Motor::voltage,
                                      &Motor::resistance,
                                      &Motor::inductance,
                                      &Motor::rotor_teeth,
                                      &Motor::torque_constant,
                                      &Motor::current,
                                      &Motor::speed};
      for (std::size_t j = 0; j < 7; ++j) {
        Motor changed = a;
        changed.*field[j] = b.*field[j];
        const Interval allowed = range.slope[j] * (changed.*field[j] - a.*field[j]);
        const double difference = pull_out(changed) - pull_out(a);
        const double rounding = 1e-7 * box.k.upper * box.i.upper;
        if (difference < allowed.lower - rounding || difference > allowed.upper + rounding) {
          INFO("argument " << j << ": " << difference << " not in [" << allowed.lower << ", " << allowed.upper << "]");
          REQUIRE(false);
        }
      }
    }
  }
}

TEST_CASE("the torque over a box answers to one variable through the chain rule") {
  // Speed from lead and feed: dT/dlead = dT/dω · dω/dlead; a longer lead turns slower, so the torque cannot fall.
  using D = Dual<Interval>;
  const D lead = D::variable(Interval(0.004, 0.01), 0);
  const D speed = 2.0 * std::numbers::pi * D(Interval(0.1)) / lead;
  const D torque = stepper::available_torque(
      D(48.0), D(0.9), D(1.13), D(0.0054), D(50.0), D(1.9), D(2.8), D(3.96), speed, D(0.03), D(0.0005));
  CHECK(torque.slope[0].lower >= 0.0);
  CHECK(torque.slope[0].upper < scalar::rounding::infinity);
  CHECK(torque.value.is_bounded());
}

TEST_CASE("a motor at rest, without resistance or without supply gives a bounded range") {
  const Interval ordinary = stepper::pull_out_torque(
      Interval(24.0), Interval(1.4), Interval(3e-3), Interval(50.0), Interval(0.2), Interval(2.0), Interval(0.0, 1e4));
  CHECK(contains(ordinary, 0.4));
  CHECK(ordinary.upper <= 0.4 * (1 + 1e-12));
  const Interval lossless = stepper::pull_out_torque(
      Interval(0.0, 24.0), Interval(0.0), Interval(3e-3), Interval(50.0), Interval(0.2), Interval(2.0), Interval(0, 9));
  CHECK(lossless.lower >= 0.0);
  CHECK(lossless.upper <= 0.4 * (1 + 1e-12));
}

TEST_CASE("available torque against the makers' curves") {
  // Pull-out torque read off published charts of two motors (rpm, N·m). The model is stated to be within 4 to 7 % of
  // the holding torque (root mean square), at worst 12.2 %, and 0.7 of it never to promise more than the maker.
  struct Reading {
    double rpm, torque;
  };
  const auto check = [](double voltage,
                        double resistance,
                        double inductance,
                        double holding,
                        double rated,
                        double current,
                        std::initializer_list<Reading> readings) {
    double squares = 0.0;
    for (const auto& [rpm, torque] : readings) {
      const double model = stepper::available_torque(voltage,
                                                     0.9,
                                                     resistance,
                                                     inductance,
                                                     50.0,
                                                     holding,
                                                     rated,
                                                     current,
                                                     rpm * std::numbers::pi / 30.0,
                                                     0.03,
                                                     0.0005);
      INFO(rpm << " r/min: " << model << " against " << torque);
      CHECK(std::abs(model - torque) < 0.123 * holding);
      CHECK(0.7 * model <= torque * 1.02);
      squares += std::pow((model - torque) / holding, 2);
    }
    CHECK(std::sqrt(squares / static_cast<double>(readings.size())) < 0.075);
  };
  check(24, 1.4, 3e-3, 0.59, 2.0, 2.0, {{90, 0.43}, {300, 0.42}, {450, 0.39}, {600, 0.33}, {750, 0.23}});
  check(48,
        1.13,
        5.4e-3,
        1.9,
        2.8,
        3.96,
        {{90, 1.84},
         {300, 1.76},
         {390, 1.56},
         {510, 1.28},
         {600, 1.12},
         {810, 0.88},
         {990, 0.60},
         {1200, 0.40},
         {1500, 0.18}});
}

TEST_CASE("corner speed satisfies its equation, and its range is spanned by two corners") {
  Draw random(7);
  for (int n = 0; n < 300; ++n) {
    const Motor m = random.motor();
    const double w =
        stepper::corner_speed(m.voltage, m.resistance, m.inductance, m.rotor_teeth, m.torque_constant, m.current);
    if (m.resistance * m.current >= m.voltage) {
      CHECK(w == 0.0);
      continue;
    }
    const double needed =
        std::hypot(m.resistance * m.current + m.torque_constant * w, m.rotor_teeth * m.inductance * w * m.current);
    CHECK(needed == Approx(m.voltage).epsilon(1e-9));
  }
}

TEST_CASE("start speed is the largest jump that the equation of motion survives") {
  // J θ'' = T_s sin(N (ω t - θ)) - T_L from rest at the loaded equilibrium, at 0.98 and 1.02 of the estimate.
  const double static_torque = 1.26, load = 0.2, teeth = 50, inertia = 6e-5;
  const double jump = stepper::start_speed(static_torque, load, teeth, inertia);
  const auto keeps_up = [&](double speed) {
    double lead = std::asin(load / static_torque) / teeth, rate = speed;  // of the field before the rotor
    const double dt = 1e-7;
    for (int i = 0; i < 2000000; ++i) {
      rate -= dt * (static_torque * std::sin(teeth * lead) - load) / inertia;
      lead += dt * rate;
      if (teeth * lead > 2.0 * std::numbers::pi) return false;
      if (rate < 0.0) return true;
    }
    return true;
  };
  CHECK(keeps_up(0.98 * jump));
  CHECK_FALSE(keeps_up(1.02 * jump));
}

TEST_CASE("the range of the start speed is tight, and its slopes have a sign") {
  std::mt19937 engine(3);
  const auto within = [&](const Interval& x) {
    return std::uniform_real_distribution<double>(x.lower, x.upper)(engine);
  };
  std::size_t below = 0;
  for (int n = 0; n < 2000; ++n) {
    const double torque = within({0.3, 3.0}), share = within({0.0, 0.9});
    const Interval strong(torque, torque * within({1.0, 1.5})), load(share * torque, within({share, 1.1}) * torque);
    const Interval teeth(50.0, within({50.0, 100.0})), inertia(2e-5, within({2e-5, 2e-4}));
    const Interval range = stepper::start_speed(strong, load, teeth, inertia);
    const double most = stepper::start_speed(strong.upper, load.lower, teeth.lower, inertia.lower);
    CHECK(range.upper == Approx(most).epsilon(1e-12));
    using Slope = scalar::Dual<Interval, 1>;
    Slope of_load(load), of_inertia(inertia), of_strength(strong);
    of_load.slope[0] = of_inertia.slope[0] = of_strength.slope[0] = Interval(1.0);
    const Interval by_load = stepper::start_speed(Slope(strong), of_load, Slope(teeth), Slope(inertia)).slope[0];
    const Interval by_inertia = stepper::start_speed(Slope(strong), Slope(load), Slope(teeth), of_inertia).slope[0];
    const Interval by_strength = stepper::start_speed(of_strength, Slope(load), Slope(teeth), Slope(inertia)).slope[0];
    CHECK(by_load.upper <= 0.0);
    CHECK(by_inertia.upper <= 0.0);
    CHECK(by_strength.lower >= 0.0);
    for (int k = 0; k < 3; ++k) {
      const double t = within(strong), l = within(load), z = within(teeth), j = within(inertia);
      if (l >= 0.999 * t) continue;
      ++below;
      const double speed = stepper::start_speed(t, l, z, j);
      CHECK(range.lower <= speed);
      CHECK(speed <= range.upper);
      const double l2 = within({load.lower, std::min(load.upper, 0.999 * t)});
      const double j2 = within(inertia), t2 = within({std::max(strong.lower, l / 0.999), strong.upper});
      const auto secant = [&](double other, double from, double to, const Interval& slope) {
        if (std::abs(to - from) < 1e-6 * std::abs(to)) return;
        const double s = (other - speed) / (to - from);
        CHECK(slope.lower <= s + 1e-9 * std::abs(s));
        CHECK(s - 1e-9 * std::abs(s) <= slope.upper);
      };
      secant(stepper::start_speed(t, l2, z, j), l, l2, by_load);
      secant(stepper::start_speed(t, l, z, j2), j, j2, by_inertia);
      secant(stepper::start_speed(t2, l, z, j), t, t2, by_strength);
    }
  }
  CHECK(below > 3000);
}

TEST_CASE("one microstep of a full step is the static torque") {
  CHECK(stepper::microstep_torque(1.34, 1.0) == Approx(1.34));
  CHECK(stepper::microstep_torque(1.0, 16.0) == Approx(0.098).margin(5e-4));   // drive makers' table: 9.8 %
  CHECK(stepper::microstep_torque(1.0, 64.0) == Approx(0.0245).margin(5e-5));  // 2.45 %
}

}  // namespace stepper_test
