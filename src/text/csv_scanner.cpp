// SPDX-License-Identifier: Apache-2.0
#include "text/csv_scanner.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace millwright::text {

namespace {

constexpr std::size_t block_size = 64;
/// After so many quotes that never close, the rest of the file is not worth reading.
constexpr int unclosed_limit = 3;

/// For each of the 64 bytes at `bytes` a bit: whether it is `a`, `b` or `c`.
std::uint64_t matches(const char* bytes, char a, char b, char c) {
  std::uint64_t mask = 0;
#ifdef __SSE2__
  const __m128i all_a = _mm_set1_epi8(a), all_b = _mm_set1_epi8(b), all_c = _mm_set1_epi8(c);
  for (std::size_t i = 0; i < block_size; i += sizeof(__m128i)) {
    __m128i part;
    std::memcpy(&part, bytes + i, sizeof part);
    const __m128i a_or_b = _mm_or_si128(_mm_cmpeq_epi8(part, all_a), _mm_cmpeq_epi8(part, all_b));
    const int hits = _mm_movemask_epi8(_mm_or_si128(a_or_b, _mm_cmpeq_epi8(part, all_c)));
    mask |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(hits)) << i;
  }
#else
  for (std::size_t i = 0; i < block_size; ++i) {
    const bool hit = bytes[i] == a || bytes[i] == b || bytes[i] == c;
    mask |= static_cast<std::uint64_t>(hit) << i;
  }
#endif
  return mask;
}

std::uint32_t narrow(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

}  // namespace

CsvScanner::CsvScanner(std::shared_ptr<const SourceText> text,
                       char separator,
                       std::size_t begin,
                       Diagnostics& diagnostics,
                       std::size_t cell_limit)
    : text_(std::move(text)),
      bytes_(text_->contents()),
      diagnostics_(diagnostics),
      separator_(separator),
      cell_limit_(cell_limit),
      position_(begin) {
  seek(begin);
}

std::uint64_t CsvScanner::mask_at(std::size_t offset) const {
  if (offset + block_size <= bytes_.size()) return matches(bytes_.data() + offset, separator_, '\n', '"');
  std::array<char, block_size> rest{};  // of zeros, which no text holds
  if (offset < bytes_.size()) std::memcpy(rest.data(), bytes_.data() + offset, bytes_.size() - offset);
  return matches(rest.data(), separator_, '\n', '"');
}

/// The offset of the next separator, line end or quote; the size of the text if there is none.
std::size_t CsvScanner::next_special() {
  while (mask_ == 0) {
    block_ += block_size;
    if (block_ >= bytes_.size()) return bytes_.size();
    mask_ = mask_at(block_);
  }
  const std::size_t found = block_ + static_cast<std::size_t>(std::countr_zero(mask_));
  mask_ &= mask_ - 1;
  return found;
}

void CsvScanner::seek(std::size_t offset) {
  position_ = offset;
  block_ = offset;
  mask_ = mask_at(offset);
}

bool CsvScanner::next(std::vector<std::uint32_t>& starts) {
  const std::size_t record = position_;
  const std::size_t most = starts.size() + cell_limit_ + 1;
  std::size_t cell_begin = position_;
  starts.push_back(narrow(cell_begin));
  while (true) {
    const std::size_t found = next_special();
    if (found < bytes_.size() && bytes_[found] == '"') {
      if (!quoted_cell(cell_begin, found)) return false;
      continue;
    }
    if (starts.size() == most) return too_many_cells(record);
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
  if (!before.empty() && before.find_first_not_of(" \t") != std::string_view::npos) {
    diagnostics_.error(span_at(text_, quote, 1),
                       "quote inside a cell that is not quoted",
                       "put the whole cell in quotes and write each quote inside it twice");
    return give_up_line(quote);
  }
  bool doubled = false;
  std::size_t closing = next_quote();
  while (closing + 1 < bytes_.size() && bytes_[closing + 1] == '"') {
    doubled = true;
    next_special();  // the second of the two
    closing = next_quote();
  }
  if (closing >= bytes_.size()) {
    diagnostics_.error(span_at(text_, quote, 1), "quote is never closed", "add a closing quote at the end of the cell");
    if (++unclosed_ < unclosed_limit) return give_up_line(quote);
    seek(bytes_.size());
    return false;
  }
  if (!check_after_quote(quote, closing)) return give_up_line(closing);
  if (doubled) unescape(cell_begin, quote, closing);
  return true;
}

std::size_t CsvScanner::next_quote() {
  std::size_t found = next_special();
  while (found < bytes_.size() && bytes_[found] != '"') found = next_special();
  return found;
}

/// Only blanks may stand between a closing quote and the end of the cell.
bool CsvScanner::check_after_quote(std::size_t opening, std::size_t closing) {
  if (closing + 1 == bytes_.size() || bytes_[closing + 1] == separator_) return true;
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

bool CsvScanner::too_many_cells(std::size_t record) {
  diagnostics_.error(span_at(text_, record, 1),
                     "more than " + std::to_string(cell_limit_) + " cells in a line: this is no table of parts",
                     "is this the right file?");
  return give_up_line(position_ = record);
}

/// Goes on with the line after the one that holds `offset`.
bool CsvScanner::give_up_line(std::size_t offset) {
  const std::size_t end = bytes_.find('\n', offset);
  seek(end == std::string_view::npos ? bytes_.size() : end + 1);
  return false;
}

}  // namespace millwright::text
