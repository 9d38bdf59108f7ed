// SPDX-License-Identifier: Apache-2.0
// What a search says on its way is true of the whole problem, not only of the part it is at. The optimum comes from
// exhaustive enumeration.
#include "catch.h"
#include "sanitized.h"
#include "solver/criteria.h"
#include "solver/enumeration.h"

namespace progress_test {

namespace {

using namespace zoo;

TEST_CASE("Bounds reported on the way rise, and never pass the optimum") {
  std::size_t reports = 0;
  std::size_t with_build = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 40 : 300); ++seed) {
    const Stack stack = random_stack(seed);
    const Everything everything = Enumeration(stack).run();
    if (everything.margin < 1e-9) continue;                 // feasibility itself hangs on rounding
    const double optimum = everything.least(&Total::cost);  // infinite where nothing is feasible
    for (const bool stagewise : {true, false}) {
      Options options;
      options.confirm = false;
      options.stagewise = stagewise;
      options.patience = seed % 2 == 0 ? 12000 : 0;
      options.progress_interval_seconds = 0.0;
      double bound = -std::numeric_limits<double>::infinity();
      double best = std::numeric_limits<double>::infinity();
      options.progress = [&](const Progress& progress) {
        INFO("seed " << seed << (stagewise ? ", stage by stage" : ""));
        REQUIRE(std::isfinite(progress.lower_bound));
        REQUIRE(progress.lower_bound <= optimum * (1.0 + options.gap));
        REQUIRE(progress.lower_bound >= bound);
        REQUIRE(rounded(progress.incumbent) <= rounded(best));  // among equals another may be kept
        REQUIRE(progress.incumbent >= optimum * (1.0 - options.gap));
        bound = progress.lower_bound;
        best = progress.incumbent;
        ++reports;
        with_build += std::isfinite(best) ? 1 : 0;
      };
      (void)solve(stack.problem, options);
    }
  }
  CHECK(reports > 100);
  CHECK(with_build > 20);
}

}  // namespace

}  // namespace progress_test
