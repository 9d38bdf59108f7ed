// SPDX-License-Identifier: Apache-2.0
#include "machine/reported_constraints.h"

#include <algorithm>

#include "machine/belt_drive_constraints.h"
#include "machine/bolted_joint.h"
#include "machine/guide_system.h"
#include "machine/member_constraints.h"
#include "machine/rack_drive_constraints.h"
#include "machine/rotary_drive_constraints.h"
#include "machine/screw_drive_constraints.h"

namespace millwright::machine {

std::vector<std::string_view> reported_constraints() {
  std::vector<std::string_view> ids;
  const auto take = [&](const Declaration& declaration, auto&&, auto&&, auto&&) {
    const bool known = std::find(ids.begin(), ids.end(), declaration.id) != ids.end();
    if (declaration.kind == ConstraintKind::soft && !known) ids.push_back(declaration.id);
  };
  screw_drive_constraints(take);
  belt_drive_constraints(take);
  rack_drive_constraints(take);
  rotary_drive_constraints(take);
  guide_constraints(take);
  member_constraints(take);
  bolted_joint_constraints(take);
  return ids;
}

}  // namespace millwright::machine
