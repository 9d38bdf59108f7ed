// SPDX-License-Identifier: Apache-2.0
//
// The coupling of a screw drive, and what of its parts must fit together (see constraint.h).
#pragma once

#include "machine/motor_constraints.h"
#include "machine/screw_drive_quantities.h"

namespace millwright::machine {

inline constexpr auto when_coupled = [](const auto& d) { return d.data->has_coupling ? Applies::yes : Applies::no; };
inline constexpr auto when_screw_turns = [](const auto& d) { return d.data->nut_rotates ? Applies::no : Applies::yes; };

/// The coupling between motor and screw.
template <class Visit>
void coupling_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  visit(
      Declaration{.id = "C-CP-TORQUE",
                  .title = "Coupling torque",
                  .symbol = "T_c",
                  .unit = "N.m",
                  .source = "ktr_couplings, shock factor; millwright_derivations, balance behind the coupling",
                  .requirement = "coupling_shock_factor",
                  .worst = WorstPhase::output_torque},
      when_coupled,
      [](const auto& d) { return d.require(coupling_shock_factor) * d.output_torque; },
      [](const auto& d) { return d.coupling.rated_torque; });
  visit(
      Declaration{.id = "C-CP-RES",
                  .title = "Torsional frequency of the drive line",
                  .symbol = "f",
                  .unit = "Hz",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, two masses on a torsional spring; acarnley2002, chapter 6",
                  .requirement = "torsional_frequency_factor",
                  .place = WorstPlace::nut_far},
      always,
      [](const auto& d) {
        return d.require(torsional_frequency_factor) *
               mechanics::stepper::resonant_frequency(d.motor.static_torque,
                                                      d.motor.rotor_teeth,
                                                      decltype(d.load_inertia)(d.motor.rotor_inertia + d.load_inertia));
      },
      [](const auto& d) {
        return mechanics::coupling::resonant_frequency(
            torsional_stiffness_at_motor(d), d.motor_side_inertia(), d.output_inertia);
      });
  visit(
      Declaration{.id = "C-CP-MISAL",
                  .title = "Parallel misalignment of the coupling",
                  .symbol = "Δr",
                  .unit = "mm",
                  .kind = ConstraintKind::soft,
                  .source = "ktr_couplings",
                  .requirement = "coupling_parallel_misalignment"},
      when_coupled,
      [](const auto& d) { return d.require(coupling_parallel_misalignment, dimension::length); },
      [](const auto& d) { return d.coupling.parallel_misalignment; });
  visit(
      Declaration{.id = "C-CP-MISAL-ANGULAR",
                  .title = "Angular misalignment of the coupling",
                  .symbol = "Δα",
                  .unit = "deg",
                  .kind = ConstraintKind::soft,
                  .source = "ktr_couplings",
                  .requirement = "coupling_angular_misalignment"},
      when_coupled,
      [](const auto& d) { return d.require(coupling_angular_misalignment); },
      [](const auto& d) { return d.coupling.angular_misalignment; });
  visit(
      Declaration{.id = "C-CP-MISAL-AXIAL",
                  .title = "Axial misalignment of the coupling",
                  .symbol = "Δx",
                  .unit = "mm",
                  .kind = ConstraintKind::soft,
                  .source = "ktr_couplings",
                  .requirement = "coupling_axial_misalignment"},
      when_coupled,
      [](const auto& d) { return d.require(coupling_axial_misalignment, dimension::length); },
      [](const auto& d) { return d.coupling.axial_misalignment; });
}

