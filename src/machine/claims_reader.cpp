// SPDX-License-Identifier: Apache-2.0
#include "machine/claims_reader.h"

#include <algorithm>

#include "machine/claims_expression.h"
#include "mechanics/formula.h"
#include "text/nearest.h"

namespace millwright::machine {

namespace {
using text::did_you_mean;
using text::in_quotes;
using text::Node;

std::vector<std::string> formula_names() {
  std::vector<std::string> names;
  for (const mechanics::Formula& formula : mechanics::formulas()) names.push_back(formula.name());
  return names;
}

std::vector<std::string> argument_names(const mechanics::Formula& formula) {
  std::vector<std::string> names;
  for (const mechanics::Argument& argument : formula.arguments()) names.push_back(argument.name);
  return names;
}

const mechanics::Argument* find_argument(const Calculation& calculation, const std::string& name) {
  if (!calculation.formula) return nullptr;
  for (const mechanics::Argument& argument : calculation.formula->arguments()) {
    if (argument.name == name) return &argument;
  }
  return nullptr;
}

std::vector<std::string> operand_names(const Calculation& calculation) {
  return calculation.formula ? argument_names(*calculation.formula) : calculation.expression->names();
}

template <class List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string what(const Node& node) { return std::string(text::describe(node.kind())); }
}  // namespace

void CalculationReader::check_keys(const Node& table, std::initializer_list<std::string_view> known) {
  for (const text::TableEntry& entry : table.entries()) {
    if (contains(known, entry.key)) continue;
    diagnostics_.error(entry.key_span, "unknown key " + in_quotes(entry.key), did_you_mean(entry.key, known));
  }
}

std::string CalculationReader::optional_text(const Node& table, std::string_view key) {
  const Node* node = table.find(key);
  if (!node) return "";
  if (const auto value = node->as_string()) return *value;
  diagnostics_.error(node->span(), std::string(key) + ": text is wanted here, not " + what(*node));
  return "";
}

std::string CalculationReader::required_text(const Node& table, std::string_view key) {
  if (!table.find(key)) {
    diagnostics_.error(table.span(), "key '" + std::string(key) + "' is missing");
    return "";
  }
  const std::string value = optional_text(table, key);
  if (value.empty() && table.find(key)->is_string()) {
    diagnostics_.error(table.find(key)->span(), std::string(key) + ": must not be empty");
  }
  return value;
}

std::optional<scalar::Quantity> CalculationReader::quantity(const Node& node) {
  if (const auto number = node.as_number()) return scalar::Quantity{*number, scalar::Unit()};
  const auto text = node.as_string();
  if (!text) {
    diagnostics_.error(node.span(), "a quantity such as \"20 mm\" is wanted here, not " + what(node));
    return std::nullopt;
  }
  std::string reason;
  const auto value = parse_printed(*text, reason);
  if (!value) {
    diagnostics_.error(node.span(), "not a quantity: " + in_quotes(*text), reason);
    return std::nullopt;
  }
  return scalar::Quantity{value->unit.to_si(value->number), value->unit};
}

std::optional<Operand> CalculationReader::reference(const Node& table, const std::string& axis) {
  const std::size_t errors_before = diagnostics_.error_count();
  check_keys(table, {"input", "axis", "from", "printed"});
  if (diagnostics_.error_count() != errors_before) return std::nullopt;
  const Node* input = table.find("input");
  const Node* from = table.find("from");
  const Node* printed = table.find("printed");
  if ((input ? 1 : 0) + (from ? 1 : 0) + (printed ? 1 : 0) != 1) {
    diagnostics_.error(table.span(), "one of input, from and printed must be given here");
    return std::nullopt;
  }
  Operand operand;
  operand.where = table.span();
  operand.kind = input ? Operand::Kind::input : (from ? Operand::Kind::row : Operand::Kind::printed);
  operand.name = required_text(table, input ? "input" : (from ? "from" : "printed"));
  if (input) operand.axis = table.find("axis") ? required_text(table, "axis") : axis;
  if (!input && table.find("axis")) {
    diagnostics_.error(table.key_span("axis"), "axis belongs to input; rows have one name in the whole file");
  }
  if (operand.name.empty()) return std::nullopt;
  return operand;
}

std::optional<Operand> CalculationReader::operand(const Node& node, const std::string& axis) {
  if (node.is_table()) return reference(node, axis);
  const auto value = quantity(node);
  if (!value) return std::nullopt;
  Operand operand;
  operand.quantity = *value;
  operand.where = node.span();
  return operand;
}

std::optional<Operand> CalculationReader::choice(const Node& node, const std::vector<std::string>& choices) {
  Operand operand;
  operand.kind = Operand::Kind::word;
  operand.where = node.span();
  operand.name = node.as_string().value_or("");
  if (contains(choices, operand.name)) return operand;
  std::string all;
  for (const std::string& word : choices) all += (all.empty() ? "" : ", ") + word;
  diagnostics_.error(node.span(), "one of " + all + " is wanted here", did_you_mean(operand.name, choices));
  return std::nullopt;
}

std::optional<Operand> CalculationReader::argument(const Node& node,
                                                   const std::string& axis,
                                                   const std::string& name,
                                                   const Calculation& calculation) {
  const mechanics::Argument* argument = find_argument(calculation, name);
  if (argument && argument->kind == mechanics::ArgumentKind::choice) return choice(node, argument->choices);
  if (!argument || argument->kind == mechanics::ArgumentKind::number) {
    if (!node.is_array()) return operand(node, axis);
    diagnostics_.error(node.span(), name + ": one value is wanted here, not a list");
    return std::nullopt;
  }
  if (!node.is_array() || node.size() == 0) {
    diagnostics_.error(node.span(), name + ": a list of values is wanted here");
    return std::nullopt;
  }
  Operand list;
  list.kind = Operand::Kind::list;
  list.where = node.span();
  for (const Node& item : node.items()) {
    auto one = operand(item, axis);
    if (!one) return std::nullopt;
    list.items.push_back(std::move(*one));
  }
  return list;
}

bool CalculationReader::choose_formula(const Node& name, Calculation& calculation) {
  const std::string word = name.as_string().value_or("");
  calculation.formula = mechanics::find_formula(word);
  calculation.where = name.span();
  if (calculation.formula) return true;
  diagnostics_.error(name.span(), "no formula is called " + in_quotes(word), did_you_mean(word, formula_names()));
  return false;
}

bool CalculationReader::choose_expression(const Node& expression, Calculation& calculation) {
  const std::string text = expression.as_string().value_or("");
  ExpressionError error;
  calculation.expression = ClaimExpression::parse(text, error);
  calculation.expression_text = text;
  calculation.where = expression.span();
  if (calculation.expression) return true;
  diagnostics_.error(expression.part_span(error.offset, 1), error.message);
  return false;
}

bool CalculationReader::add_operands(const Node& table,
                                     const std::string& axis,
                                     Calculation& calculation,
                                     std::string_view own_expression) {
  bool good = true;
  const std::vector<std::string> names = operand_names(calculation);
  for (const text::TableEntry& entry : table.entries()) {
    if (entry.key == own_expression) continue;
    if (!contains(names, entry.key)) {
      const std::string owner = calculation.formula ? calculation.formula->name() : "the expression";
      diagnostics_.error(
          entry.key_span, owner + " has no argument " + in_quotes(entry.key), did_you_mean(entry.key, names));
      good = false;
      continue;
    }
    auto value = argument(entry.value, axis, entry.key, calculation);
    if (!value) {
      good = false;
      continue;
    }
    auto known = std::find_if(calculation.operands.begin(), calculation.operands.end(), [&](const auto& one) {
      return one.first == entry.key;
    });
    if (known != calculation.operands.end()) {
      known->second = std::move(*value);
    } else {
      calculation.operands.emplace_back(entry.key, std::move(*value));
    }
  }
  return good;
}

/// Every argument of the formula is there, and lists that belong together are of one length.
bool CalculationReader::complete(const Calculation& calculation, const text::SourceSpan& where) {
  if (!calculation.formula) return true;
  bool good = true;
  const auto& arguments = calculation.formula->arguments();
  for (const mechanics::Argument& argument : arguments) {
    const Operand* operand = calculation.find(argument.name);
    if (!operand) {
      diagnostics_.error(where,
                         calculation.formula->name() + " needs " + argument.name + " (" + argument.meaning + ")");
      good = false;
    } else if (argument.same_length_as >= 0) {
      const std::string& other_name = arguments[static_cast<std::size_t>(argument.same_length_as)].name;
      const Operand* other = calculation.find(other_name);
      if (!other || other->items.size() == operand->items.size()) continue;
      diagnostics_.error(operand->where, argument.name + " must be as many as " + other_name);
      good = false;
    }
  }
  return good;
}

std::optional<Calculation> CalculationReader::calculation(const Node& row, const std::string& axis) {
  const Node* formula = row.find("formula");
  const Node* expression = row.find("expression");
  if (formula && expression) {
    diagnostics_.error(row.key_span("expression"), "a row has a formula or an expression, not both");
    return std::nullopt;
  }
  if (!formula && !expression) return std::nullopt;
  Calculation result;
  if (formula ? !choose_formula(*formula, result) : !choose_expression(*expression, result)) return std::nullopt;
  const Node* inputs = row.find("inputs");
  if (inputs && !inputs->is_table()) {
    diagnostics_.error(inputs->span(), "inputs: a table is wanted here, not " + what(*inputs));
    return std::nullopt;
  }
  const bool read = !inputs || add_operands(*inputs, axis, result);
  if (!read || !complete(result, result.where)) return std::nullopt;
  return result;
}

std::optional<Calculation> CalculationReader::line(const Node& line, const Calculation& base, const std::string& axis) {
  if (!line.is_table()) {
    diagnostics_.error(line.span(), "line: a table is wanted here, not " + what(line));
    return std::nullopt;
  }
  Calculation result;
  if (const Node* expression = line.find("expression")) {
    if (!choose_expression(*expression, result)) return std::nullopt;
  } else {
    result = base;
    result.where = line.span();
  }
  if (!add_operands(line, axis, result, "expression") || !complete(result, line.span())) return std::nullopt;
  return result;
}

}  // namespace millwright::machine
