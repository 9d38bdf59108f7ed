// SPDX-License-Identifier: Apache-2.0
//
// Limits with a price (limit_prices.cpp), against exhaustive enumeration (enumeration.h): of random stacks in which a
// free diameter moves cost and mass, the cheapest that is not heavier than a limit which the cheapest of all exceeds,
// and the lightest that is not dearer.
#include <algorithm>
#include <cmath>
#include <string>

#include "catch.h"
#include "sanitized.h"
#include "solver/criteria.h"
#include "solver/enumeration.h"

namespace limit_prices_test {

namespace {

using namespace zoo;

constexpr double gap = 1e-7;

double of(const Total& total, std::size_t resource) { return resource == 0 ? total.cost : total.mass; }

/// The least of one total among designs that keep a limit on the other.
double least_within(const Everything& all, std::size_t objective, double limit) {
  double least = std::numeric_limits<double>::infinity();
  for (const Total& total : all.designs)
    if (of(total, 1 - objective) <= limit) least = std::min(least, of(total, objective));
  return least;
}

/// A limit on the other total between two builds of the front, of which neither is the best in the objective; none
/// where some design is so near that bisection to 1e-9 decides nothing.
double limit_between(const Everything& all, std::size_t objective, std::mt19937& rng) {
  std::vector<double> others;
  for (const Total& total : all.front()) others.push_back(of(total, 1 - objective));
  std::sort(others.begin(), others.end());
  if (others.size() < 3) return 0.0;
  const std::size_t place = rng() % (others.size() - 1);
  const double limit = others[place] + uniform(rng, 0.01, 0.99) * (others[place + 1] - others[place]);
  const bool near = std::ranges::any_of(
      all.designs, [&](const Total& total) { return std::fabs(of(total, 1 - objective) - limit) < 1e-6 * limit; });
  return near ? 0.0 : limit;
}

/// Nothing is looked at before limits get their prices.
Options options_for(std::size_t objective) {
  Options options;
  options.objectives = {objective};
  options.ties = {1 - objective};
  options.gap = gap;
  options.patience = 0;
  options.confirm = false;
  return options;
}

bool names_prices(const Summary& summary) {
  return summary.method.find("what is limited at prices") != std::string::npos;
}

/// Of a search that has ended early: what it says is true all the same.
void check_ended(const Problem& problem, Options options, double least, std::uint64_t nodes) {
  options.most_nodes = nodes;
  const Summary ended = solve(problem, options);
  REQUIRE(ended.lower_bound <= least * (1.0 + 1e-12));
  if (!ended.builds.empty()) REQUIRE(ended.builds[0].resources[options.objectives[0]] >= least * (1.0 - 1e-9));
}

TEST_CASE("With a price on a limit the best build within it is that of all builds") {
  const unsigned wanted = millwright::sanitized ? 3 : 50;
  unsigned tested = 0, with_prices = 0, reports = 0;
  for (unsigned seed = 1; tested < wanted; ++seed) {
    Stack stack = random_stack(seed);
    if (!stack.priced) continue;
    stack.problem.resources[1].limit = infinity;
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9 || all.designs.empty()) continue;
    std::mt19937 rng(seed);
    for (const std::size_t objective : {std::size_t{0}, std::size_t{1}}) {
      const double limit = limit_between(all, objective, rng);
      if (limit == 0.0) continue;
      CAPTURE(seed, objective, limit);
      Problem problem = stack.problem;
      problem.resources[1 - objective].limit = limit;
      const double least = least_within(all, objective, limit);
      ++tested;
      for (const unsigned threads : {1U, 2U}) {
        Options options = options_for(objective);
        options.threads = threads;
        options.progress_interval_seconds = 0.0;
        double bound = -infinity, best = infinity;
        options.progress = [&](const Progress& progress) {
          REQUIRE(progress.lower_bound >= bound);
          REQUIRE(progress.lower_bound <= least * (1.0 + gap));
          REQUIRE(rounded(progress.incumbent) <= rounded(best));
          REQUIRE(progress.incumbent >= least * (1.0 - 1e-9));
          bound = progress.lower_bound;
          best = progress.incumbent;
          ++reports;
        };
        const Summary found = solve(problem, options);
        REQUIRE(found.status == Status::optimal);
        REQUIRE(found.builds[0].resources[objective] <= least * (1.0 + 2.0 * gap));
        REQUIRE(found.builds[0].resources[objective] >= least * (1.0 - 1e-9));
        REQUIRE(found.builds[0].resources[1 - objective] <= limit * (1.0 + 1e-12));
        REQUIRE(found.lower_bound <= least * (1.0 + 1e-12));
        if (threads > 1) continue;
        with_prices += names_prices(found) ? 1 : 0;
        options.progress = nullptr;
        options.price_limits = false;
        const Summary without = solve(problem, options);
        REQUIRE(without.status == Status::optimal);
        REQUIRE(without.builds[0].resources[objective] == Approx(least).epsilon(2.0 * gap));
        REQUIRE_FALSE(names_prices(without));
      }
      for (const std::uint64_t nodes : {std::uint64_t{5}, std::uint64_t{50}})
        check_ended(problem, options_for(objective), least, nodes);
    }
  }
  CHECK(reports > 10 * tested);
  if (!millwright::sanitized) CHECK(with_prices >= wanted / 2);
}

TEST_CASE("A limit that nothing keeps, and one that is in nobody's way, change nothing") {
  unsigned tested = 0;
  for (unsigned seed = 1; tested < (millwright::sanitized ? 2U : 10U); ++seed) {
    Stack stack = random_stack(seed);
    if (!stack.priced) continue;
    stack.problem.resources[1].limit = infinity;
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9 || all.designs.empty()) continue;
    ++tested;
    CAPTURE(seed);
    Problem problem = stack.problem;
    problem.resources[0].limit = 0.99 * all.least(&Total::cost);
    CHECK(solve(problem, options_for(1)).status == Status::infeasible);
    problem.resources[0].limit = 1e6;
    const Summary free = solve(problem, options_for(1));
    REQUIRE(free.status == Status::optimal);
    CHECK(free.builds[0].resources[1] <= all.least(&Total::mass) * (1.0 + 2.0 * gap));
    CHECK_FALSE(names_prices(free));
  }
}

TEST_CASE("What prices say of an objective is true of all that keeps the limit") {
  // By hand: a limit of 5 takes 1 * 5 off the least sum at price 1, and 4 * 5 off that at price 4.
  Criteria criteria;
  criteria.weight = {{1.0, 0.0}, {0.0, 1.0}};
  criteria.limit = {infinity, 5.0};
  const std::vector<double> prices{1.0, 4.0};
  add_limit_prices(criteria, 1, prices);
  REQUIRE(criteria.size() == 4);
  std::vector<double> total{2.0, 3.0, 13.0, 30.0};
  criteria.raise(total);
  CHECK(total[0] == Approx(10.0).epsilon(1e-9));
  CHECK(total[0] <= 10.0);
  // Sums of designs that keep the limit, up to it, say no more than the objective itself.
  std::mt19937 rng(7);
  for (int i = 0; i < 10000; ++i) {
    const double objective = uniform(rng, 0.0, 100.0);
    const double other = i % 2 == 0 ? 5.0 : uniform(rng, 0.0, 5.0);
    std::vector<double> scores(4);
    criteria.scores<double>(std::vector<double>{objective, other}, scores);
    criteria.raise(scores);
    REQUIRE(scores[0] == objective);
  }
}

}  // namespace

}  // namespace limit_prices_test
