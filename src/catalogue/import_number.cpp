// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_number.h"

#include <algorithm>
#include <array>

#include "catalogue/import_sheet.h"
#include "text/characters.h"
#include "text/number.h"

namespace millwright::catalogue {
namespace {

/// Blanks and apostrophes that separate thousands, however they are typed.
constexpr std::array<std::string_view, 6> group_marks = {
    " ", "'", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xE2\x80\x99"};

/// The length of a group mark at `at` that three digits, and no fourth, follow; else 0.
std::size_t group_mark_at(std::string_view text, std::size_t at) {
  for (const std::string_view mark : group_marks) {
    const std::size_t digits = at + mark.size();
    if (text.substr(at, mark.size()) != mark || digits + 3 > text.size()) continue;
    const bool three =
        text::is_digit(text[digits]) && text::is_digit(text[digits + 1]) && text::is_digit(text[digits + 2]);
    if (three && (digits + 3 == text.size() || !text::is_digit(text[digits + 3]))) return mark.size();
  }
  return 0;
}

/// Bytes of a sign at the front.
std::size_t sign_length(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) return 1;
  return text.starts_with("\xE2\x88\x92") ? 3 : 0;
}

/// Whether a mark behind this text may belong to the number behind it: not that of an abbreviation, as in kr.500.
bool may_lead(std::string_view before) {
  if (before.empty() || before.ends_with('-') || before.ends_with('+') || before.ends_with('\t')) return true;
  if (before.ends_with("\xE2\x88\x92")) return true;
  return std::any_of(group_marks.begin(), group_marks.end(), [&](std::string_view mark) {
    return mark != "'" && mark != "\xE2\x80\x99" && before.ends_with(mark);
  });
}

/// Bytes of an exponent: e, a sign, digits, and no letter behind them.
std::size_t exponent_length(std::string_view text) {
  if (!text.starts_with('e') && !text.starts_with('E')) return 0;
  std::size_t at = 1;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  const std::size_t first = at;
  while (at < text.size() && text::is_digit(text[at])) ++at;
  return at == first || at - first > 3 ? 0 : at;
}

}  // namespace

CellParts cut_cell(std::string_view cell) {
  CellParts parts;
  std::size_t first = 0;
  while (first < cell.size() && !text::is_digit(cell[first])) ++first;
  if (first == cell.size()) {
    parts.after = cell;
    return parts;
  }
  std::size_t begin = first;
  if (begin > 0 && (cell[begin - 1] == '.' || cell[begin - 1] == ',') && may_lead(cell.substr(0, begin - 1)))
    --begin;  // .5
  if (begin > 0 && sign_length(cell.substr(begin - 1)) == 1)
    --begin;
  else if (begin > 2 && sign_length(cell.substr(begin - 3)) == 3)
    begin -= 3;
  std::size_t end = first;
  while (end < cell.size()) {
    const bool is_mark = cell[end] == '.' || cell[end] == ',';
    if (text::is_digit(cell[end]) || (is_mark && end + 1 < cell.size() && text::is_digit(cell[end + 1]))) {
      ++end;
    } else if (const std::size_t mark = group_mark_at(cell, end); mark > 0) {
      end += mark;
    } else {
      break;
    }
  }
  end += exponent_length(cell.substr(end));
  parts.before = without_blanks(cell.substr(0, begin));
  parts.number = cell.substr(begin, end - begin);
  parts.after = without_blanks(cell.substr(end));
  return parts;
}

MarkEvidence mark_evidence(std::string_view number) {
  const std::size_t exponent = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, exponent).substr(sign_length(number));
  const auto points = std::count(digits.begin(), digits.end(), '.');
  const auto commas = std::count(digits.begin(), digits.end(), ',');
  if (points == 0 && commas == 0) return MarkEvidence::none;
  if (points > 1 && commas > 1) return MarkEvidence::contradictory;
  if (points > 0 && commas > 0) {
    const char last = digits[digits.find_last_of(".,")];
    const bool once = last == '.' ? points == 1 : commas == 1;
    if (!once) return MarkEvidence::contradictory;
    return last == '.' ? MarkEvidence::point : MarkEvidence::comma;
  }
  // One kind of mark. Several separate thousands, so the other one is decimal.
  if (points > 1) return MarkEvidence::comma;
  if (commas > 1) return MarkEvidence::point;
  const std::size_t at = digits.find_first_of(".,");
  const bool has_groups = digits.find_first_not_of("0123456789.,") != std::string_view::npos;
  const bool three_behind = digits.size() - at - 1 == 3;
  const bool may_be_thousands =
      three_behind && at >= 1 && at <= 3 && digits[0] != '0' && !has_groups && exponent == std::string_view::npos;
  if (may_be_thousands) return MarkEvidence::ambiguous;
  return digits[at] == '.' ? MarkEvidence::point : MarkEvidence::comma;
}

std::string plain_number(std::string_view number, DecimalMark mark) {
  const char decimal = mark == DecimalMark::comma ? ',' : '.';
  const char group = mark == DecimalMark::comma ? '.' : ',';
  std::string plain;
  std::size_t at = sign_length(number);
  if (at > 0 && number.front() != '+') plain += '-';
  bool fraction = false;
  bool grouped = false;
  std::size_t run = 0;  // digits since the last mark
  for (; at < number.size() && number[at] != 'e' && number[at] != 'E';) {
    const char c = number[at];
    if (text::is_digit(c)) {
      plain += c;
      ++run;
      ++at;
      continue;
    }
    std::size_t length = 1;
    const bool is_decimal = c == decimal;
    if (c != decimal && c != group) {
      length = group_mark_at(number, at);
      if (length == 0) return {};
    }
    // Marks before this one: thousands stand in threes, and never behind the decimal mark.
    if (fraction || (grouped && run != 3) || (!is_decimal && (run == 0 || run > 3))) return {};
    if (is_decimal) {
      if (run == 0) plain += '0';
      plain += '.';
      fraction = true;
    } else {
      grouped = true;
    }
    run = 0;
    at += length;
  }
  if ((grouped && !fraction && run != 3) || run == 0) return {};
  plain += number.substr(at);
  return text::parse_number(plain) ? plain : std::string();
}

bool says_unknown(std::string_view cell) {
  if (cell.size() > 9 || (!cell.empty() && cell.front() >= '0' && cell.front() <= '9')) return false;
  std::string word(cell);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::string_view, 15> words = {"-",
                                                      "--",
                                                      "---",
                                                      "\xE2\x80\x93",
                                                      "\xE2\x80\x94",
                                                      "n/a",
                                                      "na",
                                                      "n.a.",
                                                      "none",
                                                      "null",
                                                      "tbd",
                                                      "?",
                                                      "unknown",
                                                      "k.a.",
                                                      "/"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace millwright::catalogue
