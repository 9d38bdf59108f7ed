// SPDX-License-Identifier: Apache-2.0
// The next best builds of machines whose parts several shops sell: which orders make another build, and that none that
// does is left out.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

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

constexpr const char* lead_screws = "\"lead_screws\"";

/// A line of a bill: so many pieces of a part.
using Line = std::pair<std::string, int>;

/// What every order of a build's parts costs that is worth a look, one for each choice of what is bought where; with
/// preferred parts, what is compared. A line comes from one shop; what is owned goes before what the first shop sells.
class EveryOrder {
 public:
  /// `others`: what is paid for what only the first shop sells.
  EveryOrder(const Market& market, std::vector<Line> lines, double others)
      : market_(market), lines_(std::move(lines)), others_(others), seller_(lines_.size(), 0) {
    choose(0);
  }
  std::vector<double> costs;

 private:
  using Bought = std::map<std::pair<std::string, std::size_t>, int>;  ///< [part, shop]: pieces

  void choose(std::size_t at) {
    if (at == lines_.size()) return add_up();
    for (const auto& sold : market_.prices(lines_[at].first)) {
      seller_[at] = sold.first;
      choose(at + 1);
    }
  }

  void add_up() {
    Bought bought;
    std::map<std::string, int> most_elsewhere;  // in a line
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto& [part, pieces] = lines_[i];
      bought[{part, seller_[i]}] += pieces;
      if (seller_[i] != 0) most_elsewhere[part] = std::max(most_elsewhere[part], pieces);
    }
    for (const auto& [part, owned] : market_.owned) {
      int& here = bought[{part, 0}];
      // Pieces that would do for a line lie about, and one is bought. Of what is preferred that may pay.
      if (!market_.preferred.contains(part) && most_elsewhere.contains(part) && owned - here >= most_elsewhere[part])
        return;
      here = std::max(0, here - owned);
    }
    std::erase_if(bought, [](const auto& each) { return each.second == 0; });
    if (!known_.insert(bought).second) return;
    std::vector<double> spent(market_.shops.size(), 0.0), compared(spent);
    std::vector<bool> used(spent.size(), false);
    spent[0] = compared[0] = others_;
    used[0] = others_ > 0.0;
    for (const auto& [what, pieces] : bought) {
      const double price = pieces * market_.prices(what.first).at(what.second);
      spent[what.second] += price;
      compared[what.second] += market_.factor(what.first) * price;
      used[what.second] = true;
    }
    for (const auto& [what, pieces] : bought)
      if (is_beaten(what.first, what.second, used)) return;
    double cost = 0.0;
    for (std::size_t shop = 0; shop < spent.size(); ++shop)
      if (used[shop])
        cost += market_.shops[shop].fee + compared[shop] + std::max(0.0, market_.shops[shop].minimum - spent[shop]);
    costs.push_back(cost);
  }

  /// Another shop that is ordered from has it for less, and this one has no minimum that it would help to reach. What
  /// the first shop asks for a part of which some are in stock hangs on how many are taken: it stays beside the others.
  [[nodiscard]] bool is_beaten(const std::string& part, std::size_t shop, const std::vector<bool>& used) const {
    const bool in_stock = market_.owned.contains(part);
    if (market_.shops[shop].minimum > 0.0 || (in_stock && shop == 0)) return false;
    const std::map<std::size_t, double> prices = market_.prices(part);
    return std::any_of(prices.begin(), prices.end(), [&](const auto& other) {
      return used[other.first] && other.second < prices.at(shop) && !(in_stock && other.first == 0);
    });
  }

  const Market& market_;
  std::vector<Line> lines_;
  double others_;
  std::vector<std::size_t> seller_;  ///< [line]
  std::set<Bought> known_;
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
  // In the last one it pays to buy what is preferred, though one is owned.
  for (const unsigned seed : sanitized ? std::vector<unsigned>{0} : std::vector<unsigned>{0, 1, 2, 3, 4, 5, 6, 19}) {
    std::mt19937 random(700 + seed);
    Market market = random_market(random, seed);
    double apart = 0.0;  // of shops that ask for the same, which one is listed is nobody's business
    for (auto& [part, by] : market.offers)
      for (auto& [shop, price] : by) price += apart += 1e-4;
    if (seed % 3 == 1) market.preferred = {{"M17", 0.5}, {"K8", 0.5}};
    const TinyCatalogue tiny({}, {"ball_screws"});
    TemporaryFolder overlay;
    market.write(overlay);
    const int motors = seed % 4 == 0 ? 2 : 1, couplings = seed % 5 == 1 ? 2 : 1;
    const double load = 4.0 + 8.0 * (seed % 3);
    machine::Problem problem = two_axes(
        load, lead_screws, fmt::format("[spares]\nmotor = {}\n\"x.coupling\" = {}\n", motors - 1, couplings - 1));
    machine::Problem everything = two_axes(load, lead_screws);
    problem.supply_voltages = everything.supply_voltages = {24.0};
    if (!market.preferred.empty()) problem.preference = 0.5;
    evaluation::ModelOptions every;
    every.every_candidate = true;
    const MachineModel plain(everything, tiny.parts(), {}, every);
    std::map<std::pair<std::vector<Line>, double>, std::vector<double>> known;
    std::vector<double> costs;
    const Exhaustive all(plain, [&](const std::vector<std::vector<solver::Row>>& rows) {
      std::vector<Line> lines;
      double others = 0.0;
      for (std::size_t stage = 0; stage < rows.size(); ++stage)
        for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
          for (const evaluation::PartUse& use : plain.candidate(stage, slot, rows[stage][slot]).parts) {
            const std::string part(plain.catalogue().table(use.family).part_number(use.row));
            const bool is_spared = use.slot == "coupling" && plain.entries()[stage].axis == "x";
            const int pieces = use.slot == "motor" ? motors : is_spared ? couplings : 1;
            if (usual_prices.contains(part))
              lines.emplace_back(part, pieces);
            else
              others += pieces * use.price;
          }
      std::sort(lines.begin(), lines.end());
      const auto [found, is_new] = known.try_emplace({lines, others});
      if (is_new) found->second = EveryOrder(market, lines, others).costs;
      costs.insert(costs.end(), found->second.begin(), found->second.end());
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
      const auto& preference = found.designs[i].preference;
      CHECK(preference.has_value() == !market.preferred.empty());
      // What costs just its premium more is taken: a millionth is added to it.
      CHECK((preference ? preference->compared_cost : found.designs[i].cost) ==
            Approx(costs[i]).epsilon(preference ? 3e-6 : 1e-9));
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
