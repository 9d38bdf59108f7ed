// SPDX-License-Identifier: Apache-2.0
// Aligned columns of text for a terminal or a file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::report {

/// How texts are set. Emphasis is ANSI escape sequences; without colour, texts pass through unchanged.
struct Style {
  bool colour = false;
  std::size_t width = 80;  ///< columns that a line may take
  bool brief = false;      ///< the essentials only
  bool full = false;       ///< all there is, where the usual is a page
  std::string heading(std::string_view text) const { return wrap("\x1B[1m", text); }
  std::string good(std::string_view text) const { return wrap("\x1B[32m", text); }
  std::string bad(std::string_view text) const { return wrap("\x1B[1;31m", text); }
  std::string faint(std::string_view text) const { return wrap("\x1B[2m", text); }

 private:
  std::string wrap(std::string_view begin, std::string_view text) const;
};

/// Columns that a text takes on a terminal: code points, without escape sequences and combining marks.
std::size_t display_width(std::string_view text);

enum class Align { left, right };

struct TableColumn {
  std::string title;
  Align align = Align::left;
  std::size_t wrap = 0;  ///< longer cells go on in further lines, broken between words; 0 = only where it must
  bool whole = false;    ///< not even then
  std::size_t hang = 0;  ///< further lines of a cell begin with so many blanks
};

/// Collects rows, then prints them with columns as wide as needed; a line end in a cell begins a line in it. Columns
/// without any content are left out. Where a line would be longer than the style's width, columns are made narrower,
/// the widest first: those of text between words, then inside long names (after _ . / and the like), numbers between
/// number and unit last.
class TextTable {
 public:
  explicit TextTable(std::vector<TableColumn> columns) : columns_(std::move(columns)) {}
  /// Missing cells at the end are empty.
  void add(std::vector<std::string> cells);
  bool empty() const { return rows_.empty(); }
  /// Header, rows; each line begins with `indent` blanks and ends without blanks. "" without rows.
  std::string str(std::size_t indent = 2, const Style& style = {}) const;

 private:
  std::vector<TableColumn> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// `text` with every line that is longer than `width` broken between words; what follows is indented by two more.
std::string fitted(std::string_view text, std::size_t width);

/// "a = b = c" behind so many blanks; where that is longer than `width`, "= c" goes on below "= b".
std::string equation(std::string_view text, std::size_t indent, std::size_t width);

/// `text` in lines of at most `width` columns (words are not broken), each after the first indented.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

}  // namespace millwright::report