/// What must fit together. Written as utilisations like everything else: a bore that is too large for a shaft is a
/// demand over its limit.
template <class Visit>
void screw_fit_constraints(Visit&& visit) {
  using namespace scalar;
  using enum ConstraintKind;
  visit(
      Declaration{.id = "F-NUT-MASS",
                  .title = "Nut is no heavier than guides and structure are sized for",
                  .symbol = "m",
                  .unit = "kg",
                  .kind = fit,
                  .source = "millwright_derivations, what rides",
                  .requirement = "nut_mass_allowance"},
      when_screw_turns,
      [](const auto& d) { return d.screw.nut_mass; },
      [](const auto& d) { return d.require(Requirement::nut_mass_allowance, dimension::mass); });
  visit(
      Declaration{.id = "F-NUT-RIDING-MASS",
                  .title = "What rides with a nut that turns is no heavier than guides and structure are sized for",
                  .symbol = "m_r",
                  .unit = "kg",
                  .kind = fit,
                  .source = "millwright_derivations, what rides",
                  .requirement = "rotating_nut_mass_allowance"},
      [](const auto& d) { return d.data->nut_rotates ? Applies::yes : Applies::no; },
      [](const auto& d) { return d.riding_mass; },
      [](const auto& d) { return d.require(Requirement::rotating_nut_mass_allowance, dimension::mass); });
  visit(
      Declaration{.id = "F-COUPLING-MOTOR",
                  .title = "Motor or reduction shaft fits the coupling's largest bore",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      when_coupled,
      [](const auto& d) { return d.output_shaft(); },
      [](const auto& d) { return d.coupling.largest_bore; });
  visit(
      Declaration{.id = "F-COUPLING-MOTOR-MIN",
                  .title = "Motor or reduction shaft is not thinner than the coupling's least bore",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      when_coupled,
      [](const auto& d) { return d.coupling.least_bore; },
      [](const auto& d) { return d.output_shaft(); });
  visit(
      Declaration{.id = "F-COUPLING-SCREW",
                  .title = "Screw journal is not thinner than the coupling's least bore",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      when_coupled,
      [](const auto& d) { return d.coupling.least_bore; },
      [](const auto& d) { return d.support_fixed.bore; });
  visit(
      Declaration{.id = "F-SUPPORT-FIXED",
                  .title = "Journal of the fixed support can be turned from the screw",
                  .symbol = "d",
                  .unit = "mm",
                  .kind = fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.support_fixed.bore; },
      [](const auto& d) { return d.screw.root_diameter; });
  visit(
      Declaration{
          .id = "F-SUPPORT-FREE",
          .title = "Journal of the free support can be turned from the screw, or its block clamps the plain screw",
          .symbol = "d/d_max",
          .unit = "1",
          .kind = fit,
          .source = "millwright_derivations, fits of parts"},
      [](const auto& d) { return d.data->free_end ? Applies::no : Applies::yes; },
      [](const auto& d) { return free_support_fit(d); },
      [](const auto& d) { return decltype(d.peak_speed)(1.0); });
  visit(
      Declaration{.id = "F-SUPPORT-LOAD",
                  .title = "Axial load on the fixed support",
                  .symbol = "F",
                  .unit = "N",
                  .kind = fit,
                  .source = "thk_catalogue, support units",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) { return d.largest_force; },
      [](const auto& d) { return d.support_fixed.permissible_axial_load; });
  visit(
      Declaration{.id = "F-SUPPORT-SPEED",
                  .title = "Speed of the support bearings",
                  .symbol = "ω",
                  .unit = "rpm",
                  .kind = fit,
                  .source = "thk_catalogue, support units",
                  .worst = WorstPhase::speed},
      when_screw_turns,
      [](const auto& d) { return d.screw_speed; },
      [](const auto& d) { return smaller(d.support_fixed.largest_speed, d.support_free.largest_speed); });
  visit(
      Declaration{.id = "F-COUPLING-SPEED",
                  .title = "Speed of the coupling",
                  .symbol = "ω",
                  .unit = "rpm",
                  .kind = fit,
                  .source = "ktr_couplings",
                  .worst = WorstPhase::speed},
      when_coupled,
      [](const auto& d) { return d.screw_speed; },
      [](const auto& d) { return d.coupling.largest_speed; });
}

}  // namespace millwright::machine
