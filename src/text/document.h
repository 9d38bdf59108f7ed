// SPDX-License-Identifier: Apache-2.0
// Files with structure: TOML for people, the same structure as JSON for programs. Both become one tree of nodes that
// know their places; a TableReader (table_reader.h) walks it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "text/diagnostic.h"
#include "text/node.h"
#include "text/source_text.h"

namespace millwright::text {

class Document {
 public:
  Document(std::shared_ptr<const SourceText> text, Node root) : text_(std::move(text)), root_(std::move(root)) {}

  const std::shared_ptr<const SourceText>& text() const { return text_; }
  /// The outermost table.
  const Node& root() const { return root_; }

  /// Changes one value without editing the file. `path` is a chain of keys (`require.life`), list positions from 0
  /// (`moves[0]`) and, for tables in a list, their `name` (`axis.x.stroke`, or `axis[x].stroke`); keys with other
  /// characters than letters, digits, `_` and `-` stand in quotes. Tables that are missing on the way are made, list
  /// entries are not. `value` is a TOML value; what is none is taken as text (so `20 mm/s` needs no quotes). What is
  /// set has its place in a text of its own, `--set path=value`. Reports and returns false if it cannot be done.
  bool set(std::string_view path, std::string_view value, Diagnostics& diagnostics);

  /// The same for `path=value` in one string.
  bool set(std::string_view assignment, Diagnostics& diagnostics);

 private:
  std::shared_ptr<const SourceText> text_;
  Node root_;
};

/// TOML 1.0. An error is reported at its place and gives nothing. Numbers must be finite.
std::optional<Document> read_toml(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics);

/// JSON as RFC 8259 has it, with an object outermost, nested no deeper than 256 levels, no key twice in an object
/// (reported at the second), and without null, which has no meaning in our files.
std::optional<Document> read_json(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics);

/// What a person writes has some kilobytes; a program may write more.
inline constexpr std::uintmax_t document_size_limit = std::uintmax_t{4} << 20U;

/// Reports texts and keys with control characters but tabs and line ends: they stand there as escapes, and printed they
/// would tell a terminal what to do.
void refuse_control_characters(const Node& node, Diagnostics& diagnostics);

/// Loads a file that a person writes, of that size at most; JSON if its name ends in `.json`, else TOML. Control
/// characters are refused.
std::optional<Document> read_document(const std::string& path, Diagnostics& diagnostics);

}  // namespace millwright::text
