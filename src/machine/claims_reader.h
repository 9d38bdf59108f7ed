// SPDX-License-Identifier: Apache-2.0
//
// One calculation block of a claims file: formula or expression, operands, and the line that overrides them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "machine/claims.h"
#include "text/node.h"

namespace millwright::machine {

/// Reads the calculations of the rows of one file and reports what is wrong in a block by itself: unknown formulas and
/// arguments, missing ones, operands of the wrong kind. Names are checked later (claims_check.h).
class CalculationReader {
 public:
  explicit CalculationReader(text::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// From the keys `formula` or `expression` and `inputs` of a row; nothing if neither is there or something is wrong.
  std::optional<Calculation> calculation(const text::Node& row, const std::string& axis);
  /// From the table `line` of a row whose calculation is `base`.
  std::optional<Calculation> line(const text::Node& line, const Calculation& base, const std::string& axis);
  /// A number, or text with number and unit.
  std::optional<scalar::Quantity> quantity(const text::Node& node);

  /// Reports each key of a table that is not one of `known`, with the nearest of them.
  void check_keys(const text::Node& table, std::initializer_list<std::string_view> known);
  /// The text at `key`; reports it if it is missing or no text, and gives "".
  std::string required_text(const text::Node& table, std::string_view key);
  /// The same for text that may be missing.
  std::string optional_text(const text::Node& table, std::string_view key);

 private:
  bool choose_formula(const text::Node& name, Calculation& calculation);
  bool choose_expression(const text::Node& expression, Calculation& calculation);
  /// Takes every key of `table` as an operand, except `own_expression`.
  bool add_operands(const text::Node& table,
                    const std::string& axis,
                    Calculation& calculation,
                    std::string_view own_expression = {});
  bool complete(const Calculation& calculation, const text::SourceSpan& where);
  std::optional<Operand> operand(const text::Node& node, const std::string& axis);
  std::optional<Operand> reference(const text::Node& table, const std::string& axis);
  std::optional<Operand> choice(const text::Node& node, const std::vector<std::string>& choices);
  std::optional<Operand> argument(const text::Node& node,
                                  const std::string& axis,
                                  const std::string& name,
                                  const Calculation& calculation);

  text::Diagnostics& diagnostics_;
};

}  // namespace millwright::machine
