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

constexpr std::size_t unlimited = static_cast<std::size_t>(-1);

/// The end of a word that begins at `at`; with `inside`, of the piece of it after which a name may be broken.
std::size_t end_of_piece(std::string_view text, std::size_t at, bool inside) {
  for (std::size_t i = at; i < text.size(); ++i) {
    if (text[i] == ' ' || text[i] == '\n') return i;
    // A mark at the beginning belongs to what follows: -1.5, ~70.24.
    if (inside && i > at && i + 1 < text.size() && std::string_view("_./,-:=)").find(text[i]) != std::string_view::npos)
      return i + 1;
  }
  return text.size();
}

/// What cannot be broken is the narrowest that the text can be set in.
std::size_t narrowest(std::string_view text, bool inside) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_piece(text, at, inside);
    width = std::max(width, display_width(text.substr(at, end - at)));
    at = end < text.size() && (text[end] == ' ' || text[end] == '\n') ? end + 1 : std::max(end, at + 1);
  }
  return width;
}

/// Breaks a text into lines: at line ends, between words, and `inside` words that are too long for a line. Lines after
/// the first begin with `hang` blanks.
class LineBreaker {
 public:
  LineBreaker(std::size_t width, bool inside, std::size_t hang) : width_(width), inside_(inside), hang_(hang) {}

  std::vector<std::string> lines(std::string_view text) {
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      begin();
      if (const std::string_view part = text.substr(at, end - at); used_ + display_width(part) <= width_)
        lines_.back() += part;
      else
        add_words(part);
      at = end + 1;
    }
    return std::move(lines_);
  }

 private:
  void begin() {
    used_ = lines_.empty() ? 0 : hang_;
    lines_.emplace_back(used_, ' ');
    empty_ = true;
  }
  void put(std::string_view piece) {
    lines_.back() += piece;
    used_ += display_width(piece);
    empty_ = false;
  }
  void add_words(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = end_of_piece(text, at, false);
      const std::string_view word = text.substr(at, end - at);
      at = end + 1;
      if (!empty_ && used_ + 1 + display_width(word) > width_) begin();
      if (!empty_) put(" ");
      if (!inside_ || used_ + display_width(word) <= width_)
        put(word);
      else
        add_pieces(word);
    }
  }
  void add_pieces(std::string_view word) {
    for (std::size_t at = 0; at < word.size();) {
      const std::size_t end = end_of_piece(word, at, true);
      const std::string_view piece = word.substr(at, end - at);
      if (!empty_ && used_ + display_width(piece) > width_) begin();
      put(piece);
      at = end;
    }
  }

  std::size_t width_;
  bool inside_;
  std::size_t hang_;
  std::vector<std::string> lines_;
  std::size_t used_ = 0;
  bool empty_ = true;
};

