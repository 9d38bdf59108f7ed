// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "catalogue/import_workbook.h"
#include "text/file_bytes.h"
#include "text/table_size.h"
#include "text/text_check.h"
#include "text/utf8.h"

namespace millwright::catalogue {
namespace {

/// No spreadsheet has more columns.
constexpr std::size_t most_cells = 16384;
constexpr std::uintmax_t workbook_file_limit = std::uintmax_t{64} << 20U;
constexpr std::uintmax_t recoded_file_limit = std::uintmax_t{128} << 20U;

/// The bytes 80 to 9F of Windows-1252 (0: not used); the others are those of Unicode.
constexpr std::array<char16_t, 32> windows_1252 = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                                   0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

std::string from_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const char32_t value = byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80U] : byte;
    if (byte < 0x80 || value == 0)
      text += c;  // no character: stays wrong, and is reported
    else
      text::append_utf8(text, value);
  }
  return text;
}

/// UTF-16 with or without a byte order mark (then the lower byte first); what is wrong becomes a byte that is not
/// UTF-8.
std::string from_utf_16(std::string_view bytes) {
  const bool high_first = bytes.starts_with("\xFE\xFF");
  if (high_first || bytes.starts_with("\xFF\xFE")) bytes.remove_prefix(2);
  std::string text;
  text.reserve(bytes.size());
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(high_first ? a * 256 + b : b * 256 + a);
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t value = unit(i);
    if (value >= 0xD800 && value < 0xDC00 && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
      value = 0x10000 + ((value - 0xD800) << 10U) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    if (value >= 0xD800 && value < 0xE000)
      text += '\xFF';
    else
      text::append_utf8(text, value);
  }
  if (bytes.size() % 2 != 0) text += '\xFF';
  return text;
}

std::string separator_name(char separator) {
  return separator == '\t' ? "tabs" : separator == ';' ? "semicolons" : "commas";
}

/// Of tab, semicolon and comma the one that cuts the first lines most evenly into many cells.
char separator_of(std::string_view contents) {
  constexpr std::size_t looked_at = std::size_t{64} << 10U;
  contents = contents.substr(0, looked_at);
  if (contents.starts_with("sep=") && contents.size() > 4) {
    const char named = contents[4];
    if (named == ';' || named == ',' || named == '\t') return named;
  }
  char best = ',';
  std::size_t best_score = 0;
  for (const char candidate : {'\t', ';', ','}) {
    std::map<std::size_t, std::size_t> lines_with;  // number of separators: lines
    std::size_t count = 0;
    bool quoted = false;
    for (const char c : contents) {
      if (c == '"') quoted = !quoted;
      if (quoted) continue;
      if (c == candidate) ++count;
      if (c == '\n') {
        ++lines_with[count];
        count = 0;
      }
    }
    ++lines_with[count];
    std::size_t score = 0;
    for (const auto& [separators, lines] : lines_with) score = std::max(score, separators * lines);
    if (score > best_score) best = candidate;
    best_score = std::max(best_score, score);
  }
  return best;
}

bool lines_end_well(const std::shared_ptr<const text::SourceText>& text, text::Diagnostics& diagnostics) {
  const std::string_view contents = text->contents();
  for (std::size_t at = contents.find('\r'); at != std::string_view::npos; at = contents.find('\r', at + 1)) {
    if (at + 1 == contents.size() || contents[at + 1] == '\n') continue;
    diagnostics.error(text::span_at(text, at, 1),
                      "carriage return inside a line",
                      "lines end with LF or CR LF; save the file anew with such line ends");
    return false;
  }
  return true;
}

std::optional<ImportSheet> load_workbook(const std::string& path,
                                         const SheetFormat& format,
                                         text::Diagnostics& diagnostics) {
  const auto bytes = text::read_bytes(path, workbook_file_limit, diagnostics);
  if (!bytes) return std::nullopt;
  auto read = read_workbook(*bytes, path, format.sheet, diagnostics);
  if (!read) return std::nullopt;
  ImportSheet sheet;
  sheet.separator = '\t';
  sheet.sheet = read->name;
  std::remove_copy(read->names.begin(), read->names.end(), std::back_inserter(sheet.others), read->name);
  sheet.numbers = std::move(read->numbers);
  sheet.text = text::SourceText::from_string(path, std::move(read->text));
  if (format.sheet.empty() && read->names.size() > 1)
    sheet.remarks.push_back(fmt::format("sheet {}, the first of {}: {}",
                                        text::in_quotes(read->name),
                                        read->names.size(),
                                        text::printable(fmt::format("{}", fmt::join(read->names, ", ")), 120)));
  return sheet;
}

