// SPDX-License-Identifier: Apache-2.0
// "Did you mean ...?": the known word that a misspelt one is closest to.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::text {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance), byte by byte.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate closest to `word`, if any is close enough to be meant: at most one edit in three letters, upper and
/// lower case alike, `-`, `_` and blank alike; failing that, the only candidate that begins with `word` (3 letters or
/// more). The first of several equally close ones wins.
std::optional<std::string> nearest_of(std::string_view word, const std::vector<std::string_view>& candidates);

/// The same for any range of strings.
template <class Range>
std::optional<std::string> nearest(std::string_view word, const Range& candidates) {
  std::vector<std::string_view> views;
  for (const auto& candidate : candidates) views.emplace_back(candidate);
  return nearest_of(word, views);
}

inline std::optional<std::string> nearest(std::string_view word, std::initializer_list<std::string_view> candidates) {
  return nearest_of(word, std::vector<std::string_view>(candidates));
}

/// "did you mean 'stroke'?", or `otherwise` if no candidate is close.
template <class Range>
std::string did_you_mean(std::string_view word, const Range& candidates, std::string_view otherwise = {}) {
  const std::optional<std::string> found = nearest(word, candidates);
  return found ? "did you mean '" + *found + "'?" : std::string(otherwise);
}

}  // namespace millwright::text
