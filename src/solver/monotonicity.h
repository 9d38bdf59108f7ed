// SPDX-License-Identifier: Apache-2.0
//
// Is less of a state component (a carried mass, a drawn power) always better further down the chain, or more of it?
//
// It is never assumed. The plans are gone through from the last to the first (stage_plan.cpp). A component has a
// direction before a stage when, over every design of the stage and the whole range of states that can arrive there,
// every utilisation, every scored resource and every handed-on component that matters changes the right way with it.
// The proof is interval arithmetic on the derivatives (`Stage::slopes`) with recursive splitting of row sets, variables
// and state ranges. Sub-boxes need no proof where a constraint is certainly violated (no feasible design is in them),
// and a constraint needs none in a sub-box where it is certainly satisfied: a design feasible at one state stays
// feasible along the whole way to a better state, since at the first violation it would have to be in a sub-box where
// the violated constraint is either certainly satisfied or proved to change the right way.
//
// What cannot be proved within the node limit is compared by equality only: slower, never wrong.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "solver/box.h"
#include "solver/criteria.h"
#include "solver/row_profile.h"

namespace millwright::solver {

enum class Direction { irrelevant, smaller_is_better, larger_is_better, equal_only };

/// Row sets cut in two, alike rows together, with what the stage reads of the halves: proofs about one stage cut the
/// same sets again and again, and reading a large one takes far longer than asking about it.
class RowHalves {
 public:
  /// `find` finds out what tells the rows of a slot apart, when one is cut for the first time: most proofs need none.
  RowHalves(RowProfile profile, std::function<void(std::size_t slot, RowProfile&)> find)
      : profile_(std::move(profile)), find_(std::move(find)) {}

  struct Halves {
    RowSet whole;  ///< held, so that no other set comes to have its address
    RowSet left, right;
  };
  /// Of a set of at least two rows.
  const Halves& of(std::size_t slot, const RowSet& whole);

 private:
  RowProfile profile_;
  std::function<void(std::size_t, RowProfile&)> find_;
  std::set<std::size_t> found_;  ///< slots
  std::map<std::pair<std::size_t, const Rows*>, Halves> known_;
};

/// What is asked of one stage.
struct MonotonicityQuestion {
  const Stage* stage = nullptr;
  std::span<const Row> shared;
  const Criteria* criteria = nullptr;
  const Region* region = nullptr;       ///< rows that can be in a feasible design
  std::span<const Interval> inherited;  ///< every state that can arrive
  std::span<const Direction> next;      ///< directions of the components handed on
  RowHalves* halves = nullptr;          ///< one for all questions about the stage; readings need none
  std::size_t node_limit = 3000;
};

/// The direction of component `component` of the inherited state.
Direction prove_direction(const MonotonicityQuestion& question, std::size_t component, Desk& desk);

/// The direction of a graded reading (Stage::graded_readings) of a slot in all these boxes. They are not divided:
/// between the hulls of two halves of the rows there are readings that nothing would be said of.
Direction prove_reading_direction(std::span<const MonotonicityQuestion> questions,
                                  std::size_t slot,
                                  std::size_t reading,
                                  Desk& desk);

/// What a variable moves beside feasibility.
struct Moved {
  bool scores = false;              ///< a resource that is scored
  std::vector<std::size_t> states;  ///< handed-on components that matter
  bool in_steps = true;             ///< these: their slopes have no bound
  [[nodiscard]] bool nothing() const { return !scores && states.empty(); }
};
Moved what_moves(const MonotonicityQuestion& question, std::size_t variable, Desk& desk);

}  // namespace millwright::solver
