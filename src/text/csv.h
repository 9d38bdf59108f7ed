// SPDX-License-Identifier: Apache-2.0
// Tables that people keep in spreadsheets: comma or semicolon separated, quoted cells, LF or CR LF, with or without a
// byte order mark.
//
//   # comment lines may stand before the header, between the rows and behind them
//   manufacturer,part_number,holding_torque [N.cm],price
//   StepperOnline,23HS22-2804S,126,24.33
//
// Rules, where RFC 4180 leaves a choice:
// - The separator is the one of `,` and `;` that the header uses (or that a first line `sep=;` names).
// - A header cell is a name and, in brackets, a unit. Names are unique.
// - Blanks around a cell do not count, blanks inside quotes do. A quote inside a quoted cell is written twice.
// - A line that begins with # is a comment whatever it holds; a first cell that begins so is put in quotes. A whole row
//   that begins with # and a digit ("#10-24") may be meant as one and is refused.
// - Blank lines, and rows in which every cell is empty, are skipped; empty cells beyond the header are ignored.
// - Decimals have a point. Where `;` separates, a decimal comma is understood too (one mark per column); where `,`
//   separates, `1,5` is two cells, and the quoted "1,5" is refused as ambiguous. No thousands separators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::text {

/// A comment line before the header, without its `#` and the blanks around it.
struct CsvComment {
  std::string text;
  SourceSpan span;
};

/// A header cell `name [unit]`. `unit` is none without brackets and "" for `[]`; `unit_span` is then the whole cell.
struct CsvColumn {
  std::string name;
  std::optional<std::string> unit;
  SourceSpan span;
  SourceSpan name_span;
  SourceSpan unit_span;
};

/// A column of numbers on its way out of one table after the other of the same text (CsvReader::next()).
struct NumberColumn {
  std::size_t column;
  std::vector<double> values;
  /// The first cell with a decimal point and with a comma, in bytes of the text: begin and length.
  std::optional<std::pair<std::size_t, std::size_t>> point, comma;
};

/// The records of one CSV text, or some of them. Cells are views into the text, which the table keeps alive; places are
/// worked out only when asked for. Const member functions may be called from several threads (with a Diagnostics each).
class CsvTable {
 public:
  /// A wider header is not a catalogue and is refused.
  static constexpr std::size_t column_limit = 1024;

  const std::shared_ptr<const SourceText>& text() const { return text_; }
  char separator() const { return separator_; }
  const std::vector<CsvComment>& comments() const { return comments_; }
  const std::vector<CsvColumn>& columns() const { return columns_; }
  /// The header line; the whole text if there is none.
  const SourceSpan& header_span() const { return header_span_; }
  std::optional<std::size_t> find_column(std::string_view name) const;
  std::size_t row_count() const { return columns_.empty() ? 0 : starts_.size() / (columns_.size() + 1); }

  /// The content of a cell: blanks around it and quotes removed. `row` counts records from 0.
  std::string_view cell(std::size_t row, std::size_t column) const;
  bool is_empty(std::size_t row, std::size_t column) const {
    const std::size_t at = row * (columns_.size() + 1) + column;
    return starts_[at + 1] - starts_[at] == 1 || cell(row, column).empty();  // most often there is not even a blank
  }

  /// The byte of the text at which a record begins, blanks before its first cell left out.
  std::size_t record_offset(std::size_t row) const;

  /// Where the cell stands (inside its quotes and blanks; an empty cell: where it would).
  SourceSpan cell_span(std::size_t row, std::size_t column) const;
  /// The first line of a record.
  SourceSpan row_span(std::size_t row) const;

  /// The number in a cell; none if it is empty, or if it is no number, which is reported at the cell.
  std::optional<double> number(std::size_t row, std::size_t column, Diagnostics& diagnostics) const;

  /// A whole column of numbers: NaN where the cell is empty or (reported) no finite number.
  std::vector<double> number_column(std::size_t column, Diagnostics& diagnostics) const;

  /// Several columns in one pass over the text, which is faster than one after the other.
  std::vector<std::vector<double>> number_columns(std::span<const std::size_t> columns, Diagnostics& diagnostics) const;
  /// The same, appended to what is there.
  void read_numbers(std::span<NumberColumn> columns, Diagnostics& diagnostics) const;

  std::vector<std::string_view> text_column(std::size_t column) const;

 private:
  friend class CsvReader;

  double number_in(std::size_t row, NumberColumn& column, Diagnostics& diagnostics) const;
  void check_mark(std::size_t row, std::string_view raw, NumberColumn& column, Diagnostics& diagnostics) const;
  std::string_view raw(std::size_t row, std::size_t column) const;
  void report_number(std::size_t row, std::size_t column, Diagnostics& diagnostics) const;

  std::shared_ptr<const SourceText> text_;
  char separator_ = ',';
  std::vector<CsvComment> comments_;
  std::vector<CsvColumn> columns_;
  SourceSpan header_span_;
  /// Per record, where each cell begins, and one past the character that ends the last: columns + 1 numbers.
  std::vector<std::uint32_t> starts_;
  /// Content of the quoted cells that hold doubled quotes, by where the cell begins.
  std::unordered_map<std::uint32_t, std::string> unescaped_;
};

/// Reads a table. Everything wrong is reported at its place (bytes that are not text, bad quotes, rows with too few or
/// too many cells, a header without names or with the same name twice) and left out of the result; check
/// `diagnostics.has_errors()`. A text without a header gives a table without columns.
CsvTable read_csv(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics);

/// Loads and reads a file; none if it cannot be loaded.
std::optional<CsvTable> read_csv_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace millwright::text
