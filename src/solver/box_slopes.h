// SPDX-License-Identifier: Apache-2.0
//
// First-order enclosures of one design over a box of its variables. With m the middle of the box and G what `slopes`
// encloses, every answer f satisfies f(x) in f(m) + G (x - m) for all x in the box (mean value theorem). Near an
// optimum this is what ends the search: intervals alone overlook that score and constraint move against each other
// along the border of what is feasible, so that boxes have to become as small as the gap asked for.
#pragma once

#include <span>
#include <vector>

#include "solver/continuous.h"
#include "solver/variable_box.h"

namespace millwright::solver {

class BoxSlopes {
 public:
  /// Asks for the slopes over the box and for the answer at its middle.
  BoxSlopes(const LeafQuestion& question, const VariableBox& box, Desk& desk);

  /// Narrows sides (within the box) to where every open constraint may still hold. False: it holds nowhere.
  [[nodiscard]] bool narrow(std::span<Interval> side) const;

  /// Raises the bounds of scores and states of the feasible designs within these sides. A constraint u <= 1 takes part
  /// with a multiplier p >= 0: score >= score + p (u - 1), where p is chosen so that one variable's slope cancels.
  void raise(std::span<const Interval> side, Bounds& bounds) const;

  /// How much scores, states and open constraints change over a side, as parts of what they are.
  [[nodiscard]] double change_over(std::size_t variable, const Bounds& bounds, bool scores_count) const;

 private:
  struct Answers {
    std::vector<Interval> utilisation, score, state;
  };
  [[nodiscard]] Answers answers_of(const Answer<Interval>& answer) const;
  /// Least of `function` (of these slopes and value at the middle) over the sides.
  template <class Function>
  double least_of(Function&& function, std::span<const Interval> side) const;
  [[nodiscard]] bool is_open(std::size_t constraint) const { return ((open_ >> (constraint % 64)) & 1U) != 0; }

  const LeafQuestion& question_;
  std::uint64_t open_;
  std::vector<double> middle_;
  std::vector<double> width_;
  Answers at_middle_;
  std::vector<Answers> slope_;  ///< [variable]
};

}  // namespace millwright::solver
