// SPDX-License-Identifier: Apache-2.0
// What a command found out about a machine, as plain data for whoever prints it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "catalogue/inventory.h"
#include "evaluation/incomplete_parts.h"
#include "evaluation/ledger.h"
#include "evaluation/synthesis.h"
#include "evaluation/ways_out.h"
#include "machine/problem.h"
#include "machine/steering.h"

namespace millwright::report {

enum class Status { optimal, infeasible, limit };

/// "optimal", "infeasible", "limit".
const char* to_string(Status status);

/// A factor or limit that a check used.
struct RequirementLine {
  std::vector<std::string> axes;  ///< the axes that have this value
  std::string key;
  double value = 0.0;  ///< SI
  std::string unit;    ///< as declared
  bool given = false;  ///< by the problem file; else the documented default
  std::string meaning;
  std::string source;  ///< of the default
};

/// The requirements that the design's checks name, with their values; axes of the same value share a line.
std::vector<RequirementLine> used_requirements(const machine::Problem& problem, const evaluation::Design& design);

/// The value as people read it: 36000000 s as "10000 h".
std::string shown_value(const RequirementLine& line);

/// A slot for which the catalogues have no candidate at all.
struct MissingSlot {
  std::string axis;
  std::string slot;
  std::string reason;
};

/// How the answer was found.
struct Certificate {
  double combinations = 0.0;
  std::uint64_t nodes = 0;
  std::uint64_t evaluations = 0;
  std::string method;
  double front_tolerance = 0.0;  ///< relative, to which a front is covered; 0 = exact, infinity: not known
  std::vector<evaluation::IncompleteParts> incomplete = {};  ///< parts that could not be looked at
};

/// Seconds.
struct Timing {
  double read = 0.0;   ///< files
  double solve = 0.0;  ///< with the tables of candidates that are made of what was read
  double total = 0.0;
};

/// The outcome of solve, pareto or check.
struct MachineResult {
  std::string title;
  std::string file;
  std::string currency;                     ///< of the problem
  catalogue::Inventory catalogues;          ///< the files that parts were read from, where they are to be told
  machine::Steering steering;               ///< what was asked for beside the problem file
  std::vector<std::string> axes;            ///< in the order of the problem file
  std::vector<std::string> objectives;      ///< by name, see machine/objective.h
  bool has_budget = false;                  ///< something of the whole machine is limited
  Status status = Status::infeasible;       ///< of solve and pareto
  std::vector<evaluation::Design> designs;  ///< none, one, the best first, or a front ascending in the first objective
  std::size_t builds_asked = 1;             ///< of solve
  std::size_t proved = 0;                   ///< of several asked for: so many designs, from the first on
  double lower_bound = 0.0;                 ///< of a single objective, in currency, SI or, weighted, neither
  double gap = 0.0;
  bool robust = false;               ///< compliance for every value within the stated tolerances was asked for
  std::size_t robust_scenarios = 0;  ///< sets of values that were asked of every part
  /// The objective of the best build with the figures as they stand, at real prices; NaN if nothing is compliant.
  double robust_without = 0.0;
  bool fixed_objective = false;               ///< the same for every build, which is then the cheapest
  std::vector<RequirementLine> requirements;  ///< of the first design
  std::vector<MissingSlot> missing;
  std::vector<evaluation::UnmetCheck> unmet;  ///< why nothing is compliant, where single checks say so
  std::vector<evaluation::WayOut> ways_out;
  Certificate certificate;
  Timing timing;
  std::string bom_file;    ///< of check
  bool completed = false;  ///< check chose parts that the bill of materials leaves open
  evaluation::Completion completion = evaluation::Completion::best;  ///< of these, ramps and dimensions
};

/// Whether builds were compared with preferred parts counted less: an objective counts the cost, and such parts could
/// be chosen.
bool preference_counts(const MachineResult& result);
/// "1.05", by which the prices of preferred parts were divided then.
std::string preference_divisor(const MachineResult& result);

/// Whether the first build is proved to be the best, whatever became of those after it.
bool best_is_proved(const MachineResult& result);

/// To so many percent the best build is proved, where --gap let that be more than rounding: another one may be so much
/// better. None where the proof is exact, or there is none.
std::optional<std::string> proof_gap(const MachineResult& result);

/// The checks of an axis ("machine" for what no single axis owns), the most used first; what was not evaluated last.
std::vector<const evaluation::Check*> checks_of(const evaluation::Design& design, const std::string& axis);

/// Every axis that has checks: those of the problem in their order, then "machine".
std::vector<std::string> checked_axes(const MachineResult& result);

}  // namespace millwright::report
