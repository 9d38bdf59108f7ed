// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "machine/problem_keys.h"
#include "report/problem_reference.h"

namespace millwright::report {

namespace {

using Json = nlohmann::ordered_json;
using machine::ProblemKey;
using machine::ProblemTable;
using machine::ProblemTableKind;
using text::Expected;
using text::Question;

constexpr const char* number_pattern = R"((\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?)";

/// Text with a number and a unit; a minus sign only where it has a meaning.
Json quantity(const Question& form) {
  const std::string sign = form.least >= 0.0 ? R"(^\s*\+?)" : R"(^\s*[+-]?)";
  if (form.unit != "1") return {{"type", "string"}, {"pattern", sign + number_pattern + R"(\s+\S.*$)"}};
  Json number = {{"type", "number"}};
  if (std::isfinite(form.least)) number[form.above_least ? "exclusiveMinimum" : "minimum"] = form.least;
  if (std::isfinite(form.most)) number["maximum"] = form.most;
  return {{"anyOf", {number, {{"type", "string"}, {"pattern", sign + number_pattern + R"((\s+\S.*)?\s*$)"}}}}};
}

Json list_of(const Json& item, int least, int most = 0) {
  Json list = {{"type", "array"}, {"items", item}, {"minItems", least}};
  if (most > 0) list["maxItems"] = most;
  return list;
}

Json one_or_list(const Json& item, int least, int most = 0) { return {{"anyOf", {item, list_of(item, least, most)}}}; }

Json bounded(const char* type, const Question& form) {
  Json schema = {{"type", type}};
  if (std::isfinite(form.least)) schema["minimum"] = form.least;
  if (std::isfinite(form.most)) schema["maximum"] = form.most;
  return schema;
}

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

std::string definition_name(const std::string& path, const std::string& kind) {
  std::string name = path.empty() ? "problem" : path;
  for (char& c : name)
    if (c == '*') c = '_';
  return kind.empty() ? name : name + "." + kind;
}

Json value(const Question& form, const Json& table) {
  const Json text = {{"type", "string"}};
  const Json word = {{"type", "string"}, {"enum", form.words}};
  switch (form.expected) {
    case Expected::number:
      return bounded("number", form);
    case Expected::integer:
      return bounded("integer", form);
    case Expected::boolean:
      return {{"type", "boolean"}};
    case Expected::date:
      return {{"type", "string"}, {"pattern", R"(^\d{4}-\d{2}-\d{2}$)"}};
    case Expected::table:
      return table;
    case Expected::tables:
      return list_of(table, 1);
    case Expected::table_or_tables:
      return one_or_list(table, 1);
    case Expected::texts:
      return one_or_list(text, 0);
    case Expected::word:
      return word;
    case Expected::words:
      return one_or_list(word, 1);
    case Expected::quantity:
      return quantity(form);
    case Expected::range:
      return one_or_list(quantity(form), 2, 2);
    case Expected::quantities:
      return one_or_list(quantity(form), 1);
    case Expected::three_quantities:
      return list_of(quantity(form), 3, 3);
    case Expected::amount:
      return {{"type", "string"}, {"pattern", std::string("^") + number_pattern + R"(\s[A-Z]{3}$)"}};
    case Expected::text:
    case Expected::anything:
    case Expected::not_allowed:
      break;
  }
  return text;
}

/// A default as JSON has it: text in quotes, a number, true or false, a word.
Json fallback_of(const Question& form) {
  const std::string& text = form.fallback;
  if (text.front() == '"') return text.substr(1, text.size() - 2);
  if (form.expected == Expected::word) return text;
  return Json::parse(text);
}

class Schema {
 public:
  Schema() : tables_(machine::problem_tables()) {}

  Json whole() {
    Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Millwright problem file"}};
    Json definitions = Json::object();
    for (const ProblemTable& table : tables_) {
      definitions[definition_name(table.path, "")] = of_table(table);
      if (!table.told_by_own_kind && table.kinds.size() > 1)
        for (const ProblemTableKind& kind : table.kinds)
          definitions[definition_name(table.path, kind.name)] = of_kind(table, kind);
    }
    const Json root = definitions["problem"];
    definitions.erase("problem");
    for (const auto& [key, part] : root.items()) schema[key] = part;
    schema["definitions"] = definitions;
    return schema;
  }

