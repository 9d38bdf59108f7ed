// SPDX-License-Identifier: Apache-2.0
//
// The constraints of a rack drive, each declared once (see constraint.h); those of motor, driver and accuracy are
// shared.
#pragma once

#include "machine/motor_constraints.h"
#include "machine/rack_drive.h"
#include "machine/reduction_constraints.h"
#include "machine/spindle_constraints.h"

namespace millwright::machine {

/// Whether the parts of the drive go together.
template <class Visit>
void rack_fit_constraints(Visit&& visit) {
  using namespace scalar;
  using enum ConstraintKind;
  visit(
      Declaration{.id = "F-RACK-MODULE",
                  .title = "Module of the pinion is not larger than that of the rack",
                  .symbol = "m_n",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.pinion.module; },
      [](const auto& d) { return d.rack.module; });
  visit(
      Declaration{.id = "F-RACK-MODULE-MIN",
                  .title = "Module of the rack is not larger than that of the pinion",
                  .symbol = "m_n",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.rack.module; },
      [](const auto& d) { return d.pinion.module; });
  visit(
      Declaration{.id = "F-RACK-ANGLE",
                  .title = "Pressure angle of the pinion is not larger than that of the rack",
                  .symbol = "α",
                  .unit = "deg",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.pinion.pressure_angle; },
      [](const auto& d) { return d.rack.pressure_angle; });
  visit(
      Declaration{.id = "F-RACK-ANGLE-MIN",
                  .title = "Pressure angle of the rack is not larger than that of the pinion",
                  .symbol = "α",
                  .unit = "deg",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.rack.pressure_angle; },
      [](const auto& d) { return d.pinion.pressure_angle; });
  visit(
      Declaration{.id = "F-PINION-BORE",
                  .title = "Motor or reduction shaft fits the pinion bore",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.output_shaft(); },
      [](const auto& d) { return d.pinion.bore; });
  visit(
      Declaration{.id = "F-PINION-BORE-MIN",
                  .title = "Pinion bore is not larger than the shaft",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.pinion.bore; },
      [](const auto& d) { return d.output_shaft(); });
  visit(
      Declaration{.id = "F-RACK-RIDING-MASS",
                  .title = "What rides of the drive is no heavier than guides and structure are sized for",
                  .symbol = "m_r",
                  .unit = "kg",
                  .kind = fit,
                  .source = "millwright_derivations, what rides",
                  .requirement = "rack_drive_mass_allowance"},
      always,
      [](const auto& d) { return d.riding_mass; },
      [](const auto& d) { return d.require(Requirement::rack_drive_mass_allowance, dimension::mass); });
}

template <class Visit>
void rack_constraints(Visit&& visit) {
  using namespace scalar;
  move_time_constraint(visit);
  visit(
      Declaration{.id = "C-RK-BEND",
                  .title = "Tooth bending of the pinion, Lewis",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, chapter 28",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) { return d.pinion_stress; },
      [](const auto& d) { return d.pinion.allowable_stress * d.velocity_factor; });
  visit(
      Declaration{.id = "C-RK-RACK",
                  .title = "Tooth bending of the rack, Lewis",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, chapter 28",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) { return d.rack_stress; },
      [](const auto& d) { return d.rack.allowable_stress * d.velocity_factor; });
}

template <class Visit>
void rack_shaft_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  visit(
      Declaration{.id = "C-ST-RADIAL",
                  .title = "Radial load on the motor shaft",
                  .symbol = "F_R",
                  .unit = "N",
                  .source = "khurmi_gupta2005, chapter 28",
                  .requirement = "motor_radial_load",
                  .worst = WorstPhase::force},
      [](const auto& d) {
        // The bearings of a reduction carry it.
        return d.data->require.known(motor_radial_load) && !d.reduction.present ? Applies::yes : Applies::no;
      },
      [](const auto& d) { return shaft_pull(d); },
      [](const auto& d) { return d.require(motor_radial_load, dimension::force); });
}

template <class Visit>
void rack_drive_constraints(Visit&& visit) {
  rack_constraints(visit);
  reduction_constraints(visit);
  rack_shaft_constraints(visit);
  rack_fit_constraints(visit);
  motor_constraints(visit);
  motor_current_constraints(visit);
  travel_speed_constraint(visit);
  accuracy_constraints(visit);
  spindle_constraints(visit);
}

}  // namespace millwright::machine
