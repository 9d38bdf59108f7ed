// SPDX-License-Identifier: Apache-2.0
//
// When to ask whether a whole set of designs is infeasible at every value of its variables (proves_infeasible). Two
// constraints may leave no value to a variable (a ramp that is too short for one and too long for the other): bounds
// over all of its values overlook that, for sets of designs as for single ones. Asked about single designs only, a
// search comes to every combination of the parts that have no say in it. But a question that finds nothing has cost
// something: such questions must not take more than those that did find something, or a small part of the search.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solver/box.h"

namespace millwright::solver {

class SetProofs {
 public:
  /// What a question has taken.
  struct Asked {
    std::uint64_t evaluations = 0;
    bool refuted = false;
  };
  void count(const Asked& asked) { (asked.refuted ? of_use_ : in_vain_) += asked.evaluations; }

  /// After so many nodes of the search.
  [[nodiscard]] bool worth_asking(std::uint64_t nodes) const {
    constexpr std::uint64_t always = 20, nodes_for_one = 8;
    return in_vain_ <= always + nodes / nodes_for_one + of_use_;
  }

  /// Within how many boxes a set is to be refuted: the more designs it has, the more is won.
  [[nodiscard]] static std::size_t boxes_for(const Region& region) {
    constexpr double for_each_design = 24.0, most = 2000.0;
    double designs = 1.0;
    for (const RowSet& rows : region.rows) designs *= static_cast<double>(rows->size());
    return static_cast<std::size_t>(std::min(for_each_design * designs, most));
  }

 private:
  std::uint64_t of_use_ = 0, in_vain_ = 0;  ///< evaluations
};

}  // namespace millwright::solver
