// SPDX-License-Identifier: Apache-2.0
// Conflicts that are known beforehand, found again.
#include "evaluation/minimal_conflict.h"

#include <numeric>
#include <random>

#include "catch.h"

namespace minimal_conflict_test {

using namespace millwright;
using evaluation::ConditionSet;

namespace {

bool contains(const ConditionSet& set, const ConditionSet& part) {
  return std::includes(set.begin(), set.end(), part.begin(), part.end());
}

ConditionSet first(std::size_t count) {
  ConditionSet all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

TEST_CASE("A conflict that is found is impossible, and possible without any one of its members") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t count = 1 + random() % 40;
    std::vector<ConditionSet> contradictions(1 + random() % 4);
    for (ConditionSet& each : contradictions) {
      while (each.size() < 1 + random() % std::min<std::size_t>(count, 6)) {
        const std::size_t member = random() % count;
        if (std::count(each.begin(), each.end(), member) == 0) each.push_back(member);
      }
      std::sort(each.begin(), each.end());
    }
    std::size_t asked = 0;
    const auto possible = [&](const ConditionSet& set) {
      ++asked;
      CHECK(std::is_sorted(set.begin(), set.end()));
      return std::none_of(
          contradictions.begin(), contradictions.end(), [&](const ConditionSet& each) { return contains(set, each); });
    };
    const ConditionSet conflict = evaluation::minimal_conflict(first(count), possible);
    CHECK(asked <= 2 * count);
    CHECK_FALSE(possible(conflict));
    for (std::size_t i = 0; i < conflict.size(); ++i) {
      ConditionSet less = conflict;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
      CHECK(possible(less));
    }
  }
}

TEST_CASE("Of several conflicts one among the first conditions is preferred, and few questions are asked") {
  std::size_t asked = 0;
  const auto possible = [&](const ConditionSet& set) {
    ++asked;
    return !contains(set, {3, 11}) && !contains(set, {900});
  };
  CHECK(evaluation::minimal_conflict(first(1000), possible) == ConditionSet{3, 11});
  CHECK(asked < 60);
}

TEST_CASE("Members that matter alone are found in a crowd") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = 1 + random() % 60;
    ConditionSet weights(count, 0);
    for (std::size_t i = 0; i < count; ++i) weights[i] = random() % 12 == 0 ? 1 : 0;
    ConditionSet expected;
    for (std::size_t i = 0; i < count; ++i)
      if (weights[i] > 0) expected.push_back(i);
    CHECK(evaluation::those_that_matter(first(count), [&](const std::vector<ConditionSet>& sets) {
            std::vector<bool> answers;
            for (const ConditionSet& set : sets)
              answers.push_back(std::any_of(set.begin(), set.end(), [&](std::size_t i) { return weights[i] > 0; }));
            return answers;
          }) == expected);
  }
}

}  // namespace minimal_conflict_test
