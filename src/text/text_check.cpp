// SPDX-License-Identifier: Apache-2.0
#include "text/text_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "text/utf8.h"

namespace millwright::text {

namespace {

constexpr std::uint64_t ones = 0x0101010101010101U;
constexpr std::uint64_t high_bits = 0x8080808080808080U;
/// More bad bytes than this and the file is of another kind; pointing at each would help nobody.
constexpr std::size_t handful = 8;

/// True only if all eight bytes are in 0x20..0x7E.
bool is_plain(std::uint64_t word) {
  const std::uint64_t below_blank = (word - ones * 0x20U) & ~word;
  const std::uint64_t delete_or_above = word + ones;
  return ((word | below_blank | delete_or_above) & high_bits) == 0;
}

bool is_control(unsigned char byte) {
  return (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F;
}

struct BadBytes {
  std::size_t count = 0;
  std::size_t controls = 0;
  std::size_t first = 0;
};

BadBytes count_bad_bytes(std::string_view text, std::size_t stop_after) {
  BadBytes bad;
  for (auto at = find_bad_byte(text); at && bad.count <= stop_after; at = find_bad_byte(text, *at + 1)) {
    if (bad.count == 0) bad.first = *at;
    ++bad.count;
    if (is_control(static_cast<unsigned char>(text[*at]))) ++bad.controls;
  }
  return bad;
}

std::string describe(unsigned char byte) {
  if (byte == 0) return "NUL byte";
  if (is_control(byte)) return fmt::format("control character \\x{:02X}", byte);
  return fmt::format("byte \\x{:02X} is not UTF-8", byte);
}

void report_not_text(const std::shared_ptr<const SourceText>& text, const BadBytes& bad, Diagnostics& diagnostics) {
  const auto byte = static_cast<unsigned char>(text->contents()[bad.first]);
  if (bad.controls > 0) {
    const Position place = text->position(bad.first);
    diagnostics.error(
        whole(text),
        fmt::format("not a text file: {} in line {}, column {}", describe(byte), place.line, place.column));
  } else {
    diagnostics.error(span_at(text, bad.first, 1),
                      "not UTF-8: " + describe(byte) + ", and it is not the only one",
                      "save the file in the encoding UTF-8 (it looks like Latin-1 or Windows-1252)");
  }
}

}  // namespace

std::size_t plain_prefix(std::string_view text) {
  // Without a branch inside, compilers turn a block into a few wide instructions.
  constexpr std::size_t block = 256;
  std::size_t at = 0;
  for (; at + block <= text.size(); at += block) {
    unsigned char odd = 0;
    for (std::size_t i = 0; i < block; ++i) {
      const auto byte = static_cast<unsigned char>(text[at + i]);
      const auto unprintable = static_cast<unsigned char>(static_cast<unsigned char>(byte - 0x20U) > 0x5EU);
      odd |= static_cast<unsigned char>(unprintable & static_cast<unsigned char>(byte != '\n'));
    }
    if (odd != 0) break;
  }
  return at;
}

std::optional<std::size_t> find_bad_byte(std::string_view text, std::size_t from) {
  constexpr std::size_t looked_at_closely = 256;
  std::size_t at = from;
  while (at < text.size()) {
    at += plain_prefix(text.substr(at));
    const std::size_t block_end = std::min(at + looked_at_closely, text.size());
    while (at < block_end) {
      std::uint64_t word = 0;
      while (at + sizeof word <= block_end) {
        std::memcpy(&word, text.data() + at, sizeof word);
        if (!is_plain(word)) break;
        at += sizeof word;
      }
      // One word, character by character: it holds a line end, a character beyond ASCII, or a bad byte.
      const std::size_t end = std::min(at + sizeof word, text.size());
      while (at < end) {
        const auto byte = static_cast<unsigned char>(text[at]);
        if (byte < 0x80) {
          if (is_control(byte)) return at;
          ++at;
          continue;
        }
        const Character character = decode(text, at);
        if (!character.valid) return at;
        at += static_cast<std::size_t>(character.bytes);
      }
    }
  }
  return std::nullopt;
}

bool check_text(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics) {
  const std::string_view contents = text->contents();
  const BadBytes bad = count_bad_bytes(contents, handful);
  if (bad.count == 0) return true;
  if (bad.count > handful) {
    report_not_text(text, bad, diagnostics);
    return false;
  }
  for (auto at = find_bad_byte(contents); at; at = find_bad_byte(contents, *at + 1)) {
    const auto byte = static_cast<unsigned char>(contents[*at]);
    diagnostics.error(
        span_at(text, *at, 1), describe(byte), is_control(byte) ? "remove it" : "save the file in the encoding UTF-8");
  }
  return false;
}

bool looks_like_text(const std::shared_ptr<const SourceText>& head, bool complete, Diagnostics& diagnostics) {
  std::string_view contents = head->contents();
  if (contents.substr(0, 2) == "\xFF\xFE" || contents.substr(0, 2) == "\xFE\xFF") {
    diagnostics.error(whole(head), "this is UTF-16, not UTF-8", "save the file in the encoding UTF-8");
    return false;
  }
  // The last character may have been cut in two.
  if (!complete && contents.size() > 4) contents.remove_suffix(4);
  const BadBytes bad = count_bad_bytes(contents, handful);
  const bool thick = bad.count > handful || (bad.count > 1 && bad.controls * 10 > contents.size());
  if (thick) report_not_text(head, bad, diagnostics);
  return !thick;
}

}  // namespace millwright::text