std::shared_ptr<const text::SourceText> load_text(const std::string& path,
                                                  std::string encoding,
                                                  ImportSheet& sheet,
                                                  text::Diagnostics& diagnostics) {
  const std::string head = text::first_bytes(path, 2);
  if (encoding.empty() && (head == "\xFF\xFE" || head == "\xFE\xFF")) {
    encoding = "utf-16";
    sheet.remarks.emplace_back("encoding UTF-16, as its byte order mark says");
  }
  if (encoding.empty() || encoding == "utf-8") {
    auto text = text::SourceText::load(path, diagnostics, text::table_size_limit);
    if (text && !text::check_text(text, diagnostics)) text = nullptr;
    if (!text && head.size() == 2 && diagnostics.has_errors() && encoding.empty() &&
        text::first_bytes(path, std::size_t{64} << 10U).find('\0') == std::string::npos)
      diagnostics.note({}, "a table in another encoding: say --encoding windows-1252, if it is that one");
    return text;
  }
  const auto bytes = text::read_bytes(path, recoded_file_limit, diagnostics);
  if (!bytes) return nullptr;
  auto text =
      text::SourceText::from_string(path, encoding == "utf-16" ? from_utf_16(*bytes) : from_windows_1252(*bytes));
  return text::check_text(text, diagnostics) ? text : nullptr;
}

}  // namespace

std::optional<ImportSheet> load_sheet(const std::string& path,
                                      const SheetFormat& format,
                                      text::Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    diagnostics.error(text::whole(text::SourceText::from_string(path, {})), message, hint);
    return std::nullopt;
  };
  const std::string head = text::first_bytes(path, 8);
  if (head.starts_with("\xD0\xCF\x11\xE0"))
    return refuse("is a workbook of the old binary format (.xls), or one with a password",
                  "save it as .xlsx, .ods or CSV");
  ImportSheet sheet;
  if (head.starts_with("PK")) {
    auto read = load_workbook(path, format, diagnostics);
    if (!read) return std::nullopt;
    sheet = std::move(*read);
    if (!text::check_text(sheet.text, diagnostics)) return std::nullopt;
  } else {
    if (!format.sheet.empty()) return refuse("is no workbook, so it has no sheets", "leave --sheet out");
    sheet.text = load_text(path, format.encoding, sheet, diagnostics);
    if (!sheet.text || !lines_end_well(sheet.text, diagnostics)) return std::nullopt;
    sheet.separator = format.separator != 0 ? format.separator : separator_of(sheet.text->contents());
    if (format.separator == 0)
      sheet.remarks.push_back(fmt::format("cells separated by {}", separator_name(sheet.separator)));
  }
  if (sheet.text->contents().find_first_not_of(" \t\r\n") == std::string_view::npos)
    return refuse("is empty", sheet.sheet.empty() ? "" : "another sheet? say --sheet NAME");
  return sheet;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view no_break = "\xC2\xA0";
  while (true) {
    if (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r' || text.front() == '\n'))
      text.remove_prefix(1);
    else if (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r' || text.back() == '\n'))
      text.remove_suffix(1);
    else if (text.starts_with(no_break))
      text.remove_prefix(no_break.size());
    else if (text.ends_with(no_break))
      text.remove_suffix(no_break.size());
    else
      return text;
  }
}

SheetRows::SheetRows(const ImportSheet& sheet, text::Diagnostics& diagnostics, std::size_t begin)
    : sheet_(sheet), scanner_(sheet.text, sheet.separator, begin, diagnostics, most_cells) {}

bool SheetRows::next() {
  while (!scanner_.at_end()) {
    starts_.clear();
    scanner_.unescaped().clear();
    if (!scanner_.next(starts_)) continue;
    for (std::size_t i = 0; i < cells(); ++i)
      if (starts_[i + 1] - starts_[i] > 1 && !cell(i).empty()) return true;
  }
  return false;
}

std::string_view SheetRows::raw(std::size_t index) const {
  return sheet_.text->contents().substr(starts_[index], starts_[index + 1] - 1 - starts_[index]);
}

std::string_view SheetRows::cell(std::size_t index) const {
  if (index >= cells()) return {};
  const std::string_view content = without_blanks(raw(index));
  if (content.size() < 2 || content.front() != '"') return content;
  const auto& unescaped = scanner_.unescaped();
  const auto found = unescaped.find(starts_[index]);
  return without_blanks(found == unescaped.end() ? content.substr(1, content.size() - 2) : found->second);
}

bool SheetRows::is_number(std::size_t index) const {
  return index < cells() && !sheet_.numbers.empty() &&
         std::binary_search(sheet_.numbers.begin(), sheet_.numbers.end(), starts_[index]);
}

text::SourceSpan SheetRows::span(std::size_t index) const {
  if (index >= cells()) return span();
  const std::string_view content = without_blanks(raw(index));
  const std::size_t offset = static_cast<std::size_t>(content.data() - sheet_.text->contents().data());
  const bool quoted = content.size() >= 2 && content.front() == '"';
  return text::span_at(sheet_.text, quoted ? offset + 1 : offset, quoted ? content.size() - 2 : content.size());
}

text::SourceSpan SheetRows::span() const {
  return text::span_at(sheet_.text, starts_.front(), starts_.back() - 1 - starts_.front());
}

}  // namespace millwright::catalogue
