// SPDX-License-Identifier: Apache-2.0
//
// Parts whose price depends on how many of them the machine takes: some pieces are owned and cost nothing, there are
// price breaks, or only packs are sold. How many a machine takes is known only when all its stages are decided, so
// every stage charges the least that a piece can cost and hands on how many were taken so far; the last one charges
// what is missing:
//
//   stage: price += least * pieces, count += pieces     ...     last stage: price += charge(count)
//
// charge(n) = price of an order of max(0, n - owned) pieces - n * least.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/late_charge.h"
#include "evaluation/ledger.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"

namespace millwright::evaluation {

/// What more pieces than there are would cost: nothing pays so much (MachineModel).
inline constexpr double beyond_reach = 1e15;

struct CountedPart : LateCharge {
  catalogue::Family family{};
  int row = 0;                            ///< in the catalogue's table
  double owned = 0.0;                     ///< pieces that are there
  catalogue::PiecePrice price;            ///< of the others, in the part's currency
  double rate = 1.0;                      ///< of that currency, in the problem's
  bool only_owned = false;                ///< no more of them than are there can be taken
  std::optional<std::size_t> whole = {};  ///< then: the counted part that its pieces count among, too
  double least = 0.0;                     ///< what the stages charge for a piece, in the problem's currency

  /// What has to be bought for so many pieces, in the problem's currency.
  [[nodiscard]] catalogue::PiecePrice::Purchase purchase(double pieces) const;
};

/// How many pieces of a counted part the rows of a slot take, or what else they add up to by row.
struct PieceCount {
  std::size_t slot = 0;
  std::size_t state = 0;
  std::vector<double> of_row;  ///< [row of the slot's table]
  bool is_resource = false;    ///< `state` is the index of a resource
};

/// Finds the counted parts among the candidates of all stages.
class CountedParts {
 public:
  /// The state vector counts them from `first_state` on.
  CountedParts(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::size_t first_state)
      : catalogue_(catalogue), prices_(prices), first_state_(first_state) {}

  /// What the slots of one stage take, by slot.
  std::vector<PieceCount> counts(std::span<const SlotTable> tables);
  /// Those found, with what is charged for as many of them as a build can take.
  [[nodiscard]] std::vector<CountedPart> finish() &&;

 private:
  /// Number among the counted parts; nothing of a part that is not counted.
  std::optional<std::size_t> find_or_add(catalogue::Family family, int row);

  const catalogue::Catalogue& catalogue_;
  const PriceBook& prices_;
  std::size_t first_state_;
  std::vector<CountedPart> parts_;
  std::vector<double> most_;  ///< [part]: pieces that a build can take
};

/// Goes through the parts of a build, twice, and says what each is charged: by then it is known how many are bought.
class CountedPartsLedger {
 public:
  explicit CountedPartsLedger(std::span<const CountedPart> parts);

  /// Of everything that the build takes, before the first share. Pieces that may only be owned are set aside.
  void take(const PartUse& use);

  struct Share {
    double owned = 0.0;  ///< pieces of it that are there
    double price = 0.0;  ///< of the line, in the problem's currency
  };
  /// Line by line: the first ones have what is there; the others pay the same for each piece, together the order. Of a
  /// part that is not counted its own price.
  Share share(const PartUse& use);
  /// What has to be bought of the counted parts that were taken.
  [[nodiscard]] std::vector<Purchase> purchases(const catalogue::Catalogue& catalogue) const;

 private:
  [[nodiscard]] std::optional<std::size_t> find(const PartUse& use) const;
  /// Pieces of those taken that are there.
  [[nodiscard]] double owned(std::size_t part) const;

  std::span<const CountedPart> parts_;
  std::vector<double> taken_;
  std::vector<double> set_aside_;  ///< pieces of a part that lines of owned pieces take
  std::vector<double> listed_;     ///< pieces of the lines that had their share
  std::vector<double> charged_;    ///< what they were charged
};

}  // namespace millwright::evaluation
