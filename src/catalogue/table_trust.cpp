// SPDX-License-Identifier: Apache-2.0
//
// What a table says about how far its figures can be trusted, and figures that are taken otherwise than they stand.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "catalogue/companions.h"
#include "catalogue/table.h"

namespace millwright::catalogue {

std::string_view Table::figure_source(int row, Column column) const {
  return content(figure_sources_[column.index], row);
}

std::string_view Table::figure_confidence(int row, Column column) const {
  return content(figure_confidences_[column.index], row);
}

text::SourceSpan Table::where(int row, Column column, CompanionKind kind) const {
  for (const CompanionField& each : files_[file_of_[static_cast<std::size_t>(row)]].companions)
    if (each.figure == column.index && each.kind == kind) return place_of_field(row, each.field);
  return where(row, column);
}

std::string_view Table::basis(int row, Column column) const {
  if (const std::string_view own = figure_source(row, column); !own.empty()) return own;
  const std::string_view name = declaration(column).basis;
  return name.empty() ? std::string_view() : text(name, row);
}

Standing Table::standing(int row, Column column) const { return standing_of(basis(row, column)); }

bool Table::is_estimate(int row, Column column) const {
  if (declaration(column).kind == Kind::text) return false;
  const std::string_view own = figure_confidence(row, column);
  return counts_as_estimate(standing(row, column), own.empty() ? confidence(row) : own);
}

double Table::tolerance(int row, Column column) const {
  const std::vector<double>& stated = tolerances_[column.index];
  if (!stated.empty() && !std::isnan(stated[static_cast<std::size_t>(row)]))
    return stated[static_cast<std::size_t>(row)] / std::abs(number(column, row));
  return stated_tolerance(basis(row, column));
}

bool Table::has_tolerances() const {
  for (std::size_t index = 0; index < column_count(family_); ++index)
    for (int row = 0; row < rows(); ++row)
      if (half_width(row, {family_, static_cast<std::uint8_t>(index)}) > 0.0) return true;
  return false;
}

double Table::half_width(int row, Column column) const {
  if (!takes_tolerance(column)) return std::nan("");
  const std::vector<double>& stated = tolerances_[column.index];
  if (!stated.empty() && !std::isnan(stated[static_cast<std::size_t>(row)]))
    return stated[static_cast<std::size_t>(row)];
  const double share = stated_tolerance(basis(row, column));
  return share < 1.0 ? share * std::abs(number(column, row)) : std::nan("");
}

void Table::set_number(int row, Column column, double value) {
  check(column, false);
  make_column(column.index);
  numbers_[column.index][static_cast<std::size_t>(row)] = value;
  forget();
}

void Table::set_range(int row, Column column, const scalar::Interval& range) {
  check(column, false);
  for (Range& each : ranges_)
    if (each.row == row && each.column == column.index) {
      each.values = range;
      return;
    }
  ranges_.push_back({row, column.index, range});
}

scalar::Interval Table::range(Column column, int row) const {
  for (const Range& each : ranges_)
    if (each.row == row && each.column == column.index) return each.values;
  return number(column, row);
}

}  // namespace millwright::catalogue
