// SPDX-License-Identifier: Apache-2.0
//
// Staircases and archives against their definitions, by trying every point.
#include "solver/staircase.h"

#include <limits>
#include <map>
#include <random>
#include <set>

#include "catch.h"
#include "solver/archive.h"

namespace staircase_test {

namespace {

using namespace millwright::solver;

std::vector<Pair> some_points(std::mt19937& rng, std::size_t count) {
  std::vector<Pair> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({static_cast<double>(rng() % 12), static_cast<double>(rng() % 12)});
  }
  return points;
}

bool any_at_most(const std::vector<Pair>& points, double first, double second) {
  for (const Pair& p : points) {
    if (p.first <= first && p.second <= second) return true;
  }
  return false;
}

bool any_at_least(const std::vector<Pair>& points, double first, double second) {
  for (const Pair& p : points) {
    if (p.first >= first && p.second >= second) return true;
  }
  return false;
}

TEST_CASE("What is least within a limit is least among all points") {
  std::mt19937 rng(8);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Pair> points = some_points(rng, rng() % 15);
    const std::vector<Pair> lower = lower_staircase(points);
    for (int y = -1; y <= 13; ++y) {
      double least = std::numeric_limits<double>::infinity();
      for (const Pair& point : points)
        if (point.second <= y) least = std::min(least, point.first);
      REQUIRE(least_within(lower, y) == least);
    }
  }
}

TEST_CASE("A staircase bounds the same region as all its points") {
  std::mt19937 rng(7);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Pair> points = some_points(rng, rng() % 15);
    const std::vector<Pair> lower = lower_staircase(points);
    const std::vector<Pair> upper = upper_staircase(points);
    for (int x = -1; x <= 13; ++x) {
      for (int y = -1; y <= 13; ++y) {
        REQUIRE(any_at_most(lower, x, y) == any_at_most(points, x, y));
        REQUIRE((least_within(lower, y) <= x) == any_at_most(points, x, y));
        REQUIRE(below_staircase(upper, x, y) == any_at_least(points, x, y));
      }
    }
  }
}

TEST_CASE("Merged sums and differences of staircases stay bounds") {
  std::mt19937 rng(8);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Pair> a = some_points(rng, 1 + rng() % 8);
    const std::vector<Pair> b = some_points(rng, 1 + rng() % 8);
    std::vector<Pair> sums;
    std::vector<Pair> differences;
    for (const Pair& x : a) {
      for (const Pair& y : b) {
        sums.push_back({x.first + y.first, x.second + y.second});
        differences.push_back({x.first - y.first, x.second - y.second});
      }
    }
    for (const std::size_t most : {2U, 3U, 100U}) {
      const std::vector<Pair> sum = sum_of_staircases(lower_staircase(a), lower_staircase(b), most);
      const std::vector<Pair> difference = difference_of_staircases(upper_staircase(a), lower_staircase(b), most);
      REQUIRE(sum.size() <= most);
      for (int x = -13; x <= 26; ++x) {
        for (int y = -13; y <= 26; ++y) {
          const bool in_sum = any_at_most(sums, x, y);
          const bool in_difference = any_at_least(differences, x, y);
          const bool above = least_within(sum, y) <= x;
          const bool below = below_staircase(difference, x, y);
          REQUIRE((most == 100 ? above == in_sum : above || !in_sum));
          REQUIRE((most == 100 ? below == in_difference : below || !in_difference));
        }
      }
    }
  }
}

TEST_CASE("An archive answers as a search through all its members does") {
  std::mt19937 rng(9);
  for (int trial = 0; trial < 50; ++trial) {
    Archive archive(3);
    std::vector<std::vector<double>> members;
    for (int step = 0; step < 300; ++step) {
      std::vector<double> point(3);
      for (double& x : point) x = static_cast<double>(rng() % 20);
      bool expected = false;
      for (const auto& member : members) {
        expected = expected || (member[0] <= point[0] && member[1] <= point[1] && member[2] <= point[2]);
      }
      REQUIRE(archive.dominates(point) == expected);
      if (rng() % 3 != 0) continue;
      archive.add(point);
      members.push_back(point);
    }
    REQUIRE(archive.size() == members.size());
  }
}

TEST_CASE("An archive forgets what is removed, one by one or below a point, and nothing else") {
  std::mt19937 rng(10);
  const auto at_most = [](const std::vector<double>& a, const std::vector<double>& b) {
    return a[0] <= b[0] && a[1] <= b[1] && a[2] <= b[2];
  };
  for (int trial = 0; trial < 40; ++trial) {
    Archive archive(3);
    std::map<Archive::Name, std::vector<double>> members;
    constexpr double endless = std::numeric_limits<double>::infinity();
    const auto some_point = [&] {
      // Of few values, so that many members are equal in all coordinates; some are infinite.
      std::vector<double> point(3);
      for (double& x : point) x = rng() % 50 == 0 ? endless : static_cast<double>(rng() % (trial % 2 == 0 ? 4 : 40));
      return point;
    };
    for (Archive::Name name = 0; name < 600; ++name) {
      const std::vector<double> point = some_point();
      archive.add(point, name);
      members[name] = point;
      if (rng() % 4 == 0) {
        const auto victim = std::next(members.begin(), static_cast<std::ptrdiff_t>(rng() % members.size()));
        archive.remove(victim->second, victim->first);
        members.erase(victim);
      }
      if (rng() % 40 == 0) {
        const std::vector<double> bound = some_point();
        archive.remove_at_most(bound, [&](Archive::Name each) {
          REQUIRE(at_most(members.at(each), bound));
          return each % 2 == 0;
        });
        std::erase_if(members, [&](const auto& each) { return each.first % 2 == 0 && at_most(each.second, bound); });
      }
      REQUIRE(archive.size() == members.size());
      const std::vector<double> question = some_point();
      std::set<Archive::Name> found, expected;
      CHECK_FALSE(archive.any_at_most(question, [&](Archive::Name each) { return !found.insert(each).second; }));
      for (const auto& [each, member] : members)
        if (at_most(member, question)) expected.insert(each);
      REQUIRE(found == expected);
    }
  }
}

}  // namespace

}  // namespace staircase_test
