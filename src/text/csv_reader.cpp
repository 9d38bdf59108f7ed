// SPDX-License-Identifier: Apache-2.0
#include "text/csv_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "text/csv_header.h"
#include "text/large_pages.h"
#include "text/table_size.h"
#include "text/text_check.h"

namespace millwright::text {

namespace {

/// Longer header lines are refused, so that working out the places of their cells stays quick.
constexpr std::size_t header_length_limit = std::size_t{128} << 10U;
constexpr std::size_t text_size_limit = std::numeric_limits<std::uint32_t>::max() - 8;

/// An empty cell, quoted or not.
bool is_blank(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return true;
  return cell.substr(first, cell.find_last_not_of(" \t\r\n") + 1 - first) == "\"\"";
}

/// In sums of single bytes, sixteen and more at a time: std::count() takes four times as long.
std::size_t line_ends(std::string_view text) {
  constexpr std::size_t most = 240;  // a sum of more might not fit into a byte
  std::size_t all = 0;
  while (!text.empty()) {
    std::uint8_t some = 0;
    for (const char c : text.substr(0, most)) some = static_cast<std::uint8_t>(some + (c == '\n' ? 1 : 0));
    all += some;
    text.remove_prefix(std::min(most, text.size()));
  }
  return all;
}

}  // namespace

CsvReader::CsvReader(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics, std::size_t rows_at_a_time)
    : diagnostics_(diagnostics), rows_at_a_time_(rows_at_a_time) {
  table_.text_ = std::move(text);
  table_.header_span_ = whole(table_.text_);
  if (read_head()) {
    reserve(rows_begin_);
    read_rows();
  } else {
    scanner_.reset();
  }
}

bool CsvReader::next() {
  if (!scanner_ || scanner_->at_end()) return false;
  cells_before_ += table_.starts_.size();
  table_.starts_.clear();
  table_.unescaped_.clear();
  read_rows();
  return table_.row_count() > 0;
}

std::size_t CsvReader::most_rows() const {
  if (table_.columns_.empty()) return 0;
  const std::string_view rows = table_.text_->contents().substr(std::min(rows_begin_, table_.text_->contents().size()));
  // A row is a line at least, and has a byte at least behind each cell; of blank lines that is far fewer.
  const std::size_t columns = table_.columns_.size();
  return std::min({line_ends(rows), rows.size() / columns, table_cell_limit / columns}) + 1;
}

void CsvReader::error(SourceSpan where, std::string message, std::string hint) {
  diagnostics_.error(std::move(where), std::move(message), std::move(hint));
}

/// All before the rows; false if there is no good header.
bool CsvReader::read_head() {
  const std::string_view contents = table_.text_->contents();
  if (contents.size() > text_size_limit) {
    error(whole(table_.text_), fmt::format("is too large for a table: {} bytes", contents.size()));
    return false;
  }
  // Cells with bad bytes would only be complained about a second time.
  if (!check_text(table_.text_, diagnostics_)) return false;
  check_line_ends(contents);
  CsvPreamble preamble = read_preamble(table_.text_);
  table_.comments_ = std::move(preamble.comments);
  table_.separator_ = preamble.separator;
  if (preamble.header_begin >= contents.size()) {
    error(whole(table_.text_),
          contents.empty() ? "is empty: a header was expected" : "has no header",
          "the first line that is no comment names the columns, separated by commas");
    return false;
  }
  // A line of nothing but separators would take many times the memory of the file.
  constexpr std::size_t cells_in_a_line = std::size_t{1} << 20U;
  scanner_.emplace(table_.text_, preamble.separator, preamble.header_begin, diagnostics_, cells_in_a_line);
  if (!read_header(preamble.header_begin)) return false;
  rows_begin_ = scanner_->position();
  return true;
}

void CsvReader::check_line_ends(std::string_view contents) {
  for (std::size_t at = contents.find('\r', plain_prefix(contents)); at != std::string_view::npos;
       at = contents.find('\r', at + 1)) {
    if (at + 1 == contents.size() || contents[at + 1] == '\n') continue;
    error(span_at(table_.text_, at, 1),
          "carriage return inside a line",
          "lines end with LF or CR LF; save the file anew with such line ends");
    return;
  }
}

std::string_view CsvReader::slice(const std::vector<std::uint32_t>& starts, std::size_t cell) const {
  const std::string_view contents = table_.text_->contents();
  return contents.substr(starts[cell], starts[cell + 1] - 1 - starts[cell]);
}

bool CsvReader::read_header(std::size_t begin) {
  std::vector<std::uint32_t>& starts = table_.starts_;
  if (!scanner_->next(starts)) return false;
  table_.header_span_ = span_at(table_.text_, begin, 1);
  std::size_t count = starts.size() - 1;
  while (count > 1 && is_blank(slice(starts, count - 1))) --count;
  if (count > CsvTable::column_limit || scanner_->position() - begin > header_length_limit) {
    error(table_.header_span_,
          fmt::format(
              "a header of {} columns and {} bytes: this is not a catalogue", count, scanner_->position() - begin),
          fmt::format("at most {} columns and {} bytes", CsvTable::column_limit, header_length_limit));
    return false;
  }
  table_.header_span_ = span_at(table_.text_, begin, scanner_->position() - 1 - begin);
  // cell() and its kin need the columns to know where a record ends; while they are read, the header is the record.
  std::vector<CsvColumn> columns(count);
  table_.columns_.resize(count);
  starts.resize(count + 1);
  table_.unescaped_ = scanner_->unescaped();
  for (std::size_t column = 0; column < count; ++column) columns[column] = header_cell(column);
  table_.columns_ = std::move(columns);
  starts.clear();
  check_names();
  if (table_.columns_.size() == 1 && table_.columns_[0].name.find('\t') != std::string::npos) {
    error(table_.header_span_, "cells separated by tabs", "save the table with commas or semicolons between the cells");
  }
  return true;
}

CsvColumn CsvReader::header_cell(std::size_t column) {
  const std::string_view content = table_.cell(0, column);
  const std::string_view contents = table_.text_->contents();
  const bool exact = content.data() >= contents.data() && content.data() <= contents.data() + contents.size();
  const std::size_t offset =
      exact && !content.empty() ? static_cast<std::size_t>(content.data() - contents.data()) : table_.starts_[column];
  return read_header_cell(table_.text_, offset, content, exact, diagnostics_);
}

void CsvReader::check_names() {
  std::map<std::string_view, const CsvColumn*> known;
  for (const CsvColumn& column : table_.columns_) {
    const auto [first, added] = known.emplace(column.name, &column);
    if (added || column.name.empty()) continue;
    Diagnostic diagnostic;
    diagnostic.where = column.name_span;
    diagnostic.message = "two columns of the name " + in_quotes(column.name);
    diagnostic.related = first->second->name_span;
    diagnostic.related_message = "the first is here";
    diagnostics_.add(std::move(diagnostic));
  }
}

void CsvReader::read_rows() {
  std::vector<std::uint32_t>& starts = table_.starts_;
  const std::size_t columns = table_.columns_.size();
  const std::string_view contents = table_.text_->contents();
  const std::size_t enough = std::min(rows_at_a_time_, table_cell_limit + 1) * (columns + 1);
  bool full = false;
  while (!scanner_->at_end() && !full && starts.size() < enough) {
    const std::size_t before = starts.size();
    full = cells_before_ + before > table_cell_limit;
    if (full) {
      error(span_at(table_.text_, scanner_->position(), 1),
            fmt::format("more than {} cells: the rows from here on are not read", table_cell_limit),
            "is this a table of parts? cut it into several files");
      break;
    }
    const char lead = contents[scanner_->position()];
    if (lead == '#' || lead == ' ' || lead == '\t') {
      const std::size_t mark = contents.find_first_not_of(" \t", scanner_->position());
      if (mark != std::string_view::npos && contents[mark] == '#') {
        check_comment(mark);
        scanner_->skip_line();
        continue;
      }
    }
    const bool first_is_empty = lead == table_.separator_ || lead <= ' ' || lead == '"';
    const bool good = scanner_->next(starts);
    const std::size_t cells = starts.size() - before - 1;
    if (good && cells == columns && !first_is_empty) continue;
    if (!good || !accept(before, cells)) starts.resize(before);
  }
  table_.unescaped_ = std::move(scanner_->unescaped());
  scanner_->unescaped().clear();
  if (full) scanner_.reset();
}

/// A line that begins with # is a comment, a row that somebody took out too; but "#10-24" above the other cells of a
/// row may be meant as its first cell, and is not lost in silence.
void CsvReader::check_comment(std::size_t mark) {
  const std::string_view contents = table_.text_->contents();
  const bool digit = mark + 1 < contents.size() && contents[mark + 1] >= '0' && contents[mark + 1] <= '9';
  if (!digit) return;
  const std::string_view line = contents.substr(mark, contents.find('\n', mark) - mark);
  const auto cells = static_cast<std::size_t>(std::count(line.begin(), line.end(), table_.separator_)) + 1;
  if (cells < table_.columns_.size()) return;
  if (diagnostics_.is_full(table_.text_.get())) return error(whole(table_.text_), "comment or row");
  const std::string_view first = line.substr(0, line.find_first_of(" \t\r,;"));
  error(
      span_at(table_.text_, mark, first.size()),
      fmt::format("comment or row? {} with {} cells", in_quotes(first), cells),
      fmt::format("quote the first cell of a row, \"{}\"; of a comment write a blank behind #", printable(first, 40)));
}

/// Makes room for the records from `begin` on, as many as are wanted or as there are lines like the first ones: growing
/// step by step would copy what is read, and touch twice the memory.
void CsvReader::reserve(std::size_t begin) {
  constexpr std::size_t looked_at = std::size_t{64} << 10U;
  const std::string_view contents = table_.text_->contents();
  const std::string_view rest = contents.substr(std::min(begin, contents.size()));
  const std::string_view head = rest.substr(0, looked_at);
  const auto lines = static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n')) + 1;
  const double records =
      static_cast<double>(lines) * static_cast<double>(rest.size()) / static_cast<double>(head.size() + 1);
  const double wanted = std::min(1.1 * records + 1.0, static_cast<double>(rows_at_a_time_));
  const double cells = wanted * static_cast<double>(table_.columns_.size() + 1);
  reserve_large(table_.starts_, static_cast<std::size_t>(std::min(cells, static_cast<double>(table_cell_limit))));
}

/// Judges a record with a first cell that may be empty or of another length than the header; cuts empty surplus cells
/// off.
bool CsvReader::accept(std::size_t first, std::size_t cells) {
  const std::vector<std::uint32_t>& starts = table_.starts_;
  const std::size_t columns = table_.columns_.size();
  std::size_t used = cells;
  while (used > 0 && is_blank(slice(starts, first + used - 1))) --used;
  if (used == 0) return false;
  if (cells >= columns && used <= columns) {
    table_.starts_.resize(first + columns + 1);
    return true;
  }
  report_length(first, cells);
  return false;
}

void CsvReader::report_length(std::size_t first, std::size_t cells) {
  const std::vector<std::uint32_t>& starts = table_.starts_;
  const std::size_t columns = table_.columns_.size();
  if (diagnostics_.is_full(table_.text_.get())) return error(whole(table_.text_), "row of another length");
  const std::string message = fmt::format("row of {} cells, but the header has {}", cells, columns);
  if (cells < columns) {
    const std::string_view last = slice(starts, first + cells - 1);
    const std::size_t end = starts[first + cells] - 1 - (!last.empty() && last.back() == '\r' ? 1 : 0);
    return error(span_at(table_.text_, end, 1),
                 message,
                 fmt::format("the cell of {} and what follows is missing", in_quotes(table_.columns_[cells].name)));
  }
  const std::string_view surplus = slice(starts, first + columns);
  error(span_at(table_.text_, starts[first + columns], surplus.size()),
        message,
        table_.separator_ == ',' ? "a value that holds a comma is put in quotes; decimals are written with a point"
                                 : "a value that holds a semicolon is put in quotes");
}

CsvTable read_csv(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics) {
  return CsvReader(std::move(text), diagnostics).take();
}

std::optional<CsvTable> read_csv_file(const std::string& path, Diagnostics& diagnostics) {
  std::shared_ptr<const SourceText> text = SourceText::load(path, diagnostics, table_size_limit);
  if (!text) return std::nullopt;
  return read_csv(std::move(text), diagnostics);
}

}  // namespace millwright::text
