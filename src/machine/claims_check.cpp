// SPDX-License-Identifier: Apache-2.0
#include "machine/claims_check.h"

#include <set>

#include "machine/claims_expression.h"
#include "machine/claims_value.h"
#include "text/nearest.h"

namespace millwright::machine {

namespace {
using text::did_you_mean;
using text::in_quotes;

// Longer chains than this are no calculation that somebody wrote, and would exhaust the stack.
constexpr int longest_chain = 400;

class Checker {
 public:
  Checker(const ClaimsFile& file, text::Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics), values_(file) {
    for (const Claim& claim : file.claims) row_ids_.push_back(claim.id);
    for (const ClaimRow& row : file.derived) row_ids_.push_back(row.id);
  }

  void check() {
    const std::size_t errors_before = diagnostics_.error_count();
    for_each_calculation([&](const ClaimRow& row, const Calculation& calculation) { names(row, calculation); });
    if (diagnostics_.error_count() != errors_before) return;
    for_each_row([&](const ClaimRow& row) { circle(row, 0); });
    if (diagnostics_.error_count() != errors_before) return;
    for (const ClaimRow& row : file_.derived) dimension(row, *row.calculation);
    for (const Claim& claim : file_.claims) {
      if (claim.calculation) result_dimension(claim, *claim.calculation);
      if (claim.line) result_dimension(claim, *claim.line);
    }
  }

 private:
  template <class Visit>
  void for_each_row(Visit visit) {
    for (const ClaimRow& row : file_.derived) visit(row);
    for (const Claim& claim : file_.claims) visit(claim);
  }
  template <class Visit>
  void for_each_calculation(Visit visit) {
    for (const ClaimRow& row : file_.derived) visit(row, *row.calculation);
    for (const Claim& claim : file_.claims) {
      if (claim.calculation) visit(claim, *claim.calculation);
      if (claim.line) visit(claim, *claim.line);
    }
  }

  void names(const ClaimRow& row, const Calculation& calculation) {
    for (const auto& [name, operand] : calculation.operands) operand_names(operand);
    if (!calculation.expression) return;
    for (const std::string& name : calculation.expression->names()) {
      if (calculation.find(name) || file_.find_input(row.axis, name)) continue;
      known_row(name, row.axis, calculation.where);
    }
  }
  void operand_names(const Operand& operand) {
    for (const Operand& item : operand.items) operand_names(item);
    if (operand.kind == Operand::Kind::input && !file_.find_input(operand.axis, operand.name)) {
      diagnostics_.error(operand.where,
                         "axis " + operand.axis + " has no input " + in_quotes(operand.name),
                         did_you_mean(operand.name, input_names(operand.axis)));
    }
    if (operand.kind == Operand::Kind::row) known_row(operand.name, "", operand.where);
    if (operand.kind == Operand::Kind::printed && !file_.find_claim(operand.name)) {
      diagnostics_.error(
          operand.where, "no printed result " + in_quotes(operand.name), did_you_mean(operand.name, row_ids_));
    }
  }
  /// `axis` is given where the name might also have been meant as one of its inputs.
  void known_row(const std::string& id, const std::string& axis, const text::SourceSpan& where) {
    const ClaimRow* row = file_.find_row(id);
    if (row && row->calculation) return;
    if (row) {
      diagnostics_.error(where, "row " + in_quotes(id) + " has no computed value", "use { printed = \"" + id + "\" }");
      return;
    }
    std::vector<std::string> candidates = axis.empty() ? std::vector<std::string>() : input_names(axis);
    candidates.insert(candidates.end(), row_ids_.begin(), row_ids_.end());
    diagnostics_.error(where, "nothing is called " + in_quotes(id) + " here", did_you_mean(id, candidates));
  }
  std::vector<std::string> input_names(const std::string& axis) {
    std::vector<std::string> result;
    const auto inputs = file_.inputs.find(axis);
    if (inputs == file_.inputs.end()) return result;
    for (const auto& [name, value] : inputs->second) result.push_back(name);
    return result;
  }

  /// Depth first; reports a row that is met again below itself.
  void circle(const ClaimRow& row, int depth) {
    if (done_.contains(row.id) || !row.calculation) return;
    if (open_.contains(row.id)) {
      diagnostics_.error(row.where, "row " + in_quotes(row.id) + " is computed from itself");
      return;
    }
    if (depth > longest_chain) {
      diagnostics_.error(row.where, "more than 400 rows are computed one from the other");
      return;
    }
    open_.insert(row.id);
    for (const std::string& id : values_.rows_used(*row.calculation, row.axis)) {
      if (const ClaimRow* next = file_.find_row(id)) circle(*next, depth + 1);
    }
    open_.erase(row.id);
    done_.insert(row.id);
  }

  std::optional<scalar::Dimensioned> dimension(const ClaimRow& row, const Calculation& calculation) {
    try {
      return values_.value(calculation, row.axis);
    } catch (const ClaimProblem& problem) {
      diagnostics_.error(problem.where(), problem.what());
      return std::nullopt;
    }
  }
  void result_dimension(const Claim& claim, const Calculation& calculation) {
    const auto value = dimension(claim, calculation);
    if (!value) return;
    if (value->dimension == claim.unit().dimension()) return result_kind(claim, calculation);
    diagnostics_.error(calculation.where,
                       "this gives " + scalar::to_string(value->dimension) + ", but " + claim.id + " is " +
                           (claim.unit().name().empty() ? "a bare number" : "read in " + claim.unit().name()),
                       "if the paper prints a wrong unit, say with read_as in which one the number is meant");
  }

  /// Revolutions, radians and cycles per second have one dimension: 209.4 rad/s are 33.3 Hz.
  void result_kind(const Claim& claim, const Calculation& calculation) {
    if (calculation.formula == nullptr || calculation.formula->unit() == "any") return;
    const scalar::Unit gives = scalar::Unit::of(calculation.formula->unit());
    std::string reason;
    if (gives.dimension() != scalar::dimension::angular_speed || claim.unit().fits(gives, reason)) return;
    diagnostics_.error(calculation.where,
                       calculation.formula->name() + " gives " + gives.name() + ", but " + claim.id + ": " + reason,
                       "if the paper prints a wrong unit, say with read_as in which one the number is meant");
  }

  const ClaimsFile& file_;
  text::Diagnostics& diagnostics_;
  ClaimValues values_;
  std::vector<std::string> row_ids_;
  std::set<std::string> open_;
  std::set<std::string> done_;
};
}  // namespace

void check_claims(const ClaimsFile& file, text::Diagnostics& diagnostics) { Checker(file, diagnostics).check(); }

}  // namespace millwright::machine
