// SPDX-License-Identifier: Apache-2.0
// The next best builds of machines whose parts several shops sell: which orders make another build, and that none that
// does is left out.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "catch.h"
#include "evaluation/exhaustive.h"
#include "evaluation/market.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace shop_alternatives_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

/// So many best builds of the two axes.
Synthesis next_best(const catalogue::Catalogue& offered, std::size_t builds) {
  evaluation::ModelOptions every;
  every.every_candidate = true;
  evaluation::SearchOptions options;
  options.builds = builds;
  return evaluation::synthesise(MachineModel(two_axes(1.0), offered, {}, every), options);
}

/// What every order of a build's parts costs that is worth a look, one for each choice of what is bought where.
class EveryOrder {
 public:
  /// `pieces` of each part; `others`: what is paid for what only the first shop sells.
  EveryOrder(const Market& market, const std::map<std::string, int>& pieces, double others)
      : market_(market), spent_(market.shops.size(), 0.0), used_(spent_.size(), false) {
    spent_[0] = others;
    used_[0] = others > 0.0;
    for (const auto& [part, count] : pieces) {
      const auto there = market.owned.find(part);
      const int owned = there == market.owned.end() ? 0 : std::min(count, there->second);
      Part& bought = parts_.emplace_back(Part{part, count - owned, there != market.owned.end(), {}});
      bought.of_shop.assign(spent_.size(), 0);
    }
    share_out(0, 0, parts_.empty() ? 0 : parts_[0].bought);
  }
  std::vector<double> costs;

 private:
  struct Part {
    std::string name;
    int bought = 0;
    bool in_stock = false;     ///< then any seller will do; otherwise the cheapest of those that are ordered from
    std::vector<int> of_shop;  ///< pieces
  };

  /// Whether this shop sells the part.
  [[nodiscard]] bool sells(std::size_t shop, const std::string& part) const {
    return market_.prices(part).count(shop) > 0;
  }

  void share_out(std::size_t at, std::size_t shop, int left) {
    if (at == parts_.size()) return add_up();
    Part& part = parts_[at];
    if (shop + 1 == spent_.size()) {
      if (left > 0 && !sells(shop, part.name)) return;
      part.of_shop[shop] = left;
      share_out(at + 1, 0, at + 1 < parts_.size() ? parts_[at + 1].bought : 0);
      return;
    }
    for (int here = 0; here <= (sells(shop, part.name) ? left : 0); ++here) {
      part.of_shop[shop] = here;
      share_out(at, shop + 1, left - here);
    }
  }

  void add_up() {
    std::vector<double> spent = spent_;
    std::vector<bool> used = used_;
    for (const Part& part : parts_)
      for (std::size_t shop = 0; shop < spent.size(); ++shop) {
        if (part.of_shop[shop] == 0) continue;
        spent[shop] += part.of_shop[shop] * market_.prices(part.name).at(shop);
        used[shop] = true;
      }
    for (const Part& part : parts_)
      for (std::size_t shop = 0; shop < spent.size(); ++shop)
        if (part.of_shop[shop] > 0 && is_beaten(part, shop, used)) return;
    double cost = 0.0;
    for (std::size_t shop = 0; shop < spent.size(); ++shop)
      if (used[shop])
        cost += market_.shops[shop].fee + spent[shop] + std::max(0.0, market_.shops[shop].minimum - spent[shop]);
    costs.push_back(cost);
  }

  /// Another shop that is ordered from has it for less, and this one has no minimum that it would help to reach.
  [[nodiscard]] bool is_beaten(const Part& part, std::size_t shop, const std::vector<bool>& used) const {
    if (part.in_stock || market_.shops[shop].minimum > 0.0) return false;
    const std::map<std::size_t, double> prices = market_.prices(part.name);
    for (const auto& [other, price] : prices)
      if (used[other] && price < prices.at(shop)) return true;
    return false;
  }

  const Market& market_;
  std::vector<double> spent_;
  std::vector<bool> used_;
  std::vector<Part> parts_;
};

}  // namespace

// The best builds of a machine with a shop: none stands there twice for a shop that nothing is bought from.
TEST_CASE("The next best builds differ in their parts or in who sells them") {
  const TinyCatalogue tiny({}, {"ball_screws"});
  Market market;
  market.shops.push_back({"Shop A", 1.0, 0.0});
  market.shops.push_back({"Shop B", 2.0, 10.0});
  market.offers["M17"] = {{1, 8.0}, {2, 7.0}};
  market.offers["K8"] = {{1, 1.0}};
  TemporaryFolder overlay;
  market.write(overlay);
  const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
  const Synthesis found = next_best(offered, 6);
  REQUIRE(found.designs.size() == 6);
  std::set<std::vector<std::string>> seen;
  double last = 0.0;
  for (const Design& design : found.designs) {
    require_sound(design, market);
    CHECK(design.cost >= last);
    last = design.cost;
    std::vector<std::string> names;
    for (const evaluation::PartLine& part : design.parts)
      names.push_back(part.axis + part.slot + part.part_number + " " + part.supplier);
    names.push_back(fmt::format("{}", design.supply_voltage));
    CHECK(seen.insert(names).second);
  }
  CHECK(found.designs[0].cost == Approx(solved(MachineModel(two_axes(1.0), offered), {"cost"}).designs[0].cost));
}

