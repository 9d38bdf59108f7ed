// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "catch.h"
#include "mechanics/actuation.h"
#include "mechanics/actuation_steps.h"
#include "mechanics/arithmetic.h"
#include "mechanics/beam.h"
#include "mechanics/cutting.h"
#include "mechanics/guide.h"
#include "mechanics/power_screw.h"
#include "mechanics/section.h"
#include "mechanics/square_thread.h"
#include "mechanics/tool_point.h"
#include "mechanics/utilisation.h"
#include "mechanics/vibration.h"

namespace loads_test {

using namespace millwright::mechanics;

TEST_CASE("the loads of four carriages balance force and moments") {
  const double fx = 120, fy = 80, fz = -400, xf = 0.05, yf = 0.02, zf = 0.2, zd = -0.03, yd = 0.01, lx = 0.2, ly = 0.3;
  const double mx = guide::roll_moment(fy, fz, yf, zf), my = guide::pitch_moment(fx, fz, xf, zf, zd);
  const double mz = guide::yaw_moment(fx, fy, xf, yf, yd);
  double sum_z = 0, sum_y = 0, roll = 0, pitch = 0, yaw = 0, worst = 0;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double pz = guide::carriage_vertical_load(fz, mx, my, lx, ly, sx, sy);
      const double py = guide::carriage_lateral_load(fy, mz, lx, sx);
      sum_z += pz;
      sum_y += py;
      roll += 0.5 * sy * ly * pz;
      pitch -= 0.5 * sx * lx * pz;
      yaw += 0.5 * sx * lx * py;
      worst = std::max(worst, guide::equivalent_load(pz, py));
    }
  }
  CHECK(sum_z == Approx(fz));
  CHECK(sum_y == Approx(fy));
  CHECK(roll == Approx(mx));
  CHECK(pitch == Approx(my));
  CHECK(yaw == Approx(mz));
  CHECK(guide::largest_carriage_load(fz, mx, my, fy, mz, lx, ly) >= worst * (1.0 - 1e-12));
}

TEST_CASE("a guide shaft is a beam under two forces") {
  const double f = 60, l = 0.5, s = 0.06, e = 206e9, d = 0.012, a = 0.5 * (l - s);
  const double i = section::round_second_moment(d, 0.0);
  CHECK(guide::shaft_deflection(f, l, s, e, d) == Approx(beam::supported_deflection_two_loads(0.5 * f, a, l, e, i)));
  CHECK(guide::shaft_stress(f, l, s, d) == Approx(0.5 * f * a * 0.5 * d / i));
  const auto at = [&](double x) {
    return beam::supported_deflection_at(0.5 * f, a, x, l, e, i) +
           beam::supported_deflection_at(0.5 * f, l - a, x, l, e, i);
  };
  CHECK(guide::shaft_slope(f, l, s, e, d) == Approx((at(a + 1e-6) - at(a - 1e-6)) / 2e-6).epsilon(1e-5));
}

TEST_CASE("the mean load of equal loads is that load, and a rating changes with its distance") {
  const std::array<double, 3> loads{90, 90, 90}, distances{1, 2, 0.5};
  for (const double exponent : {3.0, 10.0 / 3.0})
    CHECK(guide::mean_load(std::span<const double>(loads), std::span<const double>(distances), exponent) == Approx(90));
  const double rated = guide::dynamic_load_rating_50_km(9000.0);
  CHECK(guide::ball_life_distance(rated, 500.0, 1.0, 1.0, 5e4) ==
        Approx(guide::ball_life_distance(9000.0, 500.0, 1.0, 1.0, 1e5)));
}

TEST_CASE("motor torque of a screw axis is that of the screw, up and down, self-locking or not") {
  for (const double friction : {0.02, 0.08, 0.15}) {
    const double lead = 0.008, diameter = 0.026;
    const double angle = power_screw::lead_angle(lead, diameter);
    const double forward = power_screw::thread_efficiency(angle, friction);
    const double reverse = power_screw::reverse_efficiency(angle, friction);
    const auto motor = [&](double force) {
      return actuation::screw_motor_torque(force, lead, forward, reverse, 0.0, 0.0, 0.0, 1.0, 1.0);
    };
    CHECK(motor(500.0) == Approx(power_screw::raising_torque(500.0, diameter, lead, friction)));
    CHECK(motor(-500.0) == Approx(power_screw::lowering_torque(500.0, diameter, lead, friction)));
    CHECK(motor(-1e-9) == Approx(motor(1e-9)).margin(1e-10));
  }
}

TEST_CASE("power out of a screw axis never exceeds power in") {
  const double lead = 0.01, force = 300.0, omega = 60.0, speed = omega * lead / (2.0 * std::numbers::pi);
  const double torque = actuation::screw_motor_torque(force, lead, 0.9, 0.88, 0.0, 0.0, 0.0, 1.0, 1.0);
  CHECK(0.9 * actuation::power(torque, omega) == Approx(force * speed));
}

TEST_CASE("gravity drives a motor back only through a screw that yields, and only beyond friction") {
  CHECK(actuation::backdriving_torque(49.0, 0.008, 0.55, 4.0, 1.0) ==
        Approx(45.0 * 0.008 * 0.55 / (2.0 * std::numbers::pi)));
  CHECK(actuation::backdriving_torque(49.0, 0.008, -0.3, 4.0, 1.0) == 0.0);
  CHECK(actuation::backdriving_torque(3.0, 0.008, 0.55, 4.0, 1.0) == 0.0);
  // Friction above gravity on a self-locking screw: the product of the two negative factors must not count.
  CHECK(actuation::backdriving_torque(3.0, 0.008, -0.3, 4.0, 1.0) == 0.0);
}

