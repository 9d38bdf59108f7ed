// SPDX-License-Identifier: Apache-2.0
#include "mechanics/column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "mechanics/section.h"

namespace column_test {

using namespace millwright;
using namespace millwright::mechanics;
using scalar::Interval;

TEST_CASE("Euler and Johnson meet at half the yield load, with one slope") {
  const double c = 0.25, e = 206e9, yield = 235e6, area = 3.04e-4, i = 4.5e-8;
  const double transition = std::sqrt(2.0 * c * e / yield) * std::numbers::pi * std::sqrt(i / area);
  const double euler = column::euler_load(c, e, i, transition);
  CHECK(euler == Approx(0.5 * area * yield).epsilon(1e-12));
  CHECK(column::johnson_load(c, e, yield, area, i, transition) == Approx(euler).epsilon(1e-12));
  const double h = 1e-5 * transition;
  const double above = column::critical_load(c, e, yield, area, i, transition + h) - euler;
  const double below = euler - column::critical_load(c, e, yield, area, i, transition - h);
  CHECK(above == Approx(below).epsilon(1e-4));
}

TEST_CASE("a column never carries more than yield, nor more than Euler") {
  for (double length = 0.01; length < 3.0; length += 0.01) {
    const double load = column::critical_load(1.0, 206e9, 235e6, 3.04e-4, 4.5e-8, length);
    CHECK(load <= 235e6 * 3.04e-4);
    CHECK(load <= column::euler_load(1.0, 206e9, 4.5e-8, length) * (1.0 + 1e-12));
    CHECK(load > 0.0);
  }
}

TEST_CASE("loads by second moment and by radius of gyration agree") {
  const double d = 0.02;
  const double area = section::round_area(d), i = section::round_second_moment(d, 0.0);
  const double k = section::round_radius_of_gyration(d);
  CHECK(column::johnson_load_of_radius(1.0, 200e9, 245e6, area, 0.4, k) ==
        Approx(column::johnson_load(1.0, 200e9, 245e6, area, i, 0.4)));
  CHECK(column::euler_load_of_radius(1.0, 200e9, area, 1.4, k) == Approx(column::euler_load(1.0, 200e9, i, 1.4)));
}

TEST_CASE("the range of the critical load contains every column of the box") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<> unit(0.0, 1.0);
  for (int n = 0; n < 2000; ++n) {
    const std::array<double, 6> least{0.25, 5e9, 5e7, 1e-5, 1e-10, 0.05}, most{4, 2e11, 9e8, 2e-3, 1e-6, 2.0};
    std::array<Interval, 6> box;
    for (std::size_t k = 0; k < 6; ++k) {
      const double low = least[k] * std::pow(most[k] / least[k], unit(engine));
      box[k] = Interval(low, low * (1.0 + unit(engine)));
    }
    const Interval range = column::critical_load(box[0], box[1], box[2], box[3], box[4], box[5]);
    CHECK(range.lower > 0.0);
    for (int j = 0; j < 20; ++j) {
      std::array<double, 6> x;
      for (std::size_t k = 0; k < 6; ++k)
        x[k] = box[k].lower + (box[k].upper - box[k].lower) * std::clamp(1.4 * unit(engine) - 0.2, 0.0, 1.0);
      CHECK(contains(range, column::critical_load(x[0], x[1], x[2], x[3], x[4], x[5])));
    }
  }
}

TEST_CASE("a portal lies between two cantilevers and a rigid beam") {
  const double e = 70e9, i = 1.2e-6, h = 0.35;
  const double cantilevers = 2.0 * 3.0 * e * i / (h * h * h);
  CHECK(column::portal_stiffness(e, i, h, 1e-20, 0.7) == Approx(cantilevers).epsilon(1e-6));
  CHECK(column::portal_stiffness(e, i, h, 1.0, 0.7) == Approx(4.0 * cantilevers).epsilon(1e-5));
}

