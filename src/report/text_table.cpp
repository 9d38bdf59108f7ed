// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.h"

#include <algorithm>

namespace millwright::report {

std::string Style::wrap(std::string_view begin, std::string_view text) const {
  if (!colour || text.empty()) return std::string(text);
  return std::string(begin).append(text).append("\x1B[0m");
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == 0x1B) {
      while (i < text.size() && text[i] != 'm') ++i;
    } else if (byte == 0xCC ||
               (byte == 0xCD && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xB0)) {
      ++i;  // U+0300 to U+036F: combining marks (a dot or bar over a symbol)
    } else if ((byte & 0xC0U) != 0x80) {
      ++width;
    }
  }
  return width;
}

namespace {

std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
  if (width == 0 || display_width(text) <= width) return {std::string(text)};
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (!lines.back().empty() && display_width(lines.back()) + 1 + display_width(word) > width) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string blanks(width - std::min(width, display_width(text)), ' ');
  return align == Align::left ? text + blanks : blanks + text;
}

void drop_trailing_blanks(std::string& text) { text.erase(text.find_last_not_of(' ') + 1); }

using Cells = std::vector<std::vector<std::string>>;  // of one row: the lines of each cell

struct Layout {
  const std::vector<TableColumn>& columns;
  std::vector<std::size_t> widths;
  std::size_t indent;
};

void print_row(const Cells& cells, const Layout& layout, std::string& out) {
  std::size_t height = 1;
  for (const auto& cell : cells) height = std::max(height, cell.size());
  for (std::size_t line = 0; line < height; ++line) {
    std::string text(layout.indent, ' ');
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (layout.widths[i] == 0) continue;
      text += padded(line < cells[i].size() ? cells[i][line] : "", layout.widths[i], layout.columns[i].align) + "  ";
    }
    drop_trailing_blanks(text);
    out += text + '\n';
  }
}

}  // namespace

void TextTable::add(std::vector<std::string> cells) {
  cells.resize(columns_.size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::str(std::size_t indent, const Style& style) const {
  if (rows_.empty()) return {};
  Layout layout{columns_, std::vector<std::size_t>(columns_.size(), 0), indent};
  std::vector<Cells> all;
  for (const auto& row : rows_) {
    Cells cells;
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.push_back(lines_of(row[i], columns_[i].wrap));
      for (const std::string& line : cells.back()) layout.widths[i] = std::max(layout.widths[i], display_width(line));
    }
    all.push_back(std::move(cells));
  }
  Cells titles;
  bool titled = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (layout.widths[i] > 0) layout.widths[i] = std::max(layout.widths[i], display_width(columns_[i].title));
    titled = titled || !columns_[i].title.empty();
    titles.push_back({style.faint(columns_[i].title)});
  }
  std::string out;
  if (titled) print_row(titles, layout, out);
  for (const Cells& cells : all) print_row(cells, layout, out);
  return out;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string out;
  for (const std::string& line : lines_of(text, width)) {
    if (!out.empty()) out += '\n' + std::string(indent, ' ');
    out += line;
  }
  return out;
}

}  // namespace millwright::report
