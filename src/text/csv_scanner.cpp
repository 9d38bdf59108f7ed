// SPDX-License-Identifier: Apache-2.0
#include "text/csv_scanner.h"

#include <bit>
#include <cstring>
#include <utility>

namespace millwright::text {

namespace {

constexpr std::uint64_t ones = 0x0101010101010101U;
constexpr std::uint64_t low_bits = 0x7F7F7F7F7F7F7F7FU;
constexpr std::size_t word_size = sizeof(std::uint64_t);
/// After so many quotes that never close, the rest of the file is not worth reading.
constexpr int unclosed_limit = 3;

/// The high bit of each byte of `word` that equals the byte repeated in `pattern` (exact: no false neighbours).
std::uint64_t equal_bytes(std::uint64_t word, std::uint64_t pattern) {
  const std::uint64_t difference = word ^ pattern;
  return ~(((difference & low_bits) + low_bits) | difference | low_bits);
}

std::uint64_t repeated(char c) { return ones * static_cast<unsigned char>(c); }

std::uint32_t narrow(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

}  // namespace

CsvScanner::CsvScanner(std::shared_ptr<const SourceText> text,
                       char separator,
                       std::size_t begin,
                       Diagnostics& diagnostics)
    : text_(std::move(text)),
      bytes_(text_->contents()),
      diagnostics_(diagnostics),
      separators_(repeated(separator)),
      separator_(separator),
      position_(begin) {
  seek(begin);
}

std::uint64_t CsvScanner::mask_at(std::size_t offset) const {
  std::uint64_t word = 0;
  if (offset + word_size <= bytes_.size()) {
    std::memcpy(&word, bytes_.data() + offset, word_size);
  } else if (offset < bytes_.size()) {
    std::memcpy(&word, bytes_.data() + offset, bytes_.size() - offset);
  }
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return equal_bytes(word, separators_) | equal_bytes(word, repeated('\n')) | equal_bytes(word, repeated('"'));
}

/// The offset of the next separator, line end or quote; the size of the text if there is none.
std::size_t CsvScanner::next_special() {
  while (mask_ == 0) {
    block_ += word_size;
    if (block_ >= bytes_.size()) return bytes_.size();
    mask_ = mask_at(block_);
  }
  const std::size_t found = block_ + static_cast<std::size_t>(std::countr_zero(mask_)) / 8;
  mask_ &= mask_ - 1;
  return found;
}

void CsvScanner::seek(std::size_t offset) {
  position_ = offset;
  block_ = offset;
  mask_ = mask_at(offset);
}

bool CsvScanner::next(std::vector<std::uint32_t>& starts) {
  std::size_t cell_begin = position_;
  starts.push_back(narrow(cell_begin));
  while (true) {
    const std::size_t found = next_special();
    if (found < bytes_.size() && bytes_[found] == '"') {
      if (!quoted_cell(cell_begin, found)) return false;
      continue;
    }
    cell_begin = found + 1;
    starts.push_back(narrow(cell_begin));
    if (found >= bytes_.size() || bytes_[found] == '\n') {
      position_ = cell_begin;
      return true;
    }
  }
}

/// Checks a quoted cell and goes on behind its closing quote.
bool CsvScanner::quoted_cell(std::size_t cell_begin, std::size_t quote) {
  const std::string_view before = bytes_.substr(cell_begin, quote - cell_begin);
  if (before.find_first_not_of(" \t") != std::string_view::npos) {
    diagnostics_.error(span_at(text_, quote, 1),
                       "quote inside a cell that is not quoted",
                       "put the whole cell in quotes and write each quote inside it twice");
    return give_up_line(quote);
  }
  bool doubled = false;
  std::size_t closing = bytes_.find('"', quote + 1);
  while (closing != std::string_view::npos && bytes_.substr(closing + 1, 1) == "\"") {
    doubled = true;
    closing = bytes_.find('"', closing + 2);
  }
  if (closing == std::string_view::npos) {
    diagnostics_.error(span_at(text_, quote, 1), "quote is never closed", "add a closing quote at the end of the cell");
    if (++unclosed_ < unclosed_limit) return give_up_line(quote);
    seek(bytes_.size());
    return false;
  }
  if (!check_after_quote(quote, closing)) return give_up_line(closing);
  if (doubled) unescape(cell_begin, quote, closing);
  seek(closing + 1);
  return true;
}

/// Only blanks may stand between a closing quote and the end of the cell.
bool CsvScanner::check_after_quote(std::size_t opening, std::size_t closing) {
  const std::size_t behind = bytes_.find_first_not_of(" \t", closing + 1);
  if (behind == std::string_view::npos) return true;
  const char c = bytes_[behind];
  const bool line_end = c == '\n' || (c == '\r' && (behind + 1 == bytes_.size() || bytes_[behind + 1] == '\n'));
  if (c == separator_ || line_end) return true;
  Diagnostic diagnostic;
  diagnostic.where = span_at(text_, behind, 1);
  diagnostic.message = "text after the closing quote of a cell";
  diagnostic.hint = "write each quote inside a quoted cell twice";
  diagnostic.related = span_at(text_, opening, closing + 1 - opening);
  diagnostic.related_message = "the quoted cell begins here";
  diagnostics_.add(std::move(diagnostic));
  return false;
}

void CsvScanner::unescape(std::size_t cell_begin, std::size_t opening, std::size_t closing) {
  std::string content;
  for (std::size_t i = opening + 1; i < closing; ++i) {
    content.push_back(bytes_[i]);
    if (bytes_[i] == '"') ++i;
  }
  unescaped_.insert_or_assign(narrow(cell_begin), std::move(content));
}

/// Goes on with the line after the one that holds `offset`.
bool CsvScanner::give_up_line(std::size_t offset) {
  const std::size_t end = bytes_.find('\n', offset);
  seek(end == std::string_view::npos ? bytes_.size() : end + 1);
  return false;
}

}  // namespace millwright::text
