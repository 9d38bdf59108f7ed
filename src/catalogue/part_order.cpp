// SPDX-License-Identifier: Apache-2.0
//
// The order of a table's rows that does not hang on files.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>

#include "catalogue/table.h"

namespace millwright::catalogue {
namespace {

struct NamedRow {
  std::string_view part_number;
  int row = 0;
};

bool is_before(double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; }

/// By the cells that are left when the names are the same: other points of one curve, another seller.
bool cells_are_before(const Table& table, int a, int b) {
  for (std::size_t index = 0; index < column_count(table.family()); ++index) {
    const Column column{table.family(), static_cast<std::uint8_t>(index)};
    if (declaration(column).kind == Kind::text) {
      if (const int order = table.text(column, a).compare(table.text(column, b)); order != 0) return order < 0;
    } else {
      const double of_a = table.number(column, a), of_b = table.number(column, b);
      if (is_before(of_a, of_b)) return true;
      if (is_before(of_b, of_a)) return false;
    }
  }
  return table.ownership(a) < table.ownership(b);
}

std::vector<int> sorted_rows(const Table& table) {
  std::map<std::string_view, std::vector<NamedRow>> of_maker;
  for (int row = 0; row < table.rows(); ++row)
    of_maker[table.manufacturer(row)].push_back({table.part_number(row), row});
  std::vector<int> rows;
  rows.reserve(static_cast<std::size_t>(table.rows()));
  for (auto& [maker, named] : of_maker) {
    std::stable_sort(named.begin(), named.end(), [&](const NamedRow& a, const NamedRow& b) {
      const int order = a.part_number.compare(b.part_number);
      return order != 0 ? order < 0 : cells_are_before(table, a.row, b.row);
    });
    for (const NamedRow& each : named) rows.push_back(each.row);
  }
  return rows;
}

}  // namespace

std::span<const int> Table::rows_in_order() const {
  return *order_.get([&] { return sorted_rows(*this); });
}

}  // namespace millwright::catalogue
