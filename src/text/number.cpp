// SPDX-License-Identifier: Apache-2.0
#include "text/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "text/characters.h"
#include "text/diagnostic.h"

namespace millwright::text {

namespace {

/// Nobody types more digits; what is longer is another kind of text.
constexpr std::size_t longest_number = 400;

/// The text with each of `from` replaced by `to`, if that makes it a number.
std::optional<std::string> as_number_with(std::string_view text, std::string_view from, std::string_view to) {
  std::string changed;
  for (std::size_t i = 0; i < text.size();) {
    const bool match = text.substr(i, from.size()) == from;
    changed += match ? to : text.substr(i, 1);
    i += match ? from.size() : 1;
  }
  if (changed == text || !parse_number(changed)) return std::nullopt;
  return changed;
}

/// Letters that look like digits.
std::optional<std::string> look_alikes(std::string_view text) {
  std::string changed(text);
  bool has_digit = false;
  for (char& c : changed) {
    has_digit = has_digit || is_digit(c);
    if (c == 'O' || c == 'o') c = '0';
    if (c == 'l' || c == 'I') c = '1';
  }
  if (!has_digit || changed == text || !parse_number(changed)) return std::nullopt;
  const bool zero = text.find_first_of("Oo") != std::string_view::npos;
  return fmt::format("letter {} where a {} was meant: {}",
                     zero                                       ? "O"
                     : text.find('l') != std::string_view::npos ? "l"
                                                                : "I",
                     zero ? "zero" : "one",
                     changed);
}

/// Groups of three digits after a mark that can only separate thousands.
std::optional<std::string> thousands(std::string_view text) {
  for (const std::string_view mark : {" ", "'", "\u00A0", "\u202F", "\u2019"}) {
    if (const auto found = as_number_with(text, mark, "")) return "no thousands separators: " + *found;
  }
  const bool two_commas = std::count(text.begin(), text.end(), ',') > 1;
  const bool two_points = std::count(text.begin(), text.end(), '.') > 1;
  const std::size_t comma = text.find(',');
  const std::size_t point = text.find('.');
  const bool both = comma != std::string_view::npos && point != std::string_view::npos;
  if (!two_commas && !two_points && !both) return std::nullopt;
  std::string changed(text);
  const char separator = two_points || (both && point < comma) ? '.' : ',';
  changed.erase(std::remove(changed.begin(), changed.end(), separator), changed.end());
  std::replace(changed.begin(), changed.end(), ',', '.');
  if (!parse_number(changed)) return std::nullopt;
  return "no thousands separators: " + changed;
}

/// A number with something behind it.
std::optional<std::string> unit_behind(std::string_view text, NumberPlace place) {
  double value = 0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
  const auto length = static_cast<std::size_t>(result.ptr - text.data());
  const std::string_view rest = without_blanks(text.substr(length));
  if (rest.empty() || length == 0 || !is_digit(text[length - 1])) return std::nullopt;
  const auto lead = static_cast<unsigned char>(rest.front());
  const bool word = (lead | 0x20U) - 'a' < 26U || lead >= 0x80 || lead == '%' || lead == '"' || lead == '[';
  if (!word) return std::nullopt;
  const std::string unit = in_quotes(rest, 12);
  const std::string_view number = text.substr(0, length);
  return place == NumberPlace::alone
             ? fmt::format("without {}: write {}", unit, number)
             : fmt::format("unit in the cell {}: units stand in the header, in brackets; write {}", unit, number);
}

}  // namespace

std::optional<double> parse_number(std::string_view text, DecimalMark mark) {
  text = without_blanks(text);
  // from_chars takes no plus sign; "+-1" must not slip through.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  if (text.empty() || text.size() > longest_number) return std::nullopt;
  std::array<char, longest_number> with_point{};
  if (mark == DecimalMark::point_or_comma && text.find(',') != std::string_view::npos) {
    if (text.find('.') != std::string_view::npos) return std::nullopt;
    std::replace_copy(text.begin(), text.end(), with_point.begin(), ',', '.');
    text = std::string_view(with_point.data(), text.size());
  }
  double value = 0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = result.ec == std::errc{} && result.ptr == text.data() + text.size();
  if (!whole || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string number_hint(std::string_view text, NumberPlace place) {
  text = without_blanks(text);
  if (text.size() > longest_number) return fmt::format("{} characters are no number", text.size());
  if (const auto hint = look_alikes(text)) return *hint;
  if (const auto fixed = as_number_with(text, ",", ".")) {
    if (std::count(text.begin(), text.end(), ',') == 1) {
      return fmt::format("decimal comma: write {}{}",
                         *fixed,
                         place == NumberPlace::alone ? "" : ", or separate the cells of this file by ;");
    }
  }
  if (const auto hint = thousands(text)) return *hint;
  if (const auto fixed = as_number_with(text, "\u2212", "-")) return "a minus sign of typesetting: write " + *fixed;
  if (const auto hint = unit_behind(text, place)) return *hint;
  if (place == NumberPlace::cell) {
    const std::string word = lower_case(text);
    for (const std::string_view missing :
         {"n/a", "na", "nan", "-", "--", "?", "none", "null", "tbd", "unknown", "\u2013"}) {
      if (word == missing) return "leave the cell empty where a value is missing";
    }
    if (word.front() == '#') return "an error value of a spreadsheet: compute it anew or leave the cell empty";
  }
  double value = 0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range) return "too large or too small for a number";
  return "write digits with a decimal point, such as 12.5 or 1.2e-3";
}

}  // namespace millwright::text
