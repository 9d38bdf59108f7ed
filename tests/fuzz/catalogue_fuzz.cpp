// SPDX-License-Identifier: Apache-2.0
// Catalogue files and what lint says of them. The first line names the family.
#include <cmath>

#include "catalogue/lint.h"
#include "catalogue/read_table.h"
#include "fuzz.h"

using namespace millwright;

namespace {

void check_figures(const catalogue::Table& table) {
  for (std::size_t index = 0; index < catalogue::column_count(table.family()); ++index) {
    const catalogue::Column column{table.family(), static_cast<std::uint8_t>(index)};
    const bool is_text = catalogue::declaration(column).kind == catalogue::Kind::text;
    for (int row = 0; row < table.rows(); ++row) {
      if (is_text)
        (void)table.text(column, row);
      else
        fuzz::require(!std::isinf(table.number(column, row)), "figures are finite or not known");
      fuzz::check(table.where(row, column), "a cell");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string_view input = fuzz::view(bytes, size);
  const std::string_view name = fuzz::first_line(input);
  const catalogue::Family family = catalogue::find_family(name).value_or(catalogue::Family::steppers);
  text::Diagnostics diagnostics;
  catalogue::Table table =
      catalogue::read_table(text::SourceText::from_string("parts.csv", std::string(input)), family, 0, diagnostics);
  check_figures(table);
  catalogue::drop_duplicates(table, diagnostics);
  catalogue::lint(table, diagnostics);
  fuzz::check(diagnostics);
  for (int row = 0; row < table.rows(); ++row) {
    const auto found = table.find(table.part_number(row), table.manufacturer(row));
    fuzz::require(static_cast<bool>(found), "a part is found by its name");
    (void)table.piece_price(row);
  }
  return 0;
}
