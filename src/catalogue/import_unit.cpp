// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_unit.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "catalogue/column_unit.h"
#include "catalogue/import_sheet.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

/// Spelt otherwise by many; compared without case, blanks and dots.
constexpr Pair spellings[] = {
    {"ohms", "ohm"},
    {"ohm", "ohm"},
    {"volt", "V"},
    {"volts", "V"},
    {"vdc", "V"},
    {"dcv", "V"},
    {"v", "V"},
    {"amp", "A"},
    {"amps", "A"},
    {"ampere", "A"},
    {"a", "A"},
    {"ma", "mA"},
    {"adc", "A"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"grad", "deg"},
    {"deg/step", "deg"},
    {"\"", "in"},
    {"\xE2\x80\xB3", "in"},
    {"zoll", "in"},
    {"inch", "in"},
    {"inches", "in"},
    {"gram", "g"},
    {"grams", "g"},
    {"gr", "g"},
    {"kgs", "kg"},
    {"kg", "kg"},
    {"g", "g"},
    {"lbs", "lb"},
    {"lb", "lb"},
    {"mm", "mm"},
    {"cm", "cm"},
    {"nm", "N.m"},
    {"ncm", "N.cm"},
    {"nmm", "N.mm"},
    {"mnm", "mN.m"},
    {"ozin", "oz.in"},
    {"lbin", "lbf.in"},
    {"inlb", "lbf.in"},
    {"inlbs", "lbf.in"},
    {"lbfin", "lbf.in"},
    {"ftlb", "ft.lbf"},
    {"lbft", "lbf.ft"},
    {"inoz", "oz.in"},
    {"kgcm", "kgf.cm"},
    {"kgfcm", "kgf.cm"},
    {"gcm", "gf.cm"},
    {"kgm", "kgf.m"},
    {"gcm2", "g.cm2"},
    {"kgcm2", "kg.cm2"},
    {"kgm2", "kg.m2"},
    {"kgmm2", "kg.mm2"},
    {"ozin2", "oz.in2"},
    {"lbin2", "lb.in2"},
    {"mh", "mH"},
    {"uh", "uH"},
    {"w", "W"},
    {"kw", "kW"},
    {"n", "N"},
    {"kn", "kN"},
    {"mpa", "MPa"},
    {"gpa", "GPa"},
    {"n/mm2", "N/mm2"},
    {"1/min", "rpm"},
    {"u/min", "rpm"},
    {"min-1", "rpm"},
    {"r/min", "rpm"},
    {"rev/min", "rpm"},
    {"kg/m", "kg/m"},
    {"g/m", "g/m"},
    {"n/um", "N/um"},
    {"m/s", "m/s"},
    {"kg/m3", "kg/m3"},
    {"g/cm3", "g/cm3"},
    {"percent", "%"},
    {"nm/rad", "N.m/rad"},
    {"microns", "um"},
    {"micron", "um"},
    {"stk", "1"},
    {"pcs", "1"},
    {"pc", "1"},
};

/// What says of which thing it is, not how much.
constexpr std::string_view of_what[] = {"/phase",
                                        "/ph",
                                        "/ phase",
                                        " per phase",
                                        "/pcs",
                                        "/pc",
                                        "/piece",
                                        "/ea",
                                        "/each",
                                        "/stk",
                                        "/unit",
                                        "/st\u00FCck",
                                        " each",
                                        " per piece",
                                        "/step",
                                        " rms"};

constexpr Pair currency_signs[] = {
    {"\xE2\x82\xAC", "EUR"},
    {"euro", "EUR"},
    {"\xC2\xA3", "GBP"},
    {"us$", "USD"},
    {"us dollar", "USD"},
    {"\xE2\x82\xB9", "INR"},
    {"\xE2\x82\xA9", "KRW"},
    {"\xE2\x82\xBA", "TRY"},
    {"rp", "IDR"},
    {"rmb", "CNY"},
    {"z\xC5\x82", "PLN"},
    {"\xE2\x82\xBD", "RUB"},
    {"$", "?"},
    {"\xC2\xA5", "?"},
    {"kr", "?"},
};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// Without case, blanks, dots and other signs of multiplication.
std::string folded(std::string_view text) {
  static constexpr Pair replaced[] = {{"\xC2\xB2", "2"},
                                      {"\xC2\xB3", "3"},
                                      {"\xC2\xB5", "u"},
                                      {"\xCE\xBC", "u"},
                                      {"\xCE\xA9", "ohm"},
                                      {"\xE2\x84\xA6", "ohm"},
                                      {"\xC2\xB0", "deg"},
                                      {"\xC2\xB7", ""},
                                      {"\xE2\x8B\x85", ""},
                                      {"\xC3\x97", ""},
                                      {" ", ""},
                                      {".", ""},
                                      {"*", ""},
                                      {"-", ""},
                                      {"^", ""},
                                      {"_", ""}};
  std::string result;
  const std::string all = lower(text);
  for (std::size_t i = 0; i < all.size();) {
    std::size_t length = 1;
    std::string_view with = std::string_view(all).substr(i, 1);
    for (const auto& [from, to] : replaced) {
      if (!std::string_view(all).substr(i).starts_with(from)) continue;
      length = from.size();
      with = to;
      break;
    }
    result += with;
    i += length;
  }
  return result;
}

