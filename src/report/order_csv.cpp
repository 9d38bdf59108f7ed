// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "report/bom_csv.h"
#include "report/order_files.h"

namespace millwright::report {

namespace {

/// Without the last digits of a sum, 24.300000000000004: what is cut off does not add up to a billionth.
std::string plain_number(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  return fmt::format("{}", std::abs(value) < 1e6 ? rounded : value);
}

std::string cell_in_millimetres(double metres) { return plain_number(std::round(metres * 1e6) / 1e3); }

/// A cell that no spreadsheet takes for a formula.
std::string text_cell(const std::string& text) {
  const bool formula = text.find_first_of("=+-@\t\r") == 0;
  return csv_cell(formula ? "'" + text : text);
}

std::string supplier_name(const std::string& supplier) {
  return supplier.empty() ? std::string("supplier not stated") : supplier;
}

}  // namespace

std::string total_label(const SupplierTotal& total) { return "Total, " + supplier_name(total.supplier); }

std::vector<std::pair<std::string, double>> charges(const SupplierTotal& total, const std::string& currency) {
  std::vector<std::pair<std::string, double>> result;
  if (total.shipping_fee > 0.0) result.emplace_back("Shipping, " + supplier_name(total.supplier), total.shipping_fee);
  if (total.top_up > 0.0)
    result.emplace_back(fmt::format("To the minimum order of {} {}, {}",
                                    plain_number(total.minimum_order),
                                    currency,
                                    supplier_name(total.supplier)),
                        total.top_up);
  return result;
}

std::string order_csv(const OrderList& list) {
  std::string out =
      "line,quantity,unit,description,manufacturer,part_number,supplier,unit_price,currency,price_date,price_is,total,"
      "used_for,verify,converted_at\n";
  const std::string currency = text_cell(list.currency);
  std::size_t number = 0;
  for (const OrderLine& line : list.lines)
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       ++number,
                       plain_number(line.quantity),
                       line.unit,
                       text_cell(line.description),
                       text_cell(line.manufacturer),
                       text_cell(line.part_number),
                       text_cell(line.supplier),
                       plain_number(line.unit_price),
                       currency,
                       line.price_date,
                       line.price_estimate ? "estimate" : "",
                       plain_number(line.total),
                       text_cell(line.used_for),
                       line.paper_only ? paper_only_note : "",
                       text_cell(line.converted_at));
  const auto sum = [&](const std::string& label, double total, const std::string& converted_at = {}) {
    out += fmt::format(
        ",,,{},,,,,{},,,{},,,{}\n", text_cell(label), currency, plain_number(total), text_cell(converted_at));
  };
  for (const SupplierTotal& each : list.supplier_totals) {
    for (const auto& [label, charge] : charges(each, list.currency)) sum(label, charge, each.converted_at);
    if (list.supplier_totals.size() > 1) sum(total_label(each), each.charged());
  }
  sum("Total", list.total);
  return out;
}

std::string cutting_csv(const OrderList& list) {
  std::string out = "stock,manufacturer,part_number,axis,slot,section,count,length [mm],sum [mm],bar\n";
  std::size_t cut = 0;
  for (const StockTotal& stock : list.stock) {
    const auto begin = [&](const std::string& axis, const std::string& slot, const std::string& section) {
      return fmt::format("{},{},{},{},{},{}",
                         text_cell(stock.description),
                         text_cell(stock.manufacturer),
                         text_cell(stock.part_number),
                         text_cell(axis),
                         text_cell(slot),
                         text_cell(section));
    };
    for (double pieces = 0.0; pieces < stock.pieces; ++cut) {
      const CutLine& line = list.cuts[cut];
      pieces += line.count;
      out += fmt::format("{},{},{},{},{}\n",
                         begin(line.axis, line.slot, line.section),
                         plain_number(line.count),
                         cell_in_millimetres(line.length),
                         cell_in_millimetres(line.count * line.length),
                         line.bar > 0 ? std::to_string(line.bar) : "");
    }
    out += fmt::format("{},{},,{},{}\n",
                       begin("", "", "sum"),
                       plain_number(stock.pieces),
                       cell_in_millimetres(stock.length),
                       text_cell(stock.bars));
  }
  return out;
}

}  // namespace millwright::report
