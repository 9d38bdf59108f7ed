// SPDX-License-Identifier: Apache-2.0
#include "evaluation/incomplete_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "evaluation/held_parts.h"

namespace millwright::evaluation {
namespace {

using catalogue::Column;
using catalogue::Family;
using catalogue::Table;

/// Prices that everything for sale in a family has.
std::vector<Column> prices_of(Family family) {
  std::vector<Column> prices;
  if (catalogue::declaration(family).priced_per_piece) prices.push_back(catalogue::column(family, "price"));
  if (catalogue::declaration(family).priced_per_length) prices.push_back(catalogue::column(family, "price_per_length"));
  return prices;
}

/// "inertia"; "materials.yield_strength" of another family.
std::string column_name(Column column, Family family) {
  const std::string_view name = catalogue::declaration(column).name;
  if (column.family == family) return std::string(name);
  return fmt::format("{}.{}", catalogue::declaration(column.family).name, name);
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
  /// Whether something that can be chosen there does without it.
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

/// What parts lack, by family and name.
using Lacking = std::map<std::pair<Family, std::string>, std::vector<std::string>>;

std::vector<IncompleteParts> grouped(const Lacking& lacking, const std::map<Family, std::size_t>& known) {
  std::vector<IncompleteParts> all;
  for (const auto& [part, lacks] : lacking) {
    const std::string family(catalogue::declaration(part.first).name);
    auto group = std::find_if(all.begin(), all.end(), [&, &missing = lacks](const IncompleteParts& each) {
      return each.family == family && each.missing == missing;
    });
    if (group == all.end()) group = all.insert(group, {family, lacks, {}, known.at(part.first)});
    group->parts.push_back(part.second);
  }
  std::stable_sort(all.begin(), all.end(), [](const IncompleteParts& a, const IncompleteParts& b) {
    const auto first = catalogue::find_family(a.family), second = catalogue::find_family(b.family);
    return first != second ? first < second : a.parts.size() > b.parts.size();
  });
  return all;
}

void add_new(std::vector<std::string>& words, const std::string& word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

/// Parts with what they lack, gathered slot by slot.
class Gathered {
 public:
  explicit Gathered(const catalogue::Catalogue& catalogue) : catalogue_(catalogue) {}

  void add(const SlotTable& slot) {
    if (slot.incomplete().empty()) return;
    const std::set<Part> usable = usable_parts(slot);
    MissingFigures figures(catalogue_, slot);
    for (const IncompleteRow& row : slot.incomplete()) {
      const Part part = part_of(row.part);
      if (usable.contains(part)) continue;
      std::vector<std::string>& lacks = lacking_[part];
      for (const Column column : figures.of(row)) add_new(lacks, column_name(column, row.part.family));
    }
  }

  [[nodiscard]] std::vector<IncompleteParts> by_what_is_missing() const {
    Lacking lacking;
    std::map<Family, std::size_t> known;
    for (const auto& [part, lacks] : lacking_) {
      lacking[{part.family, fmt::format("{} {}", part.maker, part.number)}] = lacks;
      if (const auto [count, is_new] = known.try_emplace(part.family); is_new)
        count->second = parts_of(catalogue_.table(part.family));
    }
    return grouped(lacking, known);
  }

 private:
  struct Part {
    Family family;
    std::string_view maker, number;
    friend auto operator<=>(const Part&, const Part&) = default;
  };
  [[nodiscard]] Part part_of(const CatalogueRow& row) const {
    const Table& table = catalogue_.table(row.family);
    return {row.family, table.manufacturer(row.row), table.part_number(row.row)};
  }
  /// Of those that were left out: another offer of the part may serve.
  [[nodiscard]] std::set<Part> usable_parts(const SlotTable& slot) const {
    std::map<Family, std::vector<bool>> rows;  // most stand in many pairs
    for (const IncompleteRow& row : slot.incomplete())
      rows[row.part.family].resize(static_cast<std::size_t>(catalogue_.table(row.part.family).rows()));
    for (const CatalogueRow& row : slot.added())
      if (const auto found = rows.find(row.family); found != rows.end())
        found->second[static_cast<std::size_t>(row.row)] = true;
    std::set<Part> incomplete, parts;
    for (const IncompleteRow& row : slot.incomplete()) incomplete.insert(part_of(row.part));
    for (const auto& [family, added] : rows)
      for (std::size_t row = 0; row < added.size(); ++row)
        if (const Part part = part_of({family, static_cast<int>(row)}); added[row] && incomplete.contains(part))
          parts.insert(part);
    return parts;
  }
  /// How many there are, the offers of one counted once.
  static std::size_t parts_of(const Table& table) {
    std::vector<std::pair<std::string_view, std::string_view>> parts;
    for (int row = 0; row < table.rows(); ++row) parts.emplace_back(table.manufacturer(row), table.part_number(row));
    std::sort(parts.begin(), parts.end());
    return static_cast<std::size_t>(std::unique(parts.begin(), parts.end()) - parts.begin());
  }

  const catalogue::Catalogue& catalogue_;
  std::map<Part, std::vector<std::string>> lacking_;
};

bool is_fixed(const MachineModel& model, const std::string& axis, const SlotTable& slot) {
  return std::ranges::all_of(slots_of(slot), [&](const std::string& name) {
    return std::ranges::any_of(model.options().fixed.lines,
                               [&](const machine::BomLine& line) { return line.axis == axis && line.slot == name; });
  });
}

}  // namespace

std::vector<IncompleteParts> incomplete_parts(const MachineModel& model) {
  Gathered gathered(model.catalogue());
  for (const StageEntry& entry : model.entries())
    for (const SlotTable& slot : entry.tables())
      if (!is_fixed(model, entry.axis, slot)) gathered.add(slot);
  return gathered.by_what_is_missing();
}

std::vector<IncompleteParts> incomplete_parts(const MachineModel& model, const HeldParts& held) {
  Gathered gathered(model.catalogue());
  for (std::size_t stage = 0; stage < held.stages.size(); ++stage) {
    const std::vector<SlotTable>& slots = model.entries()[stage].tables();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
      if (!held.stages[stage].named[slot]) gathered.add(slots[slot]);
  }
  return gathered.by_what_is_missing();
}

std::vector<IncompleteParts> united(std::span<const IncompleteParts> all) {
  Lacking lacking;
  std::map<Family, std::size_t> known;
  for (const IncompleteParts& each : all) {
    const Family family = catalogue::find_family(each.family).value();
    known[family] = each.known;
    for (const std::string& part : each.parts)
      for (std::vector<std::string>& lacks = lacking[{family, part}]; const std::string& figure : each.missing)
        add_new(lacks, figure);
  }
  return grouped(lacking, known);
}

std::vector<IncompleteParts> incomplete_parts(const catalogue::Catalogue& catalogue, const SlotTable& slot) {
  Gathered gathered(catalogue);
  gathered.add(slot);
  return gathered.by_what_is_missing();
}

}  // namespace millwright::evaluation
