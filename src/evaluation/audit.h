// SPDX-License-Identifier: Apache-2.0
//
// The audit of a published calculation: each printed result recomputed and judged.
//
// The tests come in this order, and the first that holds gives the verdict. p is the printed number, h half a unit of
// its last printed digit ("0.0700": h = 0.00005; "150": h = 0.5), c the computed value, l the line value (our formula
// with the operands as they stand on that line; c where nothing else stands there), all in the printed unit.
//
//   missing-input  the claim says what is missing; a value computed all the same is indicative and not judged
//   agrees         |p - c| <= h
//   rounding       |p - c| <= 1 % of |c|
//   unit           p is l times a named factor to within h: see named_factor.h. Not to within 1 %: a slip of a few per
//                  cent near a factor is a slip. Against l, not c, because the operands may be wrong already.
//   differs        everything else
//
// `unit` stands behind `rounding` because a number that is right within 1 % needs no excuse, and before `differs`.
// Where the paper prints a unit of another dimension (mm^2/s for a volume per time) the claim says in which unit the
// number is to be read; then `agrees` and `rounding` become `unit` too, with the factor 1.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/named_factor.h"
#include "machine/claims.h"
#include "scalar/traced.h"

namespace millwright::evaluation {

enum class AuditVerdict { agrees, rounding, unit, differs, missing_input };

/// A value that a row computes, with how.
struct AuditTrace {
  std::string symbol;
  scalar::Traced value;
  scalar::Unit unit;  ///< to show it in
};

/// "agrees", "rounding", "unit", "differs", "missing-input".
const char* to_string(AuditVerdict verdict);

struct AuditRow {
  std::string axis;
  std::string id;
  std::string quantity;
  double printed = 0.0;              ///< in `unit`
  std::string printed_text;          ///< "36.43 N*mm", as printed
  std::optional<double> computed;    ///< in `unit`; beside missing-input it is indicative
  std::optional<double> line_value;  ///< in `unit`
  std::string unit;                  ///< printed unit, or the one in which its number is read
  std::optional<double> ratio;       ///< printed / computed, in the same unit; nothing where computed is 0
  AuditVerdict verdict = AuditVerdict::differs;
  std::optional<double> factor;                    ///< of the verdict `unit`
  std::string factor_name;                         ///< "1000: printed kW, is W"
  std::string missing;                             ///< what is missing
  std::string formula;                             ///< name of the formula, or the expression
  std::vector<std::string> violations;             ///< stated limits of the formula that the operands break
  std::vector<scalar::DerivationLine> derivation;  ///< if asked for
  std::vector<AuditTrace> traces;                  ///< the same, value by value; if asked for
  text::SourceSpan where;
};

struct AuditReport {
  std::string title;
  std::string source;  ///< key of sources.bib
  std::vector<AuditRow> rows;

  /// How many rows have that verdict.
  int count(AuditVerdict verdict) const;
};

/// What judge() says.
struct Judgement {
  AuditVerdict verdict = AuditVerdict::differs;
  std::optional<NamedFactor> factor;
};

/// The rule above. `computed` and `line` in SI; `line` nothing means the same as computed.
Judgement judge(const machine::Claim& claim, std::optional<double> computed, std::optional<double> line);

/// Every claim of the file, in its order. `derive`: with the derivation of each computed value. The file must come from
/// read_claims without errors.
AuditReport audit(const machine::ClaimsFile& file, bool derive);

}  // namespace millwright::evaluation
