// SPDX-License-Identifier: Apache-2.0
#include "text/excerpt.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "text/utf8.h"

namespace millwright::text {

namespace {

/// Screen columns for the source line; with the gutter it fits a terminal of 120.
constexpr std::size_t window = 100;
constexpr std::size_t tab_width = 4;

/// One character as shown, and the screen columns it takes.
struct Glyph {
  std::string shown;
  std::size_t width = 1;
};

/// Screen columns of a character: 0 for those that combine with the one before, 2 for East Asian wide ones (Unicode
/// Standard Annex 11, coarsely: an error of one column is harmless).
std::size_t screen_width(char32_t c) {
  if ((c >= 0x0300 && c <= 0x036F) || (c >= 0x200B && c <= 0x200F) || (c >= 0xFE00 && c <= 0xFE0F)) return 0;
  const bool wide = (c >= 0x1100 && c <= 0x115F) || (c >= 0x2E80 && c <= 0xA4CF) || (c >= 0xAC00 && c <= 0xD7A3) ||
                    (c >= 0xF900 && c <= 0xFAFF) || (c >= 0xFE30 && c <= 0xFE6F) || (c >= 0xFF00 && c <= 0xFF60) ||
                    (c >= 0x1F300 && c <= 0x1FAFF) || (c >= 0x20000 && c <= 0x3FFFD);
  return wide ? 2 : 1;
}

Glyph glyph_of(const Character& character, std::string_view bytes) {
  if (bytes == "\t") return {std::string(tab_width, ' '), tab_width};
  const bool bidi_control = (character.value >= 0x202A && character.value <= 0x202E) ||
                            (character.value >= 0x2066 && character.value <= 0x2069);
  if (character.valid && bidi_control) return {fmt::format("<U+{:04X}>", static_cast<unsigned>(character.value)), 8};
  const bool control = character.value < 0x20 || (character.value >= 0x7F && character.value < 0xA0);
  if (!character.valid || control) return {fmt::format("\\x{:02X}", static_cast<unsigned>(character.value)), 4};
  return {std::string(bytes), screen_width(character.value)};
}

/// The characters [first, last) of a line, decoded; `first` counts from 0.
std::vector<Glyph> glyphs(std::string_view line, std::size_t first, std::size_t last) {
  std::vector<Glyph> result;
  std::size_t offset = bytes_of_characters(line, first);
  for (std::size_t i = first; i < last && offset < line.size(); ++i) {
    const Character character = decode(line, offset);
    result.push_back(glyph_of(character, line.substr(offset, static_cast<std::size_t>(character.bytes))));
    offset += static_cast<std::size_t>(character.bytes);
  }
  return result;
}

std::size_t total_width(const std::vector<Glyph>& shown) {
  std::size_t width = 0;
  for (const Glyph& glyph : shown) width += glyph.width;
  return width;
}

/// Cuts glyphs that do not fit into `width` columns off the end.
bool cut_end(std::vector<Glyph>& shown, std::size_t width) {
  std::size_t used = total_width(shown);
  bool cut = false;
  for (; used > width && !shown.empty(); cut = true) {
    used -= shown.back().width;
    shown.pop_back();
  }
  return cut;
}

std::string joined(const std::vector<Glyph>& shown) {
  std::string result;
  for (const Glyph& glyph : shown) result += glyph.shown;
  return result;
}

}  // namespace

Excerpt excerpt(const SourceSpan& span) {
  const std::string_view line = span.text->line(span.line);
  const auto caret = static_cast<std::size_t>(std::max(span.column, 1)) - 1;
  // Enough characters on both sides to fill the window; the rest of a 10 MB line is not looked at.
  const std::size_t first = caret > window ? caret - window : 0;
  std::vector<Glyph> before = glyphs(line, first, caret);
  std::vector<Glyph> after = glyphs(line, caret, caret + window + 1);

  // Without room problems the line is shown from its start; else the caret moves to two thirds of the window.
  bool cut_left = first > 0;
  const std::size_t room_before = std::max(window * 2 / 3, window - std::min(total_width(after), window));
  while (total_width(before) > room_before && !before.empty()) {
    before.erase(before.begin());
    cut_left = true;
  }
  const bool cut_right = cut_end(after, window - std::min(total_width(before), window)) ||
                         bytes_of_characters(line, caret + after.size()) < line.size();

  const auto marked = std::min(static_cast<std::size_t>(std::max(span.length, 1)), after.size());
  const std::vector<Glyph> under(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(marked));
  const std::size_t indent = total_width(before) + (cut_left ? 3 : 0);
  const std::size_t tildes = std::max<std::size_t>(total_width(under), 1) - 1;
  return {(cut_left ? "..." : "") + joined(before) + joined(after) + (cut_right ? "..." : ""),
          std::string(indent, ' ') + "^" + std::string(tildes, '~')};
}

}  // namespace millwright::text
