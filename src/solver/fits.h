// SPDX-License-Identifier: Apache-2.0
//
// Which rows of two slots can be in one design together. Of rows with the same fit key one is asked about; each
// question is asked once and its answer kept as a bit; when a split has made row sets smaller, `filter` removes every
// row that no longer has a partner in some other slot, until nothing changes (arc consistency). What remains need not
// fit together; that is what further splits find out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/box.h"

namespace millwright::solver {

class Fits {
 public:
  Fits(const Stage& stage, std::span<const Row> shared);

  [[nodiscard]] bool everything_fits() const { return everything_fits_; }

  /// False when some slot has no row left. `changed` is the slot that became smaller, or any value >= the number of
  /// slots for all of them.
  bool filter(Region& region, std::size_t changed) const;
  /// What `filter` would answer; the region stays as it is, and the stage need not read smaller sets of rows.
  [[nodiscard]] bool possible(const Region& region, std::size_t changed) const;
  /// Rows of a slot with the same number have the same partners in all slots; the numbers count from 0.
  [[nodiscard]] std::span<const std::uint32_t> kinds(std::size_t slot) const { return kinds_[slot]; }

 private:
  /// The rows of a slot by their key towards another slot.
  struct Kinds {
    std::vector<std::uint32_t> of_row;
    std::vector<Row> first;  ///< of each kind
  };
  /// Which kinds of slot b fit those of slot a, as bits; empty when every pair fits.
  struct Pairs {
    std::size_t words = 0;            ///< of one kind
    std::vector<std::uint64_t> bits;  ///< [kind][kind of slot b towards slot a]
    std::size_t kinds = 0;
    std::vector<std::uint32_t> kind;  ///< of every row of slot a: those of one kind have the same partners
  };
  static Kinds kinds_of(const Stage& stage, std::span<const Row> shared, std::size_t slot, std::size_t other);
  /// `fit(k, l)`: whether rows of kind k fit those of kind l of the other slot.
  template <class Fit>
  static Pairs pairs_of(const Kinds& own, const Kinds& other, Fit&& fit);
  [[nodiscard]] const Pairs& pairs(std::size_t a, std::size_t b) const { return pairs_[a * slots_ + b]; }
  Pairs& pairs(std::size_t a, std::size_t b) { return pairs_[a * slots_ + b]; }
  void find_kinds(std::size_t slot);
  /// Asks the stage about every pair of kinds of two slots.
  void ask(const Stage& stage, std::span<const Row> shared, std::size_t a, std::size_t b);
  /// The rows left of every slot that loses some.
  bool narrow(const Region& region, std::size_t changed, std::vector<std::vector<Row>>& fewer) const;
  bool keep_partners(std::span<const std::vector<Row>*> alive,
                     std::vector<std::vector<Row>>& fewer,
                     std::size_t changed,
                     std::size_t other,
                     bool& smaller) const;

  const Stage* stage_;
  std::span<const Row> shared_;
  std::size_t slots_ = 0;
  bool everything_fits_ = true;
  std::vector<Pairs> pairs_;
  std::vector<std::vector<std::uint32_t>> kinds_;  ///< [slot][row]
};

}  // namespace millwright::solver
