// SPDX-License-Identifier: Apache-2.0
// Reads a table key by key, complains about what does not fit, and in the end about the keys that nobody asked for.
//
//   TableReader axis(node, "axis 'x'", diagnostics);
//   const auto name = axis.string("name", Presence::required);
//   const auto count = axis.integer("count").value_or(1);
//   axis.finish();
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostic.h"
#include "text/node.h"
#include "text/question.h"

namespace millwright::text {

enum class Presence { optional, required };

class TableReader {
 public:
  /// `title` names the table in messages ("axis 'x'", "[objective]"). A node that is no table is reported and then
  /// treated as an empty table without missing keys. The node must outlive the reader.
  TableReader(const Node& table, std::string title, Diagnostics& diagnostics);

  const Node& node() const { return table_; }
  const std::string& title() const { return title_; }

  /// Whether the key is there; it counts as known from now on, as it does with every question below.
  bool has(const Key& key);

  /// Any kind of value; null if missing.
  const Node* find(const Key& key, Presence presence = Presence::optional);

  /// A value of one kind; nothing if it is missing (reported if required) or of another kind (reported at the value).
  std::optional<std::string> string(const Key& key, Presence presence = Presence::optional);
  std::optional<double> number(const Key& key, Presence presence = Presence::optional);
  std::optional<std::int64_t> integer(const Key& key, Presence presence = Presence::optional);
  std::optional<bool> boolean(const Key& key, Presence presence = Presence::optional);
  bool boolean_or(const Key& key, bool fallback);
  const Node* table(const Key& key, Presence presence = Presence::optional);
  const Node* array(const Key& key, Presence presence = Presence::optional);

  /// One value, or a list of values: `frame = "NEMA17"` is `frame = ["NEMA17"]`. Empty if missing.
  std::vector<const Node*> list(const Key& key, Presence presence = Presence::optional);
  /// The same, each of them text.
  std::vector<std::string> strings(const Key& key, Presence presence = Presence::optional);

  /// One of a fixed set of words.
  std::optional<std::string> word(const Key& key,
                                  const std::vector<std::string>& allowed,
                                  Presence presence = Presence::optional);
  std::string word_or(const Key& key, const std::vector<std::string>& allowed, const std::string& fallback);

  /// Whether anybody listens to what is asked: what costs time to say need not be said otherwise.
  bool heard() const { return diagnostics_.listener() != nullptr; }
  /// Says what may stand there, where the reader looks at the value itself.
  void describe(const Question& question) const;

  /// Reports each key that nobody asked for, with the nearest known one.
  void finish();

 private:
  const Node* look_up(std::string_view key, Presence presence);
  const Node* of_kind(std::string_view key, NodeKind kind, Presence presence);
  void describe(const Key& key, Expected expected, Presence presence = Presence::optional) const;
  void remember(std::string_view key);

  const Node& table_;
  std::string title_;
  Diagnostics& diagnostics_;
  std::vector<std::string> known_;
};

/// Reports at the node that another kind of value was expected, with a hint how to write it.
void report_kind(const Node& node, std::string_view what, NodeKind expected, Diagnostics& diagnostics);

}  // namespace millwright::text
