// SPDX-License-Identifier: Apache-2.0
//
// What the builds known settle, against every design on a grid: what is called hopeless must not be able to change the
// answer, and without guides and tolerance nothing else is.
#include "solver/incumbents.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "catch.h"
#include "sanitized.h"
#include "solver/front_corners.h"

namespace incumbents_test {

namespace {

using namespace millwright::solver;

constexpr unsigned side = 6;  // of the grid

void guide(Criteria& criteria) {
  add_guides(criteria, criteria.objectives == 2 ? std::vector{3.0, 2.0} : std::vector{3.0, 2.0, 5.0});
}

Criteria criteria_of(std::size_t objectives, bool guides) {
  Problem problem;
  for (const char* name : {"cost", "mass", "time", "play"}) problem.resources.push_back({name});
  Options options;
  options.objectives.clear();
  for (std::size_t k = 0; k < objectives; ++k) options.objectives.push_back(k);
  options.ties = {3};
  Criteria criteria = make_criteria(problem, options);
  if (guides) guide(criteria);
  return criteria;
}

/// A design: objectives and a tie score on the grid, and a utilisation.
struct Design {
  std::vector<double> resources;
  double utilisation = 0.0;
};

std::vector<double> scores_of(const Criteria& criteria, const std::vector<double>& resources) {
  std::vector<double> score(criteria.size());
  criteria.scores<double>(resources, score);
  return score;
}

RankedBuild build_of(const Criteria& criteria, const Design& design) {
  RankedBuild ranked;
  ranked.score = scores_of(criteria, design.resources);
  ranked.build.resources = design.resources;
  ranked.build.worst_utilisation = design.utilisation;
  return ranked;
}

class Game {
 public:
  Game(unsigned seed, std::size_t objectives, bool guides)
      : rng_(seed), objectives_(objectives), criteria_(criteria_of(objectives, guides)) {}

  /// 1, 2, ... `most`.
  double random_of(unsigned most) { return static_cast<double>(1 + rng_() % most); }

  /// `objectives_ < 3`: what is left of the grid is one value.
  Design random_design() {
    Design design;
    for (std::size_t r = 0; r < 4; ++r)
      design.resources.push_back(r < objectives_ ? random_of(side) : r == 3 ? random_of(2) : 1.0);
    design.utilisation = random_of(2) == 1.0 ? 0.5 : 0.9;
    return design;
  }

  /// Whether a design at or above a place on the grid, whose guides are at least so much, would change the answer.
  bool matters(const Incumbents& incumbents, const Design& least, const std::vector<double>& lower) const {
    const double third = objectives_ > 2 ? side : 1.0;
    for (double a = least.resources[0]; a <= side; ++a)
      for (double b = least.resources[1]; b <= side; ++b)
        for (double c = least.resources[2]; c <= third; ++c)
          for (double tie = least.resources[3]; tie <= 2.0; ++tie)
            for (const double utilisation : {0.5, 0.9}) {
              if (utilisation < least.utilisation) continue;
              const Design design{{a, b, c, tie}, utilisation};
              const std::vector<double> score = scores_of(criteria_, design.resources);
              bool allowed = true;
              for (std::size_t k = 0; k < score.size(); ++k) allowed = allowed && score[k] >= lower[k];
              if (!allowed) continue;
              Incumbents copy = incumbents;
              if (copy.offer(build_of(criteria_, design))) return true;
            }
    return false;
  }

