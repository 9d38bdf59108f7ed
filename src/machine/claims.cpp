// SPDX-License-Identifier: Apache-2.0
#include "machine/claims.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "text/characters.h"

namespace millwright::machine {

namespace {
template <class Rows>
auto find_id(const Rows& rows, const std::string& id) -> decltype(rows.data()) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.id == id; });
  return found == rows.end() ? nullptr : &*found;
}

/// Decimals and significant digits of a number that parse_number has accepted, and the power of ten it carries.
struct Digits {
  int decimals = 0;
  int significant = 0;
  int exponent = 0;
};

Digits digits_of(std::string_view number) {
  Digits digits;
  const std::size_t e = number.find_first_of("eE");
  if (e != std::string_view::npos) {
    std::string_view exponent = number.substr(e + 1);
    if (!exponent.empty() && exponent.front() == '+') exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), digits.exponent);
  }
  bool after_point = false;
  bool leading = true;
  for (const char c : number.substr(0, e)) {
    if (c == '.') after_point = true;
    if (!text::is_digit(c)) continue;
    if (c != '0') leading = false;
    if (!leading) ++digits.significant;
    if (after_point) ++digits.decimals;
  }
  return digits;
}
}  // namespace

const Operand* Calculation::find(const std::string& name) const {
  const auto found = std::find_if(operands.begin(), operands.end(), [&](const auto& one) { return one.first == name; });
  return found == operands.end() ? nullptr : &found->second;
}

std::optional<PrintedValue> parse_printed(std::string_view text, std::string& reason) {
  const std::size_t blank = text.find(' ');
  const std::string_view number = text.substr(0, blank);
  const std::string_view rest = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
  const auto value = scalar::parse_number(number, reason);
  if (!value) return std::nullopt;
  const auto unit = scalar::Unit::parse(rest, reason);
  if (!unit) return std::nullopt;
  const Digits digits = digits_of(number);
  PrintedValue printed;
  printed.text = std::string(number);
  printed.unit = *unit;
  printed.number = *value;
  printed.half_digit = 0.5 * std::pow(10.0, digits.exponent - digits.decimals);
  printed.significant_digits = digits.significant;
  if (!std::isfinite(printed.number) || !(printed.half_digit > 0.0) || !std::isfinite(printed.half_digit)) {
    reason = "beyond the numbers a computer can hold";
    return std::nullopt;
  }
  return printed;
}

const Claim* ClaimsFile::find_claim(const std::string& id) const { return find_id(claims, id); }

const ClaimRow* ClaimsFile::find_row(const std::string& id) const {
  if (const Claim* claim = find_claim(id)) return claim;
  return find_id(derived, id);
}

const scalar::Quantity* ClaimsFile::find_input(const std::string& axis, const std::string& name) const {
  const auto of_axis = inputs.find(axis);
  if (of_axis == inputs.end()) return nullptr;
  const auto found = of_axis->second.find(name);
  return found == of_axis->second.end() ? nullptr : &found->second;
}

}  // namespace millwright::machine
