// SPDX-License-Identifier: Apache-2.0
// Machines of which some parts lie in the drawer, or are preferred: the best builds against all builds, whose price is
// worked out from what each of them is made of.
#include <fmt/format.h>

#include <map>
#include <random>
#include <set>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/exhaustive.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace counted_parts_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

using Owned = std::map<std::string, double>;

/// What is paid for so many pieces, found by trying every number of pieces that could be bought.
struct Offer {
  double single = 0.0;
  std::vector<std::pair<int, double>> breaks;
  int pack = 1;

  [[nodiscard]] double price(int needed) const {
    double best = needed == 0 ? 0.0 : std::numeric_limits<double>::infinity();
    for (int bought = needed; needed > 0 && bought <= needed + 100; ++bought) {
      if (bought % pack != 0) continue;
      double each = single;
      for (const auto& [from, price] : breaks)
        if (bought >= from) each = price;
      best = std::min(best, each * bought);
    }
    return best;
  }
  [[nodiscard]] std::string columns() const {
    std::string text;
    for (const auto& [from, price] : breaks) text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", from, price);
    return fmt::format("{},{},{}", single, text, pack == 1 ? "" : std::to_string(pack));
  }
};
using Offers = std::map<std::string, Offer>;

/// Couplings and drivers of the tiny catalogue once more, with the prices of these offers.
void write_offers(const TemporaryFolder& folder, const Offers& offers) {
  const char* tail = ",currency,price_basis,evidence,source,confidence\n";
  const char* said = ",USD,test,computed,test,high\n";
  std::string couplings = std::string(
                              "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque [N.m],"
                              "torsional_stiffness [N.m/rad],inertia [g.cm2],maximum_speed [rpm],mass [kg],"
                              "price,price_breaks,pack_size [1]") +
                          tail;
  std::string drivers = std::string(
                            "manufacturer,part_number,minimum_voltage [V],maximum_voltage [V],peak_current [A],"
                            "maximum_microsteps [1],closed_loop,mass [kg],price,price_breaks,pack_size [1]") +
                        tail;
  const std::map<std::string, std::string> of_couplings = {{"K8", "3,8,2,60,10,6000,0.02"},
                                                           {"K12", "5,12,10,400,40,9000,0.08"}};
  const std::map<std::string, std::string> of_drivers = {{"D2", "9,30,2,32,no,0.1"}, {"D4", "18,50,4.2,128,no,0.3"}};
  for (const auto& [part, offer] : offers) {
    if (const auto found = of_couplings.find(part); found != of_couplings.end())
      couplings += fmt::format("tiny,{},{},{}{}", part, found->second, offer.columns(), said);
    if (const auto found = of_drivers.find(part); found != of_drivers.end())
      drivers += fmt::format("tiny,{},{},{}{}", part, found->second, offer.columns(), said);
  }
  folder.write("couplings/offers.csv", couplings);
  folder.write("drivers/offers.csv", drivers);
}

using Preferred = std::set<std::string>;

TemporaryFolder& write_stock(TemporaryFolder& folder, const Owned& owned, const Preferred& preferred = {}) {
  std::string text = "part_number,owned,available\n";
  for (const auto& [part, pieces] : owned)
    text += fmt::format("{},{},{}\n", part, pieces, preferred.contains(part) ? "preferred" : "");
  for (const std::string& part : preferred)
    if (!owned.contains(part)) text += fmt::format("{},,preferred\n", part);
  folder.write("stock.csv", text);
  return folder;
}

/// What a build costs less than the sum of its single pieces: for those that are there, and by the offers. With a
/// premium, what it costs less where preferred parts are compared; builds above the budget cost a million more.
struct Wanted {
  Preferred preferred;
  double premium = 0.0;
  double budget = std::numeric_limits<double>::infinity();
};
Discount saving(const MachineModel& model, const Owned& owned, const Offers& offers = {}, const Wanted& wanted = {}) {
  return [&model, owned, offers, wanted](const std::vector<std::vector<solver::Row>>& rows) {
    std::map<std::string, std::pair<double, double>> taken;  // pieces, price of one
    for (std::size_t stage = 0; stage < rows.size(); ++stage)
      for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
        for (const evaluation::PartUse& use : model.candidate(stage, slot, rows[stage][slot]).parts) {
          auto& [pieces, price] = taken[std::string(model.catalogue().table(use.family).part_number(use.row))];
          pieces += use.quantity;
          price = use.price / use.quantity;
        }
    double sum = 0.0, real = 0.0;
    for (const auto& [part, count] : taken) {
      const auto there = owned.find(part);
      const double needed = std::max(0.0, count.first - (there == owned.end() ? 0.0 : there->second));
      const auto offer = offers.find(part);
      const double paid = offer == offers.end() ? needed * count.second : offer->second.price(static_cast<int>(needed));
      sum += count.first * count.second - paid / (wanted.preferred.contains(part) ? 1.0 + wanted.premium : 1.0);
      real += paid;
    }
    return real > wanted.budget ? sum - 1e6 : sum;
  };
}

