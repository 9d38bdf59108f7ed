// SPDX-License-Identifier: Apache-2.0
#include "catalogue/overlay_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "catalogue/difference.h"
#include "catalogue/file_names.h"
#include "catalogue/stock.h"
#include "catalogue/suppliers.h"
#include "text/csv.h"
#include "text/number.h"

namespace millwright::catalogue {
namespace {

using Key = std::vector<std::string>;

struct FileKind {
  std::string_view name;
  std::vector<std::string_view> key;  ///< columns; the last one must be there
};

const std::vector<FileKind>& kinds() {
  static const std::vector<FileKind> all = {{"stock.csv", {"manufacturer", "part_number"}},
                                            {"suppliers.csv", {"supplier"}},
                                            {"offers.csv", {"manufacturer", "part_number", "supplier"}}};
  return all;
}

struct Line {
  text::SourceSpan where;
  text::DecimalMark mark = text::DecimalMark::point;
  std::map<std::string, std::string> cells;  ///< by column, those that are not empty
};
using Lines = std::map<Key, Line>;

std::string title_of(const FileKind& kind, const Key& key) {
  std::string title;
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (key[i].empty()) continue;
    title += (title.empty() ? "" : kind.key[i] == "supplier" ? ", " : " ") + key[i];
  }
  return title.empty() ? "(no name)" : title;
}

/// The lines of a file, over those of earlier places.
void read_lines(const std::filesystem::path& file, const FileKind& kind, Lines& lines, text::Diagnostics& diagnostics) {
  const auto csv = text::read_csv_file(file.string(), diagnostics);
  if (!csv || csv->columns().empty()) return;
  const std::size_t errors = diagnostics.error_count();
  if (is_stock_file(file))
    check_stock_lines(*csv, diagnostics);
  else
    check_supplier_lines(*csv, kind.name, diagnostics);
  if (diagnostics.error_count() != errors) return;
  for (std::size_t row = 0; row < csv->row_count(); ++row) {
    Key key;
    for (const std::string_view name : kind.key) {
      const auto column = csv->find_column(name);
      key.emplace_back(column ? csv->cell(row, *column) : std::string_view());
    }
    Line& line = lines[key];
    line = Line();
    line.where = csv->row_span(row);
    if (csv->separator() == ';') line.mark = text::DecimalMark::point_or_comma;
    for (std::size_t column = 0; column < csv->columns().size(); ++column) {
      const text::CsvColumn& named = csv->columns()[column];
      const bool names_line = std::find(kind.key.begin(), kind.key.end(), named.name) != kind.key.end();
      if (names_line || csv->cell(row, column).empty()) continue;
      const bool has_unit = named.unit && !named.unit->empty() && *named.unit != "1";
      line.cells[has_unit ? fmt::format("{} [{}]", named.name, *named.unit) : named.name] = csv->cell(row, column);
    }
  }
}

Lines lines_of(const std::vector<std::filesystem::path>& places, const FileKind& kind, text::Diagnostics& diagnostics) {
  Lines lines;
  for (const std::filesystem::path& place : places) {
    std::vector<std::filesystem::path> files = supplier_files(place);
    if (const auto stock = stock_file(place)) files.push_back(*stock);
    for (const std::filesystem::path& file : files)
      if (is_named(file, kind.name)) read_lines(file, kind, lines, diagnostics);
  }
  return lines;
}

bool same_cell(const Line& a, const std::string& in_a, const Line& b, const std::string& in_b) {
  if (in_a == in_b) return true;
  const auto x = text::parse_number(in_a, a.mark), y = text::parse_number(in_b, b.mark);
  return x && y && same_value(*x, *y);
}

std::vector<LineCell> changed_cells(const Line& a, const Line& b) {
  std::set<std::string> names;
  for (const Line* line : {&a, &b})
    for (const auto& [name, cell] : line->cells) names.insert(name);
  const auto cell_of = [](const Line& line, const std::string& name) {
    const auto found = line.cells.find(name);
    return found == line.cells.end() ? std::string() : found->second;
  };
  std::vector<LineCell> cells;
  for (const std::string& name : names) {
    std::string in_a = cell_of(a, name), in_b = cell_of(b, name);
    if (!same_cell(a, in_a, b, in_b)) cells.push_back({name, std::move(in_a), std::move(in_b)});
  }
  return cells;
}

FileDifference difference_of(const FileKind& kind, const Lines& a, const Lines& b) {
  FileDifference found{std::string(kind.name), {}, {}, {}, 0};
  for (const auto& [key, line] : a)
    if (!b.contains(key)) found.removed.push_back({title_of(kind, key), line.where, {}, {}});
  for (const auto& [key, line] : b) {
    const auto before = a.find(key);
    if (before == a.end()) {
      found.added.push_back({title_of(kind, key), {}, line.where, {}});
      continue;
    }
    std::vector<LineCell> cells = changed_cells(before->second, line);
    if (cells.empty())
      ++found.same;
    else
      found.changed.push_back({title_of(kind, key), before->second.where, line.where, std::move(cells)});
  }
  return found;
}

}  // namespace

std::vector<FileDifference> overlay_difference(const std::vector<std::filesystem::path>& a,
                                               const std::vector<std::filesystem::path>& b,
                                               text::Diagnostics& diagnostics) {
  std::vector<FileDifference> result;
  for (const FileKind& kind : kinds()) {
    const Lines in_a = lines_of(a, kind, diagnostics), in_b = lines_of(b, kind, diagnostics);
    if (!in_a.empty() || !in_b.empty()) result.push_back(difference_of(kind, in_a, in_b));
  }
  return result;
}

}  // namespace millwright::catalogue
