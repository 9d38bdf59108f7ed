// SPDX-License-Identifier: Apache-2.0
// Identities between the formulas of power screws, ball screws and belts, and published table values.
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "formula_samples.h"
#include "mechanics/ball_screw.h"
#include "mechanics/ball_screw_cycle.h"
#include "mechanics/belt.h"
#include "mechanics/buckling.h"
#include "mechanics/critical_speed.h"
#include "mechanics/power_screw.h"
#include "mechanics/power_screw_strength.h"

namespace screw_test {

using namespace millwright::mechanics;
using formula_samples::Random;
using millwright::scalar::Interval;
using power_screw::ThreadForm;

TEST_CASE("core and mean diameters are those of the thread tables") {
  // DIN 103 (Tr), ISO 724 (M), ASME B1.5 (Acme 1-5), in mm.
  struct Row {
    ThreadForm form;
    double major, pitch, mean, core, tolerance;
  };
  const Row rows[] = {{ThreadForm::trapezoidal, 8, 1.5, 7.25, 6.2, 1e-9},
                      {ThreadForm::trapezoidal, 10, 2, 9, 7.5, 1e-9},
                      {ThreadForm::trapezoidal, 20, 4, 18, 15.5, 1e-9},
                      {ThreadForm::trapezoidal, 28, 5, 25.5, 22.5, 1e-9},
                      {ThreadForm::trapezoidal, 30, 6, 27, 23, 1e-9},
                      {ThreadForm::trapezoidal, 60, 12, 54, 47, 1e-9},
                      {ThreadForm::trapezoidal, 70, 14, 63, 54, 1e-9},
                      {ThreadForm::metric_60, 8, 1.25, 7.188, 6.466, 1e-3},
                      {ThreadForm::metric_60, 12, 1.75, 10.863, 9.853, 1e-3},
                      {ThreadForm::acme, 25.4, 5.08, 22.86, 19.812, 1e-9}};
  for (const Row& row : rows) {
    INFO(row.major << " x " << row.pitch);
    CHECK(std::abs(1e3 * power_screw::mean_diameter(row.form, 1e-3 * row.major, 1e-3 * row.pitch) - row.mean) <=
          row.tolerance);
    CHECK(std::abs(1e3 * power_screw::core_diameter(row.form, 1e-3 * row.major, 1e-3 * row.pitch) - row.core) <=
          row.tolerance);
  }
}

TEST_CASE("torque, efficiency and self-locking tell the same story") {
  Random random("torque and efficiency");
  for (int i = 0; i < 1000; ++i) {
    const double force = random.uniform(1.0, 1e4), diameter = random.uniform(5e-3, 5e-2);
    const double lead = random.uniform(1e-3, 2e-2), friction = random.uniform(0.02, 0.3);
    const double angle = power_screw::lead_angle(lead, diameter);
    const double raising = power_screw::raising_torque(force, diameter, lead, friction);
    const double lowering = power_screw::lowering_torque(force, diameter, lead, friction);
    // The form with the friction angle, W d/2 tan(λ ± φ).
    CHECK(raising == Approx(force * diameter / 2.0 * std::tan(angle + std::atan(friction))).epsilon(1e-9));
    CHECK(lowering == Approx(-force * diameter / 2.0 * std::tan(angle - std::atan(friction))).epsilon(1e-9));
    // Self-locking or not: what drives the nut back is what lowering asks for, turned round.
    CHECK(ball_screw::backdriving_torque(force, lead, power_screw::reverse_efficiency(angle, friction)) ==
          Approx(-lowering).epsilon(1e-9).margin(1e-12 * force * lead));
    CHECK(power_screw::efficiency(force, lead, raising) ==
          Approx(power_screw::thread_efficiency(angle, friction)).epsilon(1e-9));
    CHECK(power_screw::thread_efficiency(angle, friction) <= power_screw::greatest_thread_efficiency(friction) + 1e-12);
    CHECK(-power_screw::reverse_efficiency(angle, friction) * force * lead / (2.0 * std::numbers::pi) ==
          Approx(lowering).epsilon(1e-9));
    CHECK((power_screw::self_locking_ratio(angle, friction) < 1.0) == (lowering > 0.0));
    if (lowering > 0.0) CHECK(power_screw::thread_efficiency(angle, friction) < 0.5);
    // A ball screw's efficiencies are the same mechanics.
    CHECK(ball_screw::efficiency(friction, angle) ==
          Approx(power_screw::thread_efficiency(angle, friction)).epsilon(1e-12));
    CHECK(ball_screw::reverse_efficiency(friction, angle) ==
          Approx(power_screw::reverse_efficiency(angle, friction)).epsilon(1e-9));
  }
}

TEST_CASE("collar with a ring of no width") {
  CHECK(power_screw::collar_torque_uniform_pressure(1000.0, 0.1, 0.02, 0.02) == Approx(2.0).epsilon(1e-12));
  CHECK(power_screw::collar_torque(1000.0, 0.1, 0.02, 0.02) == Approx(2.0).epsilon(1e-12));
  // Solid pivot, uniform pressure: two thirds of the radius.
  CHECK(power_screw::collar_torque_uniform_pressure(1000.0, 0.1, 0.03, 0.0) == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("buckling is smooth across the transition and never above Euler or the yield force") {
  Random random("buckling");
  for (int i = 0; i < 500; ++i) {
    const double c = random.uniform(0.25, 4.0), e = random.uniform(6e10, 2.1e11), s = random.uniform(1e8, 9e8);
    const double d = random.uniform(5e-3, 5e-2);
    const double at = buckling::transition_slenderness(c, e, s) * d / 4.0;
    const double below = buckling::critical_load(c, e, s, d, at * (1.0 - 1e-9));
    const double above = buckling::critical_load(c, e, s, d, at * (1.0 + 1e-9));
    CHECK(below == Approx(above).epsilon(1e-7));
    CHECK(below == Approx(s * std::numbers::pi * d * d / 8.0).epsilon(1e-6));
    const double length = at * random.uniform(0.05, 4.0);
    const double load = buckling::critical_load(c, e, s, d, length);
    CHECK(load <= buckling::euler_load(c, e, d, length) * (1.0 + 1e-12));
    CHECK(load <= s * std::numbers::pi * d * d / 4.0);
    CHECK(load > 0.0);
    const double w = random.uniform(1.0, 1.5);
    const auto around = [&](double x) { return Interval(x / w, x * w); };
    const Interval range = buckling::critical_load(around(c), around(e), around(s), around(d), around(length));
    CHECK(range.upper == Approx(buckling::critical_load(c * w, e * w, s * w, d * w, length / w)).epsilon(1e-6));
    CHECK(range.lower == Approx(buckling::critical_load(c / w, e / w, s / w, d / w, length * w)).epsilon(1e-6));
  }
}

TEST_CASE("eigenvalues solve their frequency equations") {
  using buckling::EndCondition;
  const auto free = critical_speed::eigenvalue(EndCondition::fixed_free);
  const auto propped = critical_speed::eigenvalue(EndCondition::fixed_supported);
  const auto fixed = critical_speed::eigenvalue(EndCondition::fixed_fixed);
  CHECK(std::abs(std::cos(free) * std::cosh(free) + 1.0) < 1e-12);
  CHECK(std::abs(std::tan(propped) - std::tanh(propped)) < 1e-10);
  CHECK(std::abs(std::cos(fixed) * std::cosh(fixed) - 1.0) < 1e-10);
  CHECK(std::abs(std::sin(critical_speed::eigenvalue(EndCondition::supported_supported))) < 1e-15);
}

TEST_CASE("catalogue rules in millimetres and rpm give the same permissible speed and load") {
  // n = λ₂ d / L² 10⁷ and P = η₂ d⁴ / L² 10⁴ with the factors that the catalogues print.
  using buckling::EndCondition;
  struct Row {
    EndCondition ends;
    double speed_factor, load_factor;
  };
  for (const Row& row : {Row{EndCondition::fixed_free, 3.4, 1.25},
                         Row{EndCondition::supported_supported, 9.7, 5.0},
                         Row{EndCondition::fixed_supported, 15.1, 10.0},
                         Row{EndCondition::fixed_fixed, 21.9, 20.0}}) {
    const double rpm =
        ball_screw::permissible_speed(critical_speed::eigenvalue(row.ends), 0.0133, 0.8) * 30.0 / std::numbers::pi;
    CHECK(rpm == Approx(row.speed_factor * 13.3 / (800.0 * 800.0) * 1e7).epsilon(0.015));
    const double load = ball_screw::permissible_buckling_load(buckling::theoretical_end_fixity(row.ends), 0.0133, 0.8);
    CHECK(load == Approx(row.load_factor * std::pow(13.3, 4) / (800.0 * 800.0) * 1e4).epsilon(0.025));
  }
}

TEST_CASE("preloaded nut: both sides, lift-off, and the exact pair of Hertz springs") {
  for (double preload : {10.0, 500.0, 3000.0}) {
    CHECK(ball_screw::loaded_side_force(0.0, preload) == Approx(preload));
    CHECK(ball_screw::unloaded_side_force(0.0, preload) == Approx(preload));
    const double lift_off = ball_screw::lift_off_force(preload);
    CHECK(ball_screw::loaded_side_force(lift_off, preload) == Approx(lift_off));
    CHECK(ball_screw::unloaded_side_force(1.01 * lift_off, preload) == 0.0);
    for (double share = 0.05; share < 1.0; share += 0.05) {
      // Both pairs deflect by the same δ from the preload: F = (1+δ)^1.5 - (1-δ)^1.5, in units of the preload.
      double low = 0.0, high = 1.0;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const double external = std::pow(1.0 + middle, 1.5) - std::pow(1.0 - middle, 1.5);
        (external < share * lift_off / preload ? low : high) = middle;
      }
      CHECK(ball_screw::loaded_side_force(share * lift_off, preload) ==
            Approx(preload * std::pow(1.0 + low, 1.5)).epsilon(0.035));
    }
    const Interval range = ball_screw::unloaded_side_force(Interval(0.0, 2.0 * lift_off), Interval(preload));
    CHECK(range.lower == 0.0);
    CHECK(range.upper == Approx(preload).epsilon(1e-9));
  }
}

TEST_CASE("life: rating and life invert each other, two equal pairs live shorter") {
  const double life = ball_screw::life_revolutions(12600.0, 900.0, 1.2);
  CHECK(ball_screw::required_dynamic_load_rating(900.0, 1.2, life, 1.0) == Approx(12600.0).epsilon(1e-12));
  CHECK(ball_screw::combined_life(1e8, 1e8) == Approx(1e8 * std::pow(2.0, -0.9)).epsilon(1e-12));
  // 10^6 revolutions at 500 rpm are 2000 minutes.
  CHECK(ball_screw::life_time(1e6, 500.0 * std::numbers::pi / 30.0) == Approx(120000.0).epsilon(1e-12));
}

// A carriage on a loop of two spans: pulled by F it moves until what the spans pull differs by F, one longer by as much
// as the other is shorter.
TEST_CASE("the spans of a belt share a force by their stiffness, next to the drive pulley one bears it all") {
  const double pretension = 40.0, force = 30.0, loop = 1.2, stiff = 1.7e4;
  double largest = 0.0, largest_load = 0.0;
  for (const double wrap : {2.4, 2.9, std::numbers::pi})
    for (double pulled = 1e-6; pulled < loop; pulled += 0.01) {
      const double way = force / (stiff / pulled + stiff / (loop - pulled));
      const double tight = pretension + stiff / pulled * way, slack = pretension - stiff / (loop - pulled) * way;
      REQUIRE(tight - slack == Approx(force));
      REQUIRE(tight <= belt::carriage_span_tension(pretension, force));
      const double lean = 0.5 * (std::numbers::pi - wrap);
      const double load = std::hypot((tight + slack) * std::cos(lean), (tight - slack) * std::sin(lean));
      REQUIRE(load <= belt::pulling_shaft_load(pretension, force, wrap) * (1.0 + 1e-12));
      largest = std::max(largest, tight);
      largest_load = std::max(largest_load, load);
    }
  CHECK(largest == Approx(belt::carriage_span_tension(pretension, force)).epsilon(1e-5));
  CHECK(largest_load == Approx(belt::pulling_shaft_load(pretension, force, std::numbers::pi)).epsilon(1e-5));
  CHECK(belt::pulling_shaft_load(pretension, 0.0, 2.9) == Approx(belt::shaft_load(pretension, 2.9)));
}

TEST_CASE("belt around equal pulleys, and few teeth in mesh") {
  CHECK(belt::wrap_angle(0.03, 0.03, 0.2) == Approx(std::numbers::pi));
  CHECK(belt::length(0.03, 0.03, 0.2) == Approx(0.4 + std::numbers::pi * 0.03));
  CHECK(belt::stiffness(1.7e4, 0.5, 0.5) == Approx(belt::least_stiffness(1.7e4, 1.0)));
  CHECK(belt::tooth_factor(6.0) == 1.0);
  CHECK(belt::tooth_factor(5.999) == Approx(0.8));
  CHECK(belt::tooth_factor(30.0) == 1.0);
  CHECK(belt::tooth_factor(0.5) == 0.0);
  // 20 teeth, half wrapped: exactly ten teeth, however rounded.
  CHECK(belt::tooth_factor(belt::teeth_in_mesh(12.0, std::numbers::pi)) == 1.0);
}

TEST_CASE("The two ramps of a move load a ball screw more, the greater the steady and the inertia force") {
  using millwright::scalar::Dual;
  std::mt19937 random(20);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const bool preloaded = i % 2 == 0;
    const double preload = preloaded ? 50.0 + 2000.0 * share(random) : 0.0;
    const double b = -300.0 + 3000.0 * share(random), b_width = 500.0 * share(random);
    const double c = 3000.0 * share(random), c_width = 500.0 * share(random);
    Dual<Interval> steady{Interval(b, b + b_width)}, inertia{Interval(c, c + c_width)};
    const bool by_steady = i % 4 < 2;
    (by_steady ? steady : inertia).slope[0] = Interval(1.0);
    const auto range = ball_screw::cubed_ramp_loads(steady, inertia, Dual<Interval>{Interval(preload)}, preloaded);
    if (!by_steady || b >= 0.0) CHECK(range.slope[0].lower >= 0.0);
    for (int k = 0; k < 8; ++k) {
      Dual<double> f{b + b_width * share(random)}, a{c + c_width * share(random)};
      (by_steady ? f : a).slope[0] = 1.0;
      // The sum of cubes of the two loads one by one.
      const auto load = [&](const Dual<double>& force) {
        const Dual<double> size = absolute(force);
        return preloaded ? ball_screw::loaded_side_force(size, Dual<double>{preload}) : size;
      };
      const Dual<double> sum = cube(load(f + a)) + cube(load(f - a));
      CHECK(range.value.lower <= sum.value * (1.0 + 1e-12));
      CHECK(range.value.upper >= sum.value * (1.0 - 1e-12));
      const double slack = 1e-9 * std::abs(sum.slope[0]);
      CHECK(range.slope[0].lower <= sum.slope[0] + slack);
      CHECK(range.slope[0].upper >= sum.slope[0] - slack);
    }
  }
}

TEST_CASE("Both raceways over the two ramps of a move bear more, the greater the steady and the inertia force") {
  using millwright::scalar::Dual;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const double p = 50.0 + 2000.0 * share(random), p_width = 200.0 * share(random);
    const double b = -300.0 + 3000.0 * share(random), b_width = 500.0 * share(random);
    const double c = 3000.0 * share(random), c_width = 500.0 * share(random), w = 1.0 + 3.0 * share(random);
    const Interval weight(w, w + share(random));
    Dual<Interval> steady{Interval(b, b + b_width)}, inertia{Interval(c, c + c_width)},
        preload{Interval(p, p + p_width)};
    (i % 3 == 0 ? steady : i % 3 == 1 ? inertia : preload).slope[0] = Interval(1.0);
    const auto range = ball_screw::uneven_ramp_loads(steady, inertia, preload, weight);
    if (i % 3 != 0 || b >= 0.0) CHECK(range.slope[0].lower >= 0.0);
    for (int k = 0; k < 8; ++k) {
      Dual<double> f{b + b_width * share(random)}, a{c + c_width * share(random)}, q{p + p_width * share(random)};
      (i % 3 == 0 ? f : i % 3 == 1 ? a : q).slope[0] = 1.0;
      const double times = weight.lower + (weight.upper - weight.lower) * share(random);
      Dual<double> sum{0.0};
      for (const Dual<double>& force : {absolute(f + a), absolute(f - a)})
        sum = sum + times * cube(ball_screw::loaded_side_force(force, q)) +
              cube(ball_screw::unloaded_side_force(force, q));
      CHECK(range.value.lower <= sum.value * (1.0 + 1e-12));
      CHECK(range.value.upper >= sum.value * (1.0 - 1e-12));
      const double slack = 1e-9 * std::abs(sum.slope[0]);
      CHECK(range.slope[0].lower <= sum.slope[0] + slack);
      CHECK(range.slope[0].upper >= sum.slope[0] - slack);
    }
  }
}

}  // namespace screw_test
