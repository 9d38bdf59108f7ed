// SPDX-License-Identifier: Apache-2.0
// The parts of a workbook, which would be hard to hit in a packed one: each begins with a line `=== NAME`. What comes
// before the first of them is the name of the wanted sheet.
#include "catalogue/stored_zip.h"
#include "workbook.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::string_view heading = "=== ";
  std::string wanted;
  std::vector<catalogue::NamedBytes> parts;
  for (std::string_view input = fuzz::view(bytes, size); !input.empty();) {
    const std::string_view line = fuzz::first_line(input);
    if (line.starts_with(heading))
      parts.push_back({std::string(line.substr(heading.size())), {}});
    else
      (parts.empty() ? wanted : parts.back().bytes) += std::string(line) + (parts.empty() ? "" : "\n");
  }
  text::Diagnostics diagnostics;
  fuzz::check(catalogue::read_workbook(catalogue::stored_zip(parts), "parts.ods", wanted, diagnostics), diagnostics);
  return 0;
}
