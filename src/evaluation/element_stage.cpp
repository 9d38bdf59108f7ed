// SPDX-License-Identifier: Apache-2.0
#include "evaluation/element_stage.h"

#include <algorithm>

namespace millwright::evaluation {

scalar::Interval utilisation(const scalar::Interval& demand, const scalar::Interval& capacity) {
  using scalar::rounding::infinity;
  if (demand.upper <= 0.0 && capacity.lower >= 0.0) return {0.0, 0.0};
  if (capacity.upper <= 0.0) return {demand.lower > 0.0 ? machine::useless_utilisation : 0.0, infinity};
  const double lower =
      demand.lower <= 0.0 ? 0.0 : std::max(0.0, scalar::rounding::quotient_down(demand.lower, capacity.upper));
  const double upper = capacity.lower <= 0.0 ? infinity
                       : demand.upper <= 0.0 ? 0.0
                                             : scalar::rounding::quotient_up(demand.upper, capacity.lower);
  return {std::min(solver::without_rounding(lower), machine::useless_utilisation),
          std::max(solver::without_rounding(upper), 0.0)};
}

}  // namespace millwright::evaluation
