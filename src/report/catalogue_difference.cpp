// SPDX-License-Identifier: Apache-2.0
#include "report/catalogue_difference.h"

#include <fmt/format.h>

#include <cmath>

#include "report/design_text.h"
#include "report/json_value.h"

namespace millwright::report {

namespace {

using catalogue::CellChange;
using catalogue::FamilyDifference;
using catalogue::Table;

constexpr const char* not_given = "–";
constexpr std::size_t most_points = 12;  ///< of a curve, listed; JSON has them all

std::string counted(std::size_t count, const char* what) { return fmt::format("{} {}", count, what); }

std::string parts_text(std::size_t count) { return counted(count, count == 1 ? "part" : "parts"); }

std::string line_of(const text::SourceSpan& span) {
  return fmt::format("{}:{}", text::printable(span.text ? span.text->path() : std::string()), span.line);
}

std::string value_text(const std::string& value) { return value.empty() ? not_given : text::printable(value, 1000); }

std::string relative_text(double relative) {
  if (!std::isfinite(relative)) return {};
  constexpr double smallest = 5e-4;  // that three digits of a percent show
  if (std::abs(relative) < smallest) return fmt::format("{:+.0e} %", 100.0 * relative);
  return signed_text(100.0 * relative, 1) + " %";
}

std::string cells_text(const catalogue::PartChange& part, const Style& style) {
  TextTable table({{""}, {"", Align::left, 0, false, 2}, {"", Align::right}});
  std::size_t points = 0;
  for (const CellChange& cell : part.cells) {
    if (!cell.point.empty() && ++points > most_points) continue;
    std::string name = catalogue::changed_column(cell);
    if (!cell.point.empty()) name += " at " + cell.point;
    table.add({std::move(name), value_text(cell.a) + " -> " + value_text(cell.b), relative_text(cell.relative)});
  }
  std::string out = table.str(6, style);
  if (points > most_points) out += fmt::format("      ... and {} more (--json has them)\n", points - most_points);
  return out;
}

std::string changed_text(const Table& a, const Table& b, const catalogue::PartChange& part, const Style& style) {
  std::string title = text::printable(catalogue::part_title(b, part.b_row));
  if (part.a_points > 1 || part.b_points > 1)
    title += part.a_points == part.b_points ? fmt::format(", {} points", part.b_points)
                                            : fmt::format(", {} -> {} points", part.a_points, part.b_points);
  const std::string in_a = "A " + line_of(a.where(part.a_row)), in_b = "B " + line_of(b.where(part.b_row));
  const std::string together = "      " + in_a + "   " + in_b;
  return "    " + title + "\n" +
         style.faint(display_width(together) <= style.width ? together : "      " + in_a + "\n      " + in_b) + "\n" +
         cells_text(part, style);
}

std::string list_text(const char* title, const Table& table, const std::vector<int>& rows, const Style& style) {
  if (rows.empty()) return {};
  TextTable lines({{""}, {""}});
  for (const int row : rows) lines.add({text::printable(catalogue::part_title(table, row)), line_of(table.where(row))});
  return fmt::format("  {}\n", title) + lines.str(4, style);
}

std::string family_text(const Table& a, const Table& b, const FamilyDifference& family, const Style& style) {
  std::string out;
  if (!family.changed.empty()) out += "  changed\n";
  for (const catalogue::PartChange& part : family.changed) out += changed_text(a, b, part, style);
  return out + list_text("only in B", b, family.added, style) + list_text("only in A", a, family.removed, style);
}

std::string lines_list(const char* title, const std::vector<catalogue::LineChange>& changes, const Style& style) {
  if (changes.empty()) return {};
  TextTable lines({{""}, {""}});
  for (const catalogue::LineChange& each : changes)
    lines.add({text::printable(each.title), line_of(each.a_where.text ? each.a_where : each.b_where)});
  return fmt::format("  {}\n", title) + lines.str(4, style);
}

std::string file_text(const catalogue::FileDifference& file, const Style& style) {
  std::string out;
  if (!file.changed.empty()) out += "  changed\n";
  for (const catalogue::LineChange& each : file.changed) {
    const std::string in_a = "A " + line_of(each.a_where), in_b = "B " + line_of(each.b_where);
    out += fmt::format(
        "    {}\n{}\n", text::printable(each.title), style.faint(fmt::format("      {}\n      {}", in_a, in_b)));
    TextTable table({{""}, {"", Align::left, 0, false, 2}});
    for (const catalogue::LineCell& cell : each.cells)
      table.add({text::printable(cell.column), value_text(cell.a) + " -> " + value_text(cell.b)});
    out += table.str(6, style);
  }
  return out + lines_list("only in B", file.added, style) + lines_list("only in A", file.removed, style);
}

std::string counts_text(std::size_t added, std::size_t removed, std::size_t changed, std::size_t same) {
  std::string out;
  for (const auto& [count, what] : {std::pair<std::size_t, const char*>{added, "added"},
                                    {removed, "removed"},
                                    {changed, "changed"},
                                    {same, "the same"}})
    if (count > 0) out += (out.empty() ? "" : ", ") + counted(count, what);
  return out.empty() ? "nothing" : out;
}

std::string side_text(const char* letter, const ComparedCatalogue& side) {
  const int rows = side.catalogue ? side.catalogue->rows() : 0;
  return fmt::format("{}  {}, {} {}\n", letter, text::printable(side.name), rows, rows == 1 ? "row" : "rows");
}

Json place_of(const text::SourceSpan& span) {
  if (!span.text) return nullptr;
  return fmt::format("{}:{}:{}", span.text->path(), span.line, span.column);
}

Json part_json(const Table& table, int row) {
  return Json{{"manufacturer", table.manufacturer(row)},
              {"part_number", table.part_number(row)},
              {"title", catalogue::part_title(table, row)}};
}

Json cell_json(const CellChange& cell) {
  const auto given = [](const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); };
  Json json{{"column", catalogue::changed_column(cell)}};
  if (!cell.point.empty()) json["point"] = cell.point;
  json["a"] = given(cell.a);
  json["b"] = given(cell.b);
  json["relative_change"] = number(cell.relative);
  json["a_place"] = place_of(cell.a_where);
  json["b_place"] = place_of(cell.b_where);
  return json;
}

Json rows_json(const Table& table, const std::vector<int>& rows) {
  Json list = Json::array();
  for (const int row : rows) {
    list.push_back(part_json(table, row));
    list.back()["place"] = place_of(table.where(row));
  }
  return list;
}

Json line_json(const catalogue::LineChange& line) {
  Json json{{"line", line.title}};
  if (line.a_where.text && line.b_where.text) {
    json["a_place"] = place_of(line.a_where);
    json["b_place"] = place_of(line.b_where);
    json["cells"] = Json::array();
    const auto given = [](const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); };
    for (const catalogue::LineCell& cell : line.cells)
      json["cells"].push_back({{"column", cell.column}, {"a", given(cell.a)}, {"b", given(cell.b)}});
  } else {
    json["place"] = place_of(line.a_where.text ? line.a_where : line.b_where);
  }
  return json;
}

