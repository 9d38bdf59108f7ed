// SPDX-License-Identifier: Apache-2.0
//
// What an allowance is worth that all stages share: a compliance or an error that must stay below a limit at the end of
// the chain, the power that a supply must give. Where stages add to the state that they inherit (state_form.h), any
// price per unit of an allowance gives a lower bound for all completions of a label at once (Lagrangian relaxation):
//
//   R_i(s) >= sum over the later stages of min over their designs (score + price * own addition)
//             - price * (limit - s)
//
// because a feasible completion adds no more than limit - s. The minima of the stages are independent of each other and
// of s, so this is a plane over the state; and a state that flows into another one (a mass into the load of the next
// axis) carries its price along. The prices are moved until the bound at the tool hardly rises any more (subgradient
// steps); every plane on the way is valid.
//
// Where a stage at the end of an allowance gets dearer with it (the supply that gives the power), its least is found
// for several amounts, and the plane stays below that staircase.
//
// A price says that half of an allowance is worth half of it, and stages that choose from few parts know better. So for
// each allowance with a price there is also a staircase: the others keep their prices, and of this one it is known how
// much must be added at least when so much of it is left (sums of the stages' own staircases, so to speak the knapsack
// problem without its other constraints). Where one allowance binds, little is lost then.
//
// Where several of them bind and both objectives count there are vectors (rest_vectors.h): what all later stages add to
// the objectives and take of each allowance, all at once, for a section of the front.
//
// The same bound with one region of a stage in place of the stage's minimum says what that region leads to at least.
// What cannot reach the known front that way is left out from then on; and where what is left cannot use up an
// allowance any more, designs need not be compared by it.
#pragma once

#include <memory>

#include "solver/staircase.h"
#include "solver/state_form.h"

namespace millwright::solver {

class RestPlanes {
 public:
  /// References must outlive this.
  RestPlanes(const Problem& problem, std::vector<StagePlan>& plans, std::span<const StateForm> forms, Desk& desk);
  ~RestPlanes();

  /// Sets StagePlan::planes and StagePlan::stairs of all stages for a mix of the objectives; nothing where some stage
  /// is not additive. `known`: a total that the bound will not exceed by far, for the length of the steps. Returns the
  /// best bound of a total.
  double find(const Mix& mix, double known);
  /// Adds the best plane before a stage for a label of this state. Returns what that label must still add at least.
  double find_from(const Mix& mix, double known, std::size_t stage, std::span<const double> state);
  /// Narrows the stages' regions to what may lead below some corner of an upper staircase of totals. False: nothing
  /// does.
  bool restrict_to(const std::vector<Pair>& corners);
  /// Narrows what stages can bear (StagePlan::most_after) to what is left of the stages after them. After
  /// `look_again`, which says what states can arrive.
  void tighten_limits();
  /// Sets StagePlan::vectors of all stages for the allowances that have had a price so far, as far as they may lead
  /// below some corner of an upper staircase of totals. False: nothing does.
  bool find_vectors(const std::vector<Pair>& corners);
  /// Makes the regions as they have been refined so far those of the stages' plans (StagePlan::open_regions).
  void keep_regions();

 private:
  class Prices;
  std::unique_ptr<Prices> prices_;
};

}  // namespace millwright::solver