TEST_CASE("square thread, step by step and in one piece") {
  // Mini mill, X axis: 28.7 N on a 16 x 2 mm thread with friction 0.12; recomputed 35.1445 N·mm and 9.13549 N·mm.
  const double alpha = square_thread::lead_tangent(0.002, 0.015);
  CHECK(alpha == Approx(0.0424413).epsilon(1e-6));
  const double torque = square_thread::torque(28.7, 0.015, square_thread::tangent_of_sum(alpha, 0.12));
  CHECK(torque == Approx(35.1445e-3).epsilon(1e-5));
  CHECK(torque == Approx(power_screw::raising_torque(28.7, 0.015, 0.002, 0.12)));
  CHECK(square_thread::torque(28.7, 0.015, alpha) == Approx(9.13549e-3).epsilon(1e-5));
  CHECK(square_thread::tangential_force(torque, 0.015) == Approx(torque / 0.0075));
}

TEST_CASE("sander, X axis, step by step") {
  // 21.5 kg on a lead of 5 mm... as printed: inertia 54.46e-6 + 39.06e-6 kg·m², 120 r/min in 0.2 s, rotor 6.06e-6.
  const double speed = 120.0 * std::numbers::pi / 30.0;
  const double alpha = actuation::angular_acceleration(speed, 0.2);
  CHECK(alpha == Approx(62.8319).epsilon(1e-6));
  const double inertia = actuation::accelerated_inertia(6.06e-6, 93.5226e-6, 1.0);
  CHECK(actuation::inertia_torque(inertia, alpha) == Approx(0.006256962).epsilon(1e-5));
  CHECK(actuation::flywheel_effect(1.0, 0.02, 0.01) == Approx(5e-4));
}

TEST_CASE("chip volume is engagement times feed") {
  // Mean chip thickness times arc length times teeth per second times depth is the removal rate.
  const double fz = 5e-5, ae = 0.002, d = 0.006, ap = 0.002, omega = 1885.0, teeth = 2.0;
  const double h = cutting::mean_chip_thickness(fz, ae, d, 0.5 * std::numbers::pi);
  const double arc = 0.5 * d * std::acos(1.0 - 2.0 * ae / d);
  const double volume = h * arc * ap * teeth * omega / (2.0 * std::numbers::pi);
  CHECK(volume == Approx(cutting::removal_rate(ap, ae, cutting::feed_speed(fz, teeth, omega))));
}

TEST_CASE("specific cutting force is its table value at one millimetre and falls by the rake in per cent") {
  CHECK(cutting::specific_cutting_force(7e8, 1e-3, 0.25, 0.0) == Approx(7e8));
  CHECK(cutting::specific_cutting_force(7e8, 1e-3, 0.25, 10.0 * std::numbers::pi / 180.0) == Approx(0.9 * 7e8));
  // Peak tooth force grows steadily into the slot and stays level beyond half the diameter.
  const auto peak = [](double engagement) {
    return cutting::peak_tooth_force(7e8, 0.25, 0.002, 5e-5, engagement, 0.006);
  };
  CHECK(peak(0.003 - 1e-12) == Approx(peak(0.003)));
  CHECK(peak(0.006) == Approx(peak(0.003)));
  CHECK(peak(0.001) < peak(0.002));
}

TEST_CASE("natural frequencies of one system agree") {
  const double k = 5e6, m = 12.0, g = 9.80665;
  CHECK(vibration::natural_frequency_of_static_deflection(m * g / k) == Approx(vibration::natural_frequency(k, m)));
  CHECK(vibration::cantilever_natural_frequency(206e9, 5e-8, 0.5, m, 0.0) ==
        Approx(vibration::natural_frequency(3.0 * 206e9 * 5e-8 / 0.125, m)));
  // Without a tip mass the Rayleigh estimate is close above the exact uniform beam.
  const double exact = vibration::uniform_beam_natural_frequency(1.875104068711961, 206e9, 5e-8, 3.2, 0.5);
  const double estimate = vibration::cantilever_natural_frequency(206e9, 5e-8, 0.5, 0.0, 1.6);
  CHECK(estimate > exact);
  CHECK(estimate == Approx(exact).epsilon(0.02));
  const std::array<double, 3> parts{80, 120, 45};
  CHECK(vibration::dunkerley_frequency(std::span<const double>(parts)) < 45.0);
}

TEST_CASE("springs in series at the tool are the reciprocal of their compliance") {
  const std::array<double, 2> k{2e7, 6e7}, g{1.0, 1.0};
  CHECK(1.0 / tool_point::chain_compliance(std::span<const double>(k), std::span<const double>(g)) == Approx(1.5e7));
}

TEST_CASE("a design without capacity ranks last, not nowhere") {
  CHECK(utilisation::of_maximum(62.0, 100.0) == Approx(0.62));
  CHECK(utilisation::of_maximum(1.0, 0.0) == 1e9);
  CHECK(utilisation::of_maximum(1.0, -3.0) == 1e9);
  CHECK(utilisation::of_minimum(1.5, 2.0) == Approx(0.75));
  CHECK(utilisation::of_minimum(1.5, 0.0) == 1e9);
}

}  // namespace loads_test
