// SPDX-License-Identifier: Apache-2.0
#include "scalar/dimensioned.h"

#include <functional>

#include "catch.h"

namespace dimensioned_test {

namespace {

using namespace millwright::scalar;

const Dimensioned force(80.0, dimension::force);
const Dimensioned length(0.02, dimension::length);
const Dimensioned ratio(0.5, dimension::none);

std::string refusal(const std::function<Dimensioned()>& formula) {
  try {
    static_cast<void>(formula());
  } catch (const DimensionError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("dimensions multiply and divide") {
  CHECK((force * length).dimension == dimension::torque);
  CHECK((force / square(length)).dimension == dimension::pressure);
  CHECK(sqrt(square(force)).dimension == dimension::force);
  CHECK(cbrt(cube(length)).dimension == dimension::length);
  CHECK(pow(length, -1.5).dimension == power(dimension::length, -1.5));
  CHECK((1.0 / Dimensioned(2.0, dimension::time)).dimension == dimension::frequency);
  CHECK(absolute(-force).dimension == dimension::force);
  CHECK((pi<Dimensioned>() * in_unit<Dimensioned>(1e-3, dimension::length)).dimension == dimension::length);
  // Volt from the definition of the ampere: W/A = kg·m²/(s³·A)
  CHECK(dimension::voltage == Dimension{1, 2, -3, -1, 0});
  CHECK(dimension::inductance == Dimension{1, 2, -2, -2, 0});
}

TEST_CASE("unlike dimensions are refused with both named") {
  CHECK(refusal([] { return force + length; }) == "a sum of kg·m/s² and m");
  CHECK(refusal([] { return force - 1.0; }) == "a difference of kg·m/s² and 1");
  CHECK_FALSE(refusal([] { return smaller(force, length); }).empty());
  CHECK_FALSE(refusal([] { return larger(length, 1.0); }).empty());
  CHECK_FALSE(refusal([] { return where_below(force, length, 1.0, 2.0); }).empty());
  CHECK_FALSE(refusal([] { return where_below(ratio, 1.0, force, length); }).empty());
  CHECK_FALSE(refusal([] {
                return where_below(
                    ratio, 1.0, [] { return force; }, [] { return length; });
              }).empty());
  Dimensioned sum = force;
  CHECK_THROWS_AS(sum += length, DimensionError);
}

TEST_CASE("functions of angles and ratios refuse everything else") {
  CHECK(refusal([] { return sin(length); }) == "sin of m, where a dimensionless number is needed");
  for (const auto f : {+[](const Dimensioned& x) { return exp(x); },
                       +[](const Dimensioned& x) { return log(x); },
                       +[](const Dimensioned& x) { return cos(x); },
                       +[](const Dimensioned& x) { return tan(x); },
                       +[](const Dimensioned& x) { return asin(x); },
                       +[](const Dimensioned& x) { return acos(x); },
                       +[](const Dimensioned& x) { return atan(x); },
                       +[](const Dimensioned& x) { return floor_of(x); },
                       +[](const Dimensioned& x) { return pow(x, ratio); },
                       +[](const Dimensioned& x) { return pow(ratio, x); }}) {
    CHECK_THROWS_AS(f(length), DimensionError);
    CHECK_NOTHROW(f(ratio));
    CHECK_NOTHROW(f(length / length));
  }
}

TEST_CASE("the literal 0 fits every dimension, a computed 0 does not") {
  Dimensioned sum = 0.0;
  sum += force;
  CHECK(sum.dimension == dimension::force);
  CHECK((force + 0.0).dimension == dimension::force);
  CHECK(larger(force, 0.0).dimension == dimension::force);
  CHECK(where_below(force, 0.0, 0.0, length).dimension == dimension::length);
  CHECK_THROWS_AS(force + (ratio - ratio), DimensionError);
  CHECK_THROWS_AS(force + (length - length), DimensionError);
}

TEST_CASE("values are those of double") {
  CHECK((force * length).value == 80.0 * 0.02);
  CHECK(where_below(ratio, 1.0, 3.0, 4.0).value == 3.0);
  CHECK(where_below(ratio, 0.5, 3.0, 4.0).value == 4.0);
}

TEST_CASE("dimensions are written in base units") {
  CHECK(to_string(dimension::none) == "1");
  CHECK(to_string(dimension::force) == "kg·m/s²");
  CHECK(to_string(dimension::pressure) == "kg/(m·s²)");
  CHECK(to_string(dimension::frequency) == "1/s");
  CHECK(to_string(power(dimension::length, 0.5)) == "m^0.5");
  CHECK(to_string(power(dimension::length, 12.0)) == "m¹²");
}

}  // namespace dimensioned_test
