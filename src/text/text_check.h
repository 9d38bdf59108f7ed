// SPDX-License-Identifier: Apache-2.0
// Is it text at all? Bytes that cannot stand in a text file: NUL and other control characters (except tab and line
// ends), and everything that is not UTF-8.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::text {

/// How many bytes at the beginning are printable ASCII or line feeds, rounded down: what most texts are from end to
/// end, and quick to tell.
std::size_t plain_prefix(std::string_view text);

/// Offset of the first byte at or after `from` that cannot stand in a text file. Plain text is skipped eight bytes at a
/// time.
std::optional<std::size_t> find_bad_byte(std::string_view text, std::size_t from = 0);

/// Reports every byte that cannot stand in a text file, each at its place, and "not a text file" in one error instead
/// when there are more than a handful. Returns whether the text is clean; readers stop when it is not.
bool check_text(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics);

/// Judges a file by its first bytes: reports one error and returns false when they are UTF-16, binary, or thick with
/// bytes that are not UTF-8. `complete` tells that `head` is the whole file (a character cut at the end is then wrong).
bool looks_like_text(const std::shared_ptr<const SourceText>& head, bool complete, Diagnostics& diagnostics);

}  // namespace millwright::text
