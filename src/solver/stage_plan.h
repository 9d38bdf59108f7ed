// SPDX-License-Identifier: Apache-2.0
//
// Everything that is found out about one stage, for one combination of shared choices, before the search proper: which
// rows can be in a feasible design at all, which pairs fit, what states can arrive, which state components have a
// proved direction, which variables only decide feasibility (or move a single component handed on), and the least this
// stage and all after it will add to each score.
//
// What later stages can bear of a component (a mass, a compliance that must stay below a limit at the end of the chain)
// is found from the base to the tool: where bounds prove that no design of a later stage is feasible from some value
// on, nothing that hands more on is looked at.
//
// The least is found at the best state that can arrive (`best_inherited`): the good end of each component with a proved
// direction, the whole range of the others and of those whose good end later stages cannot bear. What is infeasible or
// dear there is so for every label.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "solver/box.h"
#include "solver/criteria.h"
#include "solver/fits.h"
#include "solver/monotonicity.h"
#include "solver/proved_directions.h"
#include "solver/rest_vectors.h"
#include "solver/row_profile.h"
#include "solver/staircase.h"
#include "solver/table_memory.h"

namespace millwright::solver {

/// What `bound` says of a region, in terms of the search.
struct Bounds {
  std::vector<double> score;        ///< least of this stage's own share of each score
  std::vector<Interval> handed_on;  ///< state handed on
  double utilisation = 0.0;         ///< least worst utilisation
  std::uint64_t open = 0;           ///< constraints (modulo 64) neither certainly satisfied nor violated
  std::uint64_t telling = 0;        ///< these, and those that may raise `utilisation` in parts of the region
};

/// What has been found of a region at the states of a search holds for its parts.
inline void note_kept(const Bounds& bounds, Region& region) { region.kept = ~bounds.open; }

struct OpenRegion {
  Region region;
  Bounds bounds;
};

/// What all stages after one add at least to a score, by a component of the state handed to them: a staircase that
/// rises with what is handed on (a load that larger parts must bear, a compliance that stiffer ones must make up for).
struct RestCurve {
  std::size_t score = 0, component = 0;
  std::vector<double> from;   ///< states, ascending
  std::vector<double> least;  ///< [i]: from from[i] on; ascending
};

/// A weighted sum of the first two scores.
struct Mix {
  double first = 1.0, second = 0.0;

  /// One score alone.
  static Mix only(std::size_t score) { return score == 0 ? Mix{1.0, 0.0} : Mix{0.0, 1.0}; }
  [[nodiscard]] bool is_pure() const { return first == 0.0 || second == 0.0; }
  [[nodiscard]] double of(std::span<const double> score) const {
    return second == 0.0 ? first * score[0] : first == 0.0 ? second * score[1] : first * score[0] + second * score[1];
  }
  friend bool operator==(const Mix& a, const Mix& b) = default;
};

/// What all stages after one add at least to a mix of scores: constant + weight * (state handed to them). Rounding is
/// taken off.
struct RestPlane {
  Mix mix;
  double constant = 0.0;
  std::vector<double> weight;  ///< [component], none negative
};

/// The same with one allowance that all stages share kept as it is: what must be added depends on what is left of it.
struct RestStairs {
  Mix mix;
  double limit = 0.0;  ///< of the allowance
  double constant = 0.0;
  std::vector<double> weight;  ///< [component], none negative
  std::vector<double> use;     ///< [component]: of the allowance, none negative
  std::vector<Pair> least;     ///< lower staircase: what is added, and what that takes of the allowance
};

struct StagePlan {
  const Stage* stage = nullptr;
  std::span<const Row> shared;
  const Criteria* criteria = nullptr;
  Fits fits;
  Region region;                                      ///< rows and intervals that can be in a feasible design
  std::vector<Interval> inherited;                    ///< every state that can arrive
  std::vector<Interval> best_inherited;               ///< the best that can arrive
  std::vector<Direction> before, after;               ///< of the inherited and of the handed-on components
  const StageDirections* known_directions = nullptr;  ///< of a larger problem
  std::vector<double> most_after;   ///< per handed-on component: from more no later stage has a feasible design
  std::vector<bool> moves_outcome;  ///< per variable: it moves a score or a state that matters
  bool any_moves_outcome = false;
  /// The variables that move the outcome move this handed-on component in steps and nothing else, and it has a
  /// direction (least_state.h).
  std::optional<std::size_t> moved_state;
  RowProfile profile;
  std::vector<double> least;             ///< of this stage, per score
  std::vector<double> rest;              ///< of all later stages, per score
  std::vector<RestCurve> curves;         ///< the same by what is handed on (rest_curve.h)
  std::vector<RestPlane> planes;         ///< the same by all that is handed on (rest_plane.h)
  std::vector<RestStairs> stairs;        ///< the same by what is left of an allowance (rest_plane.h)
  RestVectors vectors;                   ///< the same by what is left of several allowances (rest_vectors.h)
  std::vector<OpenRegion> open_regions;  ///< regions that cover all designs, ascending in the first score