// Every build, every way to order it.
TEST_CASE("The next best builds of a machine with shops are the first of all builds and orders") {
  std::size_t compared = 0, with_stock = 0, with_minimum = 0;
  for (unsigned seed = 0; seed < (sanitized ? 1 : 8); ++seed) {
    std::mt19937 random(700 + seed);
    const Market market = random_market(random, seed);
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    problem.supply_voltages = {24.0};
    evaluation::ModelOptions every;
    every.every_candidate = true;
    const MachineModel plain(problem, tiny.parts(), {}, every);
    std::vector<double> costs;
    const Exhaustive all(plain, [&](const std::vector<std::vector<solver::Row>>& rows) {
      std::map<std::string, int> pieces;
      double others = 0.0;
      for (std::size_t stage = 0; stage < rows.size(); ++stage)
        for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
          for (const evaluation::PartUse& use : plain.candidate(stage, slot, rows[stage][slot]).parts) {
            const std::string part(plain.catalogue().table(use.family).part_number(use.row));
            if (usual_prices.contains(part))
              ++pieces[part];
            else
              others += use.price;
          }
      const EveryOrder orders(market, pieces, others);
      costs.insert(costs.end(), orders.costs.begin(), orders.costs.end());
      return 0.0;
    });
    if (costs.empty()) continue;
    std::sort(costs.begin(), costs.end());
    const std::size_t count = std::min<std::size_t>(sanitized ? 4 : 15, costs.size());
    evaluation::SearchOptions options;
    options.builds = count;
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    const Synthesis found = evaluation::synthesise(MachineModel(problem, offered, {}, every), options);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds, " << costs.size() << " orders");
    REQUIRE(found.designs.size() == count);
    CHECK(found.proved == count);
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(i);
      require_sound(found.designs[i], market);
      CHECK(found.designs[i].cost == Approx(costs[i]).epsilon(1e-9));
    }
    ++compared;
    with_stock += !market.owned.empty();
    with_minimum += market.shops[2].minimum > 0.0;
  }
  CHECK(compared > 0);
  if (sanitized) return;
  CHECK(with_stock > 0);
  CHECK(with_minimum > 0);
}

// Motors that are owned need no shop: that one is open beside them makes no other build.
TEST_CASE("The next best builds differ where some of what shops sell is in stock") {
  const TinyCatalogue tiny({}, {"ball_screws"});
  Market market;
  market.shops[0].fee = 1.5;
  market.shops.push_back({"Shop A", 1.0, 0.0});
  market.shops.push_back({"Shop B", 2.0, 0.0});
  market.offers["M17"] = {{1, 8.0}, {2, 7.0}};
  for (const int owned : {1, 2, 3}) {
    CAPTURE(owned);
    market.owned["M17"] = owned;
    TemporaryFolder overlay;
    market.write(overlay);
    const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
    const Synthesis found = next_best(offered, 8);
    REQUIRE(found.designs.size() == 8);
    CHECK(found.proved == 8);
    std::set<std::vector<std::string>> seen;
    double last = 0.0;
    for (const Design& design : found.designs) {
      CHECK(design.cost >= last * (1.0 - 1e-9));
      last = design.cost;
      std::vector<std::string> names;
      std::map<std::string, double> bought;
      for (const evaluation::PartLine& part : design.parts) {
        names.push_back(part.axis + part.slot + part.part_number);
        const double pieces = part.quantity + part.spares - part.owned;
        if (pieces > 0.0) bought[part.part_number + " of " + part.supplier] += pieces;
      }
      for (const auto& [what, pieces] : bought) names.push_back(fmt::format("{} {}", pieces, what));
      names.push_back(fmt::format("{}", design.supply_voltage));
      CHECK(seen.insert(names).second);
    }
    CHECK(found.designs[0].cost == Approx(solved(MachineModel(two_axes(1.0), offered), {"cost"}).designs[0].cost));
  }
}

// Of screws of two lengths it matters which is bought where. (A shop with a minimum is never left out for a cheaper
// one.)
TEST_CASE("Where each screw is cut is another build") {
  const TinyCatalogue tiny({}, {"ball_screws"});
  TemporaryFolder overlay;
  overlay.write("suppliers.csv",
                "supplier,shipping_fee,minimum_order,currency\nShop A,0.01,0.5,USD\nShop B,0.01,0.5,USD\n");
  overlay.write("offers.csv",
                "part_number,supplier,price_per_length [1/m],currency\n"
                "Tr10x2,Shop A,10.001,USD\nTr10x2,Shop B,10.002,USD\n"
                "Tr16x4,Shop A,20.001,USD\nTr16x4,Shop B,20.002,USD\n");
  const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
  const Synthesis found = next_best(offered, 9);  // of the best parts, each of three sellers on each of two axes
  REQUIRE(found.designs.size() == 9);
  CHECK(found.proved == 9);
  std::set<std::string> sellers;
  for (const Design& design : found.designs) {
    std::string of_screws;
    for (const evaluation::PartLine& part : design.parts)
      if (part.slot == "screw") of_screws += part.axis + ": " + part.supplier + ", ";
    sellers.insert(of_screws);
  }
  CHECK(sellers.size() == 9);
}

}  // namespace shop_alternatives_test
