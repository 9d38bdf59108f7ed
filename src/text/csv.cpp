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
      cell_span(row, column), columns_[column].name + ": not a number: " + quoted(content), number_hint(content));
}

/// Reads one column; where semicolons separate, it also sees to it that one decimal mark is used throughout.
class CsvTable::NumberColumn {
 public:
  NumberColumn(const CsvTable& table, std::size_t column, Diagnostics& diagnostics, std::size_t room)
      : table_(table), column_(column), check_marks_(table.separator_ == ';'), diagnostics_(diagnostics) {
    reserve_large(values_, std::max(room, table.row_count()));
  }

  void read(std::size_t row) {
    // The usual cell is a plain number from end to end.
    const std::string_view raw = table_.raw(row, column_);
    const char* begin = raw.data();
    const char* end = begin + raw.size();
    while (begin != end && is_blank(*begin)) ++begin;
    while (begin != end && is_blank(end[-1])) --end;
    double value = std::numeric_limits<double>::quiet_NaN();
    if (begin == end) return values_.push_back(value);
    if (const auto simple = simple_decimal(begin, end)) {
      value = *simple;
    } else {
      const std::from_chars_result result = std::from_chars(begin, end, value);
      if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value))
        value = table_.number(row, column_, diagnostics_).value_or(std::numeric_limits<double>::quiet_NaN());
    }
    if (check_marks_ && !std::isnan(value)) check_mark(row, raw);
    values_.push_back(value);
  }

  std::vector<double> take() { return std::move(values_); }

 private:
  void check_mark(std::size_t row, std::string_view raw) {
    const std::size_t mark = raw.find_first_of(".,");
    if (mark == std::string_view::npos) return;
    std::optional<std::size_t>& seen = raw[mark] == '.' ? point_row_ : comma_row_;
    if (!seen) seen = row;
    if (!point_row_ || !comma_row_) return;
    check_marks_ = false;
    Diagnostic diagnostic;
    diagnostic.where = table_.cell_span(row, column_);
    diagnostic.message = table_.columns_[column_].name + ": decimal commas and decimal points in one column";
    diagnostic.hint = "is this a thousands separator? use one decimal mark throughout";
    diagnostic.related = table_.cell_span(raw[mark] == '.' ? *comma_row_ : *point_row_, column_);
    diagnostic.related_message = "the other mark is here";
    diagnostics_.add(std::move(diagnostic));
  }

  const CsvTable& table_;
  std::size_t column_;
  bool check_marks_;
  Diagnostics& diagnostics_;
  std::vector<double> values_;
  std::optional<std::size_t> point_row_;
  std::optional<std::size_t> comma_row_;
};

std::vector<std::vector<double>> CsvTable::number_columns(std::span<const std::size_t> columns,
                                                          Diagnostics& diagnostics,
                                                          std::size_t room) const {
  std::vector<NumberColumn> readers;
  readers.reserve(columns.size());
  for (const std::size_t column : columns) readers.emplace_back(*this, column, diagnostics, room);
  for (std::size_t row = 0; row < row_count(); ++row) {
    for (NumberColumn& reader : readers) reader.read(row);
  }
  std::vector<std::vector<double>> values;
  values.reserve(readers.size());
  for (NumberColumn& reader : readers) values.push_back(reader.take());
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
