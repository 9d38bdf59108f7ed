// SPDX-License-Identifier: Apache-2.0
//
// The arithmetic of one line of a published calculation: "load * (tangent + mu) / (1 - tangent * mu) * X05 / 2".
//
//     sum    = product { ("+" | "-") product }
//     product = power { ("*" | "/") power }
//     power  = ["-"] atom [ "^" power ]
//     atom   = number | name | "pi" | ("sqrt" | "cbrt") "(" sum ")" | "(" sum ")"
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scalar/elementary.h"

namespace millwright::machine {

/// Where an expression does not parse: byte offset and what was wrong.
struct ExpressionError {
  std::size_t offset = 0;
  std::string message;
};

class ClaimExpression {
 public:
  enum class Operation { number, name, pi, negative, plus, minus, times, over, power, square_root, cube_root };

  /// nullptr and the reason in `error` when `text` is not an expression.
  static std::shared_ptr<const ClaimExpression> parse(std::string_view text, ExpressionError& error);

  /// The names it needs, each once, in order of appearance.
  const std::vector<std::string>& names() const { return names_; }

  /// Its value on the scalar T; `values` are those of names(), in that order. Throws what T throws, on Dimensioned a
  /// DimensionError.
  template <class T>
  T evaluate(const std::vector<T>& values) const {
    return value_of(root_, values);
  }

 private:
  friend class ExpressionParser;
  struct Node {
    Operation operation = Operation::number;
    double number = 0.0;
    std::size_t left = 0;  // index of the node; of a name: index into names_
    std::size_t right = 0;
  };

  template <class T>
  T value_of(std::size_t index, const std::vector<T>& values) const;

  std::vector<Node> nodes_;
  std::vector<std::string> names_;
  std::size_t root_ = 0;
};

template <class T>
T ClaimExpression::value_of(std::size_t index, const std::vector<T>& values) const {
  using namespace scalar;  // NOLINT(google-build-using-namespace): the functions of a formula, for double too
  const Node& node = nodes_[index];
  const auto left = [&] { return value_of(node.left, values); };
  const auto right = [&] { return value_of(node.right, values); };
  switch (node.operation) {
    case Operation::number:
      return T(node.number);
    case Operation::name:
      return values[node.left];
    case Operation::pi:
      return pi<T>();
    case Operation::negative:
      return -left();
    case Operation::plus:
      return left() + right();
    case Operation::minus:
      return left() - right();
    case Operation::times:
      return left() * right();
    case Operation::over:
      return left() / right();
    case Operation::square_root:
      return sqrt(left());
    case Operation::cube_root:
      return cbrt(left());
    case Operation::power:
      break;
  }
  // A literal exponent keeps the dimension of its base; any other needs both to be plain numbers.
  if (nodes_[node.right].operation == Operation::number) return pow(left(), nodes_[node.right].number);
  return pow(left(), right());
}

}  // namespace millwright::machine
