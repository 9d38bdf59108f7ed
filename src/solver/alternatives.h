// SPDX-License-Identifier: Apache-2.0
//
// The best builds of a problem, one after the other: the best, the second best, ..., each proved to be the next.
//
// Two builds are distinct when a shared choice or a row of a slot differs; each combination of rows counts once, with
// its best values of the continuous variables. Builds whose identities are equal count as one.
//
// By splitting what is left (Lawler 1972, Murty 1968): the best build of a part of the problem divides the rest of that
// part into disjoint parts, one for each choice - there the choices before are held at the build's rows, the build's
// own row is excluded, and the choices after are free:
//
//     best row of choice   1        2        3                 a        b        c
//     part 1               not a    free     free
//     part 2               a        not b    free
//     part 3               a        b        not c
//
// Each is solved exactly (solver.h). Nothing in a part is better than the best of the part it came from, so a part is
// solved only when nothing else that is open can come before it; and it is solved under a limit, the worst of the best
// builds known so far: what is dearer cannot be asked for. Builds next to those found, one row changed, make that limit
// tight early (neighbours.h), and rows with which every build is dearer are left out beforehand (row_worth.h).
#pragma once

#include <functional>
#include <string>

#include "solver/solver.h"

namespace millwright::solver {

/// The rows of this slot that are at least as good as `row`, whatever else is chosen: feasible wherever it is, and no
/// worse in the objective, then the ties. Must be transitive, and never go both ways. While one of them may be chosen
/// `row` is not looked at.
using CoveringRows = std::function<std::vector<Row>(std::size_t stage, std::size_t slot, Row row)>;

/// Builds of which this is equal count as one, the best of them, though their rows differ.
using BuildIdentity = std::function<std::string(const Build& build)>;

struct Alternatives {
  Summary first;              ///< of the best build; nodes, evaluations and seconds are those of everything
  std::vector<Build> builds;  ///< the best first; equal objectives by ties, then, of those met, by worst
                              ///< utilisation and row numbers
  std::size_t proved = 0;     ///< so many of them, from the first on, are proved to be the next best
  std::size_t parts = 0;      ///< parts that were solved
  /// optimal: all of `builds` are proved, and where they are fewer than asked for there are no more. limit: what is
  /// known so far.
  Status status = Status::infeasible;
};

/// The `count` best builds in the options' single objective (of Options::objectives; weights are not allowed), then its
/// ties. Where continuous variables move the objective, all that is said holds to Options::gap.
Alternatives best_builds(const Problem& problem,
                         const Options& options,
                         std::size_t count,
                         const CoveringRows& covering = {},
                         const BuildIdentity& identity = {});

}  // namespace millwright::solver
