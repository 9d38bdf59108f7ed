// SPDX-License-Identifier: Apache-2.0
#include "mechanics/section.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "catch.h"
#include "mechanics/section_stress.h"

namespace section_test {

using namespace millwright::mechanics;

namespace {

/// Second moment about the centroid, and the centroid, of a shape cut into small cells.
struct Counted {
  double area = 0.0, centroid = 0.0, second_moment = 0.0;
};
template <class Inside>
Counted counted(double width, double height, Inside inside) {
  constexpr int cells = 1000;
  const double dx = width / cells, dy = height / cells;
  double area = 0.0, first = 0.0, second = 0.0;
  for (int i = 0; i < cells; ++i) {
    for (int k = 0; k < cells; ++k) {
      const double x = (i + 0.5) * dx, y = (k + 0.5) * dy;
      if (!inside(x, y)) continue;
      area += dx * dy;
      first += y * dx * dy;
      second += y * y * dx * dy;
    }
  }
  const double centroid = first / area;
  return {area, centroid, second - area * centroid * centroid};
}

}  // namespace

TEST_CASE("second moments of area agree with counting cells") {
  const double b = 0.04, h = 0.06, t = 0.003;
  CHECK(section::rectangle_second_moment(b, h) ==
        Approx(counted(b, h, [](double, double) { return true; }).second_moment).epsilon(1e-5));
  CHECK(
      section::rectangular_tube_second_moment(b, h, t) ==
      Approx(counted(b, h, [&](double x, double y) { return x < t || x > b - t || y < t || y > h - t; }).second_moment)
          .epsilon(1e-3));
  const auto angle = counted(b, h, [&](double x, double y) { return x < t || y < t; });
  CHECK(section::angle_centroid(h, b, t) == Approx(angle.centroid).epsilon(1e-3));
  CHECK(section::angle_second_moment(h, b, t) == Approx(angle.second_moment).epsilon(1e-3));
  const double web = 0.004;
  const auto strong = counted(b, h, [&](double x, double y) { return x < web || y < t || y > h - t; });
  CHECK(section::channel_strong_second_moment(h, b, web, t) == Approx(strong.second_moment).epsilon(1e-3));
  const auto weak = counted(h, b, [&](double x, double y) { return y < web || x < t || x > h - t; });
  CHECK(section::channel_weak_second_moment(h, b, web, t) == Approx(weak.second_moment).epsilon(1e-3));
  const double d = 0.02, bore = 0.012, r = 0.5 * d;
  const auto ring = counted(d, d, [&](double x, double y) {
    const double radius = std::hypot(x - r, y - r);
    return radius <= r && radius >= 0.5 * bore;
  });
  CHECK(section::round_second_moment(d, bore) == Approx(ring.second_moment).epsilon(2e-3));
  CHECK(section::round_area(d) == Approx(std::numbers::pi * r * r));
}

TEST_CASE("a wall of half the side makes a tube solid, and a thin one is its perimeter") {
  CHECK(section::rectangular_tube_second_moment(0.04, 0.06, 0.02) ==
        Approx(section::rectangle_second_moment(0.04, 0.06)).epsilon(1e-12));
  // A square tube of mean side s and thin wall t: I = 2/3 s³ t, J = s³ t.
  const double t = 1e-6, side = 0.05 + t;
  CHECK(section::rectangular_tube_second_moment(side, side, t) ==
        Approx(2.0 / 3.0 * std::pow(0.05, 3) * t).epsilon(1e-4));
  CHECK(section::rectangular_tube_torsion_constant(side, side, t) == Approx(std::pow(0.05, 3) * t).epsilon(1e-9));
}

TEST_CASE("polar moment of a round section is the sum of its two second moments") {
  CHECK(section::round_torsion_constant(0.03, 0.01) == Approx(2.0 * section::round_second_moment(0.03, 0.01)));
}

TEST_CASE("torsion constant of a rectangle agrees with the exact series") {
  // J = b h³ / 3 · (1 - 192 h / (π⁵ b) Σ tanh(n π b / (2 h)) / n⁵), n odd, h the shorter side.
  for (const double ratio : {1.0, 1.3, 2.0, 4.0, 20.0}) {
    const double h = 0.01, b = ratio * h;
    double series = 0.0;
    for (int n = 1; n < 60; n += 2) series += std::tanh(n * std::numbers::pi * b / (2.0 * h)) / std::pow(n, 5);
    const double exact = b * h * h * h / 3.0 * (1.0 - 192.0 * h / (std::pow(std::numbers::pi, 5) * b) * series);
    CHECK(section::rectangle_torsion_constant(b, h) == Approx(exact).epsilon(5e-3));
    CHECK(section::rectangle_torsion_constant(h, b) == section::rectangle_torsion_constant(b, h));
  }
}

TEST_CASE("an open section is far softer in torsion than the closed one of the same walls") {
  const std::array<double, 4> lengths{0.037, 0.037, 0.057, 0.057}, walls{0.003, 0.003, 0.003, 0.003};
  const double open = section::open_torsion_constant(std::span<const double>(lengths), std::span<const double>(walls));
  CHECK(open == Approx(0.188 * 27e-9 / 3.0));
  CHECK(section::rectangular_tube_torsion_constant(0.04, 0.06, 0.003) > 100.0 * open);
}

TEST_CASE("lists of walls that do not match are refused") {
  const std::array<double, 2> lengths{0.1, 0.2};
  const std::array<double, 1> walls{0.003};
  CHECK_THROWS_AS(section::open_torsion_constant(std::span<const double>(lengths), std::span<const double>(walls)),
                  std::invalid_argument);
}

TEST_CASE("stress follows from section modulus and fibre distance alike") {
  const double i = section::rectangle_second_moment(0.02, 0.05);
  CHECK(section::bending_stress(40.0, i, 0.025) ==
        Approx(section::bending_stress_of_modulus(40.0, section::modulus(i, 0.025))));
  CHECK(section::bending_stress(40.0, i, 0.025) == Approx(6.0 * 40.0 / (0.02 * 0.05 * 0.05)));
  CHECK(section::round_radius_of_gyration(0.012) ==
        Approx(section::radius_of_gyration(section::round_second_moment(0.012, 0.0), section::round_area(0.012))));
}

}  // namespace section_test
