// SPDX-License-Identifier: Apache-2.0
// Document::set: what-if changes from the command line. The assignment becomes a small text of its own, so that
// complaints about it, now or later when the value is read, point into what was typed.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>
#include <vector>

#include "text/characters.h"
#include "text/document.h"
#include "text/nearest.h"
#include "text/toml_depth.h"
#include "text/toml_tree.h"
#include "text/utf8.h"

namespace millwright::text {

namespace {

/// A key, or a position in a list, with where it was typed.
struct Step {
  std::string key;
  std::optional<std::size_t> index;
  SourceSpan span;
};

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// Reads `axis.x.moves[0]."odd key"`; `text` is the assignment, in which the path begins at `begin` and ends at `end`.
class PathReader {
 public:
  PathReader(const std::shared_ptr<const SourceText>& text,
             std::size_t begin,
             std::size_t end,
             Diagnostics& diagnostics)
      : text_(text), path_(text->contents().substr(0, end)), at_(begin), diagnostics_(diagnostics) {}

  /// Empty if the path is wrong, which is reported.
  std::vector<Step> read() {
    std::vector<Step> steps;
    bool good = read_key(steps);
    while (good && at_ < path_.size()) {
      if (path_[at_] == '.') {
        ++at_;
        good = read_key(steps);
      } else if (path_[at_] == '[') {
        good = read_bracket(steps);
      } else {
        good = fail("'.' or '[' is expected");
      }
      if (good && steps.size() > most_key_parts)
        good = fail(fmt::format("a path of more than {} parts", most_key_parts));
    }
    if (!good) steps.clear();
    return steps;
  }

 private:
  bool fail(const std::string& message) {
    diagnostics_.error(span_at(text_, at_, 1), message, "a path is written like axis.x.moves[0].time");
    return false;
  }

  bool read_key(std::vector<Step>& steps) {
    const std::size_t begin = at_;
    if (at_ < path_.size() && (path_[at_] == '"' || path_[at_] == '\'')) {
      const std::size_t close = path_.find(path_[at_], at_ + 1);
      if (close == std::string_view::npos) return fail("the quote is never closed");
      at_ = close + 1;
      steps.push_back(
          {std::string(path_.substr(begin + 1, close - begin - 1)), {}, span_at(text_, begin, at_ - begin)});
      return true;
    }
    while (at_ < path_.size() && is_bare(path_[at_])) ++at_;
    if (at_ == begin) return fail("a key is expected");
    steps.push_back({std::string(path_.substr(begin, at_ - begin)), {}, span_at(text_, begin, at_ - begin)});
    return true;
  }

  bool read_bracket(std::vector<Step>& steps) {
    const std::size_t begin = ++at_;
    const std::size_t close = path_.find(']', begin);
    if (close == std::string_view::npos) return fail("']' is missing");
    const std::string_view inside = path_.substr(begin, close - begin);
    if (inside.empty()) return fail("a position or a name is expected");
    std::size_t index = 0;
    const std::from_chars_result result = std::from_chars(inside.data(), inside.data() + inside.size(), index);
    const bool is_index = result.ec == std::errc{} && result.ptr == inside.data() + inside.size();
    steps.push_back(
        {std::string(inside), is_index ? std::optional(index) : std::nullopt, span_at(text_, begin, inside.size())});
    at_ = close + 1;
    return true;
  }

