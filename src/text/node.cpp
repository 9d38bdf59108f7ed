// SPDX-License-Identifier: Apache-2.0
#include "text/node.h"

#include <algorithm>
#include <utility>

#include "text/utf8.h"

namespace millwright::text {

std::string_view describe(NodeKind kind) {
  switch (kind) {
    case NodeKind::table:
      return "a table";
    case NodeKind::array:
      return "a list";
    case NodeKind::string:
      return "text";
    case NodeKind::integer:
      return "a whole number";
    case NodeKind::number:
      return "a number";
    case NodeKind::boolean:
      return "true or false";
    case NodeKind::date:
      return "a date";
  }
  return "a value";
}

Node::Node(NodeKind kind, SourceSpan span) : kind_(kind), span_(std::move(span)) {}

std::size_t Node::size() const { return is_table() ? entries_.size() : items_.size(); }

Node Node::make_table(SourceSpan span) { return {NodeKind::table, std::move(span)}; }

Node Node::make_array(SourceSpan span) { return {NodeKind::array, std::move(span)}; }

Node Node::make_string(SourceSpan span, std::string value) {
  Node node(NodeKind::string, std::move(span));
  node.value_ = std::move(value);
  return node;
}

Node Node::make_integer(SourceSpan span, std::int64_t value) {
  Node node(NodeKind::integer, std::move(span));
  node.value_ = value;
  return node;
}

Node Node::make_number(SourceSpan span, double value) {
  Node node(NodeKind::number, std::move(span));
  node.value_ = value;
  return node;
}

Node Node::make_boolean(SourceSpan span, bool value) {
  Node node(NodeKind::boolean, std::move(span));
  node.value_ = value;
  return node;
}

Node Node::make_date(SourceSpan span, std::string value) {
  Node node(NodeKind::date, std::move(span));
  node.value_ = std::move(value);
  return node;
}

std::optional<std::string> Node::as_string() const {
  if (kind_ != NodeKind::string) return std::nullopt;
  return std::get<std::string>(value_);
}

std::optional<double> Node::as_number() const {
  if (kind_ == NodeKind::integer) return static_cast<double>(std::get<std::int64_t>(value_));
  if (kind_ == NodeKind::number) return std::get<double>(value_);
  return std::nullopt;
}

std::optional<std::int64_t> Node::as_integer() const {
  if (kind_ != NodeKind::integer) return std::nullopt;
  return std::get<std::int64_t>(value_);
}

std::optional<bool> Node::as_boolean() const {
  if (kind_ != NodeKind::boolean) return std::nullopt;
  return std::get<bool>(value_);
}

std::optional<std::string> Node::as_date() const {
  if (kind_ != NodeKind::date) return std::nullopt;
  return std::get<std::string>(value_);
}

const Node* Node::find(std::string_view key) const {
  const auto found = index_.find(key);
  return found == index_.end() ? nullptr : &entries_[found->second].value;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

const SourceSpan& Node::key_span(std::string_view key) const {
  const auto found = index_.find(key);
  return found == index_.end() ? span_ : entries_[found->second].key_span;
}

SourceSpan Node::part_span(std::size_t offset, std::size_t length) const {
  if (kind_ != NodeKind::string || !span_.text || span_.line < 1) return span_;
  const auto& value = std::get<std::string>(value_);
  offset = std::min(offset, value.size());
  const std::string_view line = span_.text->line(span_.line);
  const std::size_t begin = bytes_of_characters(line, static_cast<std::size_t>(std::max(span_.column, 1)) - 1);
  const bool has_quote = begin < line.size() && (line[begin] == '"' || line[begin] == '\'');
  if (line.substr(std::min(begin + (has_quote ? 1 : 0), line.size()), value.size()) != value) return span_;
  SourceSpan part = span_;
  part.column += static_cast<int>(count_characters(std::string_view(value).substr(0, offset))) + (has_quote ? 1 : 0);
  part.length = static_cast<int>(count_characters(std::string_view(value).substr(offset, length)));
  return part;
}

Node& Node::put(std::string key, SourceSpan key_span, Node value) {
  const auto [place, added] = index_.emplace(key, entries_.size());
  if (added) {
    entries_.push_back({std::move(key), std::move(key_span), std::move(value)});
    return entries_.back().value;
  }
  TableEntry& entry = entries_[place->second];
  entry.key_span = std::move(key_span);
  entry.value = std::move(value);
  return entry.value;
}

void Node::append(Node value) { items_.push_back(std::move(value)); }

}  // namespace millwright::text
