// SPDX-License-Identifier: Apache-2.0
#include "text/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "text/large_pages.h"
#include "text/number.h"

namespace millwright::text {

namespace {

/// The part of an unquoted or quoted raw cell that counts, and whether it was quoted.
struct Trimmed {
  std::string_view content;
  bool is_quoted = false;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

Trimmed trim(std::string_view raw) {
  while (!raw.empty() && is_blank(raw.back())) raw.remove_suffix(1);
  while (!raw.empty() && is_blank(raw.front())) raw.remove_prefix(1);
  if (raw.size() < 2 || raw.front() != '"') return {raw, false};
  return {raw.substr(1, raw.size() - 2), true};
}

/// The usual figure, digits with at most one point between them: up to 15 digits and powers of ten up to 1e15 are exact
/// in a double, so their quotient is rounded once, to what std::from_chars() finds in longer time. None if it is
/// anything else.
std::optional<double> simple_decimal(const char* begin, const char* end) {
  constexpr std::array<double, 16> powers = {
      1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  if (end - begin > 16 || *begin == '.' || end[-1] == '.') return std::nullopt;
  const char* point = nullptr;
  std::int64_t digits = 0;
  for (const char* at = begin; at != end; ++at) {
    if (*at == '.' && point == nullptr)
      point = at;
    else if (*at >= '0' && *at <= '9')
      digits = 10 * digits + (*at - '0');
    else
      return std::nullopt;
  }
  if (point == nullptr) return end - begin < 16 ? std::optional(static_cast<double>(digits)) : std::nullopt;
  return static_cast<double>(digits) / powers[static_cast<std::size_t>(end - point - 1)];
}

}  // namespace

std::optional<std::size_t> CsvTable::find_column(std::string_view name) const {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].name == name) return column;
  }
  return std::nullopt;
}

std::string_view CsvTable::raw(std::size_t row, std::size_t column) const {
  const std::size_t at = row * (columns_.size() + 1) + column;
  return text_->contents().substr(starts_[at], starts_[at + 1] - 1 - starts_[at]);
}

std::string_view CsvTable::cell(std::size_t row, std::size_t column) const {
  const Trimmed trimmed = trim(raw(row, column));
  if (!trimmed.is_quoted || unescaped_.empty()) return trimmed.content;
  const auto found = unescaped_.find(starts_[row * (columns_.size() + 1) + column]);
  return found == unescaped_.end() ? trimmed.content : found->second;
}

std::size_t CsvTable::record_offset(std::size_t row) const {
  const std::string_view contents = text_->contents();
  std::size_t offset = starts_[row * (columns_.size() + 1)];
  while (offset < contents.size() && (contents[offset] == ' ' || contents[offset] == '\t')) ++offset;
  return offset;
}

SourceSpan CsvTable::cell_span(std::size_t row, std::size_t column) const {
  const std::string_view content = trim(raw(row, column)).content;
  return span_at(text_, static_cast<std::size_t>(content.data() - text_->contents().data()), content.size());
}

SourceSpan CsvTable::row_span(std::size_t row) const {
  const std::size_t at = row * (columns_.size() + 1);
  const std::size_t end = starts_[at + columns_.size()] - 1;
  return span_at(text_, starts_[at], end - starts_[at]);
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column, Diagnostics& diagnostics) const {
  const std::string_view content = cell(row, column);
  if (content.find_first_not_of(" \t\r") == std::string_view::npos) return std::nullopt;
  const DecimalMark mark = separator_ == ';' ? DecimalMark::point_or_comma : DecimalMark::point;
  const std::optional<double> value = parse_number(content, mark);
  if (!value) report_number(row, column, diagnostics);
  return value;
}

void CsvTable::report_number(std::size_t row, std::size_t column, Diagnostics& diagnostics) const {
  if (diagnostics.is_full(text_.get())) return diagnostics.error(whole(text_), "not a number");
  const std::string_view content = cell(row, column);
  diagnostics.error(
      cell_span(row, column), columns_[column].name + ": not a number: " + in_quotes(content), number_hint(content));
}

double CsvTable::number_in(std::size_t row, NumberColumn& column, Diagnostics& diagnostics) const {
  // The usual cell is a plain number from end to end.
  const std::string_view raw = this->raw(row, column.column);
  const char* begin = raw.data();
  const char* end = begin + raw.size();
  while (begin != end && is_blank(*begin)) ++begin;
  while (begin != end && is_blank(end[-1])) --end;
  double value = std::numeric_limits<double>::quiet_NaN();
  if (begin == end) return value;
  if (const auto simple = simple_decimal(begin, end)) {
    value = *simple;
  } else {
    const std::from_chars_result result = std::from_chars(begin, end, value);
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value))
      value = number(row, column.column, diagnostics).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  if (separator_ == ';' && !std::isnan(value)) check_mark(row, raw, column, diagnostics);
  return value;
}

/// Where semicolons separate, one decimal mark is used throughout a column; another is told of once.
void CsvTable::check_mark(std::size_t row, std::string_view raw, NumberColumn& column, Diagnostics& diagnostics) const {
  if (column.point && column.comma) return;
  const std::size_t mark = raw.find_first_of(".,");
  if (mark == std::string_view::npos) return;
  auto& seen = raw[mark] == '.' ? column.point : column.comma;
  if (seen) return;
  const std::string_view content = trim(raw).content;
  seen = {static_cast<std::size_t>(content.data() - text_->contents().data()), content.size()};
  if (!column.point || !column.comma) return;
  const auto& other = raw[mark] == '.' ? *column.comma : *column.point;
  Diagnostic diagnostic;
  diagnostic.where = cell_span(row, column.column);
  diagnostic.message = columns_[column.column].name + ": decimal commas and decimal points in one column";
  diagnostic.hint = "is this a thousands separator? use one decimal mark throughout";
  diagnostic.related = span_at(text_, other.first, other.second);
  diagnostic.related_message = "the other mark is here";
  diagnostics.add(std::move(diagnostic));
}

void CsvTable::read_numbers(std::span<NumberColumn> columns, Diagnostics& diagnostics) const {
  for (std::size_t row = 0; row < row_count(); ++row) {
    for (NumberColumn& column : columns) column.values.push_back(number_in(row, column, diagnostics));
  }
}

std::vector<std::vector<double>> CsvTable::number_columns(std::span<const std::size_t> columns,
                                                          Diagnostics& diagnostics) const {
  std::vector<NumberColumn> readers;
  for (const std::size_t column : columns) {
    readers.push_back({column, {}, {}, {}});
    reserve_large(readers.back().values, row_count());
  }
  read_numbers(readers, diagnostics);
  std::vector<std::vector<double>> values;
  values.reserve(readers.size());
  for (NumberColumn& reader : readers) values.push_back(std::move(reader.values));
  return values;
}

std::vector<double> CsvTable::number_column(std::size_t column, Diagnostics& diagnostics) const {
  return std::move(number_columns(std::span(&column, 1), diagnostics).front());
}

std::vector<std::string_view> CsvTable::text_column(std::size_t column) const {
  std::vector<std::string_view> cells;
  cells.reserve(row_count());
  for (std::size_t row = 0; row < row_count(); ++row) cells.push_back(cell(row, column));
  return cells;
}

}  // namespace millwright::text