  std::mt19937 rng_;
  std::size_t objectives_;
  Criteria criteria_;
};

}  // namespace

TEST_CASE("Corners of a front in three objectives: what is below none of them is at least some point") {
  const unsigned games = millwright::sanitized ? 20 : 200;
  for (unsigned seed = 1; seed <= games; ++seed) {
    std::mt19937 rng(seed);
    const unsigned long range = 3 + rng() % 12;
    const auto random_point = [&] {
      FrontCorners::Point point{};
      for (double& x : point) x = static_cast<double>(rng() % range) - 2.0;
      return point;
    };
    FrontCorners corners;
    std::vector<FrontCorners::Point> points;
    for (unsigned i = 0; i < 80; ++i) {
      points.push_back(random_point());
      corners.add(points.back());
      for (unsigned trial = 0; trial < 20; ++trial) {
        const FrontCorners::Point lower = random_point();
        const bool settled = std::ranges::any_of(points, [&](const FrontCorners::Point& known) {
          return known[0] <= lower[0] && known[1] <= lower[1] && known[2] <= lower[2];
        });
        REQUIRE(corners.above(lower, [](const auto&) { return true; }) == !settled);
      }
    }
    // None is needless, so there are not many: 2 n + 1 for n points that are not beaten and differ in everything.
    CHECK(corners.size() <= 2 * points.size() + 1);
    // A corner that is asked for by what it is, is among those that are larger.
    unsigned asked = 0;
    CHECK_FALSE(corners.above({-3.0, -3.0, -3.0}, [&](const FrontCorners::Point& corner) {
      ++asked;
      return corner[0] < -3.0;
    }));
    CHECK(asked == corners.size());
  }
}

TEST_CASE("What is called hopeless cannot change the answer, and without guides nothing else is") {
  const unsigned games = millwright::sanitized ? 6 : 60;
  for (const std::size_t objectives : {1U, 2U, 3U}) {
    for (const bool guides : {false, true}) {
      if (objectives == 1 && guides) continue;
      unsigned hopeless = 0, by_guides = 0;
      for (unsigned seed = 1; seed <= games; ++seed) {
        CAPTURE(objectives, guides, seed);
        Game game(seed, objectives, guides);
        Incumbents incumbents(game.criteria_);
        for (unsigned i = 0; i < 12; ++i) incumbents.offer(build_of(game.criteria_, game.random_design()));
        for (unsigned trial = 0; trial < 30; ++trial) {
          const Design least = game.random_design();
          std::vector<double> lower = scores_of(game.criteria_, least.resources);
          const bool alone = incumbents.hopeless(lower, least.utilisation);
          for (std::size_t k = lower.size() - game.criteria_.guides; k < lower.size(); ++k)
            lower[k] *= 0.9 + 0.1 * game.random_of(8);
          const bool said = incumbents.hopeless(lower, least.utilisation);
          const bool matters = game.matters(incumbents, least, lower);
          REQUIRE_FALSE((said && matters));
          if (!guides) REQUIRE(said == !matters);
          hopeless += said ? 1 : 0;
          by_guides += said && !alone ? 1 : 0;
        }
      }
      CHECK(hopeless > games);
      if (guides) CHECK(by_guides > games / 2);
    }
  }
}

TEST_CASE("Within a tolerance a build settles what it may be worse than by that") {
  const unsigned games = millwright::sanitized ? 20 : 200;
  constexpr double tolerance = 0.21;
  for (const std::size_t objectives : {2U, 3U}) {
    unsigned only_within = 0;
    for (unsigned seed = 1; seed <= games; ++seed) {
      CAPTURE(objectives, seed);
      Game game(seed, objectives, false);
      Incumbents incumbents(game.criteria_);
      const auto offer = [&] { incumbents.offer(build_of(game.criteria_, game.random_design())); };
      for (unsigned i = 0; i < 6; ++i) offer();
      incumbents.set_tolerance(tolerance);
      for (unsigned i = 0; i < 6; ++i) offer();
      for (unsigned trial = 0; trial < 40; ++trial) {
        const Design least = game.random_design();
        const std::vector<double> lower = scores_of(game.criteria_, least.resources);
        const auto settled_within = [&](double part) {
          return std::ranges::any_of(incumbents.builds(), [&](const RankedBuild& known) {
            bool as_good = true;
            for (std::size_t k = 0; k < objectives; ++k) as_good = as_good && known.score[k] * (1.0 - part) <= lower[k];
            return as_good;
          });
        };
        REQUIRE(incumbents.hopeless(lower, least.utilisation) == settled_within(tolerance));
        only_within += settled_within(tolerance) && !settled_within(0.0) ? 1 : 0;
      }
    }
    CHECK(only_within > games / 4);
  }
}

TEST_CASE("Guides that come after builds, with a tolerance: what they give up is within it of a build") {
  const unsigned games = millwright::sanitized ? 20 : 200;
  constexpr double tolerance = 0.21;
  unsigned by_guides = 0;
  for (unsigned seed = 1; seed <= games; ++seed) {
    CAPTURE(seed);
    Game game(seed, 3, false);
    Incumbents incumbents(game.criteria_);
    for (unsigned i = 0; i < 12; ++i) incumbents.offer(build_of(game.criteria_, game.random_design()));
    guide(game.criteria_);
    for (RankedBuild& known : incumbents.builds()) known.score = scores_of(game.criteria_, known.build.resources);
    incumbents.set_tolerance(tolerance);
    for (unsigned trial = 0; trial < 40; ++trial) {
      // A design, and lower bounds of it: of each objective less than it has, of its guides what it has.
      const Design design = game.random_design();
      std::vector<double> lower = scores_of(game.criteria_, design.resources);
      const bool settled = incumbents.hopeless(lower, 0.0);
      for (std::size_t k = 0; k < 3; ++k) lower[k] -= game.random_of(3) - 1.0;
      const bool said = incumbents.hopeless(lower, 0.0);
      if (said) CHECK(settled);
      std::vector<double> alone = lower;
      game.criteria_.lower_guides(alone);
      by_guides += said && !incumbents.hopeless(alone, 0.0) ? 1 : 0;
    }
  }
  CHECK(by_guides > games / 4);
}

TEST_CASE("A design without an end in one objective is settled by what is at least as good in all, and settles such") {
  const Criteria criteria = criteria_of(3, true);
  const auto endless = [&](double cost, double mass) {
    Design design{{cost, mass, std::numeric_limits<double>::infinity(), 1.0}, 0.5};
    return build_of(criteria, design);
  };
  Incumbents incumbents(criteria);
  CHECK_FALSE(incumbents.hopeless(endless(2.0, 2.0).score, 0.0));
  CHECK(incumbents.offer(endless(2.0, 2.0)));
  CHECK_FALSE(incumbents.hopeless(endless(1.0, 3.0).score, 0.0));
  CHECK(incumbents.offer(endless(1.0, 3.0)));
  const Design finite{{4.0, 4.0, 4.0, 1.0}, 0.5};
  CHECK_FALSE(incumbents.hopeless(build_of(criteria, finite).score, 0.0));
  CHECK(incumbents.offer(build_of(criteria, finite)));
  CHECK(incumbents.builds().size() == 3);
  CHECK(incumbents.hopeless(endless(5.0, 5.0).score, 0.0));
  CHECK_FALSE(incumbents.hopeless(endless(3.0, 1.0).score, 0.0));
  CHECK_FALSE(incumbents.offer(endless(3.0, 3.0)));
}

}  // namespace incumbents_test
