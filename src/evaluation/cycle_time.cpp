// SPDX-License-Identifier: Apache-2.0
#include "evaluation/cycle_time.h"

#include "evaluation/screw_drive_stage.h"
#include "machine/drive_energy.h"

namespace millwright::evaluation {

double cycle_time(const machine::Problem& problem, const Design& design) {
  double sum = 0.0;
  for (const machine::Axis& axis : problem.axes) {
    double ramp = axis.acceleration_time.lower;  // where it is no choice the design does not list it
    for (const DimensionLine& line : design.dimensions)
      if (line.axis == axis.name && line.name == "acceleration_time") ramp = line.value;
    sum += machine::moving_time(motion_of(axis), ramp, machine::Timed::machine);
  }
  return sum;
}

}  // namespace millwright::evaluation
