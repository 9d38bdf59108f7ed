// SPDX-License-Identifier: Apache-2.0
// Rows found by a hash of their key: open addressing, eight bytes a row, no copies of the keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace millwright::catalogue {

/// A set of row numbers; what makes two rows equal is the caller's business (`same(row)` tells whether the row is the
/// wanted one).
class RowIndex {
 public:
  /// Room for `rows` rows.
  explicit RowIndex(std::size_t rows = 0) {
    std::size_t size = 8;
    while (size < 2 * rows) size *= 2;
    slots_.assign(size, none);
  }

  static constexpr std::int32_t none = -1;

  /// The row with that hash for which same(row) holds, or `none`.
  template <class Same>
  std::int32_t find(std::uint64_t hash, const Same& same) const {
    return slots_[slot_of(hash, same)];
  }

  /// Adds `row` unless an equal one is there; returns that one, or `none` if added.
  template <class Same>
  std::int32_t insert(std::uint64_t hash, std::int32_t row, const Same& same) {
    std::int32_t& slot = slots_[slot_of(hash, same)];
    if (slot != none) return slot;
    slot = row;
    return none;
  }

 private:
  template <class Same>
  std::size_t slot_of(std::uint64_t hash, const Same& same) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(hash) & mask;
    while (slots_[at] != none && !same(slots_[at])) at = (at + 1) & mask;
    return at;
  }

  std::vector<std::int32_t> slots_;
};

}  // namespace millwright::catalogue
