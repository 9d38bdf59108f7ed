// SPDX-License-Identifier: Apache-2.0
#include "mechanics/beam.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "catch.h"

namespace beam_test {

using namespace millwright::mechanics;

namespace {

constexpr double length = 0.7, modulus = 70e9, second_moment = 3e-8, force = 130.0;

/// Deflection by integrating the curvature M/(E I) twice (midpoint rule), from the left end with deflection 0 and the
/// slope that gives 0 at the right end too (supported) or 0 slope (clamped left).
double integrated(const std::function<double(double)>& moment, double at, bool supported) {
  constexpr int steps = 20000;
  const double h = length / steps;
  double slope = 0.0, deflection = 0.0, end = 0.0, here = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * h;
    const double curvature = moment(x) / (modulus * second_moment);
    deflection += h * slope + 0.5 * h * h * curvature;
    slope += h * curvature;
    if (std::abs(x + 0.5 * h - at) < 0.6 * h && here == 0.0) here = deflection;
  }
  end = deflection;
  return supported ? at / length * end - here : here;
}

/// Moment of a force at `a` on a simply supported beam.
double supported_moment(double a, double x) {
  const double left = force * (length - a) / length;
  return left * x - (x > a ? force * (x - a) : 0.0);
}

}  // namespace

TEST_CASE("supported beams agree with the integrated curvature") {
  for (const double a : {0.07, 0.21, 0.35, 0.56}) {
    for (const double x : {0.14, 0.35, 0.63}) {
      const double expected = integrated([&](double s) { return supported_moment(a, s); }, x, true);
      CHECK(beam::supported_deflection_at(force, a, x, length, modulus, second_moment) ==
            Approx(expected).epsilon(1e-3));
    }
  }
  const double load = 250.0;
  const auto distributed = [&](double x) { return 0.5 * load * x * (length - x); };
  CHECK(beam::supported_deflection_distributed(load, length, modulus, second_moment) ==
        Approx(integrated(distributed, 0.5 * length, true)).epsilon(1e-3));
}

TEST_CASE("cantilevers agree with the integrated curvature") {
  for (const double a : {0.2, 0.5, 0.7}) {
    const auto moment = [&](double x) { return x < a ? force * (a - x) : 0.0; };
    CHECK(beam::cantilever_tip_deflection_load_at(force, a, length, modulus, second_moment) ==
          Approx(integrated(moment, length, false)).epsilon(1e-3));
  }
  const double load = 90.0;
  const auto distributed = [&](double x) { return 0.5 * load * (length - x) * (length - x); };
  CHECK(beam::cantilever_tip_deflection_distributed(load, length, modulus, second_moment) ==
        Approx(integrated(distributed, length, false)).epsilon(1e-3));
  const auto constant = [](double) { return 12.0; };
  CHECK(beam::cantilever_tip_deflection_moment(12.0, length, modulus, second_moment) ==
        Approx(integrated(constant, length, false)).epsilon(1e-3));
}

TEST_CASE("Maxwell: the deflection here from a force there is the one there from a force here") {
  for (double a = 0.05; a < length; a += 0.09)
    for (double x = 0.02; x < length; x += 0.07)
      CHECK(beam::supported_deflection_at(force, a, x, length, modulus, second_moment) ==
            Approx(beam::supported_deflection_at(force, x, a, length, modulus, second_moment)).epsilon(1e-12));
}

TEST_CASE("loads on one beam add up") {
  const double a = 0.2;
  const double both = beam::supported_deflection_two_loads(force, a, length, modulus, second_moment);
  const double sum = beam::supported_deflection_at(force, a, 0.5 * length, length, modulus, second_moment) +
                     beam::supported_deflection_at(force, length - a, 0.5 * length, length, modulus, second_moment);
  CHECK(both == Approx(sum).epsilon(1e-12));
  // Two half loads in the middle are one load in the middle.
  CHECK(beam::supported_deflection_two_loads(0.5 * force, 0.5 * length, length, modulus, second_moment) ==
        Approx(beam::supported_deflection(force, length, modulus, second_moment)).epsilon(1e-12));
  // A distributed load is the sum of many small ones.
  constexpr int parts = 2000;
  double many = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double place = (i + 0.5) * length / parts;
    many += beam::supported_deflection_at(100.0 * length / parts, place, 0.5 * length, length, modulus, second_moment);
  }
  CHECK(many == Approx(beam::supported_deflection_distributed(100.0, length, modulus, second_moment)).epsilon(1e-6));
}

TEST_CASE("the largest deflection of a supported beam is the largest of all places") {
  for (const double a : {0.01, 0.1, 0.25, 0.35, 0.5, 0.66}) {
    double largest = 0.0;
    for (double x = 0.0; x <= length; x += 1e-4)
      largest = std::max(largest, beam::supported_deflection_at(force, a, x, length, modulus, second_moment));
    CHECK(beam::supported_largest_deflection(force, a, length, modulus, second_moment) ==
          Approx(largest).epsilon(1e-5));
  }
}

TEST_CASE("a clamped beam is a supported one with end moments that undo the end slopes") {
  // At midspan: supported deflection less the effect of end moments M = F L / 8, each M L² / (16 E I).
  const double undone = 2.0 * (force * length / 8.0) * length * length / (16.0 * modulus * second_moment);
  const double expected = beam::supported_deflection(force, length, modulus, second_moment) - undone;
  CHECK(beam::fixed_deflection(force, length, modulus, second_moment) == Approx(expected).epsilon(1e-12));
  CHECK(beam::fixed_deflection_load_at(force, 0.5 * length, length, modulus, second_moment) ==
        Approx(expected).epsilon(1e-12));
  const double w = 300.0, end_moment = w * length * length / 12.0;
  const double distributed = beam::supported_deflection_distributed(w, length, modulus, second_moment) -
                             end_moment * length * length / (8.0 * modulus * second_moment);
  CHECK(beam::fixed_deflection_distributed(w, length, modulus, second_moment) == Approx(distributed).epsilon(1e-12));
}

// A force at a from one of two clamps: F a b^2/L^2 there, F a^2 b/L^2 at the other, 2 F a^2 b^2/L^3 under it.
TEST_CASE("no place of a load on a beam clamped at both ends bends it more than a third of its span") {
  const double most = beam::fixed_moment_of_travelling_load(force, length);
  double largest = 0.0;
  for (int i = 0; i <= 300; ++i) {
    const double a = length * i / 300.0, b = length - a;
    for (const double moment : {force * a * b * b / (length * length),
                                force * a * a * b / (length * length),
                                2.0 * force * a * a * b * b / (length * length * length)}) {
      REQUIRE(moment <= most * (1.0 + 1e-12));
      largest = std::max(largest, moment);
    }
  }
  CHECK(largest == Approx(most));
  CHECK(most > beam::largest_moment(beam::LoadCase::fixed_point, force, length));
}

TEST_CASE("the tip of an overhang is a cantilever on a support that turns") {
  const double c = 0.15;
  const double turn = force * c * length / (3.0 * modulus * second_moment);  // of a span under an end moment F c
  const double expected = beam::cantilever_tip_deflection(force, c, modulus, second_moment) + c * turn;
  CHECK(beam::overhang_tip_deflection(force, length, c, modulus, second_moment) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("the largest moment of a supported beam is the one with the load in the middle") {
  CHECK(beam::supported_moment_load_at(force, 0.5 * length, length) ==
        Approx(beam::largest_moment(beam::LoadCase::supported_point, force, length)));
  CHECK(beam::supported_moment_load_at(force, 0.2, length) == Approx(supported_moment(0.2, 0.2)));
}

}  // namespace beam_test
