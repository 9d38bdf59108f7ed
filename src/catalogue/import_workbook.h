// SPDX-License-Identifier: Apache-2.0
// A sheet of a workbook (XLSX, ODS) as text: one line a row, so that line numbers are those of the sheet, cells
// separated by tabs. From there on a workbook is imported as a CSV file is.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostic.h"

namespace millwright::catalogue {

struct WorkbookSheet {
  std::string name;
  std::vector<std::string> names;      ///< of all sheets, in their order
  std::string text;                    ///< line ends inside a cell are blanks
  std::vector<std::uint32_t> numbers;  ///< bytes of the text where the cells begin that hold a number
};

/// What a workbook may unpack to, and how large its sheet may be.
inline constexpr std::size_t workbook_size_limit = std::size_t{128} << 20U;
inline constexpr std::size_t workbook_cell_limit = std::size_t{4} << 20U;

/// Reads the sheet of that name, or the first one. Numbers are given in full, with a decimal point; dates as
/// 2026-01-15; percentages as `85%`; formulas as their stored results. Reports (at `path`, as a whole) what is wrong:
/// no workbook, damaged, encrypted, too large, no such sheet, a formula without a result.
std::optional<WorkbookSheet> read_workbook(std::string_view bytes,
                                           const std::string& path,
                                           const std::string& sheet,
                                           text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