/// The lines of a design add up to its cost, and no more pieces are free than there are.
void require_sound(const Design& design, const Owned& owned) {
  double cost = 0.0;
  std::map<std::string, double> free;
  for (const evaluation::PartLine& part : design.parts) {
    cost += part.price;
    CHECK(part.price >= 0.0);
    if (part.owned > 0.0) free[part.part_number] += part.owned;
  }
  CHECK(design.cost == Approx(cost).epsilon(1e-12));
  for (const evaluation::Purchase& purchase : design.purchases) {
    double of_lines = 0.0;
    for (const evaluation::PartLine& part : design.parts)
      if (part.part_number == purchase.part_number) of_lines += part.price;
    CHECK(purchase.price == Approx(of_lines).margin(1e-9));
    CHECK(purchase.bought >= purchase.taken - purchase.owned);
  }
  for (const auto& [part, pieces] : free) {
    INFO(part);
    REQUIRE(owned.count(part) == 1);
    CHECK(pieces <= owned.at(part));
  }
}

}  // namespace

TEST_CASE("With parts in stock the cheapest build and the front equal those of all builds") {
  std::size_t bought_more = 0, changed = 0, fronts = 0;
  for (unsigned seed = 0; seed < (sanitized ? 1 : 8); ++seed) {
    std::mt19937 random(seed);
    const double dear = 1.0 + static_cast<double>(seed % 4);
    const TinyCatalogue tiny([dear](const std::string& part, PriceAndMass usual) {
      return PriceAndMass{part == "M17" || part == "K8" ? dear * usual.price : usual.price, usual.mass};
    });
    Owned owned;
    for (const char* part : {"M17", "M23", "M23L", "M34", "D2", "D4", "K8", "K12", "F6", "F10", "S6", "P24-350"})
      if (random() % 3 == 0) owned[part] = 1 + static_cast<double>(random() % 2);
    if (owned.empty()) continue;
    TemporaryFolder overlay;
    const catalogue::Catalogue stocked = catalogue_of({tiny.path(), write_stock(overlay, owned).path()});
    const machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 5));
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, owned));
    const MachineModel model(problem, stocked);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis front = solved(model, {"cost", "mass"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    const auto sound = [&](const Design& design) { require_sound(design, owned); };
    require_best_of(all, cost, front, sound);
    if (seed % 3 == 0) require_next_best_of(all, problem, stocked, 2 + seed, sound);
    for (const Design& design : front.designs)
      for (const evaluation::PartLine& part : design.parts)
        bought_more += owned.count(part.part_number) == 1 && part.owned < part.quantity;
    const Synthesis without = solved(MachineModel(problem, tiny.parts()), {"cost"});
    REQUIRE(without.designs.size() == 1);
    CHECK(cost.designs[0].cost <= without.designs[0].cost);
    for (std::size_t i = 0; i < without.designs[0].parts.size() && i < cost.designs[0].parts.size(); ++i)
      changed += without.designs[0].parts[i].part_number != cost.designs[0].parts[i].part_number;
    fronts += front.designs.size() > 1;
    if (sanitized) continue;
    require_same_costs(front, solved(model, {"cost", "mass"}, 2));
  }
  if (sanitized) return;
  // Stocks that change the choice, and ones that do not suffice.
  CHECK(changed > 0);
  CHECK(bought_more > 0);
  CHECK(fronts > 0);
}

