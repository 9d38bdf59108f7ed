// SPDX-License-Identifier: Apache-2.0
#include "text/sha256.h"

#include <nettle/sha2.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace millwright::text {

namespace {
constexpr std::string_view hexadecimal = "0123456789abcdef";
}

std::string sha256(std::string_view bytes) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string text;
  for (const std::uint8_t octet : digest) {
    text += hexadecimal[octet >> 4U];
    text += hexadecimal[octet & 15U];
  }
  return text;
}

bool is_sha256(std::string_view text) {
  return text.size() == std::size_t{2} * SHA256_DIGEST_SIZE &&
         text.find_first_not_of(hexadecimal) == std::string_view::npos;
}

}  // namespace millwright::text
