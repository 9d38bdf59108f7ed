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
  explicit PriceBook(const machine::Problem& problem, const catalogue::Stock& stock = {});
  /// What one unit of `currency` is worth in the problem's currency; NaN if no rate is given.
  [[nodiscard]] double rate(std::string_view currency) const;
  /// Pieces of a row's part that are there already and cost nothing (owned_parts.h counts them).
  [[nodiscard]] double owned(const catalogue::Table& table, int row) const;
  /// Price of a piece in the problem's currency, of what is sold by the piece.
  [[nodiscard]] double piece(const catalogue::Table& table, int row) const;
  /// Price of whole pieces plus a length, 0 if pieces of it are owned: only the whole machine knows how many it takes.
  /// Parts of the price that the row does not have count as 0. NaN if nothing is priced.
  [[nodiscard]] double line(const catalogue::Table& table, int row, double pieces, double metres) const;

 private:
  std::map<std::string, double, std::less<>> rates_;
  catalogue::Stock stock_;
};

}  // namespace millwright::evaluation
