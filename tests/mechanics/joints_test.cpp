// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "catch.h"
#include "mechanics/bolt.h"
#include "mechanics/weld.h"

namespace joints_test {

using namespace millwright::mechanics;

TEST_CASE("two parallel welds, the textbook's worked example") {
  // Bhandari, example 8.9: 7.5 kN, 50 mm welds 50 mm apart, 125 mm from the centroid; throat for 90.78 N/mm² is 5 mm.
  CHECK(weld::eccentric_stress(7500.0, 0.125, 0.005, 0.05, 0.05) == Approx(90.78e6).epsilon(1e-4));
}

TEST_CASE("weld groups agree with integrals along the weld lines") {
  const double t = 0.0035, b = 0.04, d = 0.06;
  constexpr int parts = 20000;
  double bending = 2.0 * b * t * 0.25 * d * d, polar_x = 0.0, polar_y = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double y = ((i + 0.5) / parts - 0.5) * d, x = ((i + 0.5) / parts - 0.5) * b;
    bending += 2.0 * y * y * t * d / parts;
    polar_y += 2.0 * (y * y + 0.25 * b * b) * t * d / parts;
    polar_x += 2.0 * (x * x + 0.25 * d * d) * t * b / parts;
  }
  CHECK(weld::rectangle_section_modulus(t, b, d) == Approx(bending / (0.5 * d)).epsilon(1e-6));
  CHECK(weld::rectangle_polar_moment(t, b, d) == Approx(polar_x + polar_y).epsilon(1e-6));
  CHECK(weld::parallel_polar_moment(t, b, d) == Approx(polar_x).epsilon(1e-6));
}

TEST_CASE("a weld without eccentricity has the direct stress only") {
  CHECK(weld::eccentric_stress(7500.0, 0.0, 0.005, 0.05, 0.05) == Approx(7500.0 / (2 * 0.05 * 0.005)));
  CHECK(weld::direct_stress(2000.0, 0.005, 0.1) == Approx(2000.0 / (weld::throat(0.005) * 0.1)));
}

TEST_CASE("stress areas of metric bolts are those of the standard") {
  // ISO 898-1: nominal diameter, pitch, stress area in mm².
  constexpr double table[][3] = {{3, 0.5, 5.03},
                                 {4, 0.7, 8.78},
                                 {5, 0.8, 14.2},
                                 {6, 1.0, 20.1},
                                 {8, 1.25, 36.6},
                                 {10, 1.5, 58.0},
                                 {12, 1.75, 84.3},
                                 {16, 2.0, 157},
                                 {20, 2.5, 245},
                                 {24, 3.0, 353}};
  for (const auto& [diameter, pitch, area] : table)
    CHECK(bolt::stress_area(1e-3 * diameter, 1e-3 * pitch) == Approx(1e-6 * area).epsilon(3.2e-3));
}

TEST_CASE("forces of a bolt group balance the load") {
  // Four corners: the four forces, turned about the centroid, make up force and moment. The largest is the formula's.
  const std::array<double, 4> x{-0.03, -0.03, 0.03, 0.03}, y{-0.04, 0.04, -0.04, 0.04};
  const double force = 2000.0, offset = 0.1;
  double polar = 0.0, sum = 0.0, moment = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) polar += x[i] * x[i] + y[i] * y[i];
  for (std::size_t i = 0; i < 4; ++i) {
    const double across = -force * offset * y[i] / polar, along = force / 4.0 + force * offset * x[i] / polar;
    sum += along;
    moment += x[i] * along - y[i] * across;
    largest = std::max(largest, std::hypot(across, along));
  }
  CHECK(sum == Approx(force));
  CHECK(moment == Approx(force * offset));
  CHECK(bolt::group_shear(force, offset, std::span<const double>(x), std::span<const double>(y)) == Approx(largest));
}

TEST_CASE("a tilting bracket is held by its bolts") {
  const std::array<double, 4> y{0.02, 0.02, 0.1, 0.1};
  const double largest = bolt::group_tension(300.0, std::span<const double>(y));
  double moment = 0.0;
  for (const double distance : y) moment += largest * distance / 0.1 * distance;
  CHECK(moment == Approx(300.0));
}

TEST_CASE("a joint opens when its members are unloaded") {
  const double preload = 26100.0, constant = 0.2;
  const double opening = preload / (1.0 - constant);
  CHECK(bolt::separation_safety(preload, constant, opening) == Approx(1.0));
  CHECK(bolt::largest_tension(preload, constant, opening) == Approx(opening));
}

}  // namespace joints_test
