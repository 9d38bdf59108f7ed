// SPDX-License-Identifier: Apache-2.0
#include "evaluation/shops.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "evaluation/element_stage.h"

namespace millwright::evaluation {

std::string parts_name(const catalogue::Catalogue& catalogue, const Candidate& candidate) {
  std::string name(candidate.form);
  for (const PartUse& use : candidate.parts) {
    const catalogue::Table& table = catalogue.table(use.family);
    name += use.stated.empty()
                ? fmt::format("{}\n{}\n{}\n", use.slot, table.manufacturer(use.row), table.part_number(use.row))
                : fmt::format("{}\n\n{}\n", use.slot, use.stated);
    name += fmt::format("{} {} {}\n", static_cast<int>(use.family), use.pieces(), use.length);
  }
  for (const Setting& setting : candidate.settings) name += fmt::format("{} {}\n", setting.name, setting.value);
  return name;
}

namespace {

/// Which of two candidates with the same parts is never the better one.
class Comparison {
 public:
  Comparison(const catalogue::Catalogue& catalogue, const PriceBook& prices, const Shops& shops)
      : catalogue_(catalogue), prices_(prices), shops_(shops) {}

  [[nodiscard]] bool beats(const Candidate& by, const Candidate& beaten) const {
    double saved = 0.0, saved_compared = 0.0;
    for (std::size_t i = 0; i < by.parts.size(); ++i) {
      if (by.parts[i].row == beaten.parts[i].row || takes_owned_too(by.parts[i], beaten.parts[i])) continue;
      if (is_counted(by.parts[i]) || is_counted(beaten.parts[i]) || helps_to_minimum(beaten.parts[i])) return false;
      const double saves = beaten.parts[i].price - by.parts[i].price;
      saved += saves;
      saved_compared += preference(by.parts[i]) * saves;
    }
    return saved >= 0.0 && saved_compared >= 0.0;
  }

 private:
  /// The same whoever sells the part.
  [[nodiscard]] double preference(const PartUse& use) const {
    return use.stated.empty() ? prices_.preference(catalogue_.table(use.family), use.row) : 1.0;
  }
  /// Of a part of which some are owned: what may only be one of those, beside what is bought when they are gone.
  [[nodiscard]] bool takes_owned_too(const PartUse& by, const PartUse& beaten) const {
    if (!beaten.stated.empty()) return false;
    const catalogue::Table& table = catalogue_.table(beaten.family);
    return table.ownership(beaten.row) == catalogue::Ownership::only &&
           table.ownership(by.row) == catalogue::Ownership::usual;
  }
  /// What it costs is not known before the end.
  [[nodiscard]] bool is_counted(const PartUse& use) const {
    if (!use.stated.empty()) return false;
    const catalogue::Table& table = catalogue_.table(use.family);
    return prices_.is_counted(table, use.row) || (use.length > 0.0 && prices_.bar(table, use.row));
  }
  [[nodiscard]] bool helps_to_minimum(const PartUse& use) const {
    const auto shop = shops_.shop_of(use);
    return shop && shops_.shops()[*shop].spent_state;
  }

