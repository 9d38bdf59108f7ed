// SPDX-License-Identifier: Apache-2.0
#include "text/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "text/nearest.h"
#include "text/number.h"

namespace millwright::text {

namespace {

/// How the value would have to be written, as far as that can be told from what is there.
std::string kind_hint(const Node& node, NodeKind expected) {
  const std::optional<std::string> words = node.as_string();
  if (words && (expected == NodeKind::number || expected == NodeKind::integer)) {
    if (parse_number(*words)) return "write it without quotes: " + *words;
    return number_hint(*words);
  }
  if (words && expected == NodeKind::boolean && (*words == "true" || *words == "false")) {
    return "write it without quotes: " + *words;
  }
  if (expected == NodeKind::string && node.is_number()) return "put it in quotes, with its unit if it has one";
  if (expected == NodeKind::string && node.kind() == NodeKind::date) return "put it in quotes";
  if (expected == NodeKind::integer && node.kind() == NodeKind::number) return "write it without a decimal point";
  if (expected == NodeKind::array) return "put it in brackets: [ ... ]";
  if (expected == NodeKind::table) return "a table is written as { key = value } or under a [header]";
  return {};
}

}  // namespace

void report_kind(const Node& node, std::string_view what, NodeKind expected, Diagnostics& diagnostics) {
  diagnostics.error(node.span(),
                    fmt::format("{} must be {}, but this is {}", what, describe(expected), describe(node.kind())),
                    kind_hint(node, expected));
}

TableReader::TableReader(const Node& table, std::string title, Diagnostics& diagnostics)
    : table_(table), title_(std::move(title)), diagnostics_(diagnostics) {
  if (!table_.is_table()) report_kind(table_, title_, NodeKind::table, diagnostics_);
}

void TableReader::remember(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
}

bool TableReader::has(const Key& key) {
  describe(key, Expected::anything);
  remember(key.name);
  return table_.find(key.name) != nullptr;
}

void TableReader::describe(const Question& question) const {
  if (heard()) diagnostics_.listener()->asked(table_, question);
}

void TableReader::describe(const Key& key, Expected expected, Presence presence) const {
  if (!heard()) return;
  Question question;
  question.expected = expected;
  question.key = key.name;
  question.meaning = key.meaning;
  question.required = presence == Presence::required;
  describe(question);
}

const Node* TableReader::look_up(std::string_view key, Presence presence) {
  remember(key);
  const Node* node = table_.find(key);
  if (node == nullptr && presence == Presence::required && table_.is_table()) {
    diagnostics_.error(table_.span(), fmt::format("{} needs the key '{}'", title_, key));
  }
  return node;
}

const Node* TableReader::find(const Key& key, Presence presence) {
  describe(key, Expected::anything, presence);
  return look_up(key.name, presence);
}

const Node* TableReader::of_kind(std::string_view key, NodeKind kind, Presence presence) {
  const Node* node = look_up(key, presence);
  if (node == nullptr) return nullptr;
  const bool fits = node->kind() == kind || (kind == NodeKind::number && node->is_number());
  if (fits) return node;
  report_kind(*node, fmt::format("'{}'", key), kind, diagnostics_);
  return nullptr;
}

std::optional<std::string> TableReader::string(const Key& key, Presence presence) {
  describe(key, Expected::text, presence);
  const Node* node = of_kind(key.name, NodeKind::string, presence);
  return node == nullptr ? std::nullopt : node->as_string();
}

std::optional<double> TableReader::number(const Key& key, Presence presence) {
  describe(key, Expected::number, presence);
  const Node* node = of_kind(key.name, NodeKind::number, presence);
  return node == nullptr ? std::nullopt : node->as_number();
}

std::optional<std::int64_t> TableReader::integer(const Key& key, Presence presence) {
  describe(key, Expected::integer, presence);
  const Node* node = of_kind(key.name, NodeKind::integer, presence);
  return node == nullptr ? std::nullopt : node->as_integer();
}

std::optional<bool> TableReader::boolean(const Key& key, Presence presence) {
  describe(key, Expected::boolean, presence);
  const Node* node = of_kind(key.name, NodeKind::boolean, presence);
  return node == nullptr ? std::nullopt : node->as_boolean();
}

bool TableReader::boolean_or(const Key& key, bool fallback) {
  Question question;
  question.expected = Expected::boolean;
  question.key = key.name;
  question.meaning = key.meaning;
  question.fallback = fallback ? "true" : "false";
  describe(question);
  return boolean(key).value_or(fallback);
}

const Node* TableReader::table(const Key& key, Presence presence) {
  describe(key, Expected::table, presence);
  return of_kind(key.name, NodeKind::table, presence);
}

const Node* TableReader::array(const Key& key, Presence presence) {
  describe(key, Expected::tables, presence);
  return of_kind(key.name, NodeKind::array, presence);
}

std::vector<const Node*> TableReader::list(const Key& key, Presence presence) {
  std::vector<const Node*> nodes;
  const Node* node = find(key, presence);
  if (node == nullptr) return nodes;
  if (!node->is_array()) return {node};
  for (const Node& item : node->items()) nodes.push_back(&item);
  return nodes;
}

std::vector<std::string> TableReader::strings(const Key& key, Presence presence) {
  describe(key, Expected::texts, presence);
  std::vector<std::string> words;
  for (const Node* node : list(key, presence)) {
    if (const auto word = node->as_string()) {
      words.push_back(*word);
    } else {
      report_kind(*node, fmt::format("'{}'", key.name), NodeKind::string, diagnostics_);
    }
  }
  return words;
}

std::optional<std::string> TableReader::word(const Key& key,
                                             const std::vector<std::string>& allowed,
                                             Presence presence) {
  Question question;
  question.expected = Expected::word;
  question.key = key.name;
  question.meaning = key.meaning;
  question.words = allowed;
  question.required = presence == Presence::required;
  describe(question);
  const Node* node = of_kind(key.name, NodeKind::string, presence);
  if (node == nullptr) return std::nullopt;
  const std::string value = *node->as_string();
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
  diagnostics_.error(node->span(),
                     fmt::format("'{}' cannot be {}", key.name, text::in_quotes(value)),
                     did_you_mean(value, allowed, fmt::format("one of {}", fmt::join(allowed, ", "))));
  return std::nullopt;
}

std::string TableReader::word_or(const Key& key, const std::vector<std::string>& allowed, const std::string& fallback) {
  Question question;
  question.expected = Expected::word;
  question.key = key.name;
  question.meaning = key.meaning;
  question.words = allowed;
  question.fallback = fallback;
  describe(question);
  return word(key, allowed).value_or(fallback);
}

void TableReader::finish() {
  for (const TableEntry& entry : table_.entries()) {
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    if (diagnostics_.only_counted(Severity::error, entry.key_span.text.get())) continue;
    // A key that is there already was not meant.
    std::vector<std::string> candidates;
    for (const std::string& key : known_) {
      if (table_.find(key) == nullptr) candidates.push_back(key);
    }
    const std::string all = known_.empty() ? "" : fmt::format("known keys: {}", fmt::join(known_, ", "));
    diagnostics_.error(entry.key_span,
                       fmt::format("unknown key {} in {}", text::in_quotes(entry.key), title_),
                       did_you_mean(entry.key, candidates, did_you_mean(entry.key, known_, all)));
  }
}

}  // namespace millwright::text
