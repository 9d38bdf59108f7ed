// SPDX-License-Identifier: Apache-2.0
#include "machine/claims_value.h"

#include <algorithm>
#include <type_traits>

#include "machine/claims_expression.h"

namespace millwright::machine {

namespace {
using scalar::Dimensioned;
using scalar::Traced;
using scalar::Unit;

template <class T>
T leaf(const std::string& symbol, const Dimensioned& value, const Unit& unit) {
  if constexpr (std::is_same_v<T, Traced>) {
    return Traced::leaf(symbol, value.value, value.dimension, unit);
  } else if constexpr (std::is_same_v<T, Dimensioned>) {
    return value;
  } else {
    return value.value;
  }
}

/// Sums and products of anything say more with the names of what goes in than with x and c.
std::string symbol_of(const mechanics::Argument& argument, const Operand& operand, const std::string& otherwise) {
  return argument.unit == "any" && !operand.name.empty() ? operand.name : otherwise;
}

/// "F: m, but N is wanted".
void check_dimension(const mechanics::Argument& argument, const Dimensioned& value, const text::SourceSpan& where) {
  if (argument.unit == "any") return;
  const Unit wanted = Unit::of(argument.unit);
  if (wanted.dimension() == value.dimension) return;
  throw ClaimProblem(where,
                     argument.name + ": " + scalar::to_string(value.dimension) + " is given, " + argument.unit + " (" +
                         argument.meaning + ") is wanted");
}
}  // namespace

ClaimValues::Given ClaimValues::given_row(const std::string& id, const text::SourceSpan& asked_from) {
  const Dimensioned value = row(id, asked_from);
  const Claim* claim = file_.find_claim(id);
  return {value, claim ? claim->unit() : scalar::readable_unit(value.dimension, value.value)};
}

ClaimValues::Given ClaimValues::given(const Operand& operand) {
  const auto of = [](const scalar::Quantity& q) { return Given{Dimensioned(q.si, q.unit.dimension()), q.unit}; };
  switch (operand.kind) {
    case Operand::Kind::quantity:
      return of(operand.quantity);
    case Operand::Kind::input:
      if (const scalar::Quantity* input = file_.find_input(operand.axis, operand.name)) return of(*input);
      break;
    case Operand::Kind::printed:
      if (const Claim* claim = file_.find_claim(operand.name)) {
        return of({claim->unit().to_si(claim->printed.number), claim->unit()});
      }
      break;
    case Operand::Kind::row:
      return given_row(operand.name, operand.where);
    case Operand::Kind::word:
    case Operand::Kind::list:
      break;
  }
  throw ClaimProblem(operand.where, "no value here");
}

ClaimValues::Given ClaimValues::given_name(const Calculation& calculation,
                                           const std::string& axis,
                                           const std::string& name) {
  if (const Operand* own = calculation.find(name)) return given(*own);
  if (const scalar::Quantity* input = file_.find_input(axis, name)) {
    return {Dimensioned(input->si, input->unit.dimension()), input->unit};
  }
  return given_row(name, calculation.where);
}

Dimensioned ClaimValues::row(const std::string& id, const text::SourceSpan& asked_from) {
  if (const auto known = rows_.find(id); known != rows_.end()) return known->second;
  const ClaimRow* row = file_.find_row(id);
  if (!row || !row->calculation) throw ClaimProblem(asked_from, "row " + id + " has no computed value");
  const Dimensioned result = value(*row->calculation, row->axis);
  rows_.emplace(id, result);
  return result;
}

template <class T>
std::vector<mechanics::ArgumentValue<T>> ClaimValues::arguments(const Calculation& calculation) {
  std::vector<mechanics::ArgumentValue<T>> values;
  for (const mechanics::Argument& argument : calculation.formula->arguments()) {
    const Operand* operand = calculation.find(argument.name);
    if (!operand) throw ClaimProblem(calculation.where, "argument " + argument.name + " is missing");
    const auto number = [&](const Operand& one, const std::string& symbol) {
      const Given g = given(one);
      check_dimension(argument, g.value, one.where);
      return leaf<T>(symbol_of(argument, one, symbol), g.value, g.unit);
    };
    if (argument.kind == mechanics::ArgumentKind::choice) {
      const auto& words = argument.choices;
      values.emplace_back(static_cast<int>(std::find(words.begin(), words.end(), operand->name) - words.begin()));
    } else if (argument.kind == mechanics::ArgumentKind::list) {
      std::vector<T> list;
      for (const Operand& item : operand->items) {
        list.push_back(number(item, argument.symbol + "_" + std::to_string(list.size() + 1)));
      }
      values.emplace_back(std::move(list));
    } else {
      values.emplace_back(number(*operand, argument.symbol));
    }
  }
  return values;
}

template <class T>
T ClaimValues::evaluate(const Calculation& calculation, const std::string& axis) {
  try {
    if (calculation.formula) return calculation.formula->evaluate<T>(arguments<T>(calculation));
    std::vector<T> values;
    for (const std::string& name : calculation.expression->names()) {
      const Given g = given_name(calculation, axis, name);
      values.push_back(leaf<T>(name, g.value, g.unit));
    }
    return calculation.expression->evaluate<T>(values);
  } catch (const scalar::DimensionError& mismatch) {
    throw ClaimProblem(calculation.where, mismatch.what());
  } catch (const std::invalid_argument& mismatch) {
    throw ClaimProblem(calculation.where, mismatch.what());
  }
}

std::vector<std::string> ClaimValues::rows_used(const Calculation& calculation, const std::string& axis) const {
  std::vector<std::string> ids;
  const auto visit = [&](const auto& self, const Operand& operand) -> void {
    if (operand.kind == Operand::Kind::row) ids.push_back(operand.name);
    for (const Operand& item : operand.items) self(self, item);
  };
  for (const auto& [name, operand] : calculation.operands) visit(visit, operand);
  if (!calculation.expression) return ids;
  for (const std::string& name : calculation.expression->names()) {
    if (!calculation.find(name) && !file_.find_input(axis, name)) ids.push_back(name);
  }
  return ids;
}

Dimensioned ClaimValues::value(const Calculation& calculation, const std::string& axis) {
  return evaluate<Dimensioned>(calculation, axis);
}

Traced ClaimValues::trace(const Calculation& calculation, const std::string& axis) {
  return evaluate<Traced>(calculation, axis);
}

std::vector<std::string> ClaimValues::violations(const Calculation& calculation) {
  if (!calculation.formula) return {};
  const std::vector<mechanics::ArgumentValue<double>> values = arguments<double>(calculation);
  return calculation.formula->violations(values);
}

}  // namespace millwright::machine
