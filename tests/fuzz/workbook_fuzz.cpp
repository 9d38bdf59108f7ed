// SPDX-License-Identifier: Apache-2.0
// Workbooks (XLSX, ODS) as bytes: zip directory, packed parts and their XML.
#include "catalogue/import_workbook.h"
#include "fuzz.h"
#include "text/text_check.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  text::Diagnostics diagnostics;
  const auto sheet = catalogue::read_workbook(fuzz::view(bytes, size), "parts.xlsx", "", diagnostics);
  fuzz::require(sheet.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  fuzz::check(diagnostics);
  if (!sheet) return 0;
  fuzz::require(std::is_sorted(sheet->numbers.begin(), sheet->numbers.end()), "places of numbers ascend");
  fuzz::require(sheet->numbers.empty() || sheet->numbers.back() < sheet->text.size(), "places of numbers are there");
  return 0;
}