Json file_json(const catalogue::FileDifference& file) {
  const auto lines = [](const std::vector<catalogue::LineChange>& changes) {
    Json list = Json::array();
    for (const catalogue::LineChange& each : changes) list.push_back(line_json(each));
    return list;
  };
  return {{"file", file.file},
          {"same", file.same},
          {"changed", lines(file.changed)},
          {"added", lines(file.added)},
          {"removed", lines(file.removed)}};
}

Json changes_json(const Table& a, const Table& b, const std::vector<catalogue::PartChange>& changes) {
  Json list = Json::array();
  for (const catalogue::PartChange& part : changes) {
    Json json = part_json(b, part.b_row);
    json["a_place"] = place_of(a.where(part.a_row));
    json["b_place"] = place_of(b.where(part.b_row));
    if (part.a_points > 1 || part.b_points > 1) json["points"] = {{"a", part.a_points}, {"b", part.b_points}};
    json["cells"] = Json::array();
    for (const CellChange& cell : part.cells) json["cells"].push_back(cell_json(cell));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

std::string catalogue_difference_text(const ComparedCatalogue& a,
                                      const ComparedCatalogue& b,
                                      const std::vector<FamilyDifference>& families,
                                      const std::vector<catalogue::FileDifference>& files,
                                      const Style& style) {
  std::string out = side_text("A", a) + side_text("B", b) + "\n";
  std::size_t added = 0, removed = 0, changed = 0, same = 0;
  for (const FamilyDifference& family : families) {
    added += family.added.size();
    removed += family.removed.size();
    changed += family.changed.size();
    same += static_cast<std::size_t>(family.same);
    if (family.equal()) continue;
    out +=
        style.heading(catalogue::declaration(family.family).name) + ": " +
        counts_text(
            family.added.size(), family.removed.size(), family.changed.size(), static_cast<std::size_t>(family.same)) +
        "\n";
    if (!style.brief)
      out += family_text(a.catalogue->table(family.family), b.catalogue->table(family.family), family, style) + "\n";
  }
  std::size_t same_lines = 0;
  for (const catalogue::FileDifference& file : files) {
    added += file.added.size();
    removed += file.removed.size();
    changed += file.changed.size();
    same_lines += file.same;
    if (file.equal()) continue;
    out += style.heading(file.file) + ": " +
           counts_text(file.added.size(), file.removed.size(), file.changed.size(), file.same) + "\n";
    if (!style.brief) out += file_text(file, style) + "\n";
  }
  const bool equal = added + removed + changed == 0;
  const std::string lines =
      same_lines == 0
          ? std::string()
          : (same == 0 ? "" : parts_text(same) + " and ") +
                fmt::format("{} line{} of stock, suppliers and offers", same_lines, same_lines == 1 ? "" : "s");
  same += same_lines;
  return out + (equal ? "No differences: " + (lines.empty() ? parts_text(same) : lines) + " the same.\n"
                      : "In all: " + counts_text(added, removed, changed, same) + ".\n");
}

std::string catalogue_difference_json(const ComparedCatalogue& a,
                                      const ComparedCatalogue& b,
                                      const std::vector<FamilyDifference>& families,
                                      const std::vector<catalogue::FileDifference>& files) {
  Json json = result_of("catalogue diff");
  json["a"] = {{"name", a.name}, {"rows", a.catalogue->rows()}};
  json["b"] = {{"name", b.name}, {"rows", b.catalogue->rows()}};
  bool equal = true;
  Json list = Json::array();
  for (const FamilyDifference& family : families) {
    equal = equal && family.equal();
    const Table& in_a = a.catalogue->table(family.family);
    const Table& in_b = b.catalogue->table(family.family);
    list.push_back({{"family", catalogue::declaration(family.family).name},
                    {"same", family.same},
                    {"changed", changes_json(in_a, in_b, family.changed)},
                    {"added", rows_json(in_b, family.added)},
                    {"removed", rows_json(in_a, family.removed)}});
  }
  Json other_files = Json::array();
  for (const catalogue::FileDifference& file : files) {
    equal = equal && file.equal();
    other_files.push_back(file_json(file));
  }
  json["equal"] = equal;
  json["families"] = std::move(list);
  json["files"] = std::move(other_files);
  return text_of(json);
}

}  // namespace millwright::report
