// SPDX-License-Identifier: Apache-2.0
#include "evaluation/price_book.h"

#include <cmath>
#include <limits>

namespace millwright::evaluation {

PriceBook::PriceBook(const machine::Problem& problem, const catalogue::Stock& stock) : stock_(stock) {
  for (const auto& [currency, rate] : problem.currencies) rates_[currency] = rate.rate;
  rates_.try_emplace(problem.currency, 1.0);
}

double PriceBook::rate(std::string_view currency) const {
  const auto found = rates_.find(currency);
  return found == rates_.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

double PriceBook::owned(const catalogue::Table& table, int row) const {
  if (stock_.empty()) return 0.0;
  const catalogue::StockMark* mark = stock_.find(table.family(), table.manufacturer(row), table.part_number(row));
  return mark == nullptr ? 0.0 : mark->owned;
}

bool PriceBook::is_counted(const catalogue::Table& table, int row) const {
  return owned(table, row) > 0.0 || !table.piece_price(row).is_plain();
}

double PriceBook::least_piece(const catalogue::Table& table, int row) const {
  const double least = owned(table, row) > 0.0 ? 0.0 : table.piece_price(row).least();
  return least * rate(table.price(row).currency);
}

double PriceBook::line(const catalogue::Table& table, int row, double pieces, double metres) const {
  const catalogue::Price price = table.price(row);
  const bool by_piece = !std::isnan(price.piece) && pieces > 0.0;
  const bool by_length = !std::isnan(price.length) && metres > 0.0;
  if (!by_piece && !by_length) return std::numeric_limits<double>::quiet_NaN();
  if (metres > 0.0 && !by_length) return std::numeric_limits<double>::quiet_NaN();
  const double amount = (by_piece ? pieces * price.piece : 0.0) + (by_length ? metres * price.length : 0.0);
  if (by_piece && is_counted(table, row)) return pieces * least_piece(table, row);
  return amount * rate(price.currency);
}

}  // namespace millwright::evaluation
