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

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/ledger.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"

namespace millwright::evaluation {

/// What more pieces than there are would cost: nothing pays so much (MachineModel).
inline constexpr double beyond_reach = 1e15;

struct CountedPart {
  catalogue::Family family{};
  int row = 0;                            ///< in the catalogue's table
  double owned = 0.0;                     ///< pieces that are there
  catalogue::PiecePrice price;            ///< of the others, in the part's currency
  double rate = 1.0;                      ///< of that currency, in the problem's
  bool only_owned = false;                ///< no more of them than are there can be taken
  std::optional<std::size_t> whole = {};  ///< then: the counted part that its pieces count among, too
  std::optional<std::size_t> shop;        ///< where it is bought, if that is one of Shops
  double least = 0.0;                     ///< what the stages charge for a piece, in the problem's currency
  std::size_t state = 0;                  ///< where the state vector counts them
  std::vector<double> charge;             ///< [pieces taken], in the problem's currency

  /// What has to be bought for so many pieces, in the problem's currency.
  [[nodiscard]] catalogue::PiecePrice::Purchase purchase(double pieces) const;
};

/// How many pieces of a counted part the rows of a slot take.
struct PieceCount {
  std::size_t slot = 0;
  std::size_t state = 0;
  std::vector<double> of_row;  ///< [row of the slot's table]
};

namespace detail {

struct Pieces {
  std::size_t least = 0, most = 0;
};

/// The numbers of pieces in [lower, upper], which are whole but for rounding.
inline Pieces pieces_between(const CountedPart& part, double lower, double upper) {
  constexpr double rounding = 1e-6;
  const double last = static_cast<double>(part.charge.size() - 1);
  const double least = std::min(std::max(std::floor(lower + rounding), 0.0), last);
  const double most = std::min(std::max(std::ceil(upper - rounding), least), last);
  return {static_cast<std::size_t>(least), static_cast<std::size_t>(most)};
}

/// How much the next piece costs, over these numbers of pieces and their neighbours.
inline scalar::Interval next_piece(const CountedPart& part, Pieces pieces) {
  scalar::Interval range(0.0);
  bool any = false;
  const std::size_t first = pieces.least == 0 ? 0 : pieces.least - 1;
  for (std::size_t n = first; n + 1 < part.charge.size() && n <= pieces.most; ++n) {
    const double step = part.charge[n + 1] - part.charge[n];
    range = any ? scalar::Interval(std::min(range.lower, step), std::max(range.upper, step)) : scalar::Interval(step);
    any = true;
  }
  return range;
}

}  // namespace detail

/// What is charged at the end for so many pieces taken.
inline double charge(const CountedPart& part, double taken) {
  return part.charge[detail::pieces_between(part, taken, taken).least];
}

inline scalar::Interval charge(const CountedPart& part, const scalar::Interval& taken) {
  const detail::Pieces pieces = detail::pieces_between(part, taken.lower, taken.upper);
  const auto first = part.charge.begin();
  const auto [least, most] = std::minmax_element(first + static_cast<std::ptrdiff_t>(pieces.least),
                                                 first + static_cast<std::ptrdiff_t>(pieces.most) + 1);
  return {*least, *most};
}

/// The slope is the price of the next piece: with it the charge is a broken line through the whole numbers.
template <class B>
scalar::Dual<B, 1> charge(const CountedPart& part, const scalar::Dual<B, 1>& taken) {
  scalar::Dual<B, 1> result(charge(part, taken.value));
  if constexpr (std::is_same_v<B, scalar::Interval>)
    result.slope[0] =
        taken.slope[0] * detail::next_piece(part, detail::pieces_between(part, taken.value.lower, taken.value.upper));
  else
    result.slope[0] =
        taken.slope[0] * middle(detail::next_piece(part, detail::pieces_between(part, taken.value, taken.value)));
  return result;
}

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

/// Goes through the parts of a build and says what each is charged.
class CountedPartsLedger {
 public:
  explicit CountedPartsLedger(std::span<const CountedPart> parts)
      : parts_(parts), taken_(parts.size(), 0.0), set_aside_(taken_) {}

  /// Before anything is taken: of everything that the build takes, what may only be owned is set aside.
  void set_aside(const PartUse& use);

  struct Share {
    double owned = 0.0;  ///< pieces of it that are there
    double price = 0.0;  ///< of the line, in the problem's currency
  };
  /// By how much the order grows with this line; of a part that is not counted its own price.
  Share take(const PartUse& use);
  /// What has to be bought of the counted parts that were taken.
  [[nodiscard]] std::vector<Purchase> purchases(const catalogue::Catalogue& catalogue) const;

 private:
  std::span<const CountedPart> parts_;
  std::vector<double> taken_;
  std::vector<double> set_aside_;  ///< pieces of a part that lines of owned pieces take
};

}  // namespace millwright::evaluation
