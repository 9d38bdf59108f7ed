// SPDX-License-Identifier: Apache-2.0
//
// Numbers and quantities as an engineer prints them.
#include <fmt/format.h>

#include <cmath>

#include "scalar/unit.h"

namespace millwright::scalar {
namespace {

void drop_trailing_zeros(std::string& text) {
  const std::size_t exponent = std::min(text.find('e'), text.size());
  if (text.find('.') >= exponent) return;
  std::size_t keep = exponent;
  while (text[keep - 1] == '0') --keep;
  if (text[keep - 1] == '.') --keep;
  text.erase(keep, exponent - keep);
}

/// Units of one dimension, from small to large, each used from `from` (in SI) upwards.
struct Readable {
  Dimension dimension;
  struct Step {
    double from;
    const char* unit;
  };
  Step steps[4];
};

const Dimension cube_of_force = dimension::force * dimension::force * dimension::force;

const Readable readable[] = {
    {dimension::none, {{0, ""}}},
    {dimension::length, {{0, "µm"}, {1e-4, "mm"}, {10, "m"}}},
    {dimension::area, {{0, "mm²"}, {1, "m²"}}},
    {dimension::volume, {{0, "mm³"}, {1e-3, "m³"}}},
    {dimension::second_moment_of_area, {{0, "mm⁴"}, {1e-2, "m⁴"}}},
    {dimension::mass, {{0, "g"}, {0.1, "kg"}}},
    {dimension::time, {{0, "ms"}, {0.1, "s"}, {36000, "h"}}},
    {dimension::current, {{0, "mA"}, {0.1, "A"}}},
    {dimension::temperature, {{0, "K"}}},
    {dimension::speed, {{0, "mm/s"}, {1, "m/s"}}},
    {dimension::acceleration, {{0, "m/s²"}}},
    {dimension::angular_speed, {{0, "rad/s"}}},
    {dimension::angular_acceleration, {{0, "rad/s²"}}},
    {dimension::force, {{0, "N"}, {1e4, "kN"}}},
    {dimension::torque, {{0, "mN·m"}, {0.1, "N·m"}}},
    {dimension::power_output, {{0, "mW"}, {0.1, "W"}, {1e4, "kW"}}},
    {dimension::pressure, {{0, "Pa"}, {1e4, "MPa"}, {1e10, "GPa"}}},
    {dimension::stiffness, {{0, "N/m"}, {1e3, "N/mm"}, {1e6, "N/µm"}}},
    {dimension::inertia, {{0, "g·cm²"}, {1e-4, "kg·m²"}}},
    {dimension::mass_per_length, {{0, "kg/m"}}},
    {dimension::density, {{0, "kg/m³"}}},
    {dimension::voltage, {{0, "mV"}, {0.1, "V"}}},
    {dimension::resistance, {{0, "mΩ"}, {0.1, "Ω"}}},
    {dimension::inductance, {{0, "mH"}, {1, "H"}}},
    // What cubic means of loads and the RMS of torques are made of, and the heat resistance of a winding.
    {cube_of_force, {{0, "N³"}}},
    {cube_of_force * dimension::length, {{0, "N³·m"}}},
    {cube_of_force * dimension::speed, {{0, "N³·m/s"}}},
    {dimension::torque * dimension::torque * dimension::torque, {{0, "N³·m³"}}},
    {dimension::torque * dimension::torque, {{0, "N²·m²"}}},
    {dimension::torque * dimension::torque * dimension::time, {{0, "N²·m²·s"}}},
    {dimension::temperature / dimension::power_output, {{0, "K/W"}}},
};

}  // namespace

std::string format_number(double value, int significant) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return std::isnan(value) ? "undefined" : value > 0.0 ? "∞" : "-∞";
  std::string text = fmt::format("{:.{}e}", value, significant - 1);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));  // after rounding: 9.9996 has 1 digit more
  if (exponent >= -4 && exponent < 7) {
    const double shown = std::stod(text);
    text = fmt::format("{:.{}f}", exponent >= significant ? value : shown, std::max(0, significant - 1 - exponent));
  }
  drop_trailing_zeros(text);
  return text;
}

std::string format(double si, const Unit& display, int significant) {
  std::string text = format_number(display.from_si(si), significant);
  const std::string& name = display.name();
  if (name.empty() || name == "1") return text;
  const bool attached = name == "°" || name == "%";
  return text + (attached ? "" : " ") + name;
}

Unit readable_unit(const Dimension& dimension, double si) {
  for (const Readable& row : readable) {
    if (!(row.dimension == dimension)) continue;
    const char* unit = row.steps[0].unit;
    for (const auto& step : row.steps) {
      if (step.unit != nullptr && std::fabs(si) >= step.from) unit = step.unit;
    }
    if (si == 0.0) unit = row.steps[1].unit != nullptr ? row.steps[1].unit : unit;
    return Unit::of(unit);
  }
  std::string reason;
  return Unit::parse(to_string(dimension), reason).value_or(Unit());
}

}  // namespace millwright::scalar
