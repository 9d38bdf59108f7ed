// SPDX-License-Identifier: Apache-2.0
// The rows of each part number, gathered when they are first asked for: most tables are read and never searched by
// name.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "catalogue/row_index.h"
#include "catalogue/worked_out.h"

namespace millwright::catalogue {

class PartIndex {
 public:
  /// The rows changed.
  void forget() { rows_.forget(); }

  /// The rows whose `part_number(row)` is `wanted`, ascending. Several threads may ask at a time.
  template <class PartNumber>
  std::vector<int> find(std::string_view wanted, int row_count, const PartNumber& part_number) const {
    const std::shared_ptr<const Rows> rows = rows_.get([&] { return gathered(row_count, part_number); });
    std::vector<int> found;
    const auto same = [&](std::int32_t there) { return part_number(there) == wanted; };
    for (std::int32_t row = rows->first.find(hash_of(wanted), same); row != RowIndex::none;
         row = rows->next[static_cast<std::size_t>(row)]) {
      found.push_back(row);
    }
    return found;
  }

 private:
  struct Rows {
    RowIndex first;                  ///< of each part number ...
    std::vector<std::int32_t> next;  ///< ... and for each row the next one of the same part number
  };

  static std::uint64_t hash_of(std::string_view text) { return std::hash<std::string_view>()(text); }

  template <class PartNumber>
  static Rows gathered(int row_count, const PartNumber& part_number) {
    const auto count = static_cast<std::size_t>(row_count);
    Rows rows{RowIndex(count), std::vector<std::int32_t>(count, RowIndex::none)};
    std::vector<std::int32_t> last(count, RowIndex::none);
    for (std::int32_t row = 0; row < row_count; ++row) {
      const std::string_view part = part_number(row);
      const auto same = [&](std::int32_t there) { return part_number(there) == part; };
      const std::int32_t first = rows.first.insert(hash_of(part), row, same);
      const std::int32_t chain = first == RowIndex::none ? row : first;
      if (chain != row) rows.next[static_cast<std::size_t>(last[static_cast<std::size_t>(chain)])] = row;
      last[static_cast<std::size_t>(chain)] = row;
    }
    return rows;
  }

  WorkedOut<Rows> rows_;
};

}  // namespace millwright::catalogue
