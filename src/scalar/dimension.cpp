// SPDX-License-Identifier: Apache-2.0
#include "scalar/dimension.h"

#include <fmt/format.h>

#include <cmath>

namespace millwright::scalar {
namespace {

std::string superscript(double exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 1.0) return "";
  const double whole = std::round(exponent);
  if (std::fabs(whole - exponent) > 1e-9) return fmt::format("^{:.4g}", exponent);
  std::string text;
  for (const char c : fmt::format("{:.0f}", whole)) text += c == '-' ? "⁻" : digits[c - '0'];
  return text;
}

}  // namespace

std::string to_string(const Dimension& dimension) {
  const std::pair<const char*, double> bases[] = {{"kg", dimension.kilogram},
                                                  {"m", dimension.metre},
                                                  {"s", dimension.second},
                                                  {"A", dimension.ampere},
                                                  {"K", dimension.kelvin}};
  std::string above;
  std::string below;
  int divisors = 0;
  for (const auto& [symbol, exponent] : bases) {
    if (std::fabs(exponent) < 1e-9) continue;
    std::string& side = exponent > 0.0 ? above : below;
    if (!side.empty()) side += "·";
    side += symbol + superscript(std::fabs(std::fabs(exponent) - 1.0) < 1e-9 ? 1.0 : std::fabs(exponent));
    divisors += exponent < 0.0 ? 1 : 0;
  }
  if (above.empty()) above = "1";
  if (divisors == 0) return above;
  return above + (divisors == 1 ? "/" + below : "/(" + below + ")");
}

}  // namespace millwright::scalar
