// SPDX-License-Identifier: Apache-2.0
//
// The physical dimension of a number: exponents of kilogram, metre, second, ampere and kelvin.
// Angles and counts are dimensionless here; that an angular speed is not a frequency is the business of unit.h.
#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace millwright::scalar {

/// Exponents of the SI base units. They are real numbers, because formulas take square roots.
struct Dimension {
  double kilogram = 0.0;
  double metre = 0.0;
  double second = 0.0;
  double ampere = 0.0;
  double kelvin = 0.0;

  friend constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.kilogram + b.kilogram, a.metre + b.metre, a.second + b.second, a.ampere + b.ampere, a.kelvin + b.kelvin};
  }
  friend constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
    return {a.kilogram - b.kilogram, a.metre - b.metre, a.second - b.second, a.ampere - b.ampere, a.kelvin - b.kelvin};
  }
  /// The dimension of a quantity raised to `exponent`.
  friend constexpr Dimension power(const Dimension& a, double exponent) {
    return {a.kilogram * exponent, a.metre * exponent, a.second * exponent, a.ampere * exponent, a.kelvin * exponent};
  }
  /// Equal up to the rounding of fractional exponents.
  friend constexpr bool operator==(const Dimension& a, const Dimension& b) {
    const auto near = [](double x, double y) { return x - y < 1e-9 && y - x < 1e-9; };
    return near(a.kilogram, b.kilogram) && near(a.metre, b.metre) && near(a.second, b.second) &&
           near(a.ampere, b.ampere) && near(a.kelvin, b.kelvin);
  }
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension angular{};  ///< an angle (radian) or a count
inline constexpr Dimension length{0, 1, 0, 0, 0};
inline constexpr Dimension mass{1, 0, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0, 0};
inline constexpr Dimension current{0, 0, 0, 1, 0};
inline constexpr Dimension temperature{0, 0, 0, 0, 1};
inline constexpr Dimension area = power(length, 2);
inline constexpr Dimension volume = power(length, 3);
inline constexpr Dimension second_moment_of_area = power(length, 4);
inline constexpr Dimension speed = length / time;
inline constexpr Dimension acceleration = speed / time;
inline constexpr Dimension jerk = acceleration / time;
inline constexpr Dimension frequency = none / time;      ///< 1/s
inline constexpr Dimension angular_speed = none / time;  ///< rad/s
inline constexpr Dimension angular_acceleration = angular_speed / time;
inline constexpr Dimension force = mass * acceleration;
inline constexpr Dimension torque = force * length;
inline constexpr Dimension energy = torque;
inline constexpr Dimension power_output = energy / time;  ///< watt
inline constexpr Dimension pressure = force / area;
inline constexpr Dimension stiffness = force / length;
inline constexpr Dimension force_per_length = force / length;
inline constexpr Dimension torsional_stiffness = torque;  ///< N·m/rad
inline constexpr Dimension mass_per_length = mass / length;
inline constexpr Dimension density = mass / volume;
inline constexpr Dimension inertia = mass * area;
inline constexpr Dimension voltage = power_output / current;
inline constexpr Dimension resistance = voltage / current;
inline constexpr Dimension inductance = voltage * time / current;
}  // namespace dimension

/// In base units, `kg·m²/s³`; "1" for a dimensionless quantity.
std::string to_string(const Dimension& dimension);

/// A formula adds, compares or feeds to a function quantities that do not fit.
class DimensionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace millwright::scalar
