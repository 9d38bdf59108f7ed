// SPDX-License-Identifier: Apache-2.0
// A structured text (TOML or JSON) as one kind of tree in which every value and every key knows where it stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "text/source_text.h"

namespace millwright::text {

enum class NodeKind { table, array, string, integer, number, boolean, date };

/// "a table", "a list", "text", "a whole number", "a number", "true or false", "a date": for messages.
std::string_view describe(NodeKind kind);

struct TableEntry;

/// A value with its place. Copies are deep. Questions that do not fit the kind are answered with nothing (null, none,
/// an empty list), so that readers can look before they complain.
class Node {
 public:
  static Node make_table(SourceSpan span);
  static Node make_array(SourceSpan span);
  static Node make_string(SourceSpan span, std::string value);
  static Node make_integer(SourceSpan span, std::int64_t value);
  static Node make_number(SourceSpan span, double value);
  static Node make_boolean(SourceSpan span, bool value);
  /// `value` as written in TOML (RFC 3339): 2026-01-15.
  static Node make_date(SourceSpan span, std::string value);

  NodeKind kind() const { return kind_; }
  bool is_table() const { return kind_ == NodeKind::table; }
  bool is_array() const { return kind_ == NodeKind::array; }
  bool is_string() const { return kind_ == NodeKind::string; }
  bool is_number() const { return kind_ == NodeKind::number || kind_ == NodeKind::integer; }
  const SourceSpan& span() const { return span_; }

  std::optional<std::string> as_string() const;
  /// Also for whole numbers.
  std::optional<double> as_number() const;
  std::optional<std::int64_t> as_integer() const;
  std::optional<bool> as_boolean() const;
  std::optional<std::string> as_date() const;

  /// Entries of a table, in the order of the text.
  const std::vector<TableEntry>& entries() const { return entries_; }
  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  /// Where the key stands; the place of the table if it has no such key.
  const SourceSpan& key_span(std::string_view key) const;

  /// Elements of an array; at() throws std::out_of_range.
  const std::vector<Node>& items() const { return items_; }
  std::vector<Node>& items() { return items_; }
  /// Number of entries of a table or elements of an array.
  std::size_t size() const;
  const Node& at(std::size_t index) const { return items_.at(index); }

  /// The place of `length` bytes from byte `offset` of a string's value, where the text shows the value as it is (no
  /// escapes); else the place of the whole value.
  SourceSpan part_span(std::size_t offset, std::size_t length) const;

  /// Adds an entry, or replaces the one of the same key. Returns the stored value.
  Node& put(std::string key, SourceSpan key_span, Node value);
  void append(Node value);
  /// For readers that know the end of a value only after its content.
  void set_span(SourceSpan span) { span_ = std::move(span); }

 private:
  Node(NodeKind kind, SourceSpan span);

  NodeKind kind_;
  SourceSpan span_;
  std::variant<std::monostate, std::string, std::int64_t, double, bool> value_;
  std::vector<Node> items_;
  std::vector<TableEntry> entries_;
  std::map<std::string, std::size_t, std::less<>> index_;
};

struct TableEntry {
  std::string key;
  SourceSpan key_span;
  Node value;
};

}  // namespace millwright::text
