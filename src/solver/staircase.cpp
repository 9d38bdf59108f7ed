// SPDX-License-Identifier: Apache-2.0
#include "solver/staircase.h"

#include <algorithm>

#include "solver/stage.h"

namespace millwright::solver {
namespace {

/// Merges neighbours until at most `most` are left; `lower`: into their common lower bound, else upper bound.
std::vector<Pair> coarsened(std::vector<Pair> points, std::size_t most, bool lower) {
  if (points.size() <= most) return points;
  std::vector<Pair> result;
  const std::size_t each = (points.size() + most - 1) / most;
  for (std::size_t i = 0; i < points.size(); i += each) {
    const Pair& left = points[i];
    const Pair& right = points[std::min(i + each, points.size()) - 1];
    result.push_back(lower ? Pair{left.first, right.second} : Pair{right.first, left.second});
  }
  return result;
}

}  // namespace

std::vector<Pair> lower_staircase(std::vector<Pair> points) {
  std::sort(points.begin(), points.end(), [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  std::vector<Pair> result;
  for (const Pair& point : points) {
    if (result.empty() || point.second < result.back().second) result.push_back(point);
  }
  return result;
}

std::vector<Pair> upper_staircase(std::vector<Pair> points) {
  std::sort(points.begin(), points.end(), [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first > b.first : a.second > b.second;
  });
  std::vector<Pair> result;
  for (const Pair& point : points) {
    if (result.empty() || point.second > result.back().second) result.push_back(point);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

std::vector<Pair> sum_of_staircases(const std::vector<Pair>& a, const std::vector<Pair>& b, std::size_t most) {
  std::vector<Pair> sums;
  sums.reserve(a.size() * b.size());
  for (const Pair& x : a) {
    for (const Pair& y : b) sums.push_back({x.first + y.first, x.second + y.second});
  }
  return coarsened(lower_staircase(std::move(sums)), most, true);
}

std::vector<Pair> difference_of_staircases(const std::vector<Pair>& upper,
                                           const std::vector<Pair>& lower,
                                           std::size_t most) {
  std::vector<Pair> differences;
  differences.reserve(upper.size() * lower.size());
  for (const Pair& x : upper) {
    for (const Pair& y : lower) differences.push_back({x.first - y.first, x.second - y.second});
  }
  return coarsened(upper_staircase(std::move(differences)), most, false);
}

bool below_staircase(const std::vector<Pair>& upper, double first, double second) {
  const auto at = std::lower_bound(
      upper.begin(), upper.end(), first, [](const Pair& point, double value) { return point.first < value; });
  return (at == upper.end() ? -infinity : at->second) >= second;
}

double least_within(const std::vector<Pair>& lower, double second) {
  const auto at =
      std::partition_point(lower.begin(), lower.end(), [second](const Pair& point) { return point.second > second; });
  return at == lower.end() ? infinity : at->first;
}

}  // namespace millwright::solver
