// SPDX-License-Identifier: Apache-2.0
#include "evaluation/short_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/cuts.h"
#include "scalar/unit.h"

namespace millwright::evaluation {
namespace {

/// The same parts, all of them sold by the metre; nothing where none comes in bars.
std::optional<catalogue::Catalogue> without_bars(const catalogue::Catalogue& parts) {
  std::optional<catalogue::Catalogue> result;
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    const auto stock = catalogue::find_column(family.family, "stock_length");
    if (!stock) continue;
    for (int row = 0; row < parts.table(family.family).rows(); ++row) {
      if (!(parts.table(family.family).number(*stock, row) > 0.0)) continue;
      if (!result) result = parts;
      result->changeable_table(family.family).set_number(row, *stock, std::numeric_limits<double>::quiet_NaN());
    }
  }
  return result;
}

/// Of what fits and is cut from bars: the shortest that a piece of it can be, and the longest bar.
struct Shortage {
  double piece = std::numeric_limits<double>::infinity();  ///< m
  double bar = 0.0;                                        ///< m
  std::string part;                                        ///< that has the longest bar
};

void look_at(const MachineModel& model, const std::string& axis, const SlotTable& table, Shortage& shortage) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const PartUse& use : table.candidate(row).parts) {
      if (!use.stated.empty() || !(use.length > 0.0)) continue;
      const catalogue::Table& rows = model.catalogue().table(use.family);
      const auto bar = model.prices().bar(rows, use.row);
      if (!bar) continue;
      double longest = 0.0;
      for (const Cut& cut : cuts_of(model.machine(), use, axis)) longest = std::max(longest, cut.length);
      shortage.piece = std::min(shortage.piece, longest);
      if (bar->size.stock_length <= shortage.bar) continue;
      shortage.bar = bar->size.stock_length;
      shortage.part = fmt::format("{} {}", rows.manufacturer(use.row), rows.part_number(use.row));
    }
}

}  // namespace

std::string short_bars(const MachineModel& model, const std::string& axis, const std::string& slot) {
  const auto parts = without_bars(model.catalogue());
  if (!parts) return {};
  const MachineModel by_the_metre(model.machine(), *parts);
  Shortage shortage;
  for (const StageEntry& entry : by_the_metre.entries())
    for (const SlotTable& table : entry.tables())
      if (entry.axis == axis && table.name() == slot) look_at(model, axis, table, shortage);
  if (!(shortage.bar > 0.0)) return {};
  const auto millimetres = [](double metres) { return scalar::format_number(1e3 * metres); };
  return fmt::format(
      "what fits axis '{}' there is sold in bars of at most {} mm ({}), and the shortest piece that it takes is {} mm",
      axis,
      millimetres(shortage.bar),
      shortage.part,
      millimetres(shortage.piece));
}

}  // namespace millwright::evaluation