/// `width` 0: as long as they are.
std::vector<std::string> lines_of(std::string_view text, std::size_t width, bool inside = false, std::size_t hang = 0) {
  return LineBreaker(width == 0 ? unlimited : width, inside, hang).lines(text);
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
  for (std::size_t i = 0; i < cells.size(); ++i)  // (the title of a column that is left out is many lines of no width)
    if (layout.widths[i] > 0) height = std::max(height, cells[i].size());
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

namespace {

/// How wide each column is set, and whether names in it are broken.
class Widths {
 public:
  Widths(const std::vector<TableColumn>& columns, const std::vector<std::vector<std::string>>& rows)
      : columns_(columns), rows_(rows), widths_(columns.size(), 0), inside_(columns.size(), 0) {
    for (const auto& row : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        for (const std::string& line : lines_of(row[i], columns[i].wrap, false, columns[i].hang))
          widths_[i] = std::max(widths_[i], display_width(line));
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (widths_[i] > 0) widths_[i] = std::max(widths_[i], display_width(columns[i].title));
  }

  void fit(std::size_t width) {
    narrow(width, Align::left, false);
    narrow(width, Align::left, true);
    narrow(width, Align::right, false);
  }

  [[nodiscard]] std::vector<std::string> lines(std::size_t column, const std::string& text) const {
    const std::size_t wrap = columns_[column].wrap;
    const std::size_t width = std::max<std::size_t>(widths_[column], 1);
    return lines_of(text, wrap == 0 ? width : std::min(wrap, width), inside_[column] != 0, columns_[column].hang);
  }

 private:
  [[nodiscard]] std::size_t total() const {
    std::size_t sum = 0;
    for (const std::size_t width : widths_) sum += width > 0 ? width + 2 : 0;
    return sum > 0 ? sum - 2 : 0;
  }

  /// The widest of these columns give way until the line fits, none below what it needs.
  void narrow(std::size_t width, Align align, bool inside) {
    if (total() <= width) return;
    std::vector<std::size_t> least(widths_.size(), unlimited);
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      if (columns_[i].align != align) continue;
      if (columns_[i].whole) continue;
      least[i] = narrowest(columns_[i].title, false);
      for (const auto& row : rows_) least[i] = std::max(least[i], narrowest(row[i], inside) + columns_[i].hang);
    }
    while (total() > width) {
      std::size_t widest = widths_.size();
      for (std::size_t i = 0; i < widths_.size(); ++i)
        if (widths_[i] > least[i] && least[i] != unlimited &&
            (widest == widths_.size() || widths_[i] > widths_[widest]))
          widest = i;
      if (widest == widths_.size()) return;
      --widths_[widest];
      if (inside) inside_[widest] = 1;
    }
  }

  const std::vector<TableColumn>& columns_;
  const std::vector<std::vector<std::string>>& rows_;
  std::vector<std::size_t> widths_;
  std::vector<char> inside_;
};

}  // namespace

std::string TextTable::str(std::size_t indent, const Style& style) const {
  if (rows_.empty()) return {};
  Layout layout{columns_, std::vector<std::size_t>(columns_.size(), 0), indent};
  Widths widths(columns_, rows_);
  widths.fit(style.width > indent ? style.width - indent : 1);
  std::vector<Cells> all;
  for (const auto& row : rows_) {
    Cells cells;
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.push_back(widths.lines(i, row[i]));
      for (const std::string& line : cells.back()) layout.widths[i] = std::max(layout.widths[i], display_width(line));
    }
    all.push_back(std::move(cells));
  }
  Cells titles;
  bool titled = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::vector<std::string> lines = widths.lines(i, columns_[i].title);
    for (std::string& line : lines) {
      if (layout.widths[i] > 0) layout.widths[i] = std::max(layout.widths[i], display_width(line));
      line = style.faint(line);
    }
    titled = titled || !columns_[i].title.empty();
    titles.push_back(std::move(lines));
  }
  std::string out;
  if (titled) print_row(titles, layout, out);
  for (const Cells& cells : all) print_row(cells, layout, out);
  return out;
}

std::string fitted(std::string_view text, std::size_t width) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    if (display_width(line) <= width) {
      out += line;
    } else {
      const std::size_t indent = std::min(line.find_first_not_of(' '), width / 2);
      const std::vector<std::string> parts = lines_of(line.substr(indent), width - indent, false, 2);
      for (std::size_t i = 0; i < parts.size(); ++i) out += (i == 0 ? "" : "\n") + std::string(indent, ' ') + parts[i];
    }
    if (end < text.size()) out += '\n';
  }
  return out;
}

std::string equation(std::string_view text, std::size_t indent, std::size_t width) {
  const std::string blanks(indent, ' ');
  constexpr std::string_view equals = " = ";
  const std::size_t first = text.find(equals);
  if (indent + display_width(text) <= width || first == std::string_view::npos)
    return blanks + std::string(text) + '\n';
  const std::string below = '\n' + blanks + std::string(display_width(text.substr(0, first)), ' ');
  std::string out = blanks;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(equals, at == 0 ? first + 1 : at + 1), text.size());
    out += (at == 0 ? "" : below) + std::string(text.substr(at, end - at));
    at = end;
  }
  return out + '\n';
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
