// SPDX-License-Identifier: Apache-2.0
// Somebody's table as rows of text cells: a CSV file in whatever encoding and with whatever separator, or a sheet of a
// workbook (see import_workbook.h), which is then a text of one line a row.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv_scanner.h"
#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::catalogue {

/// What a cell of a spreadsheet can hold, in bytes of UTF-8: 32767 characters.
inline constexpr std::size_t longest_cell = 32767 * std::size_t{4};

/// What may be said about a file; empty or 0 where it is to be found out.
struct SheetFormat {
  std::string sheet;     ///< of a workbook
  std::string encoding;  ///< utf-8, utf-16 or windows-1252
  char separator = 0;    ///< , ; or tab
};

struct ImportSheet {
  std::shared_ptr<const text::SourceText> text;
  char separator = ',';
  std::string sheet;                   ///< of a workbook; empty: it is none
  std::vector<std::string> others;     ///< of a workbook: its other sheets
  std::vector<std::uint32_t> numbers;  ///< of a workbook: bytes where cells begin that hold a number, not a text
  std::vector<std::string> remarks;    ///< what was found out about it, for people
};

/// Reports everything that prevents reading: no file, no text (with the place of the first bytes that are none), no or
/// an unknown workbook, too large.
std::optional<ImportSheet> load_sheet(const std::string& path,
                                      const SheetFormat& format,
                                      text::Diagnostics& diagnostics);

/// Goes through the rows once. Blank rows are skipped; rows with bad quotes are reported and skipped.
class SheetRows {
 public:
  /// From byte `begin` of the text on.
  SheetRows(const ImportSheet& sheet, text::Diagnostics& diagnostics, std::size_t begin = 0);

  /// Goes to the next row that is not blank; false at the end.
  bool next();

  std::size_t cells() const { return starts_.size() - 1; }
  /// The content of a cell: blanks around it and quotes removed; empty beyond the last one.
  std::string_view cell(std::size_t index) const;
  /// Whether a workbook holds it as a number.
  bool is_number(std::size_t index) const;
  text::SourceSpan span(std::size_t index) const;
  /// Of the whole row.
  text::SourceSpan span() const;
  /// Byte where the row begins, and where the next one does.
  std::size_t begin() const { return starts_.front(); }
  std::size_t end() const { return scanner_.position(); }

 private:
  std::string_view raw(std::size_t index) const;

  const ImportSheet& sheet_;
  text::CsvScanner scanner_;
  std::vector<std::uint32_t> starts_;
};

/// Without blanks (also those that do not break) around it.
std::string_view without_blanks(std::string_view text);

}  // namespace millwright::catalogue
