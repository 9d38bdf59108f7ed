// SPDX-License-Identifier: Apache-2.0
// Machines with spare parts: the best builds against all builds, whose price is worked out from what each of them is
// made of and what is bought beside it.
#include <fmt/format.h>

#include <map>
#include <random>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/exhaustive.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace spares_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

constexpr const char* lead_screws = "\"lead_screws\"";

/// What lies in the drawer, and couplings in packs.
struct Shelf {
  std::map<std::string, double> owned;
  std::map<std::string, int> pack;

  [[nodiscard]] double bought(const std::string& part, double pieces) const {
    const auto there = owned.find(part);
    const double needed = std::max(0.0, pieces - (there == owned.end() ? 0.0 : there->second));
    const auto packed = pack.find(part);
    if (packed == pack.end()) return needed;
    return std::ceil(needed / packed->second) * packed->second;
  }
};

using Spares = std::function<double(const std::string& axis, std::string_view slot)>;

/// What a build costs less than the parts in it by themselves: less than nothing with spares.
Discount saving(const MachineModel& model, const Shelf& shelf, const Spares& spares) {
  return [&model, shelf, spares](const std::vector<std::vector<solver::Row>>& rows) {
    struct Taken {
      double pieces = 0.0, each = 0.0;
    };
    std::map<std::string, Taken> taken;
    double usual = 0.0;
    for (std::size_t stage = 0; stage < rows.size(); ++stage)
      for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
        for (const evaluation::PartUse& use : model.candidate(stage, slot, rows[stage][slot]).parts) {
          // A length of its own for every axis.
          std::string part(model.catalogue().table(use.family).part_number(use.row));
          if (use.length > 0.0) part += model.entries()[stage].axis;
          Taken& all = taken[part];
          all.each = use.price / use.quantity;
          all.pieces += use.quantity + spares(model.entries()[stage].axis, use.slot);
          usual += use.price;
        }
    double paid = 0.0;
    for (const auto& [part, all] : taken) paid += all.each * shelf.bought(part, all.pieces);
    return usual - paid;
  };
}

void require_sound(const Design& design) {
  double cost = 0.0, mass = 0.0;
  for (const evaluation::PartLine& part : design.parts) {
    cost += part.price;
    mass += part.mass;
  }
  for (const evaluation::ShopOrder& order : design.orders) cost += order.shipping_fee + order.top_up;
  CHECK(design.cost == Approx(cost).epsilon(1e-12));
  CHECK(design.mass == Approx(mass).epsilon(1e-12));
}

}  // namespace

TEST_CASE("With spare parts the cheapest build and the front equal those of all builds") {
  std::size_t compared = 0, changed = 0;
  for (unsigned seed = 0; seed < (sanitized ? 2 : 8); ++seed) {
    std::mt19937 random(seed);
    const auto up_to = [&](unsigned most) { return static_cast<double>(random() % (most + 1)); };
    const double motors = up_to(2), couplings = up_to(2), screws = up_to(1), supplies = up_to(1);
    Shelf shelf;
    for (const char* part : {"M17", "M23", "D2", "K8", "F6"})
      if (random() % 4 == 0) shelf.owned[part] = 1 + static_cast<double>(random() % 2);
    const TinyCatalogue tiny;
    TemporaryFolder overlay;
    std::string stock = "part_number,owned\n";
    for (const auto& [part, pieces] : shelf.owned) stock += fmt::format("{},{}\n", part, pieces);
    overlay.write("stock.csv", stock);
    if (random() % 2 == 0) {  // K8 in packs
      shelf.pack["K8"] = 3;
      overlay.write("couplings/packs.csv",
                    "manufacturer,part_number,minimum_bore [mm],maximum_bore [mm],rated_torque [N.m],"
                    "torsional_stiffness [N.m/rad],inertia [g.cm2],maximum_speed [rpm],mass [kg],price,pack_size [1],"
                    "currency,price_basis,evidence,source,confidence\n"
                    "tiny,K8,3,8,2,60,10,6000,0.02,2,3,USD,test,computed,test,high\n");
    }
    const catalogue::Catalogue stocked = catalogue_of({tiny.path(), overlay.path()});
    const double load = 4.0 + 8.0 * (seed % 3);
    const std::string spares = fmt::format("[spares]\nmotor = {}\n\"x.coupling\" = {}\n\"y.screw\" = {}\nsupply = {}\n",
                                           motors,
                                           couplings,
                                           screws,
                                           supplies);
    machine::Problem everything = two_axes(load, lead_screws, "");
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, shelf, [&](const std::string& axis, std::string_view slot) {
                           if (slot == "motor") return motors;
                           if (slot == "coupling" && axis == "x") return couplings;
                           if (slot == "screw" && axis == "y") return screws;
                           return slot == "supply" ? supplies : 0.0;
                         }));
    const machine::Problem problem = two_axes(load, lead_screws, spares);
    const MachineModel model(problem, stocked);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    const Synthesis front = solved(model, {"cost", "mass"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    require_best_of(all, cost, front, require_sound);
    if (seed % 3 == 2) require_next_best_of(all, problem, stocked, 2 + seed / 2, require_sound);
    const Synthesis without = solved(MachineModel(two_axes(load, lead_screws, ""), stocked), {"cost"});
    REQUIRE(without.designs.size() == 1);
    for (std::size_t i = 0; i < without.designs[0].parts.size() && i < cost.designs[0].parts.size(); ++i)
      changed += without.designs[0].parts[i].part_number != cost.designs[0].parts[i].part_number;
  }
  CHECK(compared >= 2);
  if (!sanitized) CHECK(changed > 0);  // spares are part of the choice
}

// Shop A has the motor M17 for 7 USD instead of 9 and asks 5 for shipping: two motors are not worth it, four are.
TEST_CASE("Spares may make another shop worth its shipping") {
  const TinyCatalogue tiny;
  TemporaryFolder overlay;
  overlay.write("suppliers.csv", "supplier,shipping_fee,currency\nShop A,5,USD\n");
  overlay.write("offers.csv", "part_number,supplier,price,currency\nM17,Shop A,7,USD\n");
  const catalogue::Catalogue offered = catalogue_of({tiny.path(), overlay.path()});
  const auto found = [&](const char* spares) {
    const Synthesis result = solved(MachineModel(two_axes(1.0, lead_screws, spares), offered), {"cost"});
    REQUIRE(result.designs.size() == 1);
    require_sound(result.designs[0]);
    return result.designs[0];
  };
  const Design plain = found("");
  CHECK(plain.orders.empty());
  const Design more = found("[spares]\nmotor = 1\n");
  REQUIRE(more.orders.size() == 1);
  CHECK(more.orders[0].goods == 28.0);
  CHECK(more.cost == Approx(plain.cost - 2.0 * 9.0 + 4.0 * 7.0 + 5.0));
  CHECK(more.mass == Approx(plain.mass));
}

}  // namespace spares_test
