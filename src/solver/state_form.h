// SPDX-License-Identifier: Apache-2.0
//
// How a stage's answers depend on the state that arrives, as far as it is proved from its slopes over all its designs
// and all states that can arrive.
//
// `additive`: no score depends on the state, and every handed-on component that matters is something of the design plus
// a fixed linear form of the inherited state. Where that something is a constant the component is `exact`: the
// difference between two designs is the same at every state, and designs can be compared once for all labels. Else (a
// power in whole watts that rises with the load) it is known within bounds over a range of states, and designs are
// compared by those. A component that no utilisation depends on (a power drawn so far)
// does not `influence` which designs are feasible.
//
// `Comparison` turns scores and states into coordinates that are compared by <= : scores as they are, states in their
// proved direction, and a state without a direction twice, once with each sign, so that only equals compare. All are
// rounded to 40 binary digits like scores everywhere (criteria.h): the same sum in another order has to count as equal.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solver/stage_plan.h"

namespace millwright::solver {

struct StateForm {
  bool additive = true;
  std::vector<bool> exact;                 ///< [handed-on component]
  std::vector<bool> influences;            ///< [inherited component]
  std::vector<std::vector<double>> slope;  ///< [handed-on component][inherited component]

  [[nodiscard]] bool all_exact() const { return std::find(exact.begin(), exact.end(), false) == exact.end(); }
  /// What the linear part of handed-on component `component` changes by between two states.
  [[nodiscard]] double change(std::size_t component, std::span<const double> from, std::span<const double> to) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < from.size(); ++c) {
      if (slope[component][c] != 0.0) sum += slope[component][c] * (to[c] - from[c]);
    }
    return sum;
  }
};

StateForm find_state_form(const StagePlan& plan, Desk& desk);

class Comparison {
 public:
  /// Without states only scores are compared, with fewer digits what is nearly as good counts as equal: enough for a
  /// quick first answer, not for a proof.
  Comparison(const Criteria& criteria,
             std::span<const Direction> directions,
             bool with_states,
             int digits = exact_digits);

  [[nodiscard]] std::size_t dimensions() const { return scores_ + states_.size(); }
  [[nodiscard]] std::size_t scores() const { return scores_; }
  void key(std::span<const double> score, std::span<const double> state, double* out) const;
  /// Of something that lies between two states: its best in every coordinate; with the two exchanged, its worst.
  void best_key(std::span<const double> score,
                std::span<const double> least,
                std::span<const double> most,
                double* out) const;
  /// The key of a set: its best in every coordinate.
  void best_key(std::span<const double> score, std::span<const Interval> state, double* out) const;

 private:
  struct Coordinate {
    std::size_t component = 0;
    bool falling = false;  ///< larger is better
  };
  std::size_t scores_ = 0;
  int digits_ = exact_digits;
  std::vector<Coordinate> states_;
};

}  // namespace millwright::solver
