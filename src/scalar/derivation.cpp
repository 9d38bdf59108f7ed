// SPDX-License-Identifier: Apache-2.0
//
// Prints the expressions of Traced numbers: once in symbols, once with numbers and units substituted.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <unordered_map>

#include "scalar/expression.h"
#include "scalar/traced.h"

namespace millwright::scalar {
namespace {

using Kind = Expression::Kind;

/// How tightly a text binds, to set as few parentheses as possible.
enum Binding { sum = 1, term = 2, raised = 3, atom = 4 };

struct Text {
  std::string text;
  Binding binding = atom;
};

/// Both ways to print one expression.
struct Printed {
  Text symbols;
  Text numbers;
};

constexpr std::size_t longest_line = 160;  ///< characters of a symbolic expression before it is broken up
constexpr int argument_digits = 6;
constexpr int result_digits = 4;

std::string in_parentheses(const Text& inner, Binding needed) {
  return inner.binding >= needed ? inner.text : "(" + inner.text + ")";
}

std::string literal_text(double value) {
  std::string shortest = fmt::format("{}", value);
  if (shortest.size() <= 8 && shortest.find('e') == std::string::npos) return shortest;
  return format_number(value, argument_digits);
}

Text number_text(std::string text) {
  const bool negative = text.starts_with("-");
  return {std::move(text), negative ? sum : atom};
}
/// A value with a unit binds like a product: it needs parentheses only under a power.
Text quantity_text(double si, const Unit& unit, int digits) {
  Text text = number_text(format(si, unit, digits));
  if (text.binding == atom && text.text.find(' ') != std::string::npos) text.binding = raised;
  return text;
}

std::string superscript(const std::string& digits) {
  static const char* const raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : digits) text += c == '-' ? "⁻" : raised_digits[c - '0'];
  return text;
}

Text power_text(const Text& base, const Text& exponent) {
  const std::string& digits = exponent.text;
  const bool whole = !digits.empty() && digits.find_first_not_of("0123456789-") == std::string::npos && digits != "-";
  std::string text = in_parentheses(base, atom);
  text += whole ? superscript(digits) : "^" + in_parentheses(exponent, atom);
  return {std::move(text), raised};
}

Text function_text(const std::string& symbol, const std::vector<Text>& operands) {
  if (symbol == "|") return {"|" + operands[0].text + "|", atom};
  if (symbol == "⌊") return {"⌊" + operands[0].text + "⌋", atom};
  std::string text = symbol + "(";
  for (std::size_t i = 0; i < operands.size(); ++i) text += (i > 0 ? ", " : "") + operands[i].text;
  return {text + ")", atom};
}

Text composed(const Expression& expression, const std::vector<Text>& operands) {
  const auto binary = [&](const char* sign, Binding own, Binding right) -> Text {
    // A sign at the left end of a sum needs no parentheses, on the right of an operator it does.
    std::string second = in_parentheses(operands[1], right);
    if (second.starts_with("-")) second = "(" + second + ")";
    return {in_parentheses(operands[0], own) + sign + second, own};
  };
  switch (expression.kind) {
    case Kind::add:
      return binary(" + ", sum, sum);
    case Kind::subtract:
      return binary(" - ", sum, term);
    case Kind::multiply:
      return binary(" · ", term, term);
    case Kind::divide:
      return binary(" / ", term, raised);
    case Kind::power:
      return power_text(operands[0], operands[1]);
    case Kind::negate:
      return {"-" + in_parentheses(operands[0], term), sum};
    default:
      return function_text(expression.symbol, operands);
  }
}

class Printer {
 public:
  /// The text of an expression; whatever has a symbol of its own becomes a line first.
  const Printed& print(const ExpressionPointer& pointer) {
    if (const auto known = printed_.find(pointer.get()); known != printed_.end()) return known->second;
    return printed_[pointer.get()] = printed_anew(*pointer);
  }

