// SPDX-License-Identifier: Apache-2.0
// Characters are counted as they are decoded, one by one.
#include "text/utf8.h"

#include <random>

#include "catch.h"

namespace utf8_test {

using namespace millwright::text;

TEST_CASE(
    "Characters of mixed texts are counted as decoding one after the other does, also where bytes are not UTF-8") {
  std::mt19937 rng(11);
  const std::string_view pieces[] = {
      "a", "millimetre", "\xC2\xB5", "\xE2\x82\xAC", "\xF0\x9D\x84\x9E", "\xFF", "\xE2\x82", "\n"};
  for (int n = 0; n < 2000; ++n) {
    std::string text;
    for (std::size_t left = rng() % 20; left > 0; --left) text += pieces[rng() % std::size(pieces)];
    std::size_t expected = 0;
    for (std::size_t offset = 0; offset < text.size(); ++expected)
      offset += static_cast<std::size_t>(decode(text, offset).bytes);
    CAPTURE(text);
    CHECK(count_characters(text) == expected);
  }
  CHECK(count_characters("") == 0);
  CHECK(count_characters("12345678") == 8);
  CHECK(count_characters("1234567\xC2\xB5") == 8);
}

}  // namespace utf8_test
