// SPDX-License-Identifier: Apache-2.0
#include "catalogue/cell_text.h"

#include <cmath>

#include "catalogue/column_unit.h"

namespace millwright::catalogue {

std::string shown_unit(const Table& table, Column column, int row) {
  const ColumnDeclaration& declared = declaration(column);
  if (declared.kind == Kind::money) {
    const std::string currency(table.text("currency", row));
    return declared.unit.empty() ? currency : currency + std::string(declared.unit.substr(1));
  }
  return declared.unit == "1" ? std::string() : std::string(declared.unit);
}

std::string cell_text(const Table& table, Column column, int row, int digits) {
  const Kind kind = declaration(column).kind;
  if (kind == Kind::text) return std::string(table.text(column, row));
  const double si = table.number(column, row);
  if (std::isnan(si)) return {};
  if (kind == Kind::flag) return si != 0.0 ? "yes" : "no";
  const std::string unit = shown_unit(table, column, row);
  const std::string value = scalar::format_number(display_unit(column).from_si(si), digits);
  return unit.empty() ? value : value + " " + unit;
}

}  // namespace millwright::catalogue