std::string_view without_brackets(std::string_view text) {
  text = without_blanks(text);
  const bool round = text.starts_with('(') && text.ends_with(')');
  const bool square = text.starts_with('[') && text.ends_with(']');
  return text.size() >= 2 && (round || square) ? without_blanks(text.substr(1, text.size() - 2)) : text;
}

std::string_view without_what(std::string_view text) {
  const std::string all = lower(text);
  for (const std::string_view ending : of_what)
    if (all.size() >= ending.size() && all.ends_with(ending))
      return without_blanks(text.substr(0, text.size() - ending.size()));
  return text;
}

std::optional<scalar::Unit> fitting(std::string_view text, const scalar::Unit& expected, std::string& reason) {
  const auto unit = scalar::Unit::parse(text, reason);
  return unit && unit->fits(expected, reason) ? unit : std::nullopt;
}

/// kg.cm as kgf.cm, lb as lbf: what shops mean where a force is wanted.
std::string with_forces(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || (text[end] >= 'A' && text[end] <= 'Z')))
      ++end;
    const std::string_view word = text.substr(i, end - i);
    result += word;
    if (word == "kg" || word == "g" || word == "lb" || word == "oz") result += 'f';
    if (word == "lbs") result.back() = 'f';
    if (end == i) result += text[end++];
    i = end;
  }
  return result;
}

std::optional<ShopUnit> plain_unit(std::string_view words, const scalar::Unit& expected, std::string& reason) {
  ShopUnit found;
  const auto settle = [&](std::string_view text, const scalar::Unit& unit) {
    found.unit = std::string(text);
    found.meaning = unit;
    if (text != words) found.remark = fmt::format("{} as {}", text::printable(words, 30), text.empty() ? "1" : text);
    return found;
  };
  for (const std::string_view each : {words, without_what(words)}) {
    if (const auto unit = fitting(each, expected, reason)) return settle(each, *unit);
    std::string unused;
    const std::string fold = folded(each);
    for (const auto& [spelling, meant] : spellings) {
      if (fold != spelling && lower(each) != spelling) continue;
      if (const auto unit = fitting(meant, expected, unused)) return settle(meant, *unit);
    }
    const std::string forces = with_forces(each);
    if (const auto unit = fitting(forces, expected, unused)) return settle(forces, *unit);
  }
  return std::nullopt;
}

std::optional<ShopUnit> price_unit(std::string_view words, const scalar::Unit& expected, std::string& reason) {
  std::string_view per = without_what(words);
  const std::size_t slash = per.find('/');
  const std::string currency = currency_of(per.substr(0, slash));
  if (currency.empty()) {
    reason = fmt::format("{} is no currency", text::in_quotes(words));
    return std::nullopt;
  }
  ShopUnit found;
  found.currency = currency;
  if (slash != std::string_view::npos) {
    found.unit = "1/" + std::string(without_blanks(per.substr(slash + 1)));
    const auto unit = fitting(found.unit, expected, reason);
    if (!unit) return std::nullopt;
    found.meaning = *unit;
  } else if (expected.dimension() == scalar::dimension::none) {
    found.meaning = expected;
  } else {
    reason = fmt::format("{} says a price, not per what", text::in_quotes(words));
    return std::nullopt;
  }
  return found;
}

}  // namespace

std::string currency_of(std::string_view words) {
  words = without_brackets(words);
  // The point of an abbreviation: kr., Rp.
  if (words.size() > 1 && words.ends_with('.') && lower(words.substr(words.size() - 2, 1)) >= "a" &&
      lower(words.substr(words.size() - 2, 1)) <= "z")
    words.remove_suffix(1);
  const std::string word = lower(words);
  for (const auto& [sign, code] : currency_signs)
    if (word == sign) return std::string(code);
  std::string reason;
  std::string capitals(words);
  for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  if (capitals.size() != 3) return {};
  const auto unit = scalar::Unit::parse(capitals, reason);
  return unit ? unit->currency() : std::string();
}

std::optional<ShopUnit> shop_unit(std::string_view words, Column column, std::string& reason) {
  words = without_brackets(words);
  constexpr std::size_t longest = 40;
  if (words.size() > longest) {
    reason = "too long for a unit";
    return std::nullopt;
  }
  const scalar::Unit& expected = display_unit(column);
  return declaration(column).kind == Kind::money ? price_unit(words, expected, reason)
                                                 : plain_unit(words, expected, reason);
}

bool is_any_unit(std::string_view words) {
  words = without_brackets(words);
  if (words.empty() || words.size() > 40) return false;
  if (words.find_first_not_of("0123456789.,") == std::string_view::npos) return false;
  std::string reason;
  if (scalar::Unit::parse(without_what(words), reason) || !currency_of(words).empty()) return true;
  const std::string fold = folded(without_what(words));
  for (const auto& [spelling, meant] : spellings)
    if (fold == spelling) return true;
  return !currency_of(without_what(words).substr(0, words.find('/'))).empty();
}

}  // namespace millwright::catalogue
