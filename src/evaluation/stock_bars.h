// SPDX-License-Identifier: Apache-2.0
//
// Parts that are sold in whole bars: the pieces that all axes cut of one row of a catalogue come from as few bars as
// possible, and whole bars are paid. How many that takes is known only when all stages are decided, so every stage
// charges its lengths at the least that a metre can cost, says by a number which pieces it takes, and the last one
// charges what is missing:
//
//   stage: price += metre * lengths, code += pieces' number     ...     last stage: price += charge(code)
//
// charge(code) = bars for all pieces of that code - metre * their lengths, and metre is the largest with which that is
// never less than nothing. Where no two stages can share a bar each charges the bars for its own pieces, and nothing is
// left to charge.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/bar_packing.h"
#include "evaluation/counted_parts.h"
#include "evaluation/late_charge.h"
#include "evaluation/ledger.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"
#include "machine/problem.h"

namespace millwright::evaluation {

struct BarStock : LateCharge {
  catalogue::Family family{};
  int row = 0;  ///< in the catalogue's table
  BarSize size;
  double bar_price = 0.0;  ///< in the problem's currency
  double share = 1.0;      ///< bars that the stages charge a metre, if bars are shared
  [[nodiscard]] bool is_shared() const { return any.upper > 0.0; }
};

class StockBars {
 public:
  /// The slot of a stage.
  struct Place {
    std::size_t stage = 0, slot = 0;
    friend bool operator<(const Place& a, const Place& b) {
      return std::tie(a.stage, a.slot) < std::tie(b.stage, b.slot);
    }
  };

  StockBars(const catalogue::Catalogue& catalogue, const PriceBook& prices, const machine::Problem& problem)
      : catalogue_(catalogue), prices_(prices), problem_(problem) {}

  /// Looks what the candidates of a stage cut from bars.
  void find(std::size_t stage, const std::string& axis, std::span<const SlotTable> tables);
  /// Works out what is charged; the state vector has the codes from `first_state` on. Returns how many components that
  /// takes. Throws Refusal where a row can be cut to too many lengths.
  std::size_t settle(std::size_t first_state);
  /// After settle(): candidates of the stage cost what they do at the least.
  void reprice(std::size_t stage, std::vector<SlotTable>& tables) const;
  /// After settle(): what the candidates of the stage add to the codes, by slot.
  [[nodiscard]] std::vector<PieceCount> counts(std::size_t stage, std::span<const SlotTable> tables) const;

  /// What the stages charge for a part that is cut from bars, beside work on its pieces.
  [[nodiscard]] double charged(const BarStock& stock, const std::vector<double>& lengths) const;

  /// After settle(): whether of every set of pieces that a build can take the bars are proved to be the fewest.
  [[nodiscard]] bool all_fewest() const { return all_fewest_; }

  [[nodiscard]] std::vector<BarStock>& stocks() { return stocks_; }
  [[nodiscard]] const std::vector<BarStock>& stocks() const { return stocks_; }
  /// Where a candidate's part is cut from; none where it is no bar's.
  [[nodiscard]] std::optional<std::size_t> stock_of(Place place, const PartUse& use) const;

 private:
  using Lengths = std::vector<double>;  ///< m, of the pieces of one candidate, descending
  using Key = std::pair<catalogue::Family, int>;
  /// One or more slots that may take pieces: up to `most` times the only ones, or else any of several.
  struct Digit {
    std::vector<Lengths> pieces;
    std::size_t most = 0;
    [[nodiscard]] std::size_t values() const { return (pieces.size() == 1 ? most : pieces.size()) + 1; }
    friend bool operator<(const Digit& a, const Digit& b) {
      return std::tie(a.pieces, a.most) < std::tie(b.pieces, b.most);
    }
  };
  /// What a slot adds to which code.
  struct Code {
    std::size_t stock = 0;
    std::vector<double> of_pieces;  ///< [as in `found_`]
  };

  [[nodiscard]] bool is_cut(const PartUse& use) const;
  [[nodiscard]] Lengths lengths_of(const PartUse& use, const std::string& axis) const;
  void settle_row(Key row, std::size_t first_state);
  [[noreturn]] void refuse(Key row) const;
  void fill(BarStock& stock, const std::vector<Digit>& digits);

  const catalogue::Catalogue& catalogue_;
  const PriceBook& prices_;
  const machine::Problem& problem_;
  std::vector<std::string> axis_of_;  ///< [stage]
  std::map<Key, std::map<Place, std::vector<Lengths>>> found_;
  std::vector<Key> in_order_;  ///< of found_, as candidates name them: not by where they stand in files
  std::map<std::pair<Key, Place>, Code> codes_;
  std::vector<BarStock> stocks_;
  /// Bars and metres of each code, of digits that several rows have in common.
  std::map<std::tuple<double, double, std::vector<Digit>>, std::vector<std::pair<double, double>>> packed_;
  std::size_t components_ = 0;
  bool all_fewest_ = true;
};

/// Goes through the parts of a build and says which bar each piece is cut from.
class StockBarsLedger {
 public:
  StockBarsLedger(const StockBars& bars, const catalogue::Catalogue& catalogue) : bars_(bars), catalogue_(catalogue) {}

  /// Before anything is asked: every part of the build.
  void take(StockBars::Place place, const std::string& axis, const PartUse& use, const std::vector<Cut>& cuts);
  void finish();
  /// What a line costs beside its own price: lengths share the bars.
  [[nodiscard]] double share(StockBars::Place place, const PartUse& use, const std::vector<Cut>& cuts) const;
  [[nodiscard]] std::vector<BarPurchase> purchases() const { return purchases_; }

 private:
  const StockBars& bars_;
  const catalogue::Catalogue& catalogue_;
  std::map<std::size_t, std::vector<BarPiece>> pieces_;  // by stock
  std::map<std::size_t, double> metre_;                  // by stock, what one costs
  std::vector<BarPurchase> purchases_;
};

}  // namespace millwright::evaluation
