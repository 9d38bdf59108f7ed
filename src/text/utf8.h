// SPDX-License-Identifier: Apache-2.0
// One character of UTF-8: what the position counter, the text check and the error printer share.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace millwright::text {

/// One decoded character. Where the bytes are not UTF-8, `valid` is false, `bytes` is 1 and `value` is the byte itself.
struct Character {
  char32_t value = 0;
  int bytes = 1;
  bool valid = true;
};

/// Decodes the character that starts at `offset` (< text.size()). Refuses overlong forms, surrogates and values above
/// U+10FFFF, as RFC 3629 section 3 demands.
Character decode(std::string_view text, std::size_t offset);

/// Number of characters in `text`; a byte that is not UTF-8 counts as one.
std::size_t count_characters(std::string_view text);

/// Bytes taken by the first `characters` characters of `text` (its whole size if it has fewer).
std::size_t bytes_of_characters(std::string_view text, std::size_t characters);

/// Appends the UTF-8 form of a Unicode scalar value.
void append_utf8(std::string& text, char32_t value);

}  // namespace millwright::text
