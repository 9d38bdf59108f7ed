// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace millwright::text {

/// SHA-256 (FIPS 180-4) of the bytes, in 64 small hexadecimal digits: what `sha256sum` prints of a file.
std::string sha256(std::string_view bytes);

/// Whether it looks like one: 64 digits, 0 to 9 and a to f.
bool is_sha256(std::string_view text);

}  // namespace millwright::text
