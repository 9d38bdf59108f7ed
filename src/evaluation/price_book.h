// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/bar_packing.h"
#include "machine/problem.h"

namespace millwright::evaluation {

/// Equal pieces that are cut from what is sold by length.
struct CutPieces {
  double count = 1.0;
  double length = 0.0;         ///< m, of one
  double machined_ends = 0.0;  ///< of one, for bearings
};

/// What a piece costs beside its length.
struct PieceWork {
  double cutting_loss = 0.0;  ///< m, paid where no whole bars are
  double cutting = 0.0;       ///< in the problem's currency
  double machined_end = 0.0;  ///< of one end, in the problem's currency
};

/// Turns catalogue prices into the problem's currency. Rows in a currency without a rate are not for sale.
class PriceBook {
 public:
  PriceBook(const machine::Problem& problem, const catalogue::Catalogue& catalogue);
  /// What one unit of `currency` is worth in the problem's currency; NaN if no rate is given.
  [[nodiscard]] double rate(std::string_view currency) const;
  /// Pieces of a row's part that are there already and cost nothing, as far as this row stands for them.
  [[nodiscard]] double owned(const catalogue::Table& table, int row) const;
  /// Whether its price depends on how many the whole machine takes (counted_parts.h): not where all that it can take
  /// cost the same.
  [[nodiscard]] bool is_counted(const catalogue::Table& table, int row) const;
  /// Where a row's part is ordered, if an order there costs more than the part; else null.
  [[nodiscard]] const catalogue::Supplier* charging_supplier(const catalogue::Table& table, int row) const;
  /// By what the price of a row is multiplied where builds are compared: less than 1 for a preferred part.
  [[nodiscard]] double preference(const catalogue::Table& table, int row) const;
  /// The least that a piece of such a part can cost, in the problem's currency.
  [[nodiscard]] double least_piece(const catalogue::Table& table, int row) const;
  /// Price of whole pieces plus a length; of what is counted the least that so many pieces can cost.
  /// Parts of the price that the row does not have count as 0. NaN if nothing is priced.
  [[nodiscard]] double line(const catalogue::Table& table, int row, double pieces, double metres) const;
  /// Price of pieces that are cut, with what is done to them; where whole bars are sold their lengths cost what they do
  /// of a bar without waste (stock_bars.h). NaN if the row has no price by length, or a length is not known; infinity
  /// if a piece is longer than its bar.
  [[nodiscard]] double cut(const catalogue::Table& table, int row, const std::vector<CutPieces>& pieces) const;
  /// What a row says of work on pieces; nothing of what it does not say.
  [[nodiscard]] PieceWork work(const catalogue::Table& table, int row) const;

  struct Bar {
    BarSize size;
    double price = 0.0;  ///< in the problem's currency
  };
  /// Where a row is sold in whole bars.
  [[nodiscard]] std::optional<Bar> bar(const catalogue::Table& table, int row) const;

 private:
  std::map<std::string, double, std::less<>> rates_;
  /// How many pieces of one part of that family the machine can take.
  [[nodiscard]] double most_pieces(catalogue::Family family) const;

  double drives_ = 0.0;  ///< of all axes
  double spares_ = 0.0;  ///< no more than so many of one part
  std::optional<double> premium_;
  catalogue::Stock stock_;
  catalogue::Suppliers suppliers_;
};

}  // namespace millwright::evaluation
