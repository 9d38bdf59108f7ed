// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

/// Length of the character that begins at `at`, 0 if what stands there is no UTF-8.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (length == 1) return 1;
  if (first < 0xc2 || first > 0xf4 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  // Overlong forms, surrogates and what lies beyond Unicode.
  const unsigned char second = byte(at + 1);
  const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                     (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return wrong ? 0 : length;
}

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code == 0x7f || (code < 0x20 && c != '\n' && c != '\t');
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    if (length == 0 || (length == 1 && is_control(text[at]))) {
      out += replacement;
      ++at;
      continue;
    }
    const std::string_view named = length == 1 ? entity(text[at]) : std::string_view();
    out += named.empty() ? text.substr(at, length) : named;
    at += length;
  }
  return out;
}

std::string identifier(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-')
      out += c;
    else
      out += fmt::format("_{:02x}", static_cast<unsigned char>(c));
  }
  return out;
}

std::string json_in_script(std::string json) {
  replace_all(json, "<", "\\u003c");
  replace_all(json, "\xe2\x80\xa8", "\\u2028");
  replace_all(json, "\xe2\x80\xa9", "\\u2029");
  return json;
}

std::string shown_unit(std::string_view unit) {
  if (unit == "1") return {};
  static constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  std::string word;
  const auto end_word = [&] {
    if (word == "deg")
      out += "°";
    else if (word == "ohm")
      out += "Ω";
    else if (word.size() > 1 && word.front() == 'u' && word != "us")
      out += "µ" + word.substr(1);
    else
      out += word;
    word.clear();
  };
  for (const char c : unit) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '%') {
      word += c;
      continue;
    }
    const bool after_word = !word.empty() || !out.empty();
    end_word();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 && after_word)
      out += raised[static_cast<std::size_t>(c - '0')];
    else if (c == '-' && after_word)
      out += "⁻";
    else if (c == '.' || c == '*')
      out += "·";
    else if (c != '^')
      out += c;
  }
  end_word();
  return out;
}

std::string shown_quantity(double value, std::string_view unit, int significant) {
  if (std::isnan(value)) return "–";
  const std::string shown = shown_unit(unit);
  return scalar::format_number(value, significant) + (shown.empty() ? "" : (shown == "°" ? "" : "\u202f") + shown);
}

std::string shown_millimetres(double metres) { return millimetres_text(metres) + "\u202fmm"; }

}  // namespace millwright::report
