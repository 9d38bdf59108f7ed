// SPDX-License-Identifier: Apache-2.0
// Machines whose parts several shops sell, each with its shipping and its minimum: the best builds against all builds,
// each ordered in every way there is.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <map>
#include <random>
#include <thread>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/cheapest_order.h"
#include "evaluation/design_bill.h"
#include "evaluation/exhaustive.h"
#include "evaluation/market.h"
#include "evaluation/purchase.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace shops_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

std::size_t shops_used(const Design& design) {
  return static_cast<std::size_t>(std::count_if(
      design.orders.begin(), design.orders.end(), [](const auto& order) { return !order.supplier.empty(); }));
}

}  // namespace

TEST_CASE("With several shops the cheapest build and the front equal those of all builds and orders") {
  std::size_t compared = 0, topped_up = 0;
  std::map<std::size_t, std::size_t> used;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 12); ++seed) {
    std::mt19937 random(seed);
    const Market market = random_market(random, seed);
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    const machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, market));
    const MachineModel model(problem, offered);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis front = solved(model, {"cost", "mass"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    require_best_of(all, cost, front, [&](const Design& design) { require_sound(design, market); });
    ++used[shops_used(cost.designs[0])];
    for (const Design& design : front.designs)
      for (const evaluation::ShopOrder& order : design.orders) topped_up += order.top_up > 0.0;
    if (sanitized) continue;
    require_same_costs(front, solved(model, {"cost", "mass"}, 2));
  }
  CHECK(compared >= 2);
  if (sanitized) return;
  // No shop, one, and both pay somewhere, and so does an order that has to be filled up.
  CHECK(used[0] > 0);
  CHECK(used[1] > 0);
  CHECK(used[2] > 0);
  CHECK(topped_up > 0);
}

// Every build of the front is the cheapest order of its parts (above), so that is what its bill costs, whatever fails.
TEST_CASE("A bill costs what its parts are ordered for at least, whatever check it fails") {
  std::size_t bills = 0, ordered = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 12); ++seed) {
    std::mt19937 random(seed);
    const Market market = random_market(random, seed);
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    const machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    for (const Design& design : solved(MachineModel(problem, offered), {"cost", "mass"}).designs) {
      CAPTURE(seed, design.cost, design.mass);
      if (!(design.cost > 1.0)) continue;  // all of it is owned
      machine::Problem dearer = problem, hotter = problem;
      dearer.limits[machine::Quantity::cost] = 0.7 * design.cost;
      for (machine::Axis& axis : hotter.axes) axis.require.set(machine::Requirement::inertia_ratio, 1e-3);
      const auto over = evaluation::check(dearer, offered, evaluation::bill_of(design), false, {});
      REQUIRE(over.problems.empty());
      CHECK(over.completion == evaluation::Completion::refuted);
      CHECK(over.design.cost == Approx(design.cost).epsilon(1e-9));
      const auto spent = std::ranges::find(over.design.checks, "C-SYS-COST", &evaluation::Check::id);
      REQUIRE(spent != over.design.checks.end());
      CHECK(spent->verdict == evaluation::Verdict::violated);
      CHECK(spent->utilisation == Approx(1.0 / 0.7).epsilon(1e-9));
      const auto failing = evaluation::check(hotter, offered, evaluation::bill_of(design), false, {});
      CHECK(failing.completion == evaluation::Completion::refuted);
      CHECK(failing.design.cost == Approx(design.cost).epsilon(1e-9));
      ++bills;
      ordered += shops_used(over.design) > 0;
    }
  }
  CHECK(bills >= 2);
  CHECK(ordered > 0);
}

