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

/// Up to so many pieces the number of bars is proved to be the least. Of more, and where the proof would take too long,
/// it is that of the best plan found.
inline constexpr std::size_t pieces_proved = 60;

/// [bar]: indices of the pieces cut from it. Each piece fits on a bar. Depends on nothing but the lengths, and on the
/// order of equal ones.
std::vector<std::vector<std::size_t>> cut_from_bars(std::span<const double> lengths, const BarSize& bar);

}  // namespace millwright::evaluation
