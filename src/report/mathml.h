// SPDX-License-Identifier: Apache-2.0
// The formulas that traced numbers remember, as presentation MathML: browsers set it without fonts or scripts of ours.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scalar/expression.h"
#include "scalar/traced.h"

namespace millwright::report {

/// One line of a calculation; each piece is the inside of a <math> element.
struct MathLine {
  std::string symbol;
  std::string expression;   ///< in symbols; empty where there is nothing to calculate
  std::string substituted;  ///< the same with numbers; empty where that is the value itself
  std::string value;
};

/// The symbol of a quantity: "F_perm" with an index, "I_p/I_r", "m'".
std::string symbol_mathml(const std::string& symbol);
/// "12.3 N·m"
std::string quantity_mathml(double si, const scalar::Unit& unit, int significant);

/// Prints the calculations of one element: what several of its checks use is one line of all, and each symbol stands
/// for one quantity.
class MathPrinter {
 public:
  /// Adds a result; its number is how many there were before it. The value is shown as a number in a unit.
  void add(const scalar::Traced& result, double shown_value, const std::string& shown_unit);

  // When every result has been added:
  /// The lines that only this result needs, then its own line, which has no symbol.
  [[nodiscard]] std::vector<MathLine> lines(std::size_t result) const;
  /// What several results need, in an order in which each line only needs those before it.
  [[nodiscard]] std::vector<MathLine> shared() const;
  /// Whether a given figure stands in one of the lines.
  [[nodiscard]] bool uses(const std::string& symbol) const { return used_.count(symbol) > 0; }

 private:
  /// How tightly a piece binds, to set as few parentheses as possible.
  enum Binding { sum = 1, term = 2, raised = 3, atom = 4 };
  struct Piece {
    std::string text;
    Binding binding = atom;
    double width = 1.0;  ///< in characters, roughly
  };
  struct Printed {
    Piece symbols, numbers;
    bool plain = false;              ///< a literal: nothing to calculate
    std::vector<std::size_t> needs;  ///< lines whose symbols stand in it
    int fractions = 0;               ///< within each other
  };
  struct Line {
    MathLine text;
    std::vector<std::size_t> needs;
    std::size_t user = 0;  ///< the result that needs it, counted from 1
    bool shared = false;
  };
  struct Result {
    MathLine text;
    std::vector<std::size_t> needs;
    bool is_a_line = false;  ///< nothing but the symbol of the line that it needs
  };

  using Expression = scalar::Expression;
  using Pointer = scalar::ExpressionPointer;

  Printed print(const Pointer& whole);
  Pointer all_that_counts(const Pointer& pointer);
  Pointer what_counts(const Pointer& pointer);
  Pointer zero_of(const Pointer& pointer);
  Printed compound(const Expression& expression);
  Printed as_line(const std::string& symbol, const Printed& meaning, const Expression& expression);
  void use(std::size_t line, std::size_t result);

  static Piece composed(const Expression& expression, const std::vector<Piece>& operands);
  static Piece function(const std::string& symbol, const std::vector<Piece>& operands);
  static std::string wrapped(const Piece& inner, Binding needed);

  std::unordered_map<const Expression*, Printed> printed_;
  std::unordered_map<const Expression*, Pointer> counting_;
  std::map<std::string, std::pair<std::string, std::size_t>> meanings_;  ///< of a symbol, and its line
  std::set<std::string> used_;
  std::vector<Line> lines_;
  std::vector<Result> results_;
  std::vector<Pointer> kept_;  ///< so that no address is given twice
  int fresh_ = 0;
};

}  // namespace millwright::report
