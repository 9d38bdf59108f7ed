// SPDX-License-Identifier: Apache-2.0
#include "catalogue/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "catalogue/cell_text.h"
#include "catalogue/difference.h"
#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

constexpr int kept_digits = 15;  // as many as survive the way through decimals

/// Whether the column only says where others come from, or how sure they are.
bool is_provenance(Column column) {
  const std::string_view name = declaration(column).name;
  for (const std::string_view each : {"evidence", "source", "confidence", "note", "waiver"})
    if (name == each) return true;
  for (std::size_t index = 0; index < column_count(column.family); ++index)
    if (declaration(Column{column.family, static_cast<std::uint8_t>(index)}).basis == name) return true;
  return false;
}

struct Parsed {
  double number;
  std::string_view unit;
};

std::optional<Parsed> parse(std::string_view value) {
  const std::size_t blank = std::min(value.find(' '), value.size());
  std::string reason;
  const auto number = scalar::parse_number(value.substr(0, blank), reason);
  if (!number) return std::nullopt;
  return Parsed{*number, value.substr(std::min(blank + 1, value.size()))};
}

std::optional<std::pair<double, double>> comparable(const std::string& a, const std::string& b) {
  const auto one = parse(a), other = parse(b);
  if (!one || !other || one->unit != other->unit) return std::nullopt;
  return std::pair(one->number, other->number);
}

}  // namespace

std::vector<NamedFigure> figures_of(const Table& table, const std::vector<int>& rows) {
  std::vector<NamedFigure> figures;
  for (const int row : rows) {
    std::string point;
    std::vector<Column> columns;
    for (std::size_t index = 0; index < column_count(table.family()); ++index) {
      const Column each{table.family(), static_cast<std::uint8_t>(index)};
      const ColumnDeclaration& declared = declaration(each);
      if (declared.identity == Identity::point) point += " at " + cell_text(table, each, row, kept_digits);
      if (declared.identity == Identity::none && !is_provenance(each)) columns.push_back(each);
    }
    for (const Column each : columns) {
      const ColumnDeclaration& declared = declaration(each);
      if (!point.empty() && declared.kind != Kind::number) continue;
      std::string value = cell_text(table, each, row, kept_digits);
      if (!value.empty())
        figures.push_back({std::string(declared.name) + point, std::move(value), table.where(row, each)});
    }
  }
  return figures;
}

std::vector<int> rows_of_part(const Table& table,
                              std::string_view manufacturer,
                              std::string_view part_number,
                              std::string_view title) {
  std::vector<int> rows = table.find(part_number, manufacturer).rows;
  rows.erase(std::remove_if(rows.begin(),
                            rows.end(),
                            [&](int row) {
                              return table.part_number(row) != part_number || table.manufacturer(row) != manufacturer ||
                                     part_title(table, row) != title;
                            }),
             rows.end());
  for (std::size_t index = 0; index < column_count(table.family()); ++index) {
    const Column each{table.family(), static_cast<std::uint8_t>(index)};
    if (declaration(each).identity == Identity::point)
      std::stable_sort(
          rows.begin(), rows.end(), [&](int a, int b) { return table.number(each, a) < table.number(each, b); });
  }
  return rows;
}

bool same_figure(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto both = comparable(a, b);
  return both && same_value(both->first, both->second);
}

std::string relative_note(const std::string& before, const std::string& after) {
  const auto both = comparable(before, after);
  if (!both || both->first == 0.0) return {};
  return fmt::format(" ({:+.1f} %)", 100.0 * (both->second - both->first) / std::abs(both->first));
}

}  // namespace millwright::catalogue
