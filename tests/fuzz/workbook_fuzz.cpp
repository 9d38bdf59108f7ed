// SPDX-License-Identifier: Apache-2.0
// Workbooks (XLSX, ODS) as bytes: zip directory, packed parts and their XML.
#include "workbook.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  text::Diagnostics diagnostics;
  fuzz::check(catalogue::read_workbook(fuzz::view(bytes, size), "parts.xlsx", "", diagnostics), diagnostics);
  return 0;
}
