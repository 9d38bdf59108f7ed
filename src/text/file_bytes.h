// SPDX-License-Identifier: Apache-2.0
// Files that are no text: workbooks, and texts in another encoding than ours.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "text/diagnostic.h"

namespace millwright::text {

/// The first `count` bytes of a file, fewer if it is shorter, none if it cannot be read; nothing is reported.
std::string first_bytes(const std::string& path, std::size_t count);

/// All bytes of a regular file. Reports one error and returns none when it is not there, unreadable, no file, or larger
/// than `size_limit`.
std::optional<std::string> read_bytes(const std::string& path, std::uintmax_t size_limit, Diagnostics& diagnostics);

}  // namespace millwright::text