 private:
  /// What may stand at a key; `kind` is that of the axis the table belongs to.
  Json of_key(const ProblemTable& table, const ProblemKey& key, const std::string& kind) const {
    const std::string path = table.path.empty() ? key.name : table.path + "." + key.name;
    const bool by_axis = std::any_of(tables_.begin(), tables_.end(), [&](const ProblemTable& each) {
      return each.path == path && !each.told_by_own_kind && each.kinds.size() > 1;
    });
    const Json inner = reference(definition_name(path, by_axis ? kind : ""));
    Json all = Json::array();
    for (const Question& form : key.forms) all.push_back(value(form, inner));
    Json schema = all.size() == 1 ? all.front() : Json{{"anyOf", all}};
    // Beside a $ref nothing else counts.
    if (schema.contains("$ref")) schema = {{"allOf", Json::array({schema})}};
    schema["description"] = key.meaning;
    if (!key.required)
      for (const Question& form : key.forms)
        if (!form.fallback.empty()) schema["default"] = fallback_of(form);
    return schema;
  }

  Json of_kind(const ProblemTable& table, const ProblemTableKind& kind) const {
    const std::string axis = table.told_by_own_kind ? "" : kind.name;
    Json schema = {{"type", "object"}, {"properties", Json::object()}};
    Json required = Json::array();
    for (const ProblemKey& key : kind.keys) {
      if (key.name == "*")
        schema["additionalProperties"] = of_key(table, key, axis);
      else
        schema["properties"][key.name] = of_key(table, key, axis);
      if (key.required) required.push_back(key.name);
    }
    if (!schema.contains("additionalProperties")) schema["additionalProperties"] = false;
    if (!required.empty()) schema["required"] = required;
    return schema;
  }

  /// The keys of all kinds; which go with which kind is told in conditions.
  Json of_table(const ProblemTable& table) const {
    if (table.kinds.size() == 1) return of_kind(table, table.kinds.front());
    Json schema = {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
    for (const ProblemTableKind& kind : table.kinds)
      for (const ProblemKey& key : kind.keys)
        if (!schema["properties"].contains(key.name)) schema["properties"][key.name] = shared(table, key);
    if (table.told_by_own_kind) schema["required"] = Json::array({"kind"});
    Json conditions = Json::array();
    for (const ProblemTableKind& kind : table.kinds) {
      Json exact = of_kind(table, kind);
      if (table.told_by_own_kind) exact["properties"]["kind"] = Json{{"const", kind.name}};
      conditions.push_back({{"if", condition(table, kind.name)}, {"then", exact}});
    }
    // Of an axis and its moves the kind is told from outside: only the axis itself can say it.
    if (table.told_by_own_kind || table.path == "axis") schema["allOf"] = conditions;
    return schema;
  }

  /// The key with its meaning, any value of any kind.
  Json shared(const ProblemTable& table, const ProblemKey& key) const {
    Json all = Json::array();
    std::set<std::string> meanings;
    Json first;
    for (const ProblemTableKind& kind : table.kinds)
      for (const ProblemKey& each : kind.keys) {
        if (each.name != key.name) continue;
        Json schema = of_key(table, each, table.told_by_own_kind ? "" : kind.name);
        schema.erase("default");
        if (std::find(all.begin(), all.end(), schema) == all.end()) all.push_back(schema);
      }
    if (all.size() == 1) return all.front();
    return {{"anyOf", all}, {"description", key.meaning}};
  }

  static Json condition(const ProblemTable& table, const std::string& kind) {
    if (table.told_by_own_kind)
      return {{"properties", {{"kind", {{"const", kind}}}}}, {"required", Json::array({"kind"})}};
    const Json rotary = {
        {"properties",
         {{"mechanism", {{"properties", {{"kind", {{"const", "rotary"}}}}}, {"required", Json::array({"kind"})}}}}},
        {"required", Json::array({"mechanism"})}};
    return kind == machine::axis_that_turns ? rotary : Json{{"not", rotary}};
  }

  std::vector<ProblemTable> tables_;
};

}  // namespace

std::string problem_schema() { return Schema().whole().dump(1) + "\n"; }

}  // namespace millwright::report
