// SPDX-License-Identifier: Apache-2.0
//
// All constraints of a screw drive; those of motor, driver, accuracy and spindle are shared with other drives.
#pragma once

#include "machine/ball_screw_constraints.h"
#include "machine/motor_constraints.h"
#include "machine/reduction_constraints.h"
#include "machine/screw_accuracy_constraints.h"
#include "machine/screw_constraints.h"
#include "machine/screw_fit_constraints.h"
#include "machine/spindle_constraints.h"

namespace millwright::machine {

template <class Visit>
void screw_drive_constraints(Visit&& visit) {
  screw_shaft_constraints(visit);
  sliding_screw_constraints(visit);
  ball_screw_constraints(visit);
  reduction_constraints(visit);
  motor_constraints(visit);
  motor_current_constraints(visit);
  travel_speed_constraint(visit);
  coupling_constraints(visit);
  accuracy_constraints(visit);
  screw_accuracy_constraints(visit);
  screw_fit_constraints(visit);
  spindle_constraints(visit);
}

}  // namespace millwright::machine