// Drivers and couplings get dearer and cheaper by the number, in packs of one to three, some of them owned.
TEST_CASE("With price breaks and packs the cheapest build and the front equal those of all builds") {
  std::size_t more_than_needed = 0, compared = 0;
  for (unsigned seed = 0; seed < (sanitized ? 1 : 8); ++seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::round(100.0 * (low + (high - low) * static_cast<double>(random() >> 8U) / 16777216.0)) / 100.0;
    };
    Offers offers;
    for (const char* part : {"K8", "K12", "D2", "D4"}) {
      Offer offer{between(4.0, 12.0), {}, 1 + static_cast<int>(random() % 3)};
      if (random() % 2 == 0) offer.breaks.emplace_back(2, between(0.3, 1.0) * offer.single);
      if (random() % 3 == 0) offer.breaks.emplace_back(3, between(0.2, 0.6) * offer.single);
      for (auto& [from, price] : offer.breaks) price = std::round(100.0 * price) / 100.0;
      offers[part] = offer;
    }
    Owned owned;
    for (const char* part : {"K8", "D4", "M23"})
      if (random() % 3 == 0) owned[part] = 1.0;
    const TinyCatalogue tiny([&](const std::string& part, PriceAndMass usual) {
      const auto offer = offers.find(part);
      return PriceAndMass{offer == offers.end() ? usual.price : offer->second.single, usual.mass};
    });
    TemporaryFolder overlay;
    write_offers(overlay, offers);
    const catalogue::Catalogue stocked = catalogue_of({tiny.path(), write_stock(overlay, owned).path()});
    machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    // D2 does not give the larger one, whatever it costs.
    if (seed % 2 == 1)
      for (machine::Axis& axis : problem.axes) axis.motor.currents = {1.5, 3.0};
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_driver = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, owned, offers));
    const MachineModel model(problem, stocked);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis front = solved(model, {"cost", "mass"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    const auto sound = [&](const Design& design) { require_sound(design, owned); };
    require_best_of(all, cost, front, sound);
    if (seed % 3 == 0) require_next_best_of(all, problem, stocked, 2 + seed, sound);
    for (const Design& design : front.designs)
      for (const evaluation::DimensionLine& line : design.dimensions)
        for (const evaluation::PartLine& part : design.parts)
          if (line.name == "motor_current" && part.axis == line.axis && part.slot == "driver")
            CHECK(line.value <= (part.part_number == "D2" ? 2.0 : 4.2));
    for (const Design& design : front.designs)
      for (const evaluation::Purchase& purchase : design.purchases)
        more_than_needed += purchase.bought > purchase.taken - purchase.owned;
  }
  CHECK(compared >= (sanitized ? 1 : 2));
  if (!sanitized) CHECK(more_than_needed > 0);
}

// Two axes that would each take the cheap motor M17 (9 USD): of the dear M23 one piece is there. Free for one axis, it
// costs 16 USD for both: 0 + 9 is less than 0 + 16 and than 9 + 9.
TEST_CASE("A single piece in stock goes to one axis and the other takes what is cheaper to buy") {
  const TinyCatalogue tiny;
  const Owned owned = {{"M23", 1.0}};
  TemporaryFolder overlay;
  const catalogue::Catalogue stocked = catalogue_of({tiny.path(), write_stock(overlay, owned).path()});
  const MachineModel model(two_axes(1.0), stocked);
  const Synthesis found = solved(model, {"cost"});
  REQUIRE(found.designs.size() == 1);
  std::vector<std::string> motors;
  double paid = 0.0;
  for (const evaluation::PartLine& part : found.designs[0].parts)
    if (part.slot == "motor") {
      motors.push_back(part.part_number);
      paid += part.price;
    }
  std::sort(motors.begin(), motors.end());
  CHECK(motors == std::vector<std::string>{"M17", "M23"});
  CHECK(paid == 9.0);
  require_sound(found.designs[0], owned);
}

namespace {

/// The compared cost of a design, worked out from its lines.
double compared_cost(const Design& design, const Wanted& wanted) {
  double sum = 0.0;
  for (const evaluation::PartLine& part : design.parts) {
    CHECK(part.preferred == wanted.preferred.contains(part.part_number));
    sum += part.preferred ? part.price / (1.0 + wanted.premium) : part.price;
  }
  return sum;
}

/// Offers of couplings and drivers, owned pieces and preferred parts, all at random.
struct Choice {
  Offers offers;
  Owned owned;
  Wanted wanted;
};

Choice random_choice(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::round(100.0 * (low + (high - low) * static_cast<double>(random() >> 8U) / 16777216.0)) / 100.0;
  };
  Choice choice;
  for (const char* part : {"K8", "K12", "D2", "D4"}) {
    Offer offer{between(4.0, 12.0), {}, 1 + static_cast<int>(random() % 3)};
    if (random() % 2 == 0) offer.breaks.emplace_back(2, std::round(100.0 * between(0.3, 1.0) * offer.single) / 100.0);
    choice.offers[part] = offer;
  }
  for (const char* part : {"M23", "K8", "D4", "F6"})
    if (random() % 4 == 0) choice.owned[part] = 1.0;
  for (const char* part : {"M17", "M23", "M23L", "D2", "D4", "K8", "K12", "F6", "F10", "P24-350", "P36-350", "Tr16x4"})
    if (random() % 3 == 0) choice.wanted.preferred.insert(part);
  constexpr double premiums[] = {0.0, 0.05, 0.25, 1.0};
  choice.wanted.premium = premiums[seed % 4];
  return choice;
}

}  // namespace

