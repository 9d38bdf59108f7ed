// SPDX-License-Identifier: Apache-2.0
//
// Every constraint that an element declares.
#pragma once

#include <string>
#include <vector>

#include "evaluation/supply_stage.h"
#include "evaluation/whole_stage.h"
#include "machine/belt_drive_constraints.h"
#include "machine/bolted_joint.h"
#include "machine/guide_system.h"
#include "machine/member_constraints.h"
#include "machine/rack_drive_constraints.h"
#include "machine/rotary_drive_constraints.h"
#include "machine/screw_drive_constraints.h"

namespace millwright {

struct DeclaringElement {
  std::string name;
  std::vector<machine::Declaration> constraints;
};

inline std::vector<DeclaringElement> declaring_elements() {
  std::vector<DeclaringElement> elements;
  const auto take = [&](const char* name, auto&& walk) {
    elements.push_back({name, {}});
    walk([&](const machine::Declaration& declaration, auto&&, auto&&, auto&&) {
      elements.back().constraints.push_back(declaration);
    });
  };
  take("screw drive", [](auto&& visit) { machine::screw_drive_constraints(visit); });
  take("belt drive", [](auto&& visit) { machine::belt_drive_constraints(visit); });
  take("guide", [](auto&& visit) { machine::guide_constraints(visit); });
  take("member", [](auto&& visit) { machine::member_constraints(visit); });
  take("supply", [](auto&& visit) { evaluation::supply_constraints(visit); });
  take("bolts", [](auto&& visit) { machine::bolted_joint_constraints(visit); });
  take("rack drive", [](auto&& visit) { machine::rack_drive_constraints(visit); });
  take("rotary drive", [](auto&& visit) { machine::rotary_drive_constraints(visit); });
  take("whole", [](auto&& visit) { evaluation::whole_constraints(visit); });
  return elements;
}

}  // namespace millwright
