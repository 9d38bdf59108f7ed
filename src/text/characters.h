// SPDX-License-Identifier: Apache-2.0
/// Letters, digits and blanks of ASCII, whatever the locale: what files and command lines are read with.
#pragma once

#include <string>
#include <string_view>

namespace millwright::text {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// What a name in a file begins with: a letter or `_`.
constexpr bool begins_name(char c) { return is_letter(c) || c == '_'; }

/// With capitals A to Z made small; other bytes stay, so UTF-8 stays what it is.
inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// Without the `blanks` it begins and ends with; a view into `text`.
constexpr std::string_view without_blanks(std::string_view text, std::string_view blanks = " \t\r") {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace millwright::text