TEST_CASE("With preferred parts the best build and the front equal those of all builds, compared by their prices") {
  std::size_t compared = 0, dearer = 0, limited = 0, heavier = 0;
  for (unsigned seed = 0; seed < (sanitized ? 1 : 9); ++seed) {
    auto [offers, owned, wanted] = random_choice(seed);
    const TinyCatalogue tiny([&offers = offers](const std::string& part, PriceAndMass usual) {
      const auto offer = offers.find(part);
      return PriceAndMass{offer == offers.end() ? usual.price : offer->second.single, usual.mass};
    });
    TemporaryFolder overlay;
    write_offers(overlay, offers);
    const catalogue::Catalogue stocked =
        catalogue_of({tiny.path(), write_stock(overlay, owned, wanted.preferred).path()});
    machine::Problem problem = two_axes(4.0 + 8.0 * (seed % 3));
    problem.preference = wanted.premium;
    machine::Problem everything = problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    INFO("machine " << seed);
    machine::Problem indifferent = problem;
    indifferent.preference.reset();
    const MachineModel without(indifferent, stocked);
    CHECK_FALSE(without.prefers());
    const Synthesis cheapest = solved(without, {"cost"});
    if (cheapest.designs.empty()) continue;
    CHECK_FALSE(cheapest.designs[0].preference);
    // Every third machine may cost but little more than the least.
    if (seed % 3 == 1) {
      wanted.budget = 1.02 * cheapest.designs[0].cost;
      problem.limits[machine::Quantity::cost] = wanted.budget;
    }
    const MachineModel model(problem, stocked);
    REQUIRE(model.prefers());
    const Exhaustive all(plain, saving(plain, owned, offers, wanted));
    const Synthesis best = solved(model, {"cost"});
    REQUIRE(best.designs.size() == 1);
    const Design& design = best.designs[0];
    require_sound(design, owned);
    CHECK(best.status == solver::Status::optimal);
    REQUIRE(design.preference);
    // What is preferred at just its premium is chosen still, by a millionth.
    CHECK(design.preference->compared_cost == Approx(compared_cost(design, wanted)).epsilon(2e-6));
    CHECK(design.preference->compared_cost == Approx(all.least(&BuildValue::cost)).epsilon(3e-6));
    CHECK(best.lower_bound <= design.preference->compared_cost * (1.0 + 1e-9));
    CHECK(design.cost <= wanted.budget * (1.0 + 1e-9));
    // Not dearer than the cheapest by more than the certificate says.
    CHECK(design.cost - cheapest.designs[0].cost <= design.cost - design.preference->compared_cost + 1e-9);
    dearer += design.cost > cheapest.designs[0].cost + 1e-6;
    limited += seed % 3 == 1;
    ++compared;
    const Synthesis front = solved(model, {"cost", "mass"});
    std::vector<BuildValue> within;
    for (const BuildValue& value : all.front())
      if (value.cost < 1e5) within.push_back(value);
    // Builds that differ by less than that millionth may both be there.
    std::vector<BuildValue> found;
    for (const Design& each : front.designs)
      found.push_back({each.preference ? each.preference->compared_cost : each.cost, each.mass});
    for (const BuildValue& value : within) {
      const auto beats = [&](const BuildValue& by) {
        return by.cost <= value.cost * (1.0 + 3e-6) && by.mass <= value.mass * (1.0 + 1e-9);
      };
      CHECK(std::any_of(found.begin(), found.end(), beats));
    }
    for (const BuildValue& value : found) {
      const auto beats = [&](const BuildValue& by) {
        return by.cost < value.cost * (1.0 - 3e-6) && by.mass <= value.mass * (1.0 + 1e-9);
      };
      CHECK(std::none_of(within.begin(), within.end(), beats));
    }
    heavier += front.designs.size() > 1;
    if (sanitized) continue;
    const Synthesis again = solved(model, {"cost", "mass"}, 2);
    REQUIRE(again.designs.size() == front.designs.size());
    for (std::size_t i = 0; i < again.designs.size(); ++i) CHECK(again.designs[i].cost == front.designs[i].cost);
  }
  CHECK(compared >= (sanitized ? 1 : 3));
  if (sanitized) return;
  CHECK(dearer > 0);
  CHECK(limited > 0);
  CHECK(heavier > 0);
}

