// SPDX-License-Identifier: Apache-2.0
//
// How closely a search label by label looks at designs whose variables move scores or states (cover.h).
//
// Where less or more of a state is better a point stands for all that is worse, and few points are enough at once.
// Where a later stage proves no such direction (a resonance band, a least load) a point only stands for states that are
// equal but for the tolerance: millions of points would be needed. So the first ones are coarse, find builds, and prove
// most designs to be no better; then finer ones look at what is left (undecided_designs.h), again and again. So it is
// where a later stage takes a dimension within a window only that is narrower than the tolerance of a front.
#pragma once

#include <optional>
#include <vector>

#include "solver/undecided_designs.h"

namespace millwright::solver {

/// The tolerance of a finer search, of the one before it.
inline constexpr double refined_part = 1.0 / 16.0;

struct LeafPrecision {
  double tolerance = 1e-6;     ///< by which a point may be worse than what it stands for, where its label is exact
  int refinements = 0;         ///< of the first search
  bool refined_later = false;  ///< a search with a finer tolerance will look at what this one leaves undecided
  /// Where no such search decides the rest: one that looks at everything once more, with so many refinements.
  std::optional<int> everywhere_next = std::nullopt;
  UndecidedDesigns among = {};  ///< what an earlier search has left; no other design is looked at
};

/// Of the first search. `tolerance`: where directions are proved; `objectives`: of the problem. `left_open`: the front
/// has been looked for stage by stage, and what that left open is little.
LeafPrecision first_precision(const std::vector<StagePlan>& plans,
                              double tolerance,
                              std::size_t objectives,
                              bool left_open);

/// Of the next one, after a search with precision `last` that left `undecided`; none where there is no use in it.
std::optional<LeafPrecision> next_precision(const LeafPrecision& last,
                                            UndecidedDesigns undecided,
                                            double tolerance,
                                            std::size_t objectives);

}  // namespace millwright::solver
