// SPDX-License-Identifier: Apache-2.0
// toml++ bounds how deep values nest, but not how many parts a dotted key has; each is a table in a table, and 50 000
// of them are more than the stack takes.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace millwright::text {

/// Parts that a key may have: `a.b.c` has three.
inline constexpr std::size_t most_key_parts = 8;

/// Offset of the first dotted key, at whatever place of the text, that has more parts.
std::optional<std::size_t> find_deep_key(std::string_view toml);

}  // namespace millwright::text
