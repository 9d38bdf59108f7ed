// SPDX-License-Identifier: Apache-2.0
//
// What the rows of a claims file are worth: operands looked up through the chain of rows, with their dimensions.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "machine/claims.h"
#include "mechanics/formula.h"
#include "scalar/dimensioned.h"
#include "scalar/traced.h"

namespace millwright::machine {

/// A calculation cannot be done as written; `where` is the operand or the calculation to blame.
class ClaimProblem : public std::runtime_error {
 public:
  ClaimProblem(text::SourceSpan where, const std::string& message)
      : std::runtime_error(message), where_(std::move(where)) {}
  const text::SourceSpan& where() const { return where_; }

 private:
  text::SourceSpan where_;
};

/// Evaluates rows, each once. The file must outlive it and hold no circle and no unknown name (read_claims sees to it).
/// Members throw ClaimProblem where dimensions do not fit or a row is without a calculation.
class ClaimValues {
 public:
  explicit ClaimValues(const ClaimsFile& file) : file_(file) {}

  /// The computed value of a row, by id.
  scalar::Dimensioned row(const std::string& id, const text::SourceSpan& asked_from);
  /// The value of a calculation that belongs to `axis`.
  scalar::Dimensioned value(const Calculation& calculation, const std::string& axis);
  /// The same with its expression, for the derivation.
  scalar::Traced trace(const Calculation& calculation, const std::string& axis);
  /// Ids of the rows whose computed values it takes directly, in order, perhaps repeated.
  std::vector<std::string> rows_used(const Calculation& calculation, const std::string& axis) const;
  /// Stated limits of the formula that the operands break, one sentence each.
  std::vector<std::string> violations(const Calculation& calculation);

 private:
  /// A number on its way into a calculation: value, dimension, and the unit a person reads it in.
  struct Given {
    scalar::Dimensioned value;
    scalar::Unit unit;
  };
  Given given(const Operand& operand);
  Given given_row(const std::string& id, const text::SourceSpan& asked_from);
  Given given_name(const Calculation& calculation, const std::string& axis, const std::string& name);
  template <class T>
  std::vector<mechanics::ArgumentValue<T>> arguments(const Calculation& calculation);
  template <class T>
  T evaluate(const Calculation& calculation, const std::string& axis);

  const ClaimsFile& file_;
  std::map<std::string, scalar::Dimensioned> rows_;
};

}  // namespace millwright::machine
