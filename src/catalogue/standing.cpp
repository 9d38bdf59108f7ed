// SPDX-License-Identifier: Apache-2.0
#include "catalogue/standing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <limits>
#include <string>

#include "text/characters.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

constexpr std::array<std::string_view, 3> confidence_words = {"high", "medium", "low"};

bool contains_any(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return text.find(word) != text.npos; });
}

}  // namespace

Standing standing_of(std::string_view basis) {
  if (basis.empty()) return Standing::unstated;
  const std::string text = text::lower_case(basis);
  if (contains_any(
          text, {"estimate", "assum", "typical", "placeholder", "about ", "equal to", "same winding", "*ultimate"})) {
    return Standing::estimated;
  }
  if (contains_any(text, {"comput", "calculat", "interpolat"})) return Standing::computed;
  if (contains_any(text, {"general knowledge", "memory", "remembered"})) return Standing::remembered;
  if (contains_any(text, {"not published", "unknown"})) return Standing::unstated;
  return Standing::published;
}

std::optional<std::string_view> confidence_word(std::string_view cell) {
  const auto alike = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); };
  for (const std::string_view word : confidence_words)
    if (std::equal(cell.begin(), cell.end(), word.begin(), word.end(), alike)) return word;
  return std::nullopt;
}

std::string confidence_hint(std::string_view cell) {
  constexpr std::string_view all = "write high, medium or low, or leave the cell empty";
  const auto near = text::nearest(cell.substr(0, 16), confidence_words);
  return near ? "did you mean '" + *near + "'? " + std::string(all) : std::string(all);
}

bool counts_as_estimate(Standing standing, std::string_view confidence) {
  if (standing == Standing::estimated || standing == Standing::computed) return true;
  return standing != Standing::published && confidence == "low";
}

double stated_tolerance(std::string_view basis) {
  for (const std::string_view mark : {std::string_view("+-"), std::string_view("\u00B1")}) {
    for (std::size_t at = basis.find(mark); at != basis.npos; at = basis.find(mark, at + 1)) {
      const char* const end = basis.data() + basis.size();
      const char* begin = basis.data() + at + mark.size();
      while (begin < end && *begin == ' ') ++begin;
      double percent = 0.0;
      const auto [rest, problem] = std::from_chars(begin, end, percent);
      if (problem != std::errc()) continue;
      const char* after = rest;
      while (after < end && *after == ' ') ++after;
      if (after < end && *after == '%' && percent >= 0.0) return percent / 100.0;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string_view to_string(Standing standing) {
  switch (standing) {
    case Standing::published:
      return "published";
    case Standing::remembered:
      return "remembered";
    case Standing::computed:
      return "computed";
    case Standing::estimated:
      return "estimated";
    case Standing::unstated:
      break;
  }
  return "unstated";
}

}  // namespace millwright::catalogue