  StagePlan(const Stage& s, std::span<const Row> shared_rows, const Criteria& c, TableMemory& tables)
      : stage(&s),
        shared(shared_rows),
        criteria(&c),
        fits(s, shared_rows),
        region(tables.whole_region(s, shared_rows)) {}
};

/// Whether variables move so much that their designs are covered within a tolerance (continuous.h).
inline bool is_covered(const StagePlan& plan) { return plan.any_moves_outcome && !plan.moved_state; }

inline double least_of(double value) { return value; }
inline double least_of(const Interval& value) { return value.lower; }
/// Whether what is handed on may lead to a feasible design. `State`: numbers or intervals.
template <class State>
bool bearable(const StagePlan& plan, const State& handed_on) {
  for (std::size_t c = 0; c < plan.most_after.size(); ++c) {
    const double most = plan.most_after[c];
    if (least_of(handed_on[c]) > most + bound_slack * std::fabs(most)) return false;
  }
  return true;
}

/// Whether no later stage can bear any of what is handed on, without that slack: for a box that is too narrow to be
/// divided and lies within it.
inline bool is_beyond_bearing(const StagePlan& plan, std::span<const Interval> handed_on) {
  for (std::size_t c = 0; c < plan.most_after.size(); ++c)
    if (handed_on[c].lower > plan.most_after[c]) return true;
  return false;
}

/// So few that what the rest costs at least can be found at every state nearly exactly.
inline bool has_few_designs(const StagePlan& plan) { return plan.stage->slots().size() <= 1; }

/// What an answer of `bound` says.
void read_bounds(const StagePlan& plan, const Answer<Interval>& answer, Bounds& bounds);

/// Cuts slices in which nothing is feasible off the variables' intervals. False: nothing in the region is feasible at
/// any of the inherited states.
bool cut_variables(
    const StagePlan& plan, std::span<const Interval> inherited, Region& region, Bounds& bounds, Desk& desk);

/// Asks `bound`, then cuts the variables' intervals.
bool assess(const StagePlan& plan, std::span<const Interval> inherited, Region& region, Bounds& bounds, Desk& desk);

/// Leaves rows out of the plan's open regions that have been left out of its region, of one slot or of all.
void keep_within_region(StagePlan& plan, std::size_t slot);
void keep_within_region(StagePlan& plan);

/// The states that can arrive and the directions once more, after rows have been left out of the regions.
void look_again(const Problem& problem, std::vector<StagePlan>& plans, Desk& desk);

/// Whether plans are made with every row that can be chosen, or, of very long tables, with those only that no other
/// stands in for (row_dominance.h).
enum class PlannedRows { all, best_of_very_long };

/// The plans of all stages; empty when it is proved that some stage has no feasible design at all.
std::vector<StagePlan> make_plans(const Problem& problem,
                                  std::span<const Row> shared,
                                  const Criteria& criteria,
                                  Desk& desk,
                                  TableMemory& tables,
                                  PlannedRows planned = PlannedRows::all);
/// The same where no other combination of shared choices will be asked about.
inline std::vector<StagePlan> make_plans(const Problem& problem,
                                         std::span<const Row> shared,
                                         const Criteria& criteria,
                                         Desk& desk) {
  TableMemory tables;
  return make_plans(problem, shared, criteria, desk, tables);
}

/// What is proved of the directions of all stages; empty when it is proved that some stage has no feasible design.
std::vector<StageDirections> directions_of(const Problem& problem,
                                           std::span<const Row> shared,
                                           const Criteria& criteria,
                                           Desk& desk);

}  // namespace millwright::solver
