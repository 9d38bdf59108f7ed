// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"
#include "machine/problem.h"

namespace millwright::evaluation {

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
  /// The least that a piece of such a part can cost, in the problem's currency.
  [[nodiscard]] double least_piece(const catalogue::Table& table, int row) const;
  /// Price of whole pieces plus a length; of what is counted the least that so many pieces can cost.
  /// Parts of the price that the row does not have count as 0. NaN if nothing is priced.
  [[nodiscard]] double line(const catalogue::Table& table, int row, double pieces, double metres) const;

 private:
  std::map<std::string, double, std::less<>> rates_;
  /// How many pieces of one part of that family the machine can take.
  [[nodiscard]] double most_pieces(catalogue::Family family) const;

  double drives_ = 0.0;  ///< of all axes
  double spares_ = 0.0;  ///< no more than so many of one part
  catalogue::Stock stock_;
  catalogue::Suppliers suppliers_;
};

}  // namespace millwright::evaluation
