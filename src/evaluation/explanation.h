// SPDX-License-Identifier: Apache-2.0
//
// Why an answer is what it is. Nothing compliant: a minimal conflicting set of what is asked, and the least by which
// each of its members must give way. Something compliant: which choices are forced and what the others' next best
// costs, and what each thing that is asked costs. Every number comes from solving the machine again, to the proof.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/minimal_conflict.h"
#include "evaluation/synthesis.h"
#include "evaluation/unmet_checks.h"
#include "machine/condition.h"

namespace millwright::evaluation {

/// How far one member of a conflict must give way, all else as asked.
struct Relaxation {
  std::size_t condition = 0;
  bool enough = true;            ///< else nothing is compliant even without this condition: another conflict is left
  std::optional<double> to;      ///< of a number or budget, if it was found out in time; a choice is lifted
  std::optional<Design> design;  ///< the cheapest build then
  std::optional<std::size_t> instead = std::nullopt;  ///< by that of what may be had instead of the condition
  std::vector<Check> broken{};  ///< checks that stand against the same build if the condition does not give way
  /// Of what may be had instead, less than `to`: values with which nothing is compliant, ascending. Less of it may be
  /// too little here and enough further down, so that nothing is known of what lies between them.
  std::vector<double> refused{};

  /// What is changed.
  [[nodiscard]] const machine::Condition& changed(const std::vector<machine::Condition>& conditions) const {
    return instead ? conditions[condition].instead[*instead] : conditions[condition];
  }
};

/// Conditions that cannot be met together, though any of them can be without one other.
struct Conflict {
  ConditionSet conditions;
  std::vector<Relaxation> ways;  ///< those that are enough first, by the cost of their build
};

/// What is chosen for a slot, and what the best build without it would be.
struct SlotChoice {
  std::string axis, slot, part;
  bool only = false;                ///< nothing else could be there at all
  bool settled = true;              ///< else the question took too long, and it costs `next_best` or more
  std::optional<double> next_best;  ///< by how much the objective is worse without it; nothing: it is forced
  std::optional<double> at_most;    ///< by how much the best one found is worse: the same, if settled
  std::string instead;              ///< what that build has there
};

/// What a condition costs.
struct Price {
  std::size_t condition = 0;
  std::optional<double> to;  ///< the value to which it was eased; nothing where it was lifted only
  double saving = 0.0;       ///< of the objective, eased so far
  double at_most = 0.0;      ///< of the objective, without the condition
};

/// What a little of a condition is worth where continuous dimensions move the objective.
struct Rate {
  std::size_t condition = 0;
  double slope = 0.0;  ///< d objective / d value of the condition (SI), to the looser side, with the same parts
};

/// What would be chosen if an estimated figure of a chosen part were at an end of its tolerance.
struct FigureEnd {
  enum class Outcome { same, other, nothing };
  std::size_t figure = 0;  ///< of the design's tolerance check
  double value = 0.0;      ///< SI
  Outcome outcome = Outcome::same;
  double worse = 0.0;                ///< of the objective then
  std::vector<std::string> changes;  ///< "x.motor 17HS4401S"
};

/// What an axis asks for and is taken as it is, because less of it need not be looser (condition_loads.h).
struct NotEased {
  std::string axis;
  bool softens = false;                      ///< forces and loads: under less a nut is softer
  std::vector<std::string> slower, lighter;  ///< times and speeds, loads: for the sake of these checks
};

struct Explanation {
  solver::Status status = solver::Status::infeasible;  ///< limit: time was up, what is said holds but is not all
  std::vector<machine::Condition> conditions;
  std::string objective;
  // nothing compliant
  std::vector<Conflict> conflicts;     ///< without a common member; each must be resolved
  std::optional<Design> all_resolved;  ///< with the first way out of each of several conflicts
  bool too_little_together = false;    ///< with these nothing is compliant
  std::vector<UnmetCheck> unmet;       ///< checks that fail whatever is chosen
  std::vector<EmptySlot> empty_slots;  ///< nothing fits there
  bool catalogue_lacks = false;        ///< nothing is compliant even with all conditions lifted
  // something compliant
  std::optional<Design> design;
  std::vector<SlotChoice> choices;
  std::vector<Price> prices;  ///< the largest saving first
  ConditionSet unsettled;     ///< conditions of which what they cost took too long to find out
  std::size_t costless = 0;   ///< conditions that cost nothing on their own
  // where continuous dimensions move the objective (rates.h)
  std::vector<DimensionLine> moving;  ///< those dimensions
  std::vector<Check> holding;         ///< checks at their limit that hold them
  std::vector<Rate> rates;            ///< what 1 % is worth most first; the others are 0
  ConditionSet rough;                 ///< conditions where no derivative was borne out by solving: steps, kinks
  bool rates_undetermined = false;    ///< what holds the dimensions is no regular optimum
  std::vector<FigureEnd> ends;        ///< by the design's tolerance check
  std::size_t ends_not_tried = 0;
  std::size_t solves = 0;
  double seconds = 0.0;
  std::vector<NotEased> not_eased = {};  ///< axes of which something is not
};

/// s, for each question about a choice or a price: some are far harder than the machine itself, and the rest shall not
/// wait for them.
inline constexpr double usual_patience = 10.0;
/// s, for all questions about ends of tolerances together.
inline constexpr double patience_with_tolerances = 30.0;
/// Of a factor or limit, as a ratio: less is not told.
inline constexpr double smallest_change = 1.01;

/// Told before each solve what it is for and how many there were.
using ExplanationProgress = std::function<void(std::size_t solves, const std::string& what)>;

/// `catalogue`: all parts, those that are left out too. Within the time limit of the options. `asked` must be sound:
/// what it fixes can be fixed.
Explanation explain(const machine::Asked& asked,
                    const catalogue::Catalogue& catalogue,
                    std::vector<machine::Condition> conditions,
                    const SearchOptions& options,
                    const ExplanationProgress& progress = {},
                    double patience = usual_patience);

}  // namespace millwright::evaluation
