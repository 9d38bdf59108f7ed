// SPDX-License-Identifier: Apache-2.0
//
// Sets of vectors that bound others from below, against what they were made of.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "solver/rest_vectors.h"

namespace rest_vectors_test {

namespace {

using namespace millwright::solver;

constexpr std::size_t dimensions = 4;

VectorSet random_set(std::mt19937& rng, std::size_t size) {
  std::uniform_real_distribution<double> number(0.0, 10.0);
  VectorSet set(dimensions);
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<double> vector;
    // Whole numbers now and then, so that there are equals.
    for (std::size_t d = 0; d < dimensions; ++d)
      vector.push_back(rng() % 3 == 0 ? std::floor(number(rng)) : number(rng));
    set.add(vector);
  }
  return set;
}
struct Weights {
  double first = 0.0, second = 0.0;
  [[nodiscard]] double of(std::span<const double> score) const { return first * score[0] + second * score[1]; }
};
bool at_most(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x <= y; });
}
bool bounded_by(const VectorSet& lower, std::span<const double> vector) {
  for (std::size_t i = 0; i < lower.size(); ++i)
    if (at_most(lower[i], vector)) return true;
  return false;
}

}  // namespace

TEST_CASE("Lower vectors are at most what they stand for, few, and none stands for another") {
  std::mt19937 rng(7);
  for (const std::size_t size : {std::size_t{1}, std::size_t{30}, std::size_t{900}}) {
    for (const std::size_t most : {std::size_t{1}, std::size_t{20}, std::size_t{2000}}) {
      INFO(size << " to " << most);
      const VectorSet all = random_set(rng, size);
      const VectorSet lower = lower_vectors(all, most);
      CHECK(lower.size() <= most);
      for (std::size_t i = 0; i < all.size(); ++i) CHECK(bounded_by(lower, all[i]));
      for (std::size_t i = 0; i < lower.size(); ++i)
        for (std::size_t j = 0; j < lower.size(); ++j)
          if (i != j && at_most(lower[i], lower[j])) CHECK_FALSE(at_most(lower[i], lower[j]));
      if (most < size) continue;
      // Nothing was merged: each is one of them.
      for (std::size_t i = 0; i < lower.size(); ++i) {
        bool given = false;
        for (std::size_t j = 0; j < all.size(); ++j)
          given = given || std::equal(lower[i].begin(), lower[i].end(), all[j].begin());
        CHECK(given);
      }
    }
  }
}

TEST_CASE("Sums of vectors bound every sum that is kept, and least is the least of each coordinate") {
  std::mt19937 rng(11);
  const VectorSet a = random_set(rng, 60);
  const VectorSet b = random_set(rng, 40);
  const auto keep = [](std::span<const double> sum) { return sum[0] + sum[3] < 17.0; };
  std::size_t kept = 0;
  for (const std::size_t most : {std::size_t{15}, std::size_t{5000}}) {
    const VectorSet sums = sum_of_vectors(a, b, most, keep);
    CHECK(sums.size() <= most);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        std::vector<double> sum;
        for (std::size_t d = 0; d < dimensions; ++d) sum.push_back(a[i][d] + b[j][d]);
        if (!keep(sum)) continue;
        ++kept;
        if (!bounded_by(sums, sum)) CHECK(bounded_by(sums, sum));
      }
    }
  }
  CHECK(kept > 200);
  const std::vector<double> least = a.least();
  for (std::size_t d = 0; d < dimensions; ++d) {
    double own = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) own = std::min(own, a[i][d]);
    CHECK(least[d] == own);
  }
}

TEST_CASE("What may follow is within what is left of the allowances and below a corner") {
  // Of the state's second component each unit takes 2 of the only allowance.
  RestVectors rest{{10.0}, {{0.0, 2.0}}, VectorSet(3)};
  for (const std::vector<double>& vector : {std::vector<double>{1.0, 8.0, 9.0}, {4.0, 3.0, 4.0}, {6.0, 1.0, 2.0}})
    rest.add.add(vector);
  const std::vector<Pair> corners{{7.0, 9.0}, {9.0, 5.0}};
  const auto reach = [&](double first, double second, double state) {
    return rest.reach(
        {first, second}, [state](std::size_t c) { return c == 1 ? state : 1000.0; }, corners);
  };
  CHECK(reach(0.0, 0.0, 0.5));        // the first vector: 9 of 9
  CHECK(reach(0.0, 2.0, 3.0));        // 4 of 4 left: the second, (4, 5)
  CHECK(reach(3.0, 6.0, 3.0));        // (7, 9) is a corner itself
  CHECK_FALSE(reach(3.1, 6.0, 3.0));  // the second is (7.1, 9): beyond (7, 9); the third (9.1, 7)
  CHECK(reach(3.0, 4.0, 3.5));        // 3 left: only the third, (9, 5)
  CHECK_FALSE(reach(3.0, 4.1, 3.5));
  CHECK_FALSE(reach(0.0, 0.0, 4.5));  // 1 left: nothing
  CHECK(rest.least(
            Weights{1.0, 1.0}, {0.0, 2.0}, [](std::size_t) { return 3.0; }, corners) == 9.0);
}

}  // namespace rest_vectors_test