// The cheapest order keeps the budget, whichever of the parts' sellers would rather be taken.
TEST_CASE("A failing bill with preferred parts keeps a budget that its parts can be had for") {
  std::size_t bills = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 12); ++seed) {
    std::mt19937 random(300 + seed);
    Market market = random_market(random, seed);
    for (const char* part : {"M23", "M23L", "D4", "K8", "K12", "F10"})
      if (random() % 2 == 0) market.preferred[part] = 1.5;
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    const Synthesis cheapest = solved(MachineModel(problem, offered), {"cost"});
    if (market.preferred.empty() || cheapest.designs.empty() || !(cheapest.designs[0].cost > 1.0)) continue;
    CAPTURE(seed, cheapest.designs[0].cost);
    problem.preference = 1.5;
    problem.limits[machine::Quantity::cost] = cheapest.designs[0].cost * (1.0 + 1e-9);
    for (machine::Axis& axis : problem.axes) axis.require.set(machine::Requirement::inertia_ratio, 1e-3);
    const auto failing = evaluation::check(problem, offered, evaluation::bill_of(cheapest.designs[0]), false, {});
    REQUIRE(failing.problems.empty());
    CHECK(failing.completion == evaluation::Completion::refuted);
    CHECK(failing.design.cost == Approx(cheapest.designs[0].cost).epsilon(1e-9));
    ++bills;
  }
  CHECK(bills > 0);
}

TEST_CASE("With several shops and preferred parts the best build is that of all builds and orders") {
  std::size_t compared = 0, dearer = 0, ordered = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 12); ++seed) {
    std::mt19937 random(300 + seed);
    Market market = random_market(random, seed);
    constexpr double premiums[] = {0.0, 0.5, 1.5};
    const double premium = premiums[seed % 3];
    for (const char* part : {"M23", "M23L", "D4", "K8", "K12", "F10"})
      if (random() % 2 == 0) market.preferred[part] = premium;
    if (market.preferred.empty()) continue;
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    problem.preference = premium;
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, market));
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis best = solved(MachineModel(problem, offered), {"cost"});
    REQUIRE(best.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    const Design& design = best.designs[0];
    require_sound(design, market);
    REQUIRE(design.preference);
    CHECK(design.preference->compared_cost == Approx(all.least(&BuildValue::cost)).epsilon(3e-6));
    problem.preference.reset();
    dearer += design.cost > solved(MachineModel(problem, offered), {"cost"}).designs[0].cost + 1e-6;
    ordered += shops_used(design) > 0;
  }
  CHECK(compared >= 2);
  if (sanitized) return;
  CHECK(dearer > 0);
  CHECK(ordered > 0);
}

/// Two axes whose parts several shops sell.
struct Offered {
  Offered(std::mt19937& random, unsigned seed, const std::vector<std::string>& without)
      : market(random_market(random, seed)),
        tiny({}, without),
        parts(catalogue_with(market)),
        model(two_axes(4.0 + 8.0 * (seed % 3)), parts) {}

  Market market;
  TinyCatalogue tiny;
  TemporaryFolder overlay;
  catalogue::Catalogue parts;
  MachineModel model;

 private:
  [[nodiscard]] catalogue::Catalogue catalogue_with(const Market& shops) const {
    shops.write(overlay);
    return catalogue_of({tiny.path(), overlay.path()});
  }
};

/// The same parts, each from anyone who sells it.
solver::Build ordered_anywhere(const MachineModel& model, solver::Build build, std::mt19937& random) {
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < build.stages[stage].rows.size(); ++slot) {
      solver::Row& chosen = build.stages[stage].rows[slot];
      const auto parts_of = [&](solver::Row row) {
        return evaluation::parts_name(model.catalogue(), model.candidate(stage, slot, row));
      };
      std::vector<solver::Row> alike;
      for (solver::Row row = 0; row < model.problem().stages[stage]->slots()[slot].rows; ++row)
        if (parts_of(row) == parts_of(chosen)) alike.push_back(row);
      chosen = alike[random() % alike.size()];
    }
  model.set_suppliers(build);
  build.resources[model.resource(machine::Quantity::cost)] = model.design(build).cost;
  return build;
}

