// SPDX-License-Identifier: Apache-2.0
#include "evaluation/price_book.h"

#include <cmath>
#include <limits>

namespace millwright::evaluation {

PriceBook::PriceBook(const machine::Problem& problem, const catalogue::Catalogue& catalogue)
    : premium_(problem.preference), stock_(catalogue.stock()), suppliers_(catalogue.suppliers()) {
  for (const auto& [currency, rate] : problem.currencies) rates_[currency] = rate.rate;
  rates_.try_emplace(problem.currency, 1.0);
  for (const machine::Axis& axis : problem.axes) drives_ += static_cast<double>(axis.mechanism.drives);
  constexpr double slots_of_axis = 4.0;  // at most, that may take the same part
  for (const machine::Spare& spare : problem.spares)
    spares_ += slots_of_axis * spare.pieces * static_cast<double>(problem.axes.size());
}

double PriceBook::rate(std::string_view currency) const {
  const auto found = rates_.find(currency);
  return found == rates_.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

double PriceBook::owned(const catalogue::Table& table, int row) const {
  return table.ownership(row) == catalogue::Ownership::none ? 0.0 : catalogue::owned_pieces(table, row, stock_);
}

const catalogue::Supplier* PriceBook::charging_supplier(const catalogue::Table& table, int row) const {
  if (suppliers_.suppliers.empty() || table.ownership(row) == catalogue::Ownership::only) return nullptr;
  const catalogue::Supplier* supplier = suppliers_.find(table.text(catalogue::column(table.family(), "supplier"), row));
  return supplier != nullptr && supplier->charges() ? supplier : nullptr;
}

double PriceBook::preference(const catalogue::Table& table, int row) const {
  constexpr double at_most = 1e-6;  // what costs just the premium more, or as much, is still chosen
  return premium_ && catalogue::is_preferred(table, row, stock_) ? 1.0 / ((1.0 + *premium_) * (1.0 + at_most)) : 1.0;
}

double PriceBook::most_pieces(catalogue::Family family) const {
  switch (family) {
    case catalogue::Family::steppers:
    case catalogue::Family::drivers:
      return drives_ + spares_;
    case catalogue::Family::power_supplies:
      return 1.0 + spares_;
    case catalogue::Family::screws:
      return 1000.0 + spares_;  // as many as its joints have
    default:
      return 4.0 * drives_ + spares_;  // supports at both ends, pulleys on both sides of a belt and of a reduction
  }
}

bool PriceBook::is_counted(const catalogue::Table& table, int row) const {
  if (owned(table, row) > 0.0) return true;
  const catalogue::PiecePrice price = table.piece_price(row);
  return !price.is_plain() && !price.is_plain_up_to(most_pieces(table.family()));
}

double PriceBook::least_piece(const catalogue::Table& table, int row) const {
  if (owned(table, row) > 0.0) return 0.0 * rate(table.price(row).currency);
  return table.piece_price(row).least(most_pieces(table.family())) * rate(table.price(row).currency);
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

namespace {

/// A number that not every family has; 0 where it is not stated.
double number_or_nothing(const catalogue::Table& table, int row, std::string_view name) {
  const auto column = catalogue::find_column(table.family(), name);
  const double value = column ? table.number(*column, row) : 0.0;
  return value > 0.0 ? value : 0.0;
}

}  // namespace

PieceWork PriceBook::work(const catalogue::Table& table, int row) const {
  const double in_problem = rate(table.price(row).currency);
  return {number_or_nothing(table, row, "cutting_loss"),
          number_or_nothing(table, row, "cut_price") * in_problem,
          number_or_nothing(table, row, "end_machining_price") * in_problem};
}

std::optional<PriceBook::Bar> PriceBook::bar(const catalogue::Table& table, int row) const {
  const double length = number_or_nothing(table, row, "stock_length");
  const catalogue::Price price = table.price(row);
  if (!(length > 0.0) || std::isnan(price.length)) return std::nullopt;
  return Bar{{length, number_or_nothing(table, row, "cutting_loss")}, length * price.length * rate(price.currency)};
}

double PriceBook::cut(const catalogue::Table& table, int row, const std::vector<CutPieces>& pieces) const {
  const catalogue::Price price = table.price(row);
  const std::optional<Bar> whole = bar(table, row);
  const PieceWork each = work(table, row);
  const double lost = whole ? 0.0 : each.cutting_loss;
  double sum = 0.0;
  for (const CutPieces& cut : pieces) {
    const bool is_known = !std::isnan(cut.length);
    if (whole && is_known && !whole->size.holds(cut.length)) return std::numeric_limits<double>::infinity();
    sum += cut.count * ((cut.length + lost) * price.length * rate(price.currency) + each.cutting +
                        cut.machined_ends * each.machined_end);
  }
  return sum;
}

}  // namespace millwright::evaluation
