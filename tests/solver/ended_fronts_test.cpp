// SPDX-License-Identifier: Apache-2.0
//
// A front whose search was ended says to what tolerance it is covered all the same: no design of an exhaustive
// enumeration may be better than all of its builds by more.
#include <cmath>

#include "catch.h"
#include "sanitized.h"
#include "solver/enumeration.h"

namespace ended_fronts_test {

namespace {

using namespace zoo;

/// Whether some build is no worse than a design that is taken to be worse by a part of each of its builds' totals.
bool is_covered(const Total& design, const std::vector<Build>& builds, double part) {
  const double left = 1.0 - part;
  return std::ranges::any_of(builds, [&](const Build& build) {
    return left * build.resources[0] <= design.cost * (1.0 + 1e-9) &&
           left * build.resources[1] <= design.mass * (1.0 + 1e-9);
  });
}

}  // namespace

TEST_CASE("A front ended after any number of nodes is covered to the tolerance that it states") {
  const unsigned seeds = millwright::sanitized ? 40 : 400;
  unsigned ended = 0, stated = 0, covered = 0, closer = 0, wider_than_asked = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Stack stack = random_stack(seed);
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-6) continue;
    const auto check = [&](const Summary& front) {
      REQUIRE(!front.builds.empty());
      for (const Total& design : all.front()) REQUIRE(is_covered(design, front.builds, front.front_tolerance));
    };
    for (const std::uint64_t most_nodes : {1U, 10U, 25U, 60U, 150U, 400U, 1000U}) {
      CAPTURE(seed, most_nodes, stack.priced, stack.monotone);
      Options options;
      options.objectives = {0, 1};
      options.confirm = false;
      options.front_tolerance = seed % 3 == 0 ? 0.05 : 1e-3;
      options.stagewise = seed % 4 == 0;
      options.labels_together = seed % 5 == 0 ? 1 : 4;
      options.most_nodes = most_nodes;
      const Summary front = solve(stack.problem, options);
      if (front.status != Status::limit) {
        REQUIRE((front.status == Status::optimal) == !all.designs.empty());
        break;
      }
      ++ended;
      if (!std::isfinite(front.front_tolerance)) continue;
      ++stated;
      check(front);
      // As many nodes again, from the builds known.
      const Summary widened = cover_front(stack.problem, options, front.builds);
      REQUIRE(widened.status != Status::infeasible);
      if (!std::isfinite(widened.front_tolerance)) continue;
      ++covered;
      check(widened);
      closer += widened.front_tolerance < front.front_tolerance ? 1 : 0;
      wider_than_asked += widened.front_tolerance > 1.001 * options.front_tolerance ? 1 : 0;
      if (stack.priced)
        REQUIRE((widened.status == Status::optimal) == (widened.front_tolerance == options.front_tolerance));
    }
  }
  if (millwright::sanitized) return;
  CHECK(stated >= ended / 4);
  CHECK(covered >= stated / 2);
  CHECK(closer >= covered / 3);
  CHECK(wider_than_asked >= covered / 4);
}

}  // namespace ended_fronts_test