  const std::shared_ptr<const SourceText>& text_;
  std::string_view path_;
  std::size_t at_;
  Diagnostics& diagnostics_;
};

std::vector<std::string> names_in(const Node& array) {
  std::vector<std::string> names;
  for (const Node& item : array.items()) {
    const Node* name = item.find("name");
    if (name != nullptr && name->is_string()) names.push_back(*name->as_string());
  }
  return names;
}

/// The element of a list that a step means; null (reported) if there is none.
Node* element(Node& array, const Step& step, Diagnostics& diagnostics) {
  if (step.index) {
    if (*step.index < array.size()) return &array.items()[*step.index];
    diagnostics.error(
        step.span,
        fmt::format("position {} is not in the list", *step.index),
        fmt::format("the list has {} element{}, counted from 0", array.size(), array.size() == 1 ? "" : "s"));
    return nullptr;
  }
  for (Node& item : array.items()) {
    const Node* name = std::as_const(item).find("name");
    if (name != nullptr && name->as_string() == step.key) return &item;
  }
  const std::vector<std::string> names = names_in(array);
  std::string known = "tables of a list are named by their key 'name' or by their position, as in [0]";
  if (!names.empty()) known = fmt::format("there is {}", fmt::join(names, ", "));
  diagnostics.error(step.span, "no element has the name " + in_quotes(step.key), did_you_mean(step.key, names, known));
  return nullptr;
}

std::vector<std::string> keys_of(const Node& table) {
  std::vector<std::string> keys;
  for (const TableEntry& entry : table.entries()) keys.push_back(entry.key);
  return keys;
}

/// One step down; a missing table is made where the next step is a key.
Node* descend(Node& node, const Step& step, const Step& next, Diagnostics& diagnostics) {
  if (node.is_array()) return element(node, step, diagnostics);
  if (!node.is_table() || step.index) {
    diagnostics.error(
        step.span,
        fmt::format("this leads into {}, which has no {}", describe(node.kind()), step.index ? "positions" : "keys"));
    return nullptr;
  }
  if (Node* found = node.find(step.key)) return found;
  if (!next.index) return &node.put(step.key, step.span, Node::make_table(step.span));
  diagnostics.error(step.span, "there is no " + in_quotes(step.key), did_you_mean(step.key, keys_of(node)));
  return nullptr;
}

bool store(Node& node, const Step& last, Node value, Diagnostics& diagnostics) {
  if (node.is_table() && !last.index) {
    node.put(last.key, last.span, std::move(value));
    return true;
  }
  if (node.is_array()) {
    Node* place = element(node, last, diagnostics);
    if (place != nullptr) *place = std::move(value);
    return place != nullptr;
  }
  diagnostics.error(
      last.span,
      fmt::format("this leads into {}, which has no {}", describe(node.kind()), last.index ? "positions" : "keys"));
  return false;
}

std::optional<Node> printable_value(Node value, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  refuse_control_characters(value, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  return value;
}

/// The value behind the `=` at byte `equals` of the assignment.
std::optional<Node> read_value(const std::shared_ptr<const SourceText>& text,
                               std::size_t equals,
                               Diagnostics& diagnostics) {
  const std::string_view contents = text->contents();
  const std::string_view value = without_blanks(contents.substr(equals + 1), " \t\r\n");
  // A key as long as what stands before the `=` gives every character of the value its right column.
  const std::string toml =
      std::string(count_characters(contents.substr(0, equals)), 'k') + std::string(contents.substr(equals));
  Diagnostics attempt;
  std::optional<Node> table = value.empty() ? std::nullopt : parse_toml_tree(toml, text, attempt);
  if (table && table->size() == 1) {
    for (const Diagnostic& diagnostic : attempt.all()) diagnostics.add(diagnostic);
    if (attempt.has_errors()) return std::nullopt;
    return printable_value(table->entries().front().value, diagnostics);
  }
  // Brackets and quotes were meant as TOML; anything else is text.
  if (!value.empty() && std::string_view("[{\"'").find(value.front()) != std::string_view::npos) {
    for (const Diagnostic& diagnostic : attempt.all()) diagnostics.add(diagnostic);
    if (!attempt.has_errors()) diagnostics.error(span_at(text, equals + 1, 1), "one value is expected");
    return std::nullopt;
  }
  const std::size_t offset = value.empty() ? equals + 1 : static_cast<std::size_t>(value.data() - contents.data());
  return printable_value(Node::make_string(span_at(text, offset, value.size()), std::string(value)), diagnostics);
}

}  // namespace

bool Document::set(std::string_view path, std::string_view value, Diagnostics& diagnostics) {
  constexpr std::string_view option = "--set ";
  const std::shared_ptr<const SourceText> typed =
      SourceText::from_string("command line", std::string(option) + std::string(path) + "=" + std::string(value));
  const std::size_t equals = option.size() + path.size();
  const std::vector<Step> steps = PathReader(typed, option.size(), equals, diagnostics).read();
  if (steps.empty()) return false;
  std::optional<Node> node = read_value(typed, equals, diagnostics);
  if (!node) return false;
  Node changed = root_;  // a path that fails half-way must leave no new tables behind
  Node* place = &changed;
  for (std::size_t i = 0; i + 1 < steps.size() && place != nullptr; ++i) {
    place = descend(*place, steps[i], steps[i + 1], diagnostics);
  }
  if (place == nullptr || !store(*place, steps.back(), std::move(*node), diagnostics)) return false;
  root_ = std::move(changed);
  return true;
}

bool Document::set(std::string_view assignment, Diagnostics& diagnostics) {
  const std::size_t equals = assignment.find('=');
  if (equals != std::string_view::npos) {
    return set(assignment.substr(0, equals), assignment.substr(equals + 1), diagnostics);
  }
  const std::shared_ptr<const SourceText> typed =
      SourceText::from_string("command line", "--set " + std::string(assignment));
  diagnostics.error(span_at(typed, 6, assignment.size()), "'=' is missing", "write --set axis.x.stroke='700 mm'");
  return false;
}

}  // namespace millwright::text
