// SPDX-License-Identifier: Apache-2.0
//
// Suppliers that charge for an order itself: shipping, and a minimum up to which an order is filled. Which of them a
// build orders from is a choice shared by all stages: with a set of them given, their shipping is a constant, and the
// rows that others sell are not offered.
//
//   cost = sum of prices + sum over the set of (shipping + max(0, minimum - spent there))
//
// What was spent at those with a minimum is part of the state, and the last stage charges what is missing. The cost is
// also the largest of sums in which some shops are paid their minimum and their goods nothing: floors, by which the
// search bounds and compares it (solver/stage.h). Of rows that differ only in who sells the parts, those that another
// one of the set beats are not offered either.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/counted_parts.h"
#include "evaluation/ledger.h"

namespace millwright::evaluation {

/// Where the shared choices hold the set of suppliers: its row has a bit for each of them.
inline constexpr std::size_t shop_choice = 1;

struct Shop {
  std::string name;
  double shipping_fee = 0.0;               ///< in the problem's currency
  double minimum_order = 0.0;              ///< in the problem's currency
  std::optional<std::size_t> spent_state;  ///< where the state vector holds what was spent there
  std::optional<std::size_t> used_state;   ///< where it counts what is bought there, if somebody has to
};

/// What a build costs at least where every shop of a set is paid its minimum and its goods nothing. Over all sets, the
/// empty one too, the largest of these is what the build costs.
struct CostFloor {
  std::uint32_t shops = 0;   ///< bits of those with their minimum
  std::size_t resource = 0;  ///< where it is summed up
  [[nodiscard]] bool has(std::optional<std::size_t> shop) const { return shop && ((shops >> *shop) & 1U) != 0; }
};

/// What the rows of one slot have to do with shops.
struct SlotShops {
  using Set = std::uint32_t;
  std::vector<Set> needed;                          ///< [row]: the shops it is bought from
  std::vector<std::vector<solver::Row>> beaten_by;  ///< [row]: rows with the same parts that cost no more
  [[nodiscard]] bool offered(Set open, solver::Row row) const {
    if ((needed[row] & ~open) != 0) return false;
    for (const solver::Row by : beaten_by[row])
      if ((needed[by] & ~open) == 0) return false;
    return true;
  }
};

class Shops {
 public:
  /// Looks who sells the parts of these tables.
  void find(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::span<const SlotTable> tables);
  /// Decides what is to be counted, from this component of the state on. `all_used`: a set counts only if something is
  /// bought from each of it, so that every build has but one. Returns how many components that takes.
  std::size_t settle(std::size_t first_state, bool all_used);
  /// Floors of the cost, counted as resources from this one on; after settle(). Of all sets of shops with a minimum
  /// where these are few, and then what was spent need not be compared (`solver::Problem::states_in_floors`); of
  /// many only of each shop and of all of them.
  void add_floors(std::size_t first_resource, solver::Problem& problem);

  [[nodiscard]] const std::vector<Shop>& shops() const { return shops_; }
  [[nodiscard]] const std::vector<CostFloor>& floors() const { return floors_; }
  [[nodiscard]] bool empty() const { return shops_.empty(); }
  /// The shop where this is bought; none where that costs nothing beside.
  [[nodiscard]] std::optional<std::size_t> shop_of(catalogue::Family family, int row) const;
  [[nodiscard]] std::optional<std::size_t> shop_of(const PartUse& use) const;
  [[nodiscard]] SlotShops::Set needed(const Candidate& candidate) const;

  /// Of the tables of one stage, after settle().
  [[nodiscard]] std::vector<SlotShops> slots(const catalogue::Catalogue& catalogue,
                                             const PriceBook& prices,
                                             std::span<const SlotTable> tables) const;
  /// What their rows add to the components of the state, and to floors where they are sold by one of their shops.
  [[nodiscard]] std::vector<PieceCount> counts(std::span<const SlotTable> tables) const;

 private:
  std::map<std::pair<catalogue::Family, int>, std::string> supplier_of_;
  std::map<std::string, Shop> found_;
  std::map<std::pair<catalogue::Family, int>, std::size_t> shop_of_;
  std::vector<Shop> shops_;
  std::vector<CostFloor> floors_;

  void add_floor_counts(const CostFloor& floor,
                        std::span<const SlotTable> tables,
                        std::vector<PieceCount>& counts) const;
};

/// Equal for candidates that differ only in who sells their parts.
std::string parts_name(const catalogue::Catalogue& catalogue, const Candidate& candidate);

/// Goes through the parts of a build and says what is ordered from whom.
class ShopLedger {
 public:
  explicit ShopLedger(const Shops& shops) : shops_(shops), goods_(shops.shops().size(), 0.0), used_(goods_.size()) {}
  /// `price` is paid for what is not owned of it.
  void take(const PartUse& use, double owned, double price);
  /// Those that something is bought from.
  [[nodiscard]] std::vector<ShopOrder> orders() const;

 private:
  const Shops& shops_;
  std::vector<double> goods_;
  std::vector<bool> used_;
};

}  // namespace millwright::evaluation