  void add_line(std::string symbol, const Printed& text, double value, const Unit& unit) {
    lines_.push_back({std::move(symbol), text.symbols.text, text.numbers.text, value, unit});
  }
  std::vector<DerivationLine> lines() && { return std::move(lines_); }

 private:
  Printed printed_anew(const Expression& expression) {
    switch (expression.kind) {
      case Kind::number: {
        const Text text = number_text(literal_text(expression.value));
        return {text, text};
      }
      case Kind::constant:
        return {{expression.symbol, atom}, {expression.symbol, atom}};
      case Kind::quantity: {
        const Text text = quantity_text(expression.value, expression.unit, argument_digits);
        return {text, text};
      }
      case Kind::leaf:
        return {{expression.symbol, atom}, quantity_text(expression.value, expression.unit, argument_digits)};
      case Kind::named:
        return as_line(expression.symbol, print(expression.operands[0]), expression);
      default:
        return compound(expression);
    }
  }

  Printed compound(const Expression& expression) {
    std::vector<Text> symbols;
    std::vector<Text> numbers;
    std::size_t length = 0;
    for (const ExpressionPointer& operand : expression.operands) length += print(operand).symbols.text.size();
    for (const ExpressionPointer& operand : expression.operands) {
      const Printed* text = &print(operand);
      // Shared operands would otherwise be printed again and again, doubling with every level.
      const bool break_here = length > longest_line && 2 * text->symbols.text.size() >= longest_line;
      if (break_here) text = &(printed_[operand.get()] = as_line(fresh_symbol(), *text, *operand));
      symbols.push_back(text->symbols);
      numbers.push_back(text->numbers);
    }
    return {composed(expression, symbols), composed(expression, numbers)};
  }

  Printed as_line(const std::string& symbol, const Printed& meaning, const Expression& expression) {
    const Unit unit = readable_unit(expression.dimension, expression.value);
    std::string unique = symbol;
    // Two calls of one formula may define the same symbol: one line if they agree, a counted symbol if not.
    for (int count = 2;; ++count) {
      const auto [place, is_new] = defined_.try_emplace(unique, meaning.numbers.text + " = " + meaning.symbols.text);
      if (is_new) add_line(unique, meaning, expression.value, unit);
      if (is_new || place->second == meaning.numbers.text + " = " + meaning.symbols.text) break;
      unique = fmt::format("{}({})", symbol, count);
    }
    return {{unique, atom}, quantity_text(expression.value, unit, result_digits)};
  }

  std::string fresh_symbol() {
    std::string symbol = "z";
    for (const char c : std::to_string(++fresh_))
      symbol += fmt::format("\xe2\x82{}", static_cast<char>(0x80 + c - '0'));
    return symbol;
  }

  std::unordered_map<const Expression*, Printed> printed_;
  std::map<std::string, std::string> defined_;
  std::vector<DerivationLine> lines_;
  int fresh_ = 0;
};

}  // namespace

std::vector<DerivationLine> derivation(const Traced& result, const std::string& symbol, const Unit& unit) {
  Printer printer;
  ExpressionPointer pointer = result.expression();
  if (pointer == nullptr) {
    pointer =
        std::make_shared<const Expression>(Expression{Kind::number, result.value, result.dimension, "", Unit(), {}});
  }
  // A result that a formula named itself is the last line, under the symbol asked for.
  while (pointer->kind == Kind::named) pointer = pointer->operands[0];
  const Printed text = printer.print(pointer);
  printer.add_line(symbol, text, result.value, unit);
  return std::move(printer).lines();
}

std::vector<DerivationLine> derivation(const Traced& result, const std::string& symbol) {
  return derivation(result, symbol, readable_unit(result.dimension, result.value));
}

std::string to_string(const DerivationLine& line) {
  std::string text = line.symbol + " = " + line.expression;
  if (line.substituted != line.expression) text += " = " + line.substituted;
  const std::string value = format(line.value, line.unit, result_digits);
  return value == line.substituted ? text : text + " = " + value;
}

}  // namespace millwright::scalar