TEST_CASE("portal stiffness agrees with the slope-deflection equations solved by hand") {
  // Sway δ = 1, both beam ends turn by φ: column end moment 4EI_cφ/h - 6EI_c/h², beam end moment 6EI_bφ/L, sum 0;
  // the force is the sum of both columns' shears (12EI_c/h³ - 6EI_cφ/h²) each.
  const double e = 70e9, ic = 1.2e-6, h = 0.35, ib = 2e-6, l = 0.7;
  const double turn = 6.0 * e * ic / (h * h) / (4.0 * e * ic / h + 6.0 * e * ib / l);
  const double expected = 2.0 * (12.0 * e * ic / (h * h * h) - 6.0 * e * ic * turn / (h * h));
  CHECK(column::portal_stiffness(e, ic, h, ib, l) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("portal moments agree with the slope-deflection equations solved by hand") {
  const double f = 100.0, ic = 1.2e-6, h = 0.35, ib = 2e-6, l = 0.7, ratio = (ib / l) / (ic / h);
  // A lateral force: sway δ and corners that turn by r δ, both times E; the beam's end moment is 6I_b r/L.
  const double r = 6.0 * ic / (h * h) / (4.0 * ic / h + 6.0 * ib / l);
  const double sway = f / (2.0 * (12.0 * ic / (h * h * h) - 6.0 * ic * r / (h * h)));
  CHECK(column::portal_foot_moment(f, h, ratio) ==
        Approx((6.0 * ic / (h * h) - 2.0 * ic * r / h) * sway).epsilon(1e-12));
  CHECK(column::portal_corner_moment(f, h, ratio) == Approx(6.0 * ib * r / l * sway).epsilon(1e-12));
  // Each column shares half of the overturning moment between its foot and its corner.
  CHECK(column::portal_foot_moment(f, h, ratio) + column::portal_corner_moment(f, h, ratio) == Approx(f * h / 2.0));
  // A force on the beam: the clamped beam's F L/8 is balanced by column 4I_c φ/h and beam 2I_b φ/L.
  const double turn = f * l / 8.0 / (4.0 * ic / h + 2.0 * ib / l);
  CHECK(column::portal_corner_moment_of_beam_load(f, l, ratio) == Approx(4.0 * ic * turn / h).epsilon(1e-12));
}

TEST_CASE("moments of a portal under a moving load are the largest of all its positions") {
  const double f = 100.0, h = 0.35, l = 0.7, ic = 1.2e-6;
  for (const double ratio : {0.01, 0.2, 1.0, 8.0}) {
    CAPTURE(ratio);
    const double ib = ratio * ic / h * l;
    // Corners a and b turn, the beam shifts by d (all times E): two corners in balance and no lateral force.
    const double own = 4.0 * ic / h + 4.0 * ib / l, cross = 2.0 * ib / l, shift = 6.0 * ic / (h * h);
    double corner = 0.0, foot = 0.0;
    for (int n = 0; n <= 2000; ++n) {
      const double x = n / 2000.0, clamped_a = f * l * x * (1 - x) * (1 - x), clamped_b = -f * l * x * x * (1 - x);
      // own a + cross b - shift d = clamped_a, cross a + own b - shift d = clamped_b, a + b = 4 d/h.
      const double unlike = (clamped_a - clamped_b) / (own - cross);
      const double alike = (clamped_a + clamped_b) / (own + cross - 0.5 * shift * h);
      const double d = alike * h / 4.0;
      for (const double turn : {0.5 * (alike + unlike), 0.5 * (alike - unlike)}) {
        corner = std::max(corner, std::abs(4.0 * ic * turn / h - shift * d));
        foot = std::max(foot, std::abs(2.0 * ic * turn / h - shift * d));
      }
    }
    CHECK(column::portal_corner_moment_of_moving_load(f, l, ratio) == Approx(corner).epsilon(2e-6));
    CHECK(column::portal_corner_moment_of_moving_load(f, l, ratio) >= corner * (1.0 - 1e-12));
    CHECK(column::portal_foot_moment_of_moving_load(f, l, ratio) == Approx(foot).epsilon(2e-6));
    CHECK(column::portal_foot_moment_of_moving_load(f, l, ratio) >= foot * (1.0 - 1e-12));
    CHECK(column::portal_corner_moment_of_moving_load(f, l, ratio) >
          column::portal_corner_moment_of_beam_load(f, l, ratio));
  }
}

}  // namespace column_test
