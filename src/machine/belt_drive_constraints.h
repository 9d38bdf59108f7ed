// SPDX-License-Identifier: Apache-2.0
//
// The constraints of a belt drive, each declared once (see constraint.h); those of motor, driver and accuracy are
// shared.
#pragma once

#include "machine/belt_drive.h"
#include "machine/motor_constraints.h"
#include "machine/reduction_constraints.h"
#include "machine/spindle_constraints.h"

namespace millwright::machine {

template <class Visit>
void belt_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace bt = mechanics::belt;
  move_time_constraint(visit);
  visit(
      Declaration{.id = "C-BT-TENSION",
                  .title = "Belt working tension",
                  .symbol = "F_1",
                  .unit = "N",
                  .source = "sularso_suga, chapter 5; millwright_derivations, unequal spans of a belt",
                  .requirement = "belt_service_factor",
                  .worst = WorstPhase::force,
                  .place = WorstPlace::drive_pulley},
      always,
      [](const auto& d) {
        return d.require(belt_service_factor) * bt::carriage_span_tension(d.pretension, d.largest_force);
      },
      [](const auto& d) { return bt::tooth_factor(d.teeth_in_mesh) * d.belt.allowable_tension; });
  visit(
      Declaration{.id = "C-BT-POWER",
                  .title = "Belt power",
                  .symbol = "P_d",
                  .unit = "W",
                  .source = "fdm_printer, eq. 19 and 20; iso5295",
                  .requirement = "belt_service_factor",
                  .worst = WorstPhase::driven_force},
      always,
      [](const auto& d) {
        return bt::design_power(d.require(belt_service_factor), d.driven_force * d.cycle.peak_speed);
      },
      [](const auto& d) {
        return bt::power_capacity(
            bt::tooth_factor(d.teeth_in_mesh), d.belt.allowable_tension, d.belt.mass_per_length, d.cycle.peak_speed);
      });
  visit(
      Declaration{.id = "C-BT-TEETH",
                  .title = "Teeth in mesh",
                  .symbol = "z",
                  .unit = "1",
                  .kind = ConstraintKind::soft,
                  .source = "sularso_suga, chapter 5",
                  .requirement = "belt_teeth_in_mesh"},
      always,
      [](const auto& d) { return d.require(belt_teeth_in_mesh); },
      [](const auto& d) { return d.teeth_in_mesh; });
  visit(
      Declaration{.id = "C-BT-PRET",
                  .title = "Belt pretension",
                  .symbol = "F_0",
                  .unit = "N",
                  .source = "gates_light_power",
                  .requirement = "belt_preload_fraction",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) {
        return bt::required_pretension(d.largest_force,
                                       0.5 * d.largest_force,
                                       bt::centrifugal_tension(d.belt.mass_per_length, d.cycle.peak_speed));
      },
      [](const auto& d) { return d.pretension; });
  visit(
      Declaration{.id = "C-BT-MINZ",
                  .title = "Teeth of the drive pulley",
                  .symbol = "z",
                  .unit = "1",
                  .source = "gates_light_power"},
      always,
      [](const auto& d) { return d.belt.least_teeth; },
      [](const auto& d) { return d.belt.teeth; });
  visit(
      Declaration{.id = "F-BELT-MASS",
                  .title = "Belt is no heavier than guides and structure are sized for",
                  .symbol = "m",
                  .unit = "kg",
                  .kind = ConstraintKind::fit,
                  .source = "millwright_derivations, what rides",
                  .requirement = "belt_mass_allowance"},
      always,
      [](const auto& d) { return d.belt.belt_mass; },
      [](const auto& d) { return d.require(belt_mass_allowance, dimension::mass); });
  visit(
      Declaration{.id = "C-BT-WIDTH",
                  .title = "Belt width",
                  .symbol = "b",
                  .unit = "mm",
                  .source = "iso5295; fdm_printer, eq. 19 and 20",
                  .requirement = "belt_service_factor",
                  .worst = WorstPhase::force,
                  .implied_by = "C-BT-TENSION"},  // with C-BT-PRET: pretension alone is at least the tight side's
      always,
      [](const auto& d) {
        const auto turning = bt::centrifugal_tension(d.belt.mass_per_length, d.cycle.peak_speed);
        const auto tension = d.require(belt_service_factor) * bt::tight_side_tension(d.largest_force, turning);
        // Without a tooth in mesh any width is too small, but not endless.
        const auto teeth = larger(bt::tooth_factor(d.teeth_in_mesh), decltype(d.peak_speed)(1e-9));
        return bt::required_width(tension, teeth, d.belt.allowable_tension / d.belt.width);
      },
      [](const auto& d) { return d.belt.width; });
  visit(
      Declaration{.id = "C-BT-STIFF",
                  .title = "Stretch of the belt under the steady load",
                  .symbol = "δ",
                  .unit = "um",
                  .source = "millwright_derivations, stretch of a belt",
                  .requirement = "belt_stretch_share",
                  .worst = WorstPhase::steady,
                  .place = WorstPlace::long_belt},
      [](const auto& d) { return d.data->require.known(position_error) ? Applies::yes : Applies::no; },
      [](const auto& d) { return bt::position_error(steady_force(d), belt_stiffness(d)); },
      [](const auto& d) { return d.require(belt_stretch_share) * d.require(position_error, dimension::length); });
  visit(
      Declaration{.id = "C-BT-FREQ",
                  .title = "Frequency of the carriage on its belt",
                  .symbol = "f",
                  .unit = "Hz",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, frequency of a mass on a belt",
                  .requirement = "belt_frequency",
                  .place = WorstPlace::long_belt},
      always,
      [](const auto& d) { return in_hertz<decltype(d.peak_speed)>(d.data->require(belt_frequency)); },
      [](const auto& d) { return bt::axis_resonant_frequency(belt_stiffness(d), d.moved_mass); });
  visit(
      Declaration{.id = "C-ST-RADIAL",
                  .title = "Radial load on the motor shaft",
                  .symbol = "F_R",
                  .unit = "N",
                  .source = "autodesk_synchronous_belts; millwright_derivations, unequal spans of a belt",
                  .requirement = "motor_radial_load",
                  .worst = WorstPhase::force,
                  .place = WorstPlace::drive_pulley},
      [](const auto& d) {
        // The bearings of a reduction carry it.
        return d.data->require.known(motor_radial_load) && !d.reduction.present ? Applies::yes : Applies::no;
      },
      [](const auto& d) { return shaft_pull(d); },
      [](const auto& d) { return d.require(motor_radial_load, dimension::force); });
  visit(
      Declaration{.id = "F-PULLEY-BORE",
                  .title = "Motor or reduction shaft fits the pulley bore",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.output_shaft(); },
      [](const auto& d) { return d.belt.bore; });
  visit(
      Declaration{.id = "F-PULLEY-BORE-MIN",
                  .title = "Pulley bore is not larger than the shaft",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.belt.bore; },
      [](const auto& d) { return d.output_shaft(); });
  visit(
      Declaration{.id = "F-BELT-PULLEYS",
                  .title = "Belt and pulleys are of one profile and size",
                  .symbol = "n_k",
                  .unit = "1",
                  .kind = ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.belt.kinds; },
      [](const auto& d) { return decltype(d.belt.kinds)(1.0); });
}

template <class Visit>
void belt_drive_constraints(Visit&& visit) {
  belt_constraints(visit);
  reduction_constraints(visit);
  motor_constraints(visit);
  motor_current_constraints(visit);
  travel_speed_constraint(visit);
  accuracy_constraints(visit);
  spindle_constraints(visit);
}

}  // namespace millwright::machine
