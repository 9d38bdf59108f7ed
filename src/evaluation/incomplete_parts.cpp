// SPDX-License-Identifier: Apache-2.0
#include "evaluation/incomplete_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace millwright::evaluation {
namespace {

using catalogue::Column;
using catalogue::Family;
using catalogue::Table;

/// Which rows of every family.
class RowsOfFamilies {
 public:
  explicit RowsOfFamilies(const catalogue::Catalogue& catalogue) {
    for (const catalogue::FamilyDeclaration& family : catalogue::families)
      rows_.emplace_back(static_cast<std::size_t>(catalogue.table(family.family).rows()));
  }
  void add(const CatalogueRow& part) {
    rows_[static_cast<std::size_t>(part.family)][static_cast<std::size_t>(part.row)] = true;
  }
  [[nodiscard]] const std::vector<bool>& of(Family family) const { return rows_[static_cast<std::size_t>(family)]; }

 private:
  std::vector<std::vector<bool>> rows_;
};

/// Rows by maker and part number; of the offers of a part, the first.
using Names = std::map<std::pair<std::string_view, std::string_view>, int>;

Names names_of(const Table& table, const std::vector<bool>& rows) {
  Names names;
  for (int row = 0; row < table.rows(); ++row)
    if (rows[static_cast<std::size_t>(row)]) names.try_emplace({table.manufacturer(row), table.part_number(row)}, row);
  return names;
}

/// Prices that everything for sale in a family has.
std::vector<Column> prices_of(Family family) {
  std::vector<Column> prices;
  if (catalogue::declaration(family).priced_per_piece) prices.push_back(catalogue::column(family, "price"));
  if (catalogue::declaration(family).priced_per_length) prices.push_back(catalogue::column(family, "price_per_length"));
  return prices;
}

/// What is missing of the rows that were left out of one slot's table.
class MissingFigures {
 public:
  MissingFigures(const catalogue::Catalogue& catalogue, const SlotTable& slot) : catalogue_(catalogue), slot_(slot) {}

  std::vector<Column> of(const IncompleteRow& row) {
    const Table& table = catalogue_.table(row.part.family);
    std::vector<Column> missing;
    for (const Column price : prices_of(row.part.family))
      if (std::isnan(table.number(price, row.part.row)) && !is_dispensable(price)) missing.push_back(price);
    for (const Column column : row.missing)
      if (column.family != row.part.family || !is_dispensable(column)) missing.push_back(column);
    return missing;
  }

 private:
  /// Whether something that can be chosen there does without it: soft checks read it.
  bool is_dispensable(Column column) {
    const auto [found, is_new] = known_.try_emplace({column.family, column.index});
    const std::span<const double> numbers = catalogue_.table(column.family).numbers(column);
    if (is_new)
      found->second = std::any_of(slot_.added().begin(), slot_.added().end(), [&](const CatalogueRow& added) {
        return added.family == column.family && std::isnan(numbers[static_cast<std::size_t>(added.row)]);
      });
    return found->second;
  }

  const catalogue::Catalogue& catalogue_;
  const SlotTable& slot_;
  std::map<std::pair<Family, std::uint8_t>, bool> known_;
};

/// "inertia"; "materials.yield_strength" of another family.
std::string name_of(Column column, Family family) {
  const std::string_view name = catalogue::declaration(column).name;
  if (column.family == family) return std::string(name);
  return fmt::format("{}.{}", catalogue::declaration(column.family).name, name);
}

}  // namespace

std::vector<IncompleteParts> incomplete_parts(const MachineModel& model) {
  const catalogue::Catalogue& catalogue = model.catalogue();
  RowsOfFamilies incomplete(catalogue), complete(catalogue);
  std::map<std::pair<Family, int>, std::vector<Column>> missing;
  for (const StageEntry& entry : model.entries()) {
    for (const SlotTable& slot : entry.tables()) {
      MissingFigures figures(catalogue, slot);
      for (const IncompleteRow& row : slot.incomplete()) {
        incomplete.add(row.part);
        std::vector<Column>& known = missing[{row.part.family, row.part.row}];
        for (const Column column : figures.of(row))
          if (std::find(known.begin(), known.end(), column) == known.end()) known.push_back(column);
      }
      for (const CatalogueRow& part : slot.added()) complete.add(part);
    }
  }
  std::vector<IncompleteParts> result;
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    const Table& table = catalogue.table(family.family);
    const Names left_out = names_of(table, incomplete.of(family.family));
    if (left_out.empty()) continue;
    const Names usable = names_of(table, complete.of(family.family));
    const std::size_t known = names_of(table, std::vector<bool>(incomplete.of(family.family).size(), true)).size();
    std::vector<IncompleteParts> groups;
    for (const auto& [name, row] : left_out) {
      if (usable.contains(name)) continue;
      std::vector<std::string> lacks;
      for (const Column column : missing[{family.family, row}]) lacks.push_back(name_of(column, family.family));
      auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& each) { return each.missing == lacks; });
      if (group == groups.end()) group = groups.insert(group, {std::string(family.name), std::move(lacks), {}, known});
      group->parts.push_back(fmt::format("{} {}", name.first, name.second));
    }
    std::stable_sort(groups.begin(), groups.end(), [](const IncompleteParts& a, const IncompleteParts& b) {
      return a.parts.size() > b.parts.size();
    });
    result.insert(result.end(), groups.begin(), groups.end());
  }
  return result;
}

}  // namespace millwright::evaluation