/// What the parts of a build cost at least, of all orders.
double least_price(const MachineModel& model, const Market& market, const solver::Build& build) {
  std::vector<Piece> pieces;
  double others = 0.0;
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < build.stages[stage].rows.size(); ++slot)
      for (const evaluation::PartUse& use : model.candidate(stage, slot, build.stages[stage].rows[slot]).parts) {
        const std::string part(model.catalogue().table(use.family).part_number(use.row));
        if (market.offers.contains(part) || market.owned.contains(part))
          pieces.emplace_back(part, usual_prices.at(part));
        else
          others += use.price;
      }
  pieces.emplace_back("", others);
  return Cheapest(market, pieces).price;
}

// A set of suppliers may be open of which nothing is bought: then the build found costs less than the search counted.
TEST_CASE("A search that is ended says how far its build is above its bound, as it is bought") {
  const TinyCatalogue tiny;
  Market market;
  market.shops = {{"", 1.0, 300.0}, {"Shop A", 9.0, 90.0}, {"Shop B", 7.0, 80.0}};
  market.offers["M17"] = {{1, 5.0}, {2, 6.0}};
  market.offers["K8"] = {{1, 1.0}, {2, 1.5}};
  TemporaryFolder overlay;
  market.write(overlay);
  const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
  const MachineModel model(two_axes(4.0), offered);
  for (const double seconds : {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
    evaluation::SearchOptions options;
    options.time_limit_seconds = seconds;
    const Synthesis found = evaluation::synthesise(model, options);
    if (found.designs.empty()) continue;
    require_sound(found.designs[0], market);
    const double cost = found.designs[0].cost;
    CAPTURE(seconds, found.lower_bound);
    CHECK(found.lower_bound <= cost * (1.0 + 1e-9));
    CHECK(found.gap == Approx((cost - found.lower_bound) / cost).margin(1e-6));
  }
}

// Found by trying: where such a search had come to was up to a tenth dearer than its parts need be.
TEST_CASE("The build of a search that is stopped is ordered where its parts cost least") {
  for (const unsigned seed : {0U, 5U, 7U, 10U}) {
    std::mt19937 random(900 + seed);
    const Offered machine(random, seed, {});
    const MachineModel& model = machine.model;
    for (const int milliseconds : {2, 5, 10, 20, 50, 100}) {
      std::atomic<bool> stop{false};
      const std::jthread timer([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        stop = true;
      });
      evaluation::SearchOptions options;
      options.stop = &stop;
      const Synthesis found = evaluation::synthesise(model, options);
      if (found.designs.empty()) continue;
      CAPTURE(seed, milliseconds);
      require_sound(found.designs[0], machine.market);
      CHECK(found.designs[0].cost == Approx(least_price(model, machine.market, found.builds[0])).epsilon(2e-6));
      CHECK(found.lower_bound <= found.designs[0].cost * (1.0 + 1e-9));
    }
  }
}

solver::Build ordered_cheapest(const MachineModel& model, const solver::Build& build, double seconds) {
  std::vector<solver::Build> builds{build};
  evaluation::order_cheapest(model, {}, builds, seconds);
  REQUIRE(builds.size() == 1);
  return builds[0];
}

TEST_CASE("Parts that were ordered anywhere are ordered where they cost least, and nothing else is changed") {
  std::size_t compared = 0, cheaper = 0;
  for (unsigned seed = 0; seed < (sanitized ? 3 : 12); ++seed) {
    std::mt19937 random(500 + seed);
    const Offered machine(random, seed, {"ball_screws"});
    const MachineModel& model = machine.model;
    for (const solver::Build& build : solved(model, {"cost", "mass"}).builds) {
      const solver::Build anywhere = ordered_anywhere(model, build, random);
      const solver::Build best = ordered_cheapest(model, anywhere, 1e3);
      const Design design = model.design(best);
      ++compared;
      CAPTURE(seed, compared);
      require_sound(design, machine.market);
      const double price = least_price(model, machine.market, anywhere);
      CHECK(design.cost == Approx(price).epsilon(1e-9));
      CHECK(best.resources[model.resource(machine::Quantity::cost)] == Approx(price).epsilon(1e-9));
      cheaper += design.cost < model.design(anywhere).cost - 1e-6;
      CHECK(best.shared[0] == anywhere.shared[0]);
      for (std::size_t stage = 0; stage < best.stages.size(); ++stage) {
        CHECK(best.stages[stage].variables == anywhere.stages[stage].variables);
        for (std::size_t slot = 0; slot < best.stages[stage].rows.size(); ++slot) {
          const auto parts_of = [&](const solver::Build& each) {
            return evaluation::parts_name(model.catalogue(),
                                          model.candidate(stage, slot, each.stages[stage].rows[slot]));
          };
          CHECK(parts_of(best) == parts_of(anywhere));
        }
      }
      const solver::Build unasked = ordered_cheapest(model, anywhere, 0.0);
      CHECK(unasked.shared == anywhere.shared);
      for (std::size_t stage = 0; stage < best.stages.size(); ++stage)
        CHECK(unasked.stages[stage].rows == anywhere.stages[stage].rows);
    }
  }
  CHECK(compared >= 3);
  CHECK(cheaper >= 2);
}

TEST_CASE("Builds of a front that another one beats, once both are ordered cheaply, are left out") {
  std::size_t compared = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 6); ++seed) {
    std::mt19937 random(700 + seed);
    const Offered machine(random, seed, {"ball_screws"});
    const MachineModel& model = machine.model;
    evaluation::SearchOptions front;
    front.objectives = {"cost", "mass"};
    const std::vector<solver::Build> exact = solved(model, front.objectives).builds;
    std::vector<solver::Build> builds;
    for (const solver::Build& build : exact)
      for (int i = 0; i < 2; ++i) builds.push_back(ordered_anywhere(model, build, random));
    std::shuffle(builds.begin(), builds.end(), random);
    evaluation::order_cheapest(model, front, builds, 1e3);
    // All of the front has come back, each once, at its price.
    REQUIRE(builds.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i)
      for (const std::size_t k : {model.resource(machine::Quantity::cost), model.resource(machine::Quantity::mass)})
        CHECK(builds[i].resources[k] == Approx(exact[i].resources[k]).epsilon(1e-9));
    compared += builds.size();
  }
  CHECK(compared >= (sanitized ? 2 : 4));
}