  const catalogue::Catalogue& catalogue_;
  const PriceBook& prices_;
  const Shops& shops_;
};

}  // namespace

void Shops::find(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::span<const SlotTable> tables) {
  for (const SlotTable& table : tables)
    for (std::size_t row = 0; row < table.rows(); ++row)
      for (const PartUse& use : table.candidate(row).parts) {
        if (!use.stated.empty() || supplier_of_.contains({use.family, use.row})) continue;
        const catalogue::Supplier* supplier = prices.charging_supplier(catalogue.table(use.family), use.row);
        if (supplier == nullptr) continue;
        const double rate = prices.rate(supplier->currency);
        supplier_of_[{use.family, use.row}] = supplier->name;
        found_[supplier->name] = {
            supplier->name, rate * supplier->shipping_fee, rate * supplier->minimum_order, {}, {}};
      }
}

std::size_t Shops::settle(std::size_t first_state, bool all_used) {
  std::size_t count = 0;
  for (auto& [name, shop] : found_) {
    if (shop.minimum_order > 0.0) shop.spent_state = first_state + count++;
    if (all_used) shop.used_state = first_state + count++;
    for (const auto& [part, supplier] : supplier_of_)
      if (supplier == name) shop_of_[part] = shops_.size();
    shops_.push_back(shop);
  }
  return count;
}

void Shops::add_floors(std::size_t first_resource, solver::Problem& problem) {
  constexpr std::size_t few = 2;
  SlotShops::Set all = 0;
  std::vector<std::size_t> with_minimum;
  for (std::size_t i = 0; i < shops_.size(); ++i)
    if (shops_[i].spent_state) {
      with_minimum.push_back(i);
      all |= SlotShops::Set{1} << i;
    }
  const auto add = [&](SlotShops::Set set) { floors_.push_back({set, first_resource + floors_.size()}); };
  for (const std::size_t shop : with_minimum) add(SlotShops::Set{1} << shop);
  if (with_minimum.size() > 1) add(all);
  for (const CostFloor& floor : floors_) problem.floors.push_back({cost_resource, floor.resource});
  if (with_minimum.size() > few) return;
  for (const std::size_t shop : with_minimum) problem.states_in_floors.push_back(*shops_[shop].spent_state);
}

std::optional<std::size_t> Shops::shop_of(catalogue::Family family, int row) const {
  const auto found = shop_of_.find({family, row});
  return found == shop_of_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> Shops::shop_of(const PartUse& use) const {
  return use.stated.empty() ? shop_of(use.family, use.row) : std::nullopt;
}

SlotShops::Set Shops::needed(const Candidate& candidate) const {
  SlotShops::Set set = 0;
  for (const PartUse& use : candidate.parts)
    if (const auto shop = shop_of(use)) set |= SlotShops::Set{1} << *shop;
  return set;
}

std::vector<SlotShops> Shops::slots(const catalogue::Catalogue& catalogue,
                                    const PriceBook& prices,
                                    std::span<const SlotTable> tables) const {
  const Comparison comparison(catalogue, prices, *this);
  std::vector<SlotShops> result;
  for (const SlotTable& table : tables) {
    SlotShops& slot = result.emplace_back();
    slot.beaten_by.resize(table.rows());
    std::map<std::string, std::vector<solver::Row>> alike;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      slot.needed.push_back(needed(table.candidate(row)));
      alike[parts_name(catalogue, table.candidate(row))].push_back(static_cast<solver::Row>(row));
    }
    for (const auto& [name, rows] : alike)
      for (const solver::Row row : rows)
        for (const solver::Row by : rows) {
          if (by == row || !comparison.beats(table.candidate(by), table.candidate(row))) continue;
          // Of those that beat each other the first stays.
          if (by < row || !comparison.beats(table.candidate(row), table.candidate(by)))
            slot.beaten_by[row].push_back(by);
        }
  }
  return result;
}

std::vector<PieceCount> Shops::counts(std::span<const SlotTable> tables) const {
  std::vector<PieceCount> result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot)
    for (std::size_t shop = 0; shop < shops_.size(); ++shop) {
      std::vector<double> spent(tables[slot].rows(), 0.0), used(spent);
      bool any = false;
      for (std::size_t row = 0; row < tables[slot].rows(); ++row)
        for (const PartUse& use : tables[slot].candidate(row).parts) {
          if (shop_of(use) != shop) continue;
          spent[row] += use.price;
          used[row] += 1.0;
          any = true;
        }
      if (any && shops_[shop].spent_state) result.push_back({slot, *shops_[shop].spent_state, spent});
      if (any && shops_[shop].used_state) result.push_back({slot, *shops_[shop].used_state, used});
    }
  for (const CostFloor& floor : floors_) add_floor_counts(floor, tables, result);
  return result;
}

/// Nothing of what its shops sell. Of a stage where they sell nothing a floor is the cost (ElementStage).
void Shops::add_floor_counts(const CostFloor& floor,
                             std::span<const SlotTable> tables,
                             std::vector<PieceCount>& counts) const {
  std::vector<PieceCount> more;
  bool any = false;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    PieceCount& count = more.emplace_back();
    count.slot = slot;
    count.state = floor.resource;
    count.is_resource = true;
    for (std::size_t row = 0; row < tables[slot].rows(); ++row) {
      const Candidate& candidate = tables[slot].candidate(row);
      double price = candidate.price;
      for (const PartUse& use : candidate.parts) {
        if (!floor.has(shop_of(use))) continue;
        price -= use.price;
        any = true;
      }
      count.of_row.push_back(std::max(0.0, price));
    }
  }
  if (any) counts.insert(counts.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void ShopLedger::take(const PartUse& use, double owned, double price) {
  const auto shop = shops_.shop_of(use);
  if (!shop || !(use.pieces() > owned)) return;
  used_[*shop] = true;
  goods_[*shop] += price;
}

std::vector<ShopOrder> ShopLedger::orders() const {
  std::vector<ShopOrder> result;
  for (std::size_t i = 0; i < goods_.size(); ++i) {
    if (!used_[i]) continue;
    const Shop& shop = shops_.shops()[i];
    result.push_back(
        {shop.name, goods_[i], shop.shipping_fee, shop.minimum_order, std::max(0.0, shop.minimum_order - goods_[i])});
  }
  return result;
}

}  // namespace millwright::evaluation
