// SPDX-License-Identifier: Apache-2.0
#include "text/nearest.h"

#include <algorithm>

namespace millwright::text {

namespace {

/// Nobody misspells a word this long; and the distance of two long words takes time.
constexpr std::size_t longest_word = 64;

std::string folded(std::string_view word) {
  std::string result(word);
  for (char& letter : result) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (letter == '-' || letter == ' ') letter = '_';
  }
  return result;
}

/// The only candidate that begins with `word`.
std::optional<std::string> completion(const std::string& word, const std::vector<std::string_view>& candidates) {
  std::optional<std::string> found;
  if (word.size() < 3) return found;
  for (const std::string_view candidate : candidates) {
    if (folded(candidate.substr(0, word.size())) != word) continue;
    if (found && *found != candidate) return std::nullopt;
    found = std::string(candidate);
  }
  return found;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> nearest_of(std::string_view word, const std::vector<std::string_view>& candidates) {
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  const std::string wanted = folded(word);
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::optional<std::string> best;
  std::size_t best_distance = allowed + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.empty() || candidate.size() > word.size() + allowed || candidate.size() + allowed < word.size())
      continue;
    const std::size_t distance = edit_distance(wanted, folded(candidate));
    // A word of one or two letters is not "misspelt" when all of it changes.
    if (distance >= best_distance || distance >= std::max(word.size(), candidate.size())) continue;
    best_distance = distance;
    best = std::string(candidate);
  }
  return best ? best : completion(wanted, candidates);
}

}  // namespace millwright::text