/// What lines of so many pieces are charged; from three pieces on each costs `each`, and only whole packs are sold.
std::vector<double> charged(double each, double pack, double owned, const std::vector<double>& lines) {
  evaluation::CountedPart part;
  part.family = catalogue::Family::couplings;
  part.owned = owned;
  part.price = catalogue::PiecePrice{12.0, {{3.0, each}}, pack};
  const std::vector<evaluation::CountedPart> parts(1, part);
  std::vector<evaluation::PartUse> uses(lines.size());
  evaluation::CountedPartsLedger ledger(parts);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    uses[i].family = part.family;
    uses[i].quantity = lines[i];
    ledger.take(uses[i]);
  }
  std::vector<double> prices;
  for (const evaluation::PartUse& use : uses) prices.push_back(ledger.share(use).price);
  return prices;
}

// Three pieces at 4 USD are 4 USD each wherever they stand, and not 12 USD for the first line that is counted.
TEST_CASE("Lines of a part with price breaks or in packs pay the same for every piece that is bought") {
  CHECK(charged(4.0, 1.0, 0.0, {1.0, 2.0}) == std::vector<double>{4.0, 8.0});
  CHECK(charged(4.0, 1.0, 1.0, {2.0, 1.0, 1.0}) == std::vector<double>{4.0, 4.0, 4.0});
  CHECK(charged(4.0, 1.0, 3.0, {1.0, 2.0}) == std::vector<double>{0.0, 0.0});
  // Four pieces, 5 USD, for three lines: whole cents, and no cent is lost.
  const std::vector<double> thirds = charged(1.25, 4.0, 0.0, {1.0, 1.0, 1.0});
  CHECK(thirds[0] == Approx(1.67));
  CHECK(thirds[1] == Approx(1.66));
  CHECK(thirds[0] + thirds[1] + thirds[2] == Approx(5.0).epsilon(1e-15));
  const std::vector<double> small = charged(0.0125, 1.0, 0.0, {1.0, 3.0});
  CHECK(small[0] == Approx(0.0125));
  CHECK(small[1] == Approx(0.0375));
}

// M17 costs 9 USD. At a premium of 5 % another motor that does the same is taken up to 9.45 USD.
TEST_CASE("A preferred part is taken up to just its premium and no further") {
  const auto motor = [](double price, std::optional<double> premium, const char* mark = "preferred") {
    const TinyCatalogue tiny([price](const std::string& part, PriceAndMass usual) {
      return PriceAndMass{part == "M23" ? price : usual.price, usual.mass};
    });
    TemporaryFolder overlay;
    overlay.write("stock.csv", fmt::format("part_number,available\nM23,{}\n", mark));
    machine::Problem problem = two_axes(1.0);
    problem.preference = premium;
    const catalogue::Catalogue marked = catalogue_of({tiny.path(), overlay.path()});
    const Synthesis found = solved(MachineModel(problem, marked), {"cost"});
    REQUIRE(found.designs.size() == 1);
    std::string names;
    for (const evaluation::PartLine& part : found.designs[0].parts)
      if (part.slot == "motor") names += part.part_number + " ";
    return names;
  };
  CHECK(motor(9.45, 0.05) == "M23 M23 ");
  CHECK(motor(9.46, 0.05) == "M17 M17 ");
  CHECK(motor(9.45, 0.05, "yes") == "M17 M17 ");
  CHECK(motor(9.45, std::nullopt) == "M17 M17 ");
  // With no premium it goes first among equals, though it is heavier.
  CHECK(motor(9.0, 0.0) == "M23 M23 ");
  CHECK(motor(9.0, std::nullopt) == "M17 M17 ");
  CHECK(motor(9.01, 0.0) == "M17 M17 ");
}

}  // namespace counted_parts_test
