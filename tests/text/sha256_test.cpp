// SPDX-License-Identifier: Apache-2.0
// Digests of FIPS 180-4 (NIST's examples), and of what GNU sha256sum printed.
#include "text/sha256.h"

#include "catch.h"
#include "text/diagnostic.h"
#include "text/source_text.h"

namespace sha256_test {

using namespace millwright::text;

TEST_CASE("SHA-256 of the examples of FIPS 180-4") {
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("the bytes of a text are those of its file, with a byte order mark and CR LF") {
  // printf '\xef\xbb\xbfabc\r\n' | sha256sum
  const auto text = SourceText::from_string("x",
                                            "\xEF\xBB\xBF"
                                            "abc\r\n");
  CHECK(text->contents() == "abc\r\n");
  CHECK(sha256(text->bytes()) == "c3199f17595cd7b59cea561d9cb96f204ef903c38b1b9cb4a50b7e68d286f675");
}

TEST_CASE("what looks like a SHA-256") {
  CHECK(is_sha256(std::string(64, 'a')));
  CHECK(is_sha256(std::string(64, '9')));
  CHECK_FALSE(is_sha256(std::string(63, 'a')));
  CHECK_FALSE(is_sha256(std::string(65, 'a')));
  CHECK_FALSE(is_sha256(std::string(63, 'a') + "A"));
  CHECK_FALSE(is_sha256(std::string(63, 'a') + "g"));
  CHECK_FALSE(is_sha256(""));
}

}  // namespace sha256_test
