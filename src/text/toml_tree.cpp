// SPDX-License-Identifier: Apache-2.0
#include "text/toml_tree.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "text/number.h"
#include "text/toml_depth.h"
#include "text/utf8.h"

namespace millwright::text {

namespace {

class TomlConverter {
 public:
  TomlConverter(const std::shared_ptr<const SourceText>& shown, Diagnostics& diagnostics)
      : shown_(shown), diagnostics_(diagnostics) {}

  SourceSpan span(const toml::source_region& region, const SourceSpan& otherwise) const {
    if (region.begin.line == 0) return otherwise;
    const auto line = static_cast<int>(region.begin.line);
    const auto column = static_cast<int>(region.begin.column);
    if (region.end.line == region.begin.line) {
      return {shown_, line, column, std::max(static_cast<int>(region.end.column) - column, 1)};
    }
    const auto characters = static_cast<int>(count_characters(shown_->line(line)));
    return {shown_, line, column, std::max(characters - column + 1, 1)};
  }

  Node convert(const toml::node& node, const SourceSpan& otherwise) {
    const SourceSpan where = span(node.source(), otherwise);
    if (const toml::table* table = node.as_table()) return convert_table(*table, where);
    if (const toml::array* array = node.as_array()) {
      Node result = Node::make_array(where);
      for (const toml::node& item : *array) result.append(convert(item, where));
      return result;
    }
    if (const auto* value = node.as_string()) return Node::make_string(where, value->get());
    if (const auto* value = node.as_integer()) return Node::make_integer(where, value->get());
    if (const auto* value = node.as_boolean()) return Node::make_boolean(where, value->get());
    if (const auto* value = node.as_floating_point()) return convert_number(value->get(), where);
    std::ostringstream date;
    if (const auto* value = node.as_date()) date << value->get();
    if (const auto* value = node.as_time()) date << value->get();
    if (const auto* value = node.as_date_time()) date << value->get();
    return Node::make_date(where, date.str());
  }

 private:
  Node convert_table(const toml::table& table, const SourceSpan& where) {
    // toml++ sorts keys by name; people want the order they wrote.
    std::vector<std::pair<const toml::key*, const toml::node*>> entries;
    for (auto&& [key, value] : table) entries.emplace_back(&key, &value);
    const auto place = [](const auto& entry) {
      const toml::source_position& begin = entry.first->source().begin;
      return std::pair(begin.line, begin.column);
    };
    std::stable_sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    Node result = Node::make_table(where);
    for (const auto& [key, value] : entries) {
      const SourceSpan key_span = span(key->source(), where);
      result.put(std::string(key->str()), key_span, convert(*value, key_span));
    }
    return result;
  }

  Node convert_number(double value, const SourceSpan& where) {
    if (!std::isfinite(value)) {
      diagnostics_.error(where, "not a finite number", "leave the key out where a value is missing or without limit");
      value = 0;
    }
    return Node::make_number(where, value);
  }

  const std::shared_ptr<const SourceText>& shown_;
  Diagnostics& diagnostics_;
};

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// What stands behind the first `=` of a line, without a comment; empty if it begins like correct TOML text or a list.
std::string_view bare_value(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  std::string_view value = line.substr(equals + 1);
  value = value.substr(0, value.find('#'));
  const std::size_t begin = value.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  value = value.substr(begin, value.find_last_not_of(" \t") - begin + 1);
  return std::string_view("\"'[{").find(value.front()) == std::string_view::npos ? value : std::string_view{};
}

/// What people usually did when toml++ says this in this line.
std::string hint_for(std::string_view description, std::string_view line) {
  if (contains(description, "control characters other than TAB")) return "is a closing quote missing in this line?";
  if (contains(description, "cannot redefine"))
    return "a key or table stands once; lists of tables are written [[name]]";
  if (contains(description, "leading zeroes")) return "leave out the leading zero, or put the value in quotes";
  if (contains(description, "expected keys, tables"))
    return "keys with other characters than A-Z a-z 0-9 _ - need quotes";
  if (contains(description, "expected value, saw")) return "write a value behind '='";
  const std::string_view value = bare_value(line);
  if (value.empty()) return {};
  if (parse_number(value)) return contains(value, ".") ? "a decimal point needs a digit before and behind it" : "";
  if (value.find_first_not_of("0123456789,.+-") == std::string_view::npos && contains(value, ",")) {
    return "decimals are written with a point, lists in brackets";
  }
  return "text and quantities with a unit stand in quotes: \"" + printable(value, 60) + "\"";
}

void report(const toml::parse_error& error, const SourceSpan& place, Diagnostics& diagnostics) {
  constexpr std::string_view preface = "Error while parsing ";
  std::string_view description = error.description();
  const std::string hint = hint_for(description, place.line > 0 ? place.text->line(place.line) : std::string_view{});
  if (description.substr(0, preface.size()) == preface) description.remove_prefix(preface.size());
  diagnostics.error(place, "TOML: " + std::string(description), hint);
}

/// toml++ places a duplicate key at its value; the key stands earlier in the same line.
SourceSpan at_duplicate_key(const toml::parse_error& error, SourceSpan place) {
  const std::string_view description = error.description();
  if (!contains(description, "cannot redefine") || place.line < 1) return place;
  const std::size_t open = description.find('\'');
  const std::size_t close = open == std::string_view::npos ? open : description.find('\'', open + 1);
  if (close == std::string_view::npos) return place;
  const std::string_view key = description.substr(open + 1, close - open - 1);
  const std::string_view line = place.text->line(place.line);
  const std::size_t found = line.find(key);
  if (key.empty() || found == std::string_view::npos) return place;
  place.column = static_cast<int>(count_characters(line.substr(0, found))) + 1;
  place.length = static_cast<int>(count_characters(key));
  return place;
}

}  // namespace

std::optional<Node> parse_toml_tree(std::string_view toml,
                                    const std::shared_ptr<const SourceText>& shown,
                                    Diagnostics& diagnostics) {
  TomlConverter converter(shown, diagnostics);
  if (const auto deep = find_deep_key(toml)) {
    // The two texts have the same lines and columns.
    const Position place = SourceText({}, std::string(toml)).position(*deep);
    diagnostics.error({shown, place.line, place.column, 1},
                      "TOML: a key of more than " + std::to_string(most_key_parts) + " parts");
    return std::nullopt;
  }
  try {
    const toml::table table = toml::parse(toml, std::string_view(shown->path()));
    return converter.convert(table, SourceSpan{shown, 1, 1, 1});
  } catch (const toml::parse_error& error) {
    SourceSpan place = converter.span(error.source(), whole(shown));
    // Where the text ends, toml++ counts its last line end among the columns.
    if (place.line > 0)
      place.column = std::min(place.column, static_cast<int>(count_characters(shown->line(place.line))) + 1);
    report(error, at_duplicate_key(error, place), diagnostics);
    return std::nullopt;
  }
}

}  // namespace millwright::text
