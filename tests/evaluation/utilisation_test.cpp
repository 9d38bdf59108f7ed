// SPDX-License-Identifier: Apache-2.0
// Demand over capacity where either is zero, negative, unbounded or nothing at all.
#include <array>
#include <cmath>
#include <limits>

#include "catch.h"
#include "evaluation/element_stage.h"

namespace utilisation_test {

using namespace millwright;
using evaluation::utilisation;
using scalar::Interval;
using Dual = scalar::Dual<double, 1>;
using DualInterval = scalar::Dual<Interval, 1>;

namespace {
constexpr double useless = machine::useless_utilisation;
const std::vector<double> numbers{-1e300, -3.0, -1e-9, 0.0, 1e-300, 1e-9, 0.5, 1.0, 3.0, 1e12, 1e300};
}  // namespace

TEST_CASE("A utilisation is a number between 0 and 1e9, whatever the demand and the capacity") {
  CHECK(utilisation(1.0, 2.0) == 0.5);
  CHECK(utilisation(3.0, 2.0) == 1.5);
  CHECK(utilisation(0.0, 2.0) == 0.0);
  CHECK(utilisation(-5.0, 2.0) == 0.0);  // a force that helps
  CHECK(utilisation(0.0, 0.0) == 0.0);   // nothing asked, nothing given
  CHECK(utilisation(1.0, 0.0) == useless);
  CHECK(utilisation(1.0, -2.0) == useless);
  CHECK(utilisation(1e10, 1e-10) == useless);
  const double nothing = std::nan("");
  CHECK(utilisation(nothing, 1.0) == useless);
  CHECK(utilisation(1.0, nothing) == useless);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(utilisation(1.0, infinity) == 0.0);
  CHECK(utilisation(infinity, 1.0) == useless);
}

// Whole watts with a reserve in decimals: exactly what the supply gives, and in binary a little more.
TEST_CASE("A demand that is its capacity but for the rounding of decimal figures keeps it") {
  for (const auto& [watts, reserve, supply] : std::vector<std::array<double, 3>>{
           {24.0, 2.2, 52.8}, {33.0, 1.6, 52.8}, {48.0, 1.05, 50.4}, {56.0, 1.35, 75.6}, {219.0, 1.6, 350.4}}) {
    CAPTURE(watts, reserve, supply);
    REQUIRE(reserve * watts > supply);
    CHECK(utilisation(reserve * watts, supply) == 1.0);
    CHECK(utilisation(Interval(reserve) * Interval(watts), Interval(supply)).upper == 1.0);
    CHECK(utilisation(reserve * watts * (1.0 + 1e-11), supply) > 1.0);
    CHECK(utilisation(Interval(reserve * watts * (1.0 + 1e-11)), Interval(supply)).lower > 1.0);
  }
}

TEST_CASE("The utilisation of ranges contains that of their members") {
  for (const double demand_low : numbers)
    for (const double demand_high : numbers)
      for (const double capacity_low : numbers)
        for (const double capacity_high : numbers) {
          if (demand_low > demand_high || capacity_low > capacity_high) continue;
          const Interval demand(demand_low, demand_high), capacity(capacity_low, capacity_high);
          const Interval u = utilisation(demand, capacity);
          INFO(demand_low << ".." << demand_high << " over " << capacity_low << ".." << capacity_high);
          REQUIRE(u.lower >= 0.0);
          REQUIRE(u.lower <= u.upper);
          for (const double d : numbers)
            for (const double c : numbers)
              if (demand_low <= d && d <= demand_high && capacity_low <= c && c <= capacity_high) {
                const double value = utilisation(d, c);
                REQUIRE(u.lower <= value);
                REQUIRE(value <= u.upper);
              }
        }
}

TEST_CASE("Where a utilisation rests at its ends it has no slope") {
  const auto slope = [](double demand, double capacity) {
    return utilisation(Dual(demand, {1.0}), Dual(capacity, {0.0})).slope[0];
  };
  CHECK(slope(1.0, 4.0) == 0.25);
  CHECK(slope(-1.0, 4.0) == 0.0);
  CHECK(slope(1.0, -4.0) == 0.0);
  CHECK(slope(1e12, 1e-3) == 0.0);
  // Over a range that reaches zero both the slope and the rest count; without a certain capacity any slope.
  const DualInterval about_zero = utilisation(DualInterval(Interval(-1.0, 1.0), {Interval(1.0)}), DualInterval(4.0));
  CHECK(about_zero.slope[0].lower <= 0.0);
  CHECK(about_zero.slope[0].upper >= 0.25);
  const DualInterval uncertain = utilisation(DualInterval(1.0, {Interval(1.0)}), DualInterval(Interval(-1.0, 1.0)));
  CHECK(uncertain.slope[0].lower == -std::numeric_limits<double>::infinity());
  CHECK(uncertain.slope[0].upper == std::numeric_limits<double>::infinity());
}

}  // namespace utilisation_test
