// SPDX-License-Identifier: Apache-2.0
// The cells of one sheet of a workbook, within limits, and the two formats they are read from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/import_workbook.h"
#include "text/zip_archive.h"

namespace millwright::catalogue {

/// Why a workbook is refused.
struct WorkbookProblem {
  std::string message;
  std::string hint;
};

/// Rows and columns count from 0. Whatever goes beyond a limit throws WorkbookProblem.
class WorkbookCells {
 public:
  void add_text(std::int64_t row, std::int64_t column, std::string_view text);
  /// `unit` is written behind it: a currency; `%` makes 0.85 to 85%.
  void add_number(std::int64_t row, std::int64_t column, double value, std::string_view unit = {});
  void add_boolean(std::int64_t row, std::int64_t column, bool value) {
    add_text(row, column, value ? "true" : "false");
  }
  /// The cells of the last row added, `count` times more below it.
  void repeat_last_row(std::int64_t count);

  /// The cells as lines of text; sheet.text and sheet.numbers are filled.
  void render(WorkbookSheet& sheet);

 private:
  struct Cell {
    std::int32_t row;
    std::int32_t column;
    std::uint32_t begin;  ///< in texts_
    std::uint32_t length;
    bool is_number;
  };
  void add(std::int64_t row, std::int64_t column, std::string_view text, bool is_number);

  std::vector<Cell> cells_;
  std::string texts_;
};

/// What a zip file holds, each part unpacked when it is asked for.
class WorkbookParts {
 public:
  explicit WorkbookParts(std::string_view bytes);
  bool has(std::string_view name) const;
  /// Throws WorkbookProblem if it is not there (and must be), cannot be unpacked or is too large.
  std::string part(const std::string& name, bool required = true) const;

 private:
  std::string_view bytes_;
  std::vector<text::ZipEntry> directory_;
};

/// Fill in sheet.name, sheet.names and the cells; throw WorkbookProblem or, where the XML is damaged, std::exception.
void read_xlsx(const WorkbookParts& parts, const std::string& wanted, WorkbookSheet& sheet, WorkbookCells& cells);
void read_ods(const WorkbookParts& parts, const std::string& wanted, WorkbookSheet& sheet, WorkbookCells& cells);

/// The index of the wanted sheet (the first one, if `wanted` is empty); throws WorkbookProblem if there is none.
std::size_t wanted_sheet(const std::string& wanted, const std::vector<std::string>& names);

/// A whole number in an attribute; `fallback` if it is none. Never beyond what a sheet can have by far.
std::int64_t attribute_number(std::string_view text, std::int64_t fallback);

}  // namespace millwright::catalogue
