// SPDX-License-Identifier: Apache-2.0
// `catalogue import`: somebody's table, in whatever encoding, or a workbook, up to the file that is written. The first
// line says the family and, if a second word is there, the encoding.
#include "catalogue/import_mapping_file.h"
#include "catalogue/import_write.h"
#include "catalogue/read_table.h"
#include "fuzz.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::MemoryFile file;
  std::string_view input = fuzz::view(bytes, size);
  const std::string_view said = fuzz::first_line(input);
  const std::size_t blank = std::min(said.find(' '), said.size());
  const catalogue::Family family = catalogue::find_family(said.substr(0, blank)).value_or(catalogue::Family::steppers);
  catalogue::SheetFormat format;
  for (const char* encoding : {"utf-8", "utf-16", "windows-1252"})
    if (said.substr(std::min(blank + 1, said.size())) == encoding) format.encoding = encoding;
  file.hold(input);
  text::Diagnostics diagnostics;
  const auto sheet = catalogue::load_sheet(file.path(), format, diagnostics);
  fuzz::require(sheet || diagnostics.has_errors(), "a table that is refused is complained about");
  catalogue::ImportChoices choices;
  choices.family = family;
  const auto mapping = sheet ? catalogue::propose_mapping(*sheet, choices, diagnostics) : std::nullopt;
  if (!mapping) {
    fuzz::require(diagnostics.has_errors(), "a table that is refused is complained about");
    fuzz::check(diagnostics);
    return 0;
  }
  std::string written;
  const auto take = [&](std::string_view lines) {
    written += lines;
    return true;
  };
  const catalogue::ImportSummary summary = catalogue::write_import(*sheet, *mapping, take, diagnostics);
  fuzz::check(diagnostics);
  (void)catalogue::mapping_text(*mapping, {.family = family, .format = format, .choices = choices}, true);
  if (diagnostics.has_errors()) return 0;
  text::Diagnostics found;
  const catalogue::Table table =
      catalogue::read_table(text::SourceText::from_string("written.csv", written), family, 0, found);
  fuzz::require(!found.has_errors(), "what was written can be read", text::format(found) + written);
  fuzz::require(static_cast<std::size_t>(table.rows()) == summary.rows, "what was written is all there", written);
  return 0;
}
