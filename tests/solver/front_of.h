// SPDX-License-Identifier: Apache-2.0
//
// The front of cost and mass of some totals, for enumerations.
#pragma once

#include <algorithm>
#include <vector>

namespace zoo {

/// Ascending in cost, falling in mass by more than the rounding of sums in another order.
template <class Total>
std::vector<Total> front_of(std::vector<Total> totals) {
  std::sort(totals.begin(), totals.end(), [](const Total& a, const Total& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.mass < b.mass;
  });
  std::vector<Total> front;
  for (const Total& total : totals)
    if (front.empty() || total.mass < front.back().mass * (1.0 - 1e-11)) front.push_back(total);
  return front;
}

}  // namespace zoo
