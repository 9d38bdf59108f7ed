// SPDX-License-Identifier: Apache-2.0
//
// Pieces cut from bars of one length: which piece comes from which bar, so that as few bars as possible are needed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace millwright::evaluation {

/// What a bar is, m. Between two pieces of a bar the saw takes `cutting_loss`; what is left behind the last piece may
/// be less than that.
struct BarSize {
  double stock_length = 0.0;
  double cutting_loss = 0.0;
  [[nodiscard]] bool holds(double piece) const { return piece <= stock_length * (1.0 + 1e-9); }
};

/// Up to so many pieces a plan is searched for that needs fewer bars than taking the longest piece first.
inline constexpr std::size_t pieces_searched = 60;

struct BarPlan {
  std::vector<std::vector<std::size_t>> bars;  ///< of each: indices of the pieces cut from it
  bool is_fewest = true;                       ///< proved: no plan needs fewer bars. Else it is the best one found.
};

/// Each piece fits on a bar. Depends on nothing but the lengths, and on the order of equal ones.
BarPlan cut_from_bars(std::span<const double> lengths, const BarSize& bar);

}  // namespace millwright::evaluation
