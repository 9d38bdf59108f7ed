// SPDX-License-Identifier: Apache-2.0
//
// The expression behind a Traced number; shared by traced.cpp (builds it) and derivation.cpp (prints it).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scalar/unit.h"

namespace millwright::scalar {

struct Expression {
  enum class Kind {
    number,    ///< a literal without dimension
    constant,  ///< a symbol that is never substituted: π
    quantity,  ///< a literal with a dimension
    leaf,      ///< an argument with symbol and display unit
    named,     ///< an intermediate result with a symbol; one operand
    add,       ///< two operands, as the following four
    subtract,
    multiply,
    divide,
    power,
    negate,   ///< one operand
    function  ///< symbol(operands...)
  };
  Kind kind = Kind::number;
  double value = 0.0;
  Dimension dimension;
  std::string symbol;
  Unit unit;
  std::vector<std::shared_ptr<const Expression>> operands;
};

using ExpressionPointer = std::shared_ptr<const Expression>;

}  // namespace millwright::scalar
