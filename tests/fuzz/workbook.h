// SPDX-License-Identifier: Apache-2.0
// What is demanded of a sheet that was read from a workbook.
#pragma once

#include <optional>

#include "catalogue/import_workbook.h"
#include "fuzz.h"

namespace millwright::fuzz {

inline void check(const std::optional<catalogue::WorkbookSheet>& sheet, const text::Diagnostics& diagnostics) {
  require(sheet.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  check(diagnostics);
  if (!sheet) return;
  require(std::is_sorted(sheet->numbers.begin(), sheet->numbers.end()), "places of numbers ascend");
  require(sheet->numbers.empty() || sheet->numbers.back() < sheet->text.size(), "places of numbers are there");
}

}  // namespace millwright::fuzz
