// SPDX-License-Identifier: Apache-2.0
#include "text/csv_header.h"

#include <algorithm>

#include "text/characters.h"

namespace millwright::text {

namespace {

/// The separator a header uses: of `,` and `;` the more frequent one outside quotes and brackets.
char separator_of(std::string_view contents, std::size_t begin) {
  bool in_quotes = false;
  bool in_brackets = false;
  std::size_t commas = 0;
  std::size_t semicolons = 0;
  for (std::size_t i = begin; i < contents.size(); ++i) {
    const char c = contents[i];
    if (c == '"') in_quotes = !in_quotes;
    if (in_quotes) continue;
    if (c == '\n') break;
    if (c == '[') in_brackets = true;
    if (c == ']') in_brackets = false;
    if (in_brackets) continue;
    commas += c == ',' ? 1 : 0;
    semicolons += c == ';' ? 1 : 0;
  }
  return semicolons > commas ? ';' : ',';
}

}  // namespace

CsvPreamble read_preamble(const std::shared_ptr<const SourceText>& text) {
  CsvPreamble preamble;
  const std::string_view contents = text->contents();
  bool named = false;
  std::size_t begin = 0;
  while (begin < contents.size()) {
    const std::size_t end = std::min(contents.find('\n', begin), contents.size());
    const std::string_view line = without_blanks(contents.substr(begin, end - begin));
    if (!line.empty() && line.front() == '#') {
      const auto offset = static_cast<std::size_t>(line.data() - contents.data());
      preamble.comments.push_back({std::string(without_blanks(line.substr(1))), span_at(text, offset, line.size())});
    } else if (!named && (line == "sep=;" || line == "sep=,")) {
      named = true;
      preamble.separator = line.back();
    } else if (!line.empty()) {
      break;
    }
    begin = std::min(end + 1, contents.size());
  }
  preamble.header_begin = begin;
  if (!named) preamble.separator = separator_of(contents, begin);
  return preamble;
}

CsvColumn read_header_cell(const std::shared_ptr<const SourceText>& text,
                           std::size_t offset,
                           std::string_view content,
                           bool exact,
                           Diagnostics& diagnostics) {
  CsvColumn column;
  column.span = span_at(text, offset, content.size());
  const auto part = [&](std::string_view piece) {
    if (!exact || piece.empty()) return column.span;
    return span_at(text, offset + static_cast<std::size_t>(piece.data() - content.data()), piece.size());
  };
  const std::string_view trimmed = without_blanks(content);
  const std::size_t open = trimmed.find('[');
  const std::string_view name = without_blanks(trimmed.substr(0, open));
  column.name = std::string(name);
  column.name_span = part(name);
  column.unit_span = column.span;
  if (name.empty()) {
    diagnostics.error(column.span, "a column without a name", "give each column a name");
  }
  if (open == std::string_view::npos) {
    if (trimmed.find(']') != std::string_view::npos) {
      diagnostics.error(column.span, "']' without '['", "a header cell is a name and a unit in brackets: mass [kg]");
    }
    return column;
  }
  const std::size_t close = trimmed.find(']', open);
  if (close != trimmed.size() - 1 || trimmed.find('[', open + 1) != std::string_view::npos) {
    diagnostics.error(part(trimmed.substr(open)),
                      "the unit of a column must end with ']', and nothing may follow it",
                      "a header cell is a name and a unit in brackets: mass [kg]");
    return column;
  }
  const std::string_view unit = without_blanks(trimmed.substr(open + 1, close - open - 1));
  column.unit = std::string(unit);
  column.unit_span = part(unit);
  return column;
}

}  // namespace millwright::text
