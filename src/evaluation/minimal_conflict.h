// SPDX-License-Identifier: Apache-2.0
//
// Which of many conditions contradict each other: a smallest set in the sense that without any one of its members the
// rest of it can be met. By splitting in halves (Junker, QuickXplain, AAAI 2004): of n conditions k of which are in
// conflict, about 2 k log2(n/k) questions are asked instead of n.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace millwright::evaluation {

using ConditionSet = std::vector<std::size_t>;

/// `possible(set)`: whether all conditions of a set (ascending) can be met together; fewer must be possible whenever
/// more are. All of `conditions` together must be impossible, none of them possible. Where several sets conflict, one
/// of the conditions that come first in `conditions` is preferred.
template <class Possible>
ConditionSet minimal_conflict(const ConditionSet& conditions, Possible&& possible) {
  const auto joined = [](ConditionSet a, const ConditionSet& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::sort(a.begin(), a.end());
    return a;
  };
  // Members of a conflict among `of`, given all of `background`; `grown`: the background was extended just now.
  const auto search =
      [&](auto&& self, const ConditionSet& background, bool grown, const ConditionSet& of) -> ConditionSet {
    if (grown && !possible(background)) return {};
    if (of.size() <= 1) return of;
    const auto middle = of.begin() + static_cast<std::ptrdiff_t>((of.size() + 1) / 2);
    const ConditionSet first(of.begin(), middle), second(middle, of.end());
    const ConditionSet of_second = self(self, joined(background, first), true, second);
    const ConditionSet of_first = self(self, joined(background, of_second), !of_second.empty(), first);
    return joined(of_first, of_second);
  };
  return search(search, {}, false, conditions);
}

/// Members of `candidates` that matter on their own: matter({{i}})[0]. Where a set does not matter no member of it
/// does, so most are never asked alone. `matter(sets)` answers for each of several sets, which may be looked at
/// together.
template <class Matter>
ConditionSet those_that_matter(const ConditionSet& candidates, Matter&& matter) {
  ConditionSet result;
  std::vector<ConditionSet> open;
  if (!candidates.empty()) open.push_back(candidates);
  while (!open.empty()) {
    const std::vector<bool> answers = matter(open);
    std::vector<ConditionSet> next;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (!answers[k]) continue;
      if (open[k].size() == 1) {
        result.push_back(open[k].front());
        continue;
      }
      const auto middle = open[k].begin() + static_cast<std::ptrdiff_t>(open[k].size() / 2);
      next.emplace_back(open[k].begin(), middle);
      next.emplace_back(middle, open[k].end());
    }
    open = std::move(next);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace millwright::evaluation
