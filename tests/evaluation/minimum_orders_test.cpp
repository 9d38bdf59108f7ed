// SPDX-License-Identifier: Apache-2.0
// Shops with minimum orders up to and above all that a machine needs: then many builds cost the same, and the lightest
// of them is wanted. Against all builds, each ordered in every way there is.
#include <fmt/format.h>

#include <random>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/exhaustive.h"
#include "evaluation/market.h"
#include "evaluation/purchase.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace minimum_orders_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

/// Of three shops some, or all, have a minimum between nothing and more than any build costs.
Market market_with_minima(std::mt19937& random) {
  Market market = random_market(random, 0);
  constexpr double more_than_any_build = 500.0;
  for (Shop& shop : market.shops) {
    shop.minimum = 0.0;
    if (random() % 3 == 0) continue;
    const double share = static_cast<double>(random() % 1000) / 1000.0;
    shop.minimum = std::round(100.0 * more_than_any_build * share * share) / 100.0;
  }
  return market;
}

/// All that was tried, and a model of the same machine.
struct Machine {
  explicit Machine(unsigned seed, const std::vector<std::string>& without = {"ball_screws"})
      : random(seed),
        market(market_with_minima(random)),
        tiny({}, without),
        parts(written(market)),
        problem(two_axes(4.0 + 8.0 * (seed % 3))),
        model(problem, parts),
        plain(everything(problem), tiny.parts()),
        all(plain, saving(plain, market)) {}

  std::mt19937 random;
  Market market;
  TinyCatalogue tiny;
  TemporaryFolder overlay;
  catalogue::Catalogue parts;
  machine::Problem problem;
  MachineModel model, plain;
  Exhaustive all;

  [[nodiscard]] double lightest_that_costs(double most) const {
    double mass = std::numeric_limits<double>::infinity();
    for (const BuildValue& build : all.builds)
      if (build.cost <= most * (1.0 + 1e-9)) mass = std::min(mass, build.mass);
    return mass;
  }

 private:
  [[nodiscard]] catalogue::Catalogue written(const Market& shops) const {
    shops.write(overlay);
    return catalogue_of({tiny.path(), overlay.path()});
  }
  static machine::Problem everything(machine::Problem problem) {
    for (machine::Axis& axis : problem.axes) axis.keep_every_candidate = true;
    return problem;
  }
};

double topped_up(const Design& design) {
  double sum = 0.0;
  for (const evaluation::ShopOrder& order : design.orders) sum += order.top_up;
  return sum;
}

}  // namespace

TEST_CASE("With minimum orders the cheapest build, the lightest of those, and the front are those of all builds") {
  std::size_t compared = 0, filled = 0, tied = 0;
  for (unsigned seed = 0; seed < (sanitized ? 3 : 24); ++seed) {
    const Machine machine(1000 + seed);
    const Exhaustive& all = machine.all;
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    if (all.builds.empty()) continue;
    ++compared;
    const Synthesis cost = solved(machine.model, {"cost"});
    const Synthesis front = solved(machine.model, {"cost", "mass"});
    require_best_of(all, cost, front, [&](const Design& design) { require_sound(design, machine.market); });
    const Design& best = cost.designs[0];
    CHECK(best.mass == Approx(machine.lightest_that_costs(best.cost)).epsilon(1e-9));
    filled += topped_up(best) > 0.0;
    tied += std::count_if(all.builds.begin(), all.builds.end(), [&](const BuildValue& build) {
              return std::fabs(build.cost - best.cost) < 1e-9 * best.cost;
            }) > 1;
    if (sanitized) continue;
    require_same_costs(front, solved(machine.model, {"cost", "mass"}, 2));
  }
  CHECK(compared >= 2);
  CHECK(filled >= 1);
  CHECK(tied >= 1);
}

TEST_CASE("With minimum orders the lightest build within a budget, and a weighted sum, are those of all builds") {
  std::size_t compared = 0, filled = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 16); ++seed) {
    const Machine machine(2000 + seed);
    const Exhaustive& all = machine.all;
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    if (all.builds.empty()) continue;
    ++compared;
    machine::Problem limited = machine.problem;
    limited.limits[machine::Quantity::cost] = 1.02 * all.least(&BuildValue::cost);
    const Synthesis lightest = solved(MachineModel(limited, machine.parts), {"mass"});
    REQUIRE(lightest.designs.size() == 1);
    CHECK(lightest.status == solver::Status::optimal);
    CHECK(lightest.designs[0].mass ==
          Approx(machine.lightest_that_costs(*limited.limits[machine::Quantity::cost])).epsilon(2e-6));
    require_sound(lightest.designs[0], machine.market);
    filled += topped_up(lightest.designs[0]) > 0.0;

    limited.limits[machine::Quantity::cost] = 0.98 * all.least(&BuildValue::cost);
    const Synthesis none = solved(MachineModel(limited, machine.parts), {"mass"});
    CHECK(none.designs.empty());
    CHECK(none.status == solver::Status::infeasible);

    double least = std::numeric_limits<double>::infinity();
    for (const BuildValue& build : all.builds) least = std::min(least, build.cost + 20.0 * build.mass);
    const Synthesis sum = solved(machine.model, {"cost + 20*mass"});
    REQUIRE(sum.designs.size() == 1);
    CHECK(sum.status == solver::Status::optimal);
    CHECK(sum.designs[0].cost + 20.0 * sum.designs[0].mass == Approx(least).epsilon(2e-6));
  }
  CHECK(compared >= 2);
  if (!sanitized) CHECK(filled >= 1);
}

// By hand: everything is sold by one shop that ships for 3 USD and takes no order below 1000. That is what every build
// costs, and the lightest of all is the best.
TEST_CASE("Where every build costs the minimum order the lightest one is chosen") {
  const TinyCatalogue tiny;
  Market market;
  market.shops[0] = {"", 3.0, 1000.0};
  TemporaryFolder overlay;
  market.write(overlay);
  const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
  const MachineModel model(two_axes(4.0), offered);
  const Synthesis best = solved(model, {"cost"});
  const Synthesis front = solved(model, {"cost", "mass"});
  const Synthesis lightest = solved(MachineModel(two_axes(4.0), tiny.parts()), {"mass"});
  REQUIRE(best.designs.size() == 1);
  REQUIRE(front.designs.size() == 1);
  CHECK(best.status == solver::Status::optimal);
  CHECK(best.designs[0].cost == Approx(1003.0).epsilon(1e-12));
  CHECK(best.lower_bound == Approx(1003.0).epsilon(1e-9));
  CHECK(best.designs[0].mass == Approx(lightest.designs[0].mass).epsilon(1e-9));
  CHECK(front.designs[0].cost == Approx(1003.0).epsilon(1e-12));
  CHECK(front.designs[0].mass == Approx(lightest.designs[0].mass).epsilon(1e-9));
}

}  // namespace minimum_orders_test
