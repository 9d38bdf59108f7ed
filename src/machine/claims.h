// SPDX-License-Identifier: Apache-2.0
//
// A published calculation to be audited: what was printed, and how we compute the same result. Plain data, read from
//
//     title = "..."    source = "mini_mill"                     # key of sources.bib
//     [inputs.x]                                                # what the paper states, by axis
//     outer_diameter = "16 mm"
//     [[derived]]                                               # an intermediate value the paper does not print
//     axis = "x"   id = "guide_friction"   expression = "friction * mass * gravity"
//     [[claim]]                                                 # a printed result
//     axis = "x"   id = "X07"   quantity = "raising_torque"   printed = "36.43 N*mm"
//     formula = "power_screw.raising_torque"                    # or expression = "pitch / (pi * X05)"
//     inputs = { force = { input = "axial_load" }, mean_diameter = { from = "X05" }, lead = "2 mm", friction = 0.12 }
//     line = { mean_diameter = "15.1 mm" }                      # operands as they stand on that line of the paper
//     missing = "the screw diameter"                            # instead of a formula, or beside an indicative one
//     read_as = "mm^3/s"                                        # where the printed unit is of another dimension
//
// An operand is a quantity, a number, the name of an enumerator, { input = "name" } (of another axis with axis =
// "..."), { from = "id" } (the computed value of a row), { printed = "id" } (its printed value) or a list of such. The
// names of an expression are its own inputs, then the inputs of its axis, then rows. `line` keeps the formula or
// expression and replaces operands, or states an `expression` of its own.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scalar/unit.h"
#include "text/diagnostic.h"

namespace millwright::mechanics {
class Formula;
}

namespace millwright::text {
class Document;
}

namespace millwright::machine {

class ClaimExpression;  // claims_expression.h

/// What one argument of a calculation is given.
struct Operand {
  enum class Kind { quantity, input, row, printed, word, list };
  Kind kind = Kind::quantity;
  scalar::Quantity quantity;   ///< of a quantity
  std::string name;            ///< of an input, a row (computed or printed) or an enumerator
  std::string axis;            ///< of an input
  std::vector<Operand> items;  ///< of a list
  text::SourceSpan where;
};

/// One computation: a formula of ours with its operands, or an expression with the names it defines itself.
struct Calculation {
  const mechanics::Formula* formula = nullptr;
  std::shared_ptr<const ClaimExpression> expression;  ///< where there is no formula
  std::string expression_text;
  std::vector<std::pair<std::string, Operand>> operands;
  text::SourceSpan where;

  const Operand* find(const std::string& name) const;
};

/// A number as it was printed: the last digit decides how much it says.
struct PrintedValue {
  std::string text;         ///< "36.25e-6", without the unit
  scalar::Unit unit;        ///< as printed
  double number = 0.0;      ///< in `unit`
  double half_digit = 0.0;  ///< in `unit`: half a unit of the last printed digit
  int significant_digits = 0;
};

/// Reads "0.0700 mm": number 0.07, half digit 0.00005, three significant digits. Zeros at the end of a whole number
/// count as digits: "150" is 150 +- 0.5. On failure nothing, and why in `reason`.
std::optional<PrintedValue> parse_printed(std::string_view text, std::string& reason);

/// A row: a value with a name that other rows may use.
struct ClaimRow {
  std::string axis;
  std::string id;
  std::optional<Calculation> calculation;  ///< nothing where an input is missing
  text::SourceSpan where;
};

/// A printed result.
struct Claim : ClaimRow {
  std::string quantity;
  PrintedValue printed;
  std::optional<scalar::Unit>
      read_as;                      ///< the unit in which the printed number is read, where the printed one is wrong
  std::string missing;              ///< what is missing; the calculation, if there is one, is then indicative
  std::optional<Calculation> line;  ///< the same with the operands as printed on its line; complete

  /// The unit in which the printed number counts.
  const scalar::Unit& unit() const { return read_as ? *read_as : printed.unit; }
};

struct ClaimsFile {
  std::string title;
  std::string source;                                                     ///< key of sources.bib
  std::map<std::string, std::map<std::string, scalar::Quantity>> inputs;  ///< by axis, then by name
  std::vector<Claim> claims;                                              ///< in the order of the file
  std::vector<ClaimRow> derived;
  std::shared_ptr<const text::SourceText> text;

  const Claim* find_claim(const std::string& id) const;
  /// A claim or a derived value.
  const ClaimRow* find_row(const std::string& id) const;
  /// An input of that axis; nullptr when there is none.
  const scalar::Quantity* find_input(const std::string& axis, const std::string& name) const;
};

/// Reads a claims file (.toml or .json) and checks it so far that auditing cannot fail on it: formulas, arguments,
/// names, circles and dimensions. Every problem is reported at its place; nothing if there was an error.
std::optional<ClaimsFile> read_claims(const std::string& path, text::Diagnostics& diagnostics);
std::optional<ClaimsFile> read_claims(const text::Document& document, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
