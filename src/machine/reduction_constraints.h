// SPDX-License-Identifier: Apache-2.0
//
// What a reduction bears, each declared once (see constraint.h): every drive that may have one.
#pragma once

#include "machine/constraint.h"
#include "machine/requirement.h"

namespace millwright::machine {

template <class Visit>
void reduction_constraints(Visit&& visit) {
  using namespace scalar;
  visit(
      Declaration{.id = "C-RD-TORQUE",
                  .title = "Torque at the output of the reduction",
                  .symbol = "T_2",
                  .unit = "N.m",
                  .source = "millwright_derivations, torque through a reduction",
                  .requirement = "reduction_service_factor",
                  .worst = WorstPhase::output_torque},
      [](const auto& d) { return d.reduction.torque_is_rated; },
      [](const auto& d) { return d.require(Requirement::reduction_service_factor) * d.output_torque; },
      [](const auto& d) { return d.reduction.rated_torque; });
  visit(
      Declaration{.id = "C-RD-SPEED",
                  .title = "Speed at the input of the reduction",
                  .symbol = "ω_1",
                  .unit = "rpm",
                  .source = "millwright_derivations, torque through a reduction",
                  .worst = WorstPhase::speed},
      [](const auto& d) { return d.reduction.speed_is_rated; },
      [](const auto& d) { return d.peak_speed; },
      [](const auto& d) { return d.reduction.largest_speed; });
}

}  // namespace millwright::machine
