// SPDX-License-Identifier: Apache-2.0
// Rows found by a hash of their key: open addressing, no copies of the keys. Half of the hash is kept, so that the keys
// of rows that merely share a place are not looked at: they lie anywhere in memory.
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
    slots_.assign(size, Slot{});
  }

  static constexpr std::int32_t none = -1;

  /// Announces that this hash will be asked for soon.
  void prefetch(std::uint64_t hash) const {
    __builtin_prefetch(&slots_[static_cast<std::size_t>(hash) & (slots_.size() - 1)]);
  }

  /// The row with that hash for which same(row) holds, or `none`.
  template <class Same>
  std::int32_t find(std::uint64_t hash, const Same& same) const {
    return slots_[slot_of(hash, same)].row;
  }

  /// Adds `row` unless an equal one is there; returns that one, or `none` if added.
  template <class Same>
  std::int32_t insert(std::uint64_t hash, std::int32_t row, const Same& same) {
    Slot& slot = slots_[slot_of(hash, same)];
    if (slot.row != none) return slot.row;
    slot = {row, tag_of(hash)};
    return none;
  }

 private:
  struct Slot {
    std::int32_t row = none;
    std::uint32_t tag = 0;
  };

  static std::uint32_t tag_of(std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 32U); }

  template <class Same>
  std::size_t slot_of(std::uint64_t hash, const Same& same) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(hash) & mask;
    const std::uint32_t tag = tag_of(hash);
    while (slots_[at].row != none && (slots_[at].tag != tag || !same(slots_[at].row))) at = (at + 1) & mask;
    return at;
  }

  std::vector<Slot> slots_;
};

}  // namespace millwright::catalogue
