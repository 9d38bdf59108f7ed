// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "catalogue/import_fields.h"
#include "catalogue/lint.h"
#include "catalogue/read_table.h"
#include "text/utf8.h"

namespace millwright::catalogue {
namespace {

/// Rows that are examined together: all of them in any table that somebody made, and little memory where a program
/// made a million.
constexpr std::size_t rows_together = std::size_t{1} << 17U;

class ImportWriter {
 public:
  ImportWriter(const ImportSheet& sheet,
               const ImportMapping& mapping,
               const std::function<bool(std::string_view)>& write,
               text::Diagnostics& diagnostics)
      : sheet_(sheet), mapping_(mapping), write_(write), diagnostics_(diagnostics), fields_(mapping, diagnostics) {}

  ImportSummary run() {
    header_ = fields_.header_line();
    if (!write_(top() + header_)) return summary_;
    lines_ = header_;
    SheetRows row(sheet_, diagnostics_, mapping_.data_begin);
    while (row.next()) {
      if (is_no_part(row)) {
        ++summary_.left_out;
        if (summary_.left_out <= notes_kept) diagnostics_.note(row.span(), "no part: left out");
        continue;
      }
      const std::size_t begin = lines_.size();
      if (!fields_.append(row, lines_)) continue;
      places_.push_back({line_, row.begin()});
      line_ += static_cast<int>(std::count(lines_.begin() + static_cast<std::ptrdiff_t>(begin), lines_.end(), '\n'));
      ++summary_.rows;
      if (places_.size() == rows_together && !finish()) return summary_;
    }
    finish();
    return summary_;
  }

 private:
  static constexpr std::size_t notes_kept = 20;
  struct Place {
    int line;           ///< in the lines that are examined
    std::size_t begin;  ///< byte of the table where the row begins
  };

  std::string top() const {
    std::string text = fmt::format("# Imported from {}{}.\n",
                                   text::printable(std::filesystem::path(sheet_.text->path()).filename().string()),
                                   sheet_.sheet.empty() ? "" : ", sheet " + text::printable(sheet_.sheet));
    for (const std::string& title : mapping_.titles) text += "# " + text::printable(title, 300) + "\n";
    return text;
  }

  /// A title between the rows (one cell alone), or the header once more.
  bool is_no_part(const SheetRows& row) const {
    std::size_t used = 0;
    std::size_t like_header = 0;
    for (std::size_t i = 0; i < row.cells() && used < 4; ++i) {
      if (row.cell(i).empty()) continue;
      ++used;
      if (i < mapping_.columns.size() && row.cell(i) == mapping_.columns[i].header) ++like_header;
    }
    return mapping_.columns.size() >= 3 && (used == 1 || (used > 2 && like_header == used));
  }

  bool finish() {
    if (places_.empty()) return true;
    if (!write_(std::string_view(lines_).substr(header_.size()))) return false;
    const bool whole_table = summary_.rows <= rows_together;
    text::Diagnostics findings;
    const std::size_t size = lines_.size();
    {
      const auto text = text::SourceText::from_string(sheet_.text->path(), std::move(lines_));
      Table table = read_table(text, mapping_.family, 0, findings);
      drop_duplicates(table, findings);
      lint(table, findings);
      if (!whole_table || places_.size() == rows_together) find_far_duplicates(table, findings);
      translate(findings, *text);
    }
    lines_.reserve(size);  // the next ones are about as long
    lines_ = header_;
    places_.clear();
    line_ = 2;
    return true;
  }

  /// Parts that stood in earlier pieces already.
  void find_far_duplicates(const Table& table, text::Diagnostics& findings) {
    const auto old = static_cast<std::ptrdiff_t>(hashes_.size());
    for (int row = 0; row < table.rows(); ++row) {
      const std::uint64_t hash = table.part_hash(row, Identity::point);
      hashes_.push_back(hash);
      if (!std::binary_search(hashes_.begin(), hashes_.begin() + old, hash)) continue;
      findings.error(table.where(row),
                     fmt::format("duplicate part {} of {}: it stands far above already",
                                 text::in_quotes(table.part_number(row)),
                                 text::in_quotes(table.manufacturer(row))));
    }
    std::sort(hashes_.begin() + old, hashes_.end());
    std::inplace_merge(hashes_.begin(), hashes_.begin() + old, hashes_.end());
  }

  /// What lint says about our lines, said about the table's cells.
  void translate(const text::Diagnostics& findings, const text::SourceText& ours) {
    std::size_t errors = 0;
    std::size_t warnings = 0;
    for (text::Diagnostic& each : findings.all()) {
      if (each.severity == text::Severity::note) continue;
      ++(each.severity == text::Severity::error ? errors : warnings);
      if (each.where.line <= 1) {
        // Of missing columns the proposal has told; unknown ones are kept on purpose.
        if (each.severity == text::Severity::warning) continue;
        each.where = mapping_.header;
      } else {
        each.where = place(each.where, ours);
      }
      if (each.related) each.related = each.related->line <= 1 ? mapping_.header : place(*each.related, ours);
      diagnostics_.add(std::move(each));
    }
    const auto more = [&](text::Severity severity, std::size_t count) {
      if (count == 0) return;
      text::Diagnostic rest;
      rest.severity = severity;
      rest.where = text::whole(sheet_.text);
      rest.message =
          fmt::format("{} more of the kind in rows {} to {}", count, summary_.rows - places_.size() + 1, summary_.rows);
      diagnostics_.add(std::move(rest));
    };
    more(text::Severity::error, findings.error_count() - errors);
    more(text::Severity::warning, findings.warning_count() - warnings);
  }

  text::SourceSpan place(const text::SourceSpan& where, const text::SourceText& ours) const {
    const auto after = std::upper_bound(
        places_.begin(), places_.end(), where.line, [](int line, const Place& each) { return line < each.line; });
    if (after == places_.begin()) return mapping_.header;
    const Place& found = *(after - 1);
    text::Diagnostics unused;
    SheetRows row(sheet_, unused, found.begin);
    if (!row.next()) return mapping_.header;
    if (found.line != where.line) return row.span();
    const std::string_view line = ours.line(where.line);
    const std::size_t end = text::bytes_of_characters(line, static_cast<std::size_t>(std::max(where.column - 1, 0)));
    std::size_t field = 0;
    bool quoted = false;
    for (const char c : line.substr(0, end)) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++field;
    }
    const auto& fields = fields_.fields();
    return field < fields.size() && fields[field].source ? row.span(*fields[field].source) : row.span();
  }

  const ImportSheet& sheet_;
  const ImportMapping& mapping_;
  const std::function<bool(std::string_view)>& write_;
  text::Diagnostics& diagnostics_;
  ImportFields fields_;
  ImportSummary summary_;
  std::string header_;
  std::string lines_;
  int line_ = 2;
  std::vector<Place> places_;
  std::vector<std::uint64_t> hashes_;
};

}  // namespace

ImportSummary write_import(const ImportSheet& sheet,
                           const ImportMapping& mapping,
                           const std::function<bool(std::string_view)>& write,
                           text::Diagnostics& diagnostics) {
  const ImportSummary summary = ImportWriter(sheet, mapping, write, diagnostics).run();
  if (summary.rows == 0 && !diagnostics.has_errors())
    diagnostics.error(mapping.header, "there are no parts below the header");
  return summary;
}

}  // namespace millwright::catalogue
