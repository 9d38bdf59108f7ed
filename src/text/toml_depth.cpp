// SPDX-License-Identifier: Apache-2.0
#include "text/toml_depth.h"

#include <algorithm>

namespace millwright::text {

namespace {

bool is_key_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// The end of the string that begins at `at`, behind its closing quotes; where it is not closed, its line or the text.
std::size_t behind_string(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool several_lines = toml.substr(at, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  const std::string_view closing = several_lines ? toml.substr(at, 3) : toml.substr(at, 1);
  at += closing.size();
  while (at < toml.size()) {
    if (toml.substr(at, closing.size()) == closing) return at + closing.size();
    if (toml[at] == '\n' && !several_lines) return at;
    at += quote == '"' && toml[at] == '\\' && at + 1 < toml.size() && toml[at + 1] != '\n' ? 2 : 1;
  }
  return toml.size();
}

}  // namespace

std::optional<std::size_t> find_deep_key(std::string_view toml) {
  std::size_t begin = 0;  // of what may be a key
  std::size_t parts = 0;  // that it has so far
  bool open = false;      // a part may follow: at its beginning or behind a point
  for (std::size_t at = 0; at < toml.size();) {
    const char c = toml[at];
    const bool is_part = is_key_character(c) || c == '"' || c == '\'';
    if (is_part) {
      if (!open || parts == 0) {
        begin = at;
        parts = 0;
      }
      if (++parts > most_key_parts) return begin;
      if (is_key_character(c))
        while (at < toml.size() && is_key_character(toml[at])) ++at;
      else
        at = behind_string(toml, at);
      open = false;
      continue;
    }
    if (c == '.') {
      open = parts > 0 && !open;
      if (!open) parts = 0;
    } else if (c != ' ' && c != '\t') {
      open = false;
      parts = 0;
    }
    at = c == '#' ? std::min(toml.find('\n', at), toml.size()) : at + 1;
  }
  return std::nullopt;
}

}  // namespace millwright::text