// Two motors M17 (9 USD) and two drivers D2 (6 USD): 30 USD. Shop A asks 5 for shipping and has the motors for 7, Shop
// B asks 5 and has the drivers for 4: each alone saves 4 of what its shipping costs 5. With both at Shop A they save 8.
TEST_CASE("A second shop is ordered from only if it saves more than its shipping") {
  const TinyCatalogue tiny;
  const auto cost_with = [&](const char* drivers_from) {
    Market market;
    market.shops.push_back({"Shop A", 5.0, 0.0});
    market.shops.push_back({"Shop B", 5.0, 0.0});
    market.offers["M17"][1] = 7.0;
    market.offers["D2"][drivers_from == std::string("Shop A") ? 1 : 2] = 4.0;
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    const Synthesis found = solved(MachineModel(two_axes(1.0), offered), {"cost"});
    REQUIRE(found.designs.size() == 1);
    require_sound(found.designs[0], market);
    return std::pair(found.designs[0].cost, shops_used(found.designs[0]));
  };
  const Synthesis plain = solved(MachineModel(two_axes(1.0), tiny.parts()), {"cost"});
  REQUIRE(plain.designs.size() == 1);
  const auto apart = cost_with("Shop B");
  CHECK(apart.second == 0);
  CHECK(apart.first == Approx(plain.designs[0].cost));
  const auto together = cost_with("Shop A");
  CHECK(together.second == 1);
  CHECK(together.first == Approx(plain.designs[0].cost - 3.0));
}

}  // namespace shops_test
