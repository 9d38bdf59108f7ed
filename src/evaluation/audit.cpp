// SPDX-License-Identifier: Apache-2.0
#include "evaluation/audit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "machine/claims_value.h"

namespace millwright::evaluation {

namespace {
using machine::Calculation;
using machine::Claim;
using machine::ClaimRow;
using machine::ClaimValues;

// A value exactly between two printed numbers agrees with both, whatever the last bit of the conversion.
constexpr double half_digit_slack = 1.0 + 1e-9;
constexpr double rounding_limit = 0.01;

bool to_the_digit(const Claim& claim, double value) {
  return std::fabs(claim.printed.number - value) <= claim.printed.half_digit * half_digit_slack;
}

bool within_rounding(const Claim& claim, double value) {
  return std::fabs(claim.printed.number - value) <= rounding_limit * std::fabs(value);
}

/// The symbol of the formula; the name of the row for plain arithmetic.
std::string symbol_of(const ClaimRow& row) {
  const mechanics::Formula* formula = row.calculation->formula;
  return formula && formula->unit() != "any" && !formula->symbol().empty() ? formula->symbol() : row.id;
}

/// The lines of a row, after those of the derived values it uses; values that the paper prints have rows of their own.
class Derivation {
 public:
  Derivation(const machine::ClaimsFile& file, ClaimValues& values) : file_(file), values_(values) {}

  void write(const Claim& claim, AuditRow& row) {
    add_derived(claim);
    add({symbol_of(claim), values_.trace(*claim.calculation, claim.axis), claim.unit()});
    row.derivation = std::move(lines_);
    row.traces = std::move(traces_);
  }

 private:
  void add_derived(const ClaimRow& row) {
    for (const std::string& id : values_.rows_used(*row.calculation, row.axis)) {
      if (file_.find_claim(id) || !done_.insert(id).second) continue;
      const ClaimRow& derived = *file_.find_row(id);
      add_derived(derived);
      const scalar::Traced value = values_.trace(*derived.calculation, derived.axis);
      add({symbol_of(derived), value, scalar::readable_unit(value.dimension, value.value)});
    }
  }
  void add(AuditTrace trace) {
    std::vector<scalar::DerivationLine> lines = scalar::derivation(trace.value, trace.symbol, trace.unit);
    traces_.push_back(std::move(trace));
    lines_.insert(lines_.end(), std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
  }

  const machine::ClaimsFile& file_;
  ClaimValues& values_;
  std::set<std::string> done_;
  std::vector<scalar::DerivationLine> lines_;
  std::vector<AuditTrace> traces_;
};

void compute(AuditRow& row, const Claim& claim, ClaimValues& values) {
  const scalar::Unit& unit = claim.unit();
  const Calculation& calculation = *claim.calculation;
  const double computed = values.row(claim.id, claim.where).value;
  const double line = claim.line ? values.value(*claim.line, claim.axis).value : computed;
  row.computed = unit.from_si(computed);
  row.line_value = unit.from_si(line);
  if (*row.computed != 0.0) row.ratio = row.printed / *row.computed;
  row.formula = calculation.formula ? calculation.formula->name() : calculation.expression_text;
  row.violations = values.violations(calculation);
  const Judgement judgement = judge(claim, computed, line);
  row.verdict = judgement.verdict;
  if (judgement.factor) {
    row.factor = judgement.factor->factor;
    row.factor_name = judgement.factor->name;
  }
}

AuditRow audit_row(const Claim& claim, ClaimValues& values) {
  AuditRow row;
  row.axis = claim.axis;
  row.id = claim.id;
  row.quantity = claim.quantity;
  row.printed = claim.printed.number;
  row.printed_text = claim.printed.text;
  if (!claim.printed.unit.name().empty()) row.printed_text += " " + claim.printed.unit.name();
  row.unit = claim.unit().name().empty() ? "1" : claim.unit().name();
  row.missing = claim.missing;
  row.where = claim.where;
  row.verdict = AuditVerdict::missing_input;
  if (claim.calculation) compute(row, claim, values);
  return row;
}
}  // namespace

const char* to_string(AuditVerdict verdict) {
  switch (verdict) {
    case AuditVerdict::agrees:
      return "agrees";
    case AuditVerdict::rounding:
      return "rounding";
    case AuditVerdict::unit:
      return "unit";
    case AuditVerdict::differs:
      return "differs";
    case AuditVerdict::missing_input:
      break;
  }
  return "missing-input";
}

int AuditReport::count(AuditVerdict verdict) const {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [&](const AuditRow& row) { return row.verdict == verdict; }));
}

Judgement judge(const Claim& claim, std::optional<double> computed, std::optional<double> line) {
  if (!claim.missing.empty() || !computed) return {AuditVerdict::missing_input, std::nullopt};
  const scalar::Unit& unit = claim.unit();
  const double value = unit.from_si(*computed);
  if (!std::isfinite(value)) return {AuditVerdict::differs, std::nullopt};
  const bool agrees = to_the_digit(claim, value);
  if (agrees || within_rounding(claim, value)) {
    if (!claim.read_as) return {agrees ? AuditVerdict::agrees : AuditVerdict::rounding, std::nullopt};
    return {AuditVerdict::unit, NamedFactor{1.0, "printed " + claim.printed.unit.name() + ", is " + unit.name()}};
  }
  if (auto factor = named_factor(claim.printed, unit, line.value_or(*computed))) {
    return {AuditVerdict::unit, std::move(factor)};
  }
  return {AuditVerdict::differs, std::nullopt};
}

AuditReport audit(const machine::ClaimsFile& file, bool derive) {
  AuditReport report;
  report.title = file.title;
  report.source = file.source;
  ClaimValues values(file);
  report.rows.reserve(file.claims.size());
  for (const Claim& claim : file.claims) {
    report.rows.push_back(audit_row(claim, values));
    if (derive && claim.calculation) Derivation(file, values).write(claim, report.rows.back());
  }
  return report;
}

}  // namespace millwright::evaluation
