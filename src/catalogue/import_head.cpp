// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_head.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "catalogue/import_names.h"
#include "catalogue/import_unit.h"
#include "text/csv.h"

namespace millwright::catalogue {
namespace {

constexpr std::size_t rows_looked_at = 40;
constexpr std::size_t rows_sampled = 200;
constexpr std::size_t samples_kept = 50;
constexpr std::size_t longest_header_cell = 500;
constexpr std::size_t longest_name = 80;  ///< of a column, when a header is looked for

bool names_a_column(std::string_view cell, Family family) {
  for (const HeaderReading& reading : header_readings(cell)) {
    const std::vector<std::string> words = words_of(reading.name);
    for (std::size_t index = 0; index < column_count(family); ++index)
      if (name_match(words, Column{family, static_cast<std::uint8_t>(index)}) >= 0.7) return true;
  }
  return false;
}

/// How many cells of the row name a column of ours or, with a mapping file, one of its columns.
std::size_t names_in(const SheetRows& row, const ImportChoices& choices) {
  std::size_t count = 0;
  const std::size_t looked_at = std::min(row.cells(), text::CsvTable::column_limit);
  for (std::size_t i = 0; i < looked_at; ++i) {
    const std::string_view cell = row.cell(i);
    if (cell.empty() || cell.size() > longest_header_cell || row.is_number(i)) continue;
    if (choices.complete)
      count +=
          std::any_of(
              choices.columns.begin(), choices.columns.end(), [&](const auto& given) { return given.from == cell; })
              ? 1
              : 0;
    else if (cell.size() <= longest_name && cut_cell(cell).number.size() < cell.size())
      count += names_a_column(cell, choices.family) ? 1 : 0;
  }
  return count;
}

bool is_units_row(const SheetRows& row) {
  std::size_t units = 0;
  std::size_t others = 0;
  for (std::size_t i = 0; i < row.cells(); ++i) {
    const std::string_view cell = row.cell(i);
    if (cell.empty() || says_unknown(cell)) continue;
    if (is_any_unit(cell))
      ++units;
    else
      ++others;
    if (cut_cell(cell).number.size() == cell.size()) return false;
  }
  return units >= 2 && units > others;
}

/// Units and samples of the first `used` columns, from the rows after the header.
void sample_rows(SheetRows& row, std::size_t used, TableHead& head) {
  head.samples.resize(used);
  head.data_begin = row.end();
  for (std::size_t i = 0; i < rows_sampled && row.next(); ++i) {
    if (i == 0 && is_units_row(row)) {
      for (std::size_t column = 0; column < used; ++column) head.units.emplace_back(row.cell(column));
      head.data_begin = row.end();
      continue;
    }
    for (std::size_t column = 0; column < std::min(used, row.cells()); ++column) {
      const std::string_view cell = row.cell(column);
      if (cell.empty() || says_unknown(cell) || head.samples[column].size() >= samples_kept) continue;
      head.samples[column].push_back({std::string(cell.substr(0, longest_header_cell)), row.is_number(column)});
    }
  }
}

/// Nothing was found that is imported from such a table.
void report_no_head(const ImportSheet& sheet, const ImportChoices& choices, text::Diagnostics& diagnostics) {
  const std::string family(declaration(choices.family).name);
  const std::string message =
      choices.complete ? "no row holds the headers that the mapping names"
                       : fmt::format("no row among the first {} names columns of {}", rows_looked_at, family);
  std::string hint = choices.complete ? "is this the table it was made for?"
                                      : "is it another family? 'millwright catalogue list' shows them; a mapping "
                                        "file can name the columns";
  if (!sheet.others.empty()) {  // often the first one is a cover
    constexpr std::size_t shown = 200;
    hint = fmt::format("this is sheet {}; --sheet reads another one: {}; or {}",
                       text::in_quotes(sheet.sheet),
                       text::printable(fmt::format("{}", fmt::join(sheet.others, ", ")), shown),
                       hint);
  }
  diagnostics.error(text::whole(sheet.text), message, hint);
}

}  // namespace

std::optional<TableHead> find_head(const ImportSheet& sheet,
                                   const ImportChoices& choices,
                                   text::Diagnostics& diagnostics) {
  struct Best {
    std::size_t names = 0;
    std::size_t begin = 0;
  } best;
  {
    text::Diagnostics unused;
    SheetRows row(sheet, unused);
    for (std::size_t i = 0; i < rows_looked_at && row.next(); ++i) {
      const std::size_t names = names_in(row, choices);
      if (names > best.names) best = {names, row.begin()};
      if (names >= 3 && 2 * names > row.cells()) break;
    }
  }
  SheetRows row(sheet, diagnostics);
  TableHead head;
  bool found = false;
  while (!found && row.next()) {
    found = best.names > 0 && row.begin() == best.begin;
    std::string title;
    for (std::size_t i = 0; !found && i < row.cells() && title.size() < longest_header_cell; ++i)
      if (!row.cell(i).empty())
        title += (title.empty() ? "" : " ") + std::string(row.cell(i).substr(0, longest_header_cell));
    if (!found && head.titles.size() < rows_looked_at) head.titles.push_back(std::move(title));
    if (best.names == 0) break;
  }
  if (!found) {
    report_no_head(sheet, choices, diagnostics);
    return std::nullopt;
  }
  std::size_t used = row.cells();
  while (used > 1 && row.cell(used - 1).empty()) --used;
  head.span = row.span();
  if (used > text::CsvTable::column_limit) {
    diagnostics.error(text::span_at(sheet.text, row.begin(), 1),
                      fmt::format("a header of {} columns", used),
                      fmt::format("at most {} are read", text::CsvTable::column_limit));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < used; ++i) {
    head.cells.emplace_back(row.cell(i));
    head.spans.push_back(row.span(i));
    if (head.cells.back().size() > longest_header_cell)
      diagnostics.error(head.spans.back(), fmt::format("a header cell of {} bytes", head.cells.back().size()));
  }
  sample_rows(row, used, head);
  return head;
}

}  // namespace millwright::catalogue
