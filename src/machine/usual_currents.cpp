// SPDX-License-Identifier: Apache-2.0
#include "machine/usual_currents.h"

#include <algorithm>

namespace millwright::machine {

std::vector<double> usual_currents(const Axis& axis, const catalogue::Catalogue& catalogue) {
  constexpr std::size_t few = 6;  // every motor is paired with each of them
  const catalogue::Table& motors = catalogue.table(catalogue::Family::steppers);
  const double factor = axis.require(Requirement::current_factor);
  std::vector<double> rated;
  for (int row = 0; row < motors.rows(); ++row) {
    const double current = factor * motors.number(catalogue::column(catalogue::Family::steppers, "rated_current"), row);
    if (current > 0.0) rated.push_back(current);
  }
  std::sort(rated.begin(), rated.end());
  std::vector<double> currents = axis.motor.currents;
  for (std::size_t i = 0; i < few && !rated.empty(); ++i) currents.push_back(rated[i * (rated.size() - 1) / (few - 1)]);
  std::sort(currents.begin(), currents.end());
  currents.erase(std::unique(currents.begin(), currents.end()), currents.end());
  return currents;
}

}  // namespace millwright::machine
