// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "catalogue/read_table.h"
#include "catalogue/row_index.h"

namespace millwright::catalogue {

void drop_duplicates(Table& table, text::Diagnostics& diagnostics) {
  RowIndex seen(static_cast<std::size_t>(table.rows()));
  std::vector<bool> keep(static_cast<std::size_t>(table.rows()), true);
  bool all_kept = true;
  // Where the rows of a block belong lies anywhere in memory, so it is sent for before it is needed.
  constexpr int block = 32;
  std::array<std::uint64_t, block> hashes{};
  for (int row = 0; row < table.rows(); ++row) {
    for (int i = 0; row % block == 0 && i < std::min(block, table.rows() - row); ++i) {
      hashes[static_cast<std::size_t>(i)] = table.part_hash(row + i, Identity::point);
      seen.prefetch(hashes[static_cast<std::size_t>(i)]);
    }
    const auto same = [&](int there) { return table.same_part(row, table, there, Identity::point); };
    const int first = seen.insert(hashes[static_cast<std::size_t>(row % block)], row, same);
    if (first == RowIndex::none) continue;
    keep[static_cast<std::size_t>(row)] = all_kept = false;
    text::Diagnostic duplicate;
    duplicate.where = table.where(row);
    const bool is_point = table.family() == Family::stepper_curves;
    duplicate.message = fmt::format("duplicate {} {} of {}",
                                    is_point ? "point of a curve of" : "part",
                                    text::in_quotes(table.part_number(row)),
                                    text::in_quotes(table.manufacturer(row)));
    duplicate.hint = is_point
                         ? "a speed stands once for a voltage, current, driver and step mode, whatever the kind of "
                           "current; to replace a curve use an overlay folder"
                         : "a part stands once in a folder; to replace it use an overlay folder";
    duplicate.related = table.where(first);
    duplicate.related_message = "first given here";
    diagnostics.add(std::move(duplicate));
  }
  if (!all_kept) table.keep_only(keep);
}

}  // namespace millwright::catalogue
