// SPDX-License-Identifier: Apache-2.0
//
// The questions a user asks of a machine: the best compliant build (solve), the front of builds (pareto), and whether a
// given bill of materials works (check). Each answer is re-evaluated from scratch before it is returned.
#pragma once

#include <string>
#include <vector>

#include "evaluation/incomplete_parts.h"
#include "evaluation/search_options.h"
#include "machine/bill_of_materials.h"

namespace millwright::evaluation {

struct Synthesis {
  solver::Status status = solver::Status::infeasible;
  std::vector<solver::Build> builds;  ///< of the designs, in rows of the model's problem
  std::vector<Design> designs;        ///< one, or the front ascending in the first objective, or the best first
  std::size_t proved = 0;  ///< of several builds asked for: so many, from the first on, are the next best for sure
  std::vector<EmptySlot> empty_slots;   ///< why nothing can be built at all
  double lower_bound = 0.0, gap = 0.0;  ///< of a single objective
  double combinations = 0.0;
  std::uint64_t nodes = 0, evaluations = 0;
  bool fixed_objective = false;  ///< the same for every build: the cheapest was searched for instead
  /// To which a front is covered where free dimensions move it, 0 = exact; infinity: nothing was proved by the limit.
  double front_tolerance = 0.0;
  std::string method;
  double seconds = 0.0;
};

/// The best compliant build by one objective, or as many of the best as are asked for, or the front of several.
Synthesis synthesise(const MachineModel& model, const SearchOptions& options);

/// The best build that is compliant for every value within the stated tolerances, or the front of such builds.
struct RobustSynthesis {
  Synthesis best;  ///< of the last round; its status is a limit too where the check of a build is not settled
  /// The (first) objective of the best build with the figures as stated, at real prices; NaN if there is none.
  double without = 0.0;
  std::size_t scenarios = 0;  ///< values that broke a build on the way: every later one is compliant with them
};

/// Solves with the figures as stated; as long as values within the tolerances break the best build, they are asked of
/// every build too (of all parts: as far off as those that broke), and it is solved again. What is found in the end is
/// the best of all that are compliant for every value: it is compliant with fewer wishes than those, and proved to be
/// compliant with all. Nothing being compliant with the values asked so far proves that nothing is for all. Of a front
/// the same holds for every build: none of those that are compliant for all values beats one of it. When a limit is
/// reached, the builds of a front that values break are left out, and those that there was no time to ask are
/// unsettled.
RobustSynthesis synthesise_robustly(const machine::Problem& problem,
                                    const catalogue::Catalogue& catalogue,
                                    const ModelOptions& model_options,
                                    const SearchOptions& options);

/// What the search for the rest of a bill of materials has come to.
enum class Completion {
  best,       ///< the build is the best compliant one with what the bill holds
  compliant,  ///< it complies; a limit was reached before it was proved that none is better
  refuted,    ///< nothing complies with what the bill holds: the rest are the cheapest parts that fit
  open        ///< the same parts: a limit was reached before it was known whether something complies
};

/// What a bill of materials amounts to.
struct BomCheck {
  std::vector<BomProblem>
      problems;  ///< unknown parts, parts that do not go together, missing slots: nothing was evaluated if any
  std::vector<BomProblem> remarks;     ///< more or longer pieces than are taken, which are not priced
  std::vector<EmptySlot> empty_slots;  ///< no catalogue row can fill these, which is a problem
  Design design;                       ///< with every check, satisfied or not
  bool completed = false;              ///< something was chosen by us
  Completion completion = Completion::open;
  std::vector<IncompleteParts> incomplete;  ///< what could not be looked at for that
};

/// Evaluates a bill of materials. What it holds is held; an acceleration time or free dimension it leaves open is
/// chosen so that the fewest checks fail, and those by least. With `complete`, missing slots are filled with the
/// cheapest compliant choice, or where there is none with the cheapest parts that fit; without it they are problems.
/// `only_origin`: hold only the lines of that origin (empty = all).
BomCheck check(const machine::Problem& problem,
               const catalogue::Catalogue& catalogue,
               const machine::BillOfMaterials& bom,
               bool complete,
               const SearchOptions& options,
               const std::string& only_origin = {});

}  // namespace millwright::evaluation
