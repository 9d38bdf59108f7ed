// SPDX-License-Identifier: Apache-2.0
#include "report/quantity_text.h"

#include <fmt/format.h>

#include "report/rounded.h"
#include "scalar/unit.h"

namespace millwright::report {
namespace {

constexpr int digits_of_energy = 5, digits_of_error = 4;

}  // namespace

std::string quantity_text(machine::Quantity quantity, double value, const std::string& currency) {
  switch (quantity) {
    case machine::Quantity::cost:
      return fmt::format("{:.2f} {}", value, currency);
    case machine::Quantity::mass:
      return fmt::format("{:.3f} kg", value);
    case machine::Quantity::cycle_time:
      return fmt::format("{:.3f} s", value);
    case machine::Quantity::energy:
      return fmt::format("{} J", scalar::format_number(value, digits_of_energy));
    case machine::Quantity::position_error:
      return fmt::format("{} um", scalar::format_number(scalar::Unit::of("um").from_si(value), digits_of_error));
  }
  return {};
}

std::string quantity_bound_text(machine::Quantity quantity, double bound, const std::string& currency) {
  switch (quantity) {
    case machine::Quantity::cost:
      return quantity_text(quantity, rounded_down(bound, 0.01), currency);
    case machine::Quantity::mass:
    case machine::Quantity::cycle_time:
      return quantity_text(quantity, rounded_down(bound, 0.001), currency);
    case machine::Quantity::energy:
      return quantity_text(quantity, rounded_down(bound, last_digit(bound, digits_of_energy)), currency);
    case machine::Quantity::position_error: {
      const double micrometres = scalar::Unit::of("um").from_si(bound);
      const double down = rounded_down(micrometres, last_digit(micrometres, digits_of_error));
      return quantity_text(quantity, scalar::Unit::of("um").to_si(down), currency);
    }
  }
  return {};
}

std::string millimetres_text(double metres) {
  const double millimetres = scalar::Unit::of("mm").from_si(metres);
  int digits = 4;
  for (double tenfold = 1000.0; tenfold <= std::abs(millimetres); tenfold *= 10.0) ++digits;
  return scalar::format_number(millimetres, digits);
}

std::string percent_rounded_up(double part, int digits) {
  return fmt::format("{:.{}g}", rounded_up(100.0 * part, last_digit(100.0 * part, digits)), digits);
}

}  // namespace millwright::report
