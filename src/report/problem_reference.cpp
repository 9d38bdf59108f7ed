// SPDX-License-Identifier: Apache-2.0
#include "report/problem_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "machine/problem_keys.h"
#include "report/source_list.h"

namespace millwright::report {

namespace {

using machine::ProblemKey;
using machine::ProblemTable;
using machine::ProblemTableKind;
using text::Expected;
using text::Question;

constexpr std::pair<std::string_view, std::string_view> dimensions[] = {
    {"m", "length"},
    {"mm", "length"},
    {"s", "time"},
    {"kg", "mass"},
    {"N", "force"},
    {"N.m", "torque"},
    {"mm/s", "speed"},
    {"m/s", "speed"},
    {"m/s^3", "jerk"},
    {"rad/s^3", "angular jerk"},
    {"V", "voltage"},
    {"A", "current"},
    {"J", "energy"},
    {"deg", "angle"},
    {"rad", "angle"},
    {"rpm", "rotational speed"},
    {"kg.m2", "moment of inertia"},
    {"N.m/rad", "torsional stiffness"},
    {"Hz", "frequency"},
    {"Pa", "stress"},
    {"rad/m", "twist"},
    {"K", "temperature difference"},
    {"N/m", "stiffness"},
    {"m2/N", "wear rate"},
    {"W", "power"},
};

std::string code(std::string_view text) { return fmt::format("`{}`", text); }

std::string quantity_of(const Question& form) {
  if (form.unit == "1") return form.most == 1.0 ? "share up to 1" : "number";
  for (const auto& [unit, name] : dimensions)
    if (unit == form.unit) return fmt::format("{}, {}", name, code(form.example));
  return fmt::format("quantity, {}", code(form.example));
}

std::string words_of(const Question& form) {
  std::vector<std::string> words;
  for (const std::string& word : form.words) words.push_back(code(word));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string value_of(const Question& form) {
  switch (form.expected) {
    case Expected::text:
      return "text";
    case Expected::number:
      return "number";
    case Expected::integer:
      return std::isfinite(form.most) ? fmt::format("whole number, {:g} to {:g}", form.least, form.most)
                                      : "whole number";
    case Expected::boolean:
      return "`true` or `false`";
    case Expected::date:
      return "date, " + code(form.example);
    case Expected::table:
      return "table";
    case Expected::tables:
      return "tables";
    case Expected::table_or_tables:
      return "table, or list of tables";
    case Expected::texts:
      return "text, or list of texts";
    case Expected::word:
      return words_of(form);
    case Expected::words:
      return "one or more of " + words_of(form);
    case Expected::quantity:
      return quantity_of(form);
    case Expected::range:
      return quantity_of(form) + "; or a range of two in brackets";
    case Expected::quantities:
      return quantity_of(form) + "; or a list";
    case Expected::three_quantities:
      return "three in brackets: " + quantity_of(form);
    case Expected::amount:
      return "money, " + code(form.example);
    case Expected::anything:
    case Expected::not_allowed:
      break;
  }
  return "";
}

/// Without what would end a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

std::string first_letter_up(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string row(const ProblemKey& key) {
  std::vector<std::string> values;
  std::string fallback, source;
  for (const Question& form : key.forms) {
    values.push_back(value_of(form));
    if (!form.fallback.empty()) fallback = code(form.fallback);
    if (!form.source.empty()) source = form.source;
  }
  if (key.required) fallback = "required";
  if (!source.empty() && !key.required && !fallback.empty()) fallback += " (" + source + ")";
  return fmt::format("| {} | {} | {} | {} |\n",
                     key.name == "*" ? "any name" : code(key.name),
                     cell(fmt::format("{}", fmt::join(values, "; or "))),
                     cell(fallback),
                     cell(first_letter_up(key.meaning)));
}

bool same(const ProblemKey& one, const ProblemKey& other) { return row(one) == row(other); }

const ProblemKey* find_key(const ProblemTableKind& kind, std::string_view name) {
  for (const ProblemKey& key : kind.keys)
    if (key.name == name) return &key;
  return nullptr;
}

bool in_all(const ProblemTable& table, const ProblemKey& key) {
  return std::all_of(table.kinds.begin(), table.kinds.end(), [&](const ProblemTableKind& kind) {
    const ProblemKey* other = find_key(kind, key.name);
    return other != nullptr && same(*other, key);
  });
}

std::string rows(const std::vector<const ProblemKey*>& keys) {
  if (keys.empty()) return "";
  std::string text = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const ProblemKey* key : keys) text += row(*key);
  return text + "\n";
}

const ProblemTable* find_table(const std::vector<ProblemTable>& tables, std::string_view path) {
  for (const ProblemTable& table : tables)
    if (table.path == path) return &table;
  return nullptr;
}

/// As it is written in a file: [[axis.moves]], [axis.guide].
std::string heading(const std::vector<ProblemTable>& tables, const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::string parent = dot == std::string::npos ? "" : path.substr(0, dot);
  const std::string name = dot == std::string::npos ? path : path.substr(dot + 1);
  bool many = false;
  if (const ProblemTable* above = find_table(tables, parent))
    for (const ProblemTableKind& kind : above->kinds)
      if (const ProblemKey* key = find_key(kind, name))
        many = many || std::any_of(key->forms.begin(), key->forms.end(), [](const Question& form) {
                 return form.expected == Expected::tables;
               });
  return many ? "[[" + path + "]]" : "[" + path + "]";
}

/// A table whose keys are those of another one, or some of them.
bool is_part_of(const ProblemTable& table, const ProblemTable& whole) {
  return std::all_of(table.kinds.begin(), table.kinds.end(), [&](const ProblemTableKind& kind) {
    return std::all_of(kind.keys.begin(), kind.keys.end(), [&](const ProblemKey& key) {
      const ProblemKey* other = find_key(whole.kinds.front(), key.name);
      return other != nullptr && same(*other, key);
    });
  });
}

std::string kind_title(const ProblemTable& table, const std::string& name) {
  if (table.told_by_own_kind) return fmt::format("With `kind = \"{}\"`", name);
  return name == machine::axis_that_turns ? "Of an axis with a rotary mechanism"
                                          : "Of an axis that goes along a length";
}

/// The keys that a table leaves out of those of another one.
std::string left_out(const ProblemTable& table, const ProblemTable& whole) {
  std::string text;
  for (const ProblemTableKind& kind : table.kinds) {
    std::vector<std::string> without;
    for (const ProblemKey& key : whole.kinds.front().keys)
      if (find_key(kind, key.name) == nullptr) without.push_back(code(key.name));
    if (!without.empty())
      text += fmt::format("{}: without {}.\n\n", kind_title(table, kind.name), fmt::join(without, ", "));
  }
  return text;
}

std::string section(const std::vector<ProblemTable>& tables, const ProblemTable& table) {
  std::string text =
      table.path.empty() ? "## The outermost keys\n\n" : fmt::format("## `{}`\n\n", heading(tables, table.path));
  const std::string last = table.path.substr(table.path.rfind('.') + 1);
  const ProblemTable* same_name = find_table(tables, last);
  if (table.path == "axis.require.position_error") same_name = find_table(tables, "require.position_error");
  if (same_name != nullptr && same_name != &table && is_part_of(table, *same_name))
    return text + fmt::format("The keys of `{}`, for this axis.\n\n", heading(tables, same_name->path)) +
           left_out(table, *same_name);
  std::vector<const ProblemKey*> shared;
  for (const ProblemKey& key : table.kinds.front().keys)
    if (in_all(table, key)) shared.push_back(&key);
  text += rows(shared);
  if (table.kinds.size() < 2) return text;
  for (const ProblemTableKind& kind : table.kinds) {
    std::vector<const ProblemKey*> own;
    for (const ProblemKey& key : kind.keys)
      if (!in_all(table, key)) own.push_back(&key);
    if (!own.empty()) text += kind_title(table, kind.name) + ":\n\n" + rows(own);
  }
  return text;
}

std::string source_section(const std::vector<ProblemTable>& tables) {
  std::set<std::string> keys;
  for (const ProblemTable& table : tables)
    for (const ProblemTableKind& kind : table.kinds)
      for (const ProblemKey& key : kind.keys)
        for (const Question& form : key.forms)
          if (!form.source.empty() && !form.fallback.empty()) keys.insert(form.source);
  std::string text = "## Sources\n\n";
  for (const std::string& key : keys) text += fmt::format("- {}: {}\n", key, citation(key));
  return text + "\n";
}

/// Tables in the order in which they are met in a file: each followed by those inside it.
void in_depth(const std::vector<ProblemTable>& all, const std::string& path, std::vector<const ProblemTable*>& order) {
  const ProblemTable* table = find_table(all, path);
  if (table == nullptr) return;
  order.push_back(table);
  std::set<std::string> done;
  for (const ProblemTableKind& kind : table->kinds)
    for (const ProblemKey& key : kind.keys)
      if (std::any_of(key.forms.begin(), key.forms.end(), machine::holds_tables) && done.insert(key.name).second)
        in_depth(all, path.empty() ? key.name : path + "." + key.name, order);
}

}  // namespace

std::string problem_reference() {
  const std::vector<ProblemTable> tables = machine::problem_tables();
  std::string text =
      "# The problem file\n\n"
      "TOML, or JSON of the same structure in a file whose name ends in `.json`. This page is written by `millwright "
      "reference` from what the program's readers ask for; `millwright schema` writes the same for editors.\n\n"
      "- A quantity is text with its unit: `\"700 mm\"`, `\"0.7 m\"`, `\"27.6 in\"`; the examples below show the "
      "dimension, any unit of it will do. Numbers without a dimension stand bare: `0.8`; or `\"80 %\"`.\n"
      "- The word in parentheses behind a default is its source, listed at the end.\n"
      "- A table may be written under its header or in braces: `mechanism = { kind = \"belt\" }`.\n"
      "- What depends on more than one key (a time or a speed, a length within the stroke) is not told here: the "
      "program "
      "says it, with line, column and hint.\n\n";
  std::vector<const ProblemTable*> order;
  in_depth(tables, "", order);
  for (const ProblemTable* table : order) text += section(tables, *table);
  text += source_section(tables);
  while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
  return text;
}

}  // namespace millwright::report
