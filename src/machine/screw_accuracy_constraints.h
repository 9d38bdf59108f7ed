// SPDX-License-Identifier: Apache-2.0
//
// Stiffness of a screw drive and the single contributions to its position error (see constraint.h).
#pragma once

#include "machine/motor_constraints.h"
#include "machine/screw_drive_quantities.h"

namespace millwright::machine {

inline constexpr auto when_accuracy_is_required = [](const auto& d) {
  return d.data->require.known(Requirement::position_error) ? Applies::yes : Applies::no;
};

template <class Visit>
void screw_accuracy_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  visit(
      Declaration{.id = "C-BS-LEAD",
                  .title = "Lead error over the stated travel",
                  .symbol = "e_l",
                  .unit = "um",
                  .source = "iso3408_3; jis_b1192, lead accuracy",
                  .requirement = "lead_error_share"},
      when_accuracy_is_required,
      [](const auto& d) { return lead_error(d); },
      [](const auto& d) { return d.require(lead_error_share) * d.require(position_error, dimension::length); });
  visit(
      Declaration{.id = "C-BS-STIFF",
                  .title = "Axial stiffness at the worst position",
                  .symbol = "k",
                  .unit = "N/um",
                  .source = "thk_catalogue, axial rigidity",
                  .requirement = "axial_stiffness",
                  .place = WorstPlace::nut_softest},
      [](const auto& d) { return d.data->require.known(axial_stiffness) ? Applies::yes : Applies::no; },
      [](const auto& d) { return d.require(axial_stiffness, dimension::stiffness); },
      [](const auto& d) { return least_axial_stiffness(d, working_force(d)); });
  visit(
      Declaration{.id = "C-CP-WINDUP",
                  .title = "Wind-up of coupling and screw",
                  .symbol = "e_w",
                  .unit = "um",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, wind-up",
                  .requirement = "windup_share",
                  .worst = WorstPhase::steady,
                  .place = WorstPlace::nut_far},
      when_accuracy_is_required,
      [](const auto& d) { return windup_error(d); },
      [](const auto& d) { return d.require(windup_share) * d.require(position_error, dimension::length); });
  visit(
      Declaration{.id = "C-ACC-THERM",
                  .title = "Thermal growth of the screw over the stated travel",
                  .symbol = "ΔL",
                  .unit = "um",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, thermal growth",
                  .requirement = "thermal_growth_share"},
      when_accuracy_is_required,
      [](const auto& d) { return thermal_growth(d); },
      [](const auto& d) { return d.require(thermal_growth_share) * d.require(position_error, dimension::length); });
}

}  // namespace millwright::machine
