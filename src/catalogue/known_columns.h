// SPDX-License-Identifier: Apache-2.0
// What stock.csv, suppliers.csv and offers.csv have in common: a header of known columns, texts, counts, sums of money.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv.h"
#include "text/nearest.h"

namespace millwright::catalogue {

struct KnownColumn {
  std::string_view name;
  std::string_view unit = {};
  bool needed = false;
};

/// Reads cells of one of the files and reports what is wrong with them.
class KnownColumns {
 public:
  KnownColumns(const text::CsvTable& csv,
               std::string_view file_name,
               std::span<const KnownColumn> columns,
               text::Diagnostics& diagnostics)
      : csv_(csv), file_name_(file_name), columns_(columns), diagnostics_(diagnostics), fields_(columns.size()) {}

  bool match_header() {
    if (csv_.columns().empty()) return false;  // reported
    const std::size_t errors = diagnostics_.error_count();
    std::vector<std::string_view> names;
    for (const KnownColumn& each : columns_) names.push_back(each.name);
    for (std::size_t i = 0; i < csv_.columns().size(); ++i) match(csv_.columns()[i], i, names);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].needed && !fields_[i])
        diagnostics_.error(csv_.header_span(),
                           fmt::format("{} has no column {}", file_name_, columns_[i].name),
                           fmt::format("its columns: {}", fmt::join(names, ", ")));
    return diagnostics_.error_count() == errors;
  }

  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t field) const {
    return fields_[field] ? csv_.cell(row, *fields_[field]) : std::string_view();
  }
  [[nodiscard]] text::SourceSpan span(std::size_t row, std::size_t field) const {
    return fields_[field] ? csv_.cell_span(row, *fields_[field]) : csv_.row_span(row);
  }

  /// Not negative; NaN where nothing is written.
  double amount(std::size_t row, std::size_t field, std::string_view hint) {
    if (cell(row, field).empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto number = csv_.number(row, *fields_[field], diagnostics_);
    if (number && (*number < 0.0 || !std::isfinite(*number)))
      diagnostics_.error(
          span(row, field), fmt::format("{} cannot be {}", columns_[field].name, *number), std::string(hint));
    return number.value_or(0.0);
  }

  /// Whether the line says something there.
  [[nodiscard]] bool says(std::size_t row, std::size_t field) const { return !cell(row, field).empty(); }

  /// A whole number of these limits, NaN where nothing is written. `problem` says of a number what is wrong with it.
  template <class Problem>
  double count(std::size_t row, std::size_t field, double least, double most, const Problem& problem) {
    if (!says(row, field)) return std::numeric_limits<double>::quiet_NaN();
    const auto number = csv_.number(row, *fields_[field], diagnostics_);
    if (!number) return 0.0;
    if (!(*number >= least && *number <= most) || *number != std::floor(*number))
      diagnostics_.error(span(row, field), problem(*number), "write a whole number");
    return *number;
  }

  void check_currency(std::size_t row, std::size_t field) {
    const std::string_view code = cell(row, field);
    if (code.empty())
      diagnostics_.error(span(row, field), "currency is missing", "for example USD");
    else if (code.size() != 3 || !std::all_of(code.begin(), code.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
      diagnostics_.error(span(row, field),
                         fmt::format("{} is not a currency", text::in_quotes(code)),
                         "three capital letters, for example USD or EUR");
  }

 private:
  void match(const text::CsvColumn& column, std::size_t at, const std::vector<std::string_view>& names) {
    const auto known = std::find(names.begin(), names.end(), column.name);
    if (known == names.end()) {
      diagnostics_.error(
          column.name_span,
          fmt::format("{} has no column {}", file_name_, text::in_quotes(column.name)),
          text::did_you_mean(column.name, names, fmt::format("its columns: {}", fmt::join(names, ", "))));
      return;
    }
    const auto index = static_cast<std::size_t>(known - names.begin());
    fields_[index] = at;
    const std::string_view unit = column.unit ? std::string_view(*column.unit) : std::string_view();
    const bool pieces = unit == "1" && columns_[index].unit.empty();
    if (unit != columns_[index].unit && !pieces)
      diagnostics_.error(column.unit_span,
                         fmt::format("{} is read in [{}]", column.name, columns_[index].unit),
                         columns_[index].unit.empty()
                             ? fmt::format("write {}", column.name)
                             : fmt::format("write {} [{}]", column.name, columns_[index].unit));
  }

  const text::CsvTable& csv_;
  std::string_view file_name_;
  std::span<const KnownColumn> columns_;
  text::Diagnostics& diagnostics_;
  std::vector<std::optional<std::size_t>> fields_;
};

}  // namespace millwright::catalogue
