// SPDX-License-Identifier: Apache-2.0
//
// The constraints of a rotary table, each declared once (see constraint.h); those of motor and driver are shared. Speed
// and accuracy are angles here and so have constraints of their own.
#pragma once

#include "machine/motor_constraints.h"
#include "machine/reduction_constraints.h"
#include "machine/rotary_drive.h"

namespace millwright::machine {

template <class Visit>
void rotary_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  move_time_constraint(visit);
  visit(
      Declaration{.id = "C-ROT-SPEED",
                  .title = "Rapid speed of the table against the pulse rate",
                  .symbol = "ω",
                  .unit = "rpm",
                  .source = "millwright_derivations, smallest of the speed limits",
                  .worst = WorstPhase::speed},
      always,
      [](const auto& d) { return d.cycle.peak_speed; },
      [](const auto& d) { return speed_limit(d); });
  visit(
      Declaration{.id = "C-ROT-RES",
                  .title = "Resolution of the table",
                  .symbol = "Δφ",
                  .unit = "deg",
                  .source = "sander, travel of one step",
                  .requirement = "resolution_fraction"},
      [](const auto& d) { return d.data->require.known(angle_error) ? Applies::yes : Applies::no; },
      [](const auto& d) { return resolution(d); },
      [](const auto& d) { return d.require(resolution_fraction) * d.require(angle_error); });
  visit(
      Declaration{.id = "C-ROT-TOTAL",
                  .title = "Angle error budget",
                  .symbol = "e",
                  .unit = "deg",
                  .source = "slocum1992, chapter 2",
                  .requirement = "angle_error",
                  .worst = WorstPhase::steady},
      [](const auto& d) { return d.data->require.known(angle_error) ? Applies::yes : Applies::no; },
      [](const auto& d) { return error_budget(d).total(); },
      [](const auto& d) { return d.require(angle_error); });
  visit(
      Declaration{.id = "C-ROT-LOST",
                  .title = "Lost motion of the table on reversal",
                  .symbol = "Δ",
                  .unit = "deg",
                  .source = "millwright_derivations, lost motion",
                  .requirement = "lost_angle"},
      [](const auto& d) { return d.data->require.known(lost_angle) ? Applies::yes : Applies::no; },
      [](const auto& d) { return reversal_error(d) + 2.0 * turning_give_under_friction(d); },
      [](const auto& d) { return d.require(lost_angle); });
}

template <class Visit>
void rotary_drive_constraints(Visit&& visit) {
  rotary_constraints(visit);
  reduction_constraints(visit);
  motor_constraints(visit);
  motor_current_constraints(visit);
}

}  // namespace millwright::machine
