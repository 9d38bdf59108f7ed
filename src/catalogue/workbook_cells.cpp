// SPDX-License-Identifier: Apache-2.0
#include "catalogue/workbook_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "catalogue/import_sheet.h"
#include "text/csv.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

constexpr std::int64_t most_rows = 1 << 20;
constexpr auto most_columns = static_cast<std::int64_t>(text::CsvTable::column_limit);

void append_quoted(std::string& line, std::string_view text) {
  const bool quoted =
      text.find('"') != std::string_view::npos || (!text.empty() && (text.front() == ' ' || text.back() == ' '));
  if (quoted) line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  }
  if (quoted) line += '"';
}

}  // namespace

void WorkbookCells::add(std::int64_t row, std::int64_t column, std::string_view text, bool is_number) {
  if (row < 0 || row >= most_rows || column < 0 || column >= most_columns)
    throw WorkbookProblem{fmt::format("has a cell in row {}, column {}", row + 1, column + 1),
                          fmt::format("at most {} rows and {} columns are read", most_rows, most_columns)};
  if (text.size() > longest_cell)
    throw WorkbookProblem{fmt::format("has a cell of {} bytes in row {}, column {}", text.size(), row + 1, column + 1),
                          {}};
  if (cells_.size() >= workbook_cell_limit || texts_.size() + text.size() > workbook_size_limit)
    throw WorkbookProblem{
        fmt::format(
            "has more than {} cells, or {} MB of text, in a sheet", workbook_cell_limit, workbook_size_limit >> 20U),
        "save the sheet as CSV (UTF-8) and import that"};
  cells_.push_back({static_cast<std::int32_t>(row),
                    static_cast<std::int32_t>(column),
                    static_cast<std::uint32_t>(texts_.size()),
                    static_cast<std::uint32_t>(text.size()),
                    is_number});
  texts_ += text;
}

void WorkbookCells::add_text(std::int64_t row, std::int64_t column, std::string_view text) {
  if (!text.empty()) add(row, column, text, false);
}

void WorkbookCells::add_number(std::int64_t row, std::int64_t column, double value, std::string_view unit) {
  // Spreadsheets show and keep 15 digits; a whole number, a part number perhaps, is written in full.
  constexpr double exact_limit = 9007199254740992.0;  // 2^53
  const bool whole = std::abs(value) < exact_limit && std::trunc(value) == value;
  const std::string figure = whole ? fmt::format("{:.0f}", value) : fmt::format("{:.15g}", value);
  const std::string text = unit == "%"    ? fmt::format("{:.14g}%", value * 100.0)
                           : unit.empty() ? figure
                                          : fmt::format("{} {}", figure, unit);
  add(row, column, text, true);
}

void WorkbookCells::repeat_last_row(std::int64_t count) {
  if (cells_.empty()) return;
  const std::int32_t row = cells_.back().row;
  std::size_t first = cells_.size();
  while (first > 0 && cells_[first - 1].row == row) --first;
  const std::vector<Cell> copied(cells_.begin() + static_cast<std::ptrdiff_t>(first), cells_.end());
  for (std::int64_t i = 1; i <= count; ++i)
    for (const Cell& cell : copied)
      add(row + i, cell.column, std::string(std::string_view(texts_).substr(cell.begin, cell.length)), cell.is_number);
}

void WorkbookCells::render(WorkbookSheet& sheet) {
  std::stable_sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::int32_t row = 0;
  std::int32_t column = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    if (i + 1 < cells_.size() && cells_[i + 1].row == cell.row && cells_[i + 1].column == cell.column) continue;
    for (; row < cell.row; ++row, column = 0) sheet.text += '\n';
    for (; column < cell.column; ++column) sheet.text += '\t';
    if (sheet.text.size() > 2 * workbook_size_limit) throw WorkbookProblem{"holds too much text", {}};
    if (cell.is_number) sheet.numbers.push_back(static_cast<std::uint32_t>(sheet.text.size()));
    append_quoted(sheet.text, std::string_view(texts_).substr(cell.begin, cell.length));
  }
  if (!sheet.text.empty()) sheet.text += '\n';
}

WorkbookParts::WorkbookParts(std::string_view bytes) : bytes_(bytes) {
  std::string reason;
  auto directory = text::zip_directory(bytes, reason);
  if (!directory) throw WorkbookProblem{reason, {}};
  directory_ = std::move(*directory);
}

bool WorkbookParts::has(std::string_view name) const {
  return std::any_of(directory_.begin(), directory_.end(), [&](const auto& entry) { return entry.name == name; });
}

std::string WorkbookParts::part(const std::string& name, bool required) const {
  const auto entry =
      std::find_if(directory_.begin(), directory_.end(), [&](const auto& each) { return each.name == name; });
  if (entry == directory_.end()) {
    if (!required) return {};
    throw WorkbookProblem{"lacks its part " + text::in_quotes(name), {}};
  }
  if (entry->unpacked > workbook_size_limit)
    throw WorkbookProblem{fmt::format("{} in it unpacks to {} MB; at most {} MB are read",
                                      text::in_quotes(name),
                                      entry->unpacked >> 20U,
                                      workbook_size_limit >> 20U),
                          "save the sheet as CSV (UTF-8) and import that"};
  std::string reason;
  auto unpacked = text::unzip(bytes_, *entry, reason);
  if (!unpacked) throw WorkbookProblem{fmt::format("{} in it {}", text::in_quotes(name), reason), {}};
  return std::move(*unpacked);
}

std::size_t wanted_sheet(const std::string& wanted, const std::vector<std::string>& names) {
  if (names.empty()) throw WorkbookProblem{"has no sheets", {}};
  if (wanted.empty()) return 0;
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string all = text::printable(fmt::format("sheets: {}", fmt::join(names, ", ")));
  throw WorkbookProblem{"has no sheet " + text::in_quotes(wanted), text::did_you_mean(wanted, names, all)};
}

std::int64_t attribute_number(std::string_view text, std::int64_t fallback) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return fallback;
  return std::clamp<std::int64_t>(value, -1, std::int64_t{1} << 40U);
}

std::optional<WorkbookSheet> read_workbook(std::string_view bytes,
                                           const std::string& path,
                                           const std::string& wanted,
                                           text::Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    diagnostics.error(text::whole(text::SourceText::from_string(path, {})), message, hint);
    return std::nullopt;
  };
  try {
    const WorkbookParts parts(bytes);
    WorkbookSheet sheet;
    WorkbookCells cells;
    if (parts.has("content.xml"))
      read_ods(parts, wanted, sheet, cells);
    else if (parts.has("xl/workbook.bin"))
      throw WorkbookProblem{"is a binary workbook (.xlsb)", "save it as .xlsx"};
    else if (parts.has("xl/workbook.xml"))
      read_xlsx(parts, wanted, sheet, cells);
    else
      throw WorkbookProblem{"is a zip file, but no workbook", "workbooks are .xlsx and .ods files"};
    cells.render(sheet);
    return sheet;
  } catch (const WorkbookProblem& problem) {
    return refuse(problem.message, problem.hint);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& problem) {
    return refuse("is damaged: " + text::printable(problem.what()),
                  "open it in a spreadsheet program and save it anew");
  }
}

}  // namespace millwright::catalogue
