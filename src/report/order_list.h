// SPDX-License-Identifier: Apache-2.0
// What to buy for a build: equal parts of all axes in one line, grouped by who sells them, and what is to be cut from
// what is sold by length. The bill of materials (bom_csv.h) says what is where; this says what to order.
#pragma once

#include <string>
#include <vector>

#include "evaluation/ledger.h"

namespace millwright::report {

/// In the place of a supplier.
inline constexpr const char* in_stock = "(in stock)";

/// What to verify of a part that only a publication names.
inline constexpr const char* paper_only_note = "known only from a paper";

struct OrderLine {
  double quantity = 0.0;
  std::string unit;  ///< "pcs", "m" or "kg"
  std::string description, manufacturer, part_number;
  std::string supplier;     ///< empty where the catalogue does not say; `in_stock` for what is owned
  double unit_price = 0.0;  ///< per `unit`
  double total = 0.0;
  std::string price_date;       ///< "2026-09-03", "2024-2026", "2026"; empty where the catalogue does not say
  bool price_estimate = false;  ///< nobody has quoted this price
  std::string converted_at;     ///< "1 EUR = 1.08 USD (2026-01-15)"; empty for what is stated in the list's currency
  std::string used_for;         ///< "x.motor, y.motor"
  bool paper_only = false;      ///< only a publication names the part: does any maker sell it?
  std::size_t family = 0;       ///< place of its kind in the order, as the catalogues'
};

struct SupplierTotal {
  std::string supplier;  ///< empty for what has none
  double total = 0.0;    ///< of the lines
  double shipping_fee = 0.0;
  double minimum_order = 0.0;
  double top_up = 0.0;       ///< what the lines lack of the minimum
  std::string converted_at;  ///< of fee and minimum, as of a line
  [[nodiscard]] double charged() const { return total + shipping_fee + top_up; }
};

/// Equal pieces of one stock part for one slot.
struct CutLine {
  std::string description, manufacturer, part_number;
  std::string axis, slot;
  std::string section;  ///< "diameter 12.4 mm" of what is made to measure
  double count = 0.0;
  double length = 0.0;  ///< m, of one piece
  std::size_t bar = 0;  ///< which of the bars that are bought, from 1 on; 0 where none are
};

/// What is cut of one stock part.
struct StockTotal {
  std::string description, manufacturer, part_number;
  double pieces = 0.0;
  double length = 0.0;  ///< m, in all
  std::string bars;     ///< "2 bars of 2000 mm, left over 310 and 45 mm"; empty where no whole bars are bought
};

struct OrderList {
  std::string title, currency;
  std::vector<OrderLine> lines;                ///< by supplier (none last), kind, maker and part number
  std::vector<SupplierTotal> supplier_totals;  ///< in the order of the lines
  double total = 0.0;                          ///< the cost of the build, which lines, shipping and top-ups add up to
  std::vector<CutLine> cuts;                   ///< by stock part; the longest first
  std::vector<StockTotal> stock;               ///< in the order of the cuts
};

OrderList order_list(const evaluation::Design& design, const std::string& title);

/// The day, or else the years, that a price basis names ("list price, read 2026-09-27"); empty if it names none.
std::string price_date(const std::string& basis);

}  // namespace millwright::report
