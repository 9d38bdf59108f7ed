// SPDX-License-Identifier: Apache-2.0
//
// How a stage's answers depend on the state that arrives, as far as it is proved from its slopes over all its designs
// and all states that can arrive.
//
// `additive`: every handed-on component that matters is something of the design plus a fixed linear form of the
// inherited state. Where that something is a constant the component is `exact`: the difference between two designs is
// the same at every state, and designs can be compared once for all labels. Else (a power in whole watts that rises
// with the load) it is known within bounds over a range of states, and designs are compared by those. So are scores
// that depend on the state (a position error that grows with the carried mass). A component that no utilisation depends
// on (a power drawn so far) does not `influence` which designs are feasible, or which values of the variables are best
// where these move what is handed on.
//
// `Comparison` turns scores and states into coordinates that are compared by <= : scores as they are, states in their
// proved direction, and a state without a direction twice, once with each sign, so that only equals compare. All are
// rounded to 40 binary digits like scores everywhere (criteria.h): the same sum in another order has to count as equal.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solver/archive.h"
#include "solver/stage_plan.h"

namespace millwright::solver {

struct StateForm {
  bool additive = true;
  std::vector<bool> exact;                 ///< [handed-on component]
  std::vector<bool> influences;            ///< [inherited component]
  std::vector<bool> moves_scores;          ///< [inherited component]
  std::vector<std::vector<double>> slope;  ///< [handed-on component][inherited component]
  /// By how much a slope may be another, at most: what rounding leaves open.
  std::vector<std::vector<double>> slope_error;

  [[nodiscard]] bool scores_vary() const {
    return std::find(moves_scores.begin(), moves_scores.end(), true) != moves_scores.end();
  }
  /// Scores and everything handed on.
  [[nodiscard]] bool all_exact() const {
    return !scores_vary() && std::find(exact.begin(), exact.end(), false) == exact.end();
  }
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

enum class Compared {
  objectives,    ///< nothing else: enough for a quick first answer, not for a proof
  without_ties,  ///< all but what decides between equal objectives
  everything
};

class Comparison {
 public:
  /// With fewer digits what is nearly as good counts as equal, which proves nothing.
  Comparison(const Criteria& criteria,
             std::span<const Direction> directions,
             Compared compared,
             int digits = exact_digits);

  [[nodiscard]] std::size_t dimensions() const { return scores_.size() + states_.size(); }
  /// The scores that are compared: they are the first coordinates.
  [[nodiscard]] const std::vector<std::size_t>& scores() const { return scores_; }
  /// [coordinate]: it decides between equal objectives and nothing else, and which are equal is known.
  [[nodiscard]] const std::vector<bool>& is_tie() const { return is_tie_; }
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
  std::vector<std::size_t> scores_;
  std::vector<bool> is_tie_;
  int digits_ = exact_digits;
  std::vector<Coordinate> states_;
};

/// Keys of what is feasible, and whether they dominate others. What is strictly better in an objective and as good in
/// all that has a limit or is handed on need not be so in what decides between equals: any completion of the other is
/// worse than the same completion of it.
class KnownKeys {
 public:
  explicit KnownKeys(const Comparison& comparison);

  [[nodiscard]] bool dominates(std::span<const double> key) const;
  void add(std::span<const double> key);

 private:
  /// The coordinates that always count.
  [[nodiscard]] std::span<const double> counted(std::span<const double> key) const;

  std::vector<bool> is_tie_;
  std::size_t leading_ = 0;  ///< coordinates up to the last that decides between equals; 0: there is none
  Archive known_;
  std::vector<double> decided_by_;  ///< [key][leading coordinate]
};

}  // namespace millwright::solver
