// SPDX-License-Identifier: Apache-2.0
//
// All stages a machine can have, and the constraints of each: for those few who look inside.
#pragma once

#include <type_traits>

#include "evaluation/belt_drive_stage.h"
#include "evaluation/bolt_stage.h"
#include "evaluation/guide_stage.h"
#include "evaluation/member_stage.h"
#include "evaluation/rack_drive_stage.h"
#include "evaluation/rotary_drive_stage.h"
#include "evaluation/screw_drive_stage.h"
#include "evaluation/supply_stage.h"
#include "evaluation/whole_stage.h"

namespace millwright::evaluation {

/// Calls a visitor with every constraint of the element that a stage chooses.
template <class Stage>
constexpr auto constraints_of() {
  return [](auto& visit) {
    if constexpr (std::is_same_v<Stage, ScrewDriveStage>) machine::screw_drive_constraints(visit);
    if constexpr (std::is_same_v<Stage, BeltDriveStage>) machine::belt_drive_constraints(visit);
    if constexpr (std::is_same_v<Stage, RackDriveStage>) machine::rack_drive_constraints(visit);
    if constexpr (std::is_same_v<Stage, RotaryDriveStage>) machine::rotary_drive_constraints(visit);
    if constexpr (std::is_same_v<Stage, GuideStage>) machine::guide_constraints(visit);
    if constexpr (std::is_same_v<Stage, MemberStage>) machine::member_constraints(visit);
    if constexpr (std::is_same_v<Stage, BoltStage>) machine::bolted_joint_constraints(visit);
    if constexpr (std::is_same_v<Stage, SupplyStage>) supply_constraints(visit);
    if constexpr (std::is_same_v<Stage, WholeStage>) whole_constraints(visit);
  };
}

}  // namespace millwright::evaluation
