// SPDX-License-Identifier: Apache-2.0
//
// A build of one model in another one of the same machine, of which something else is asked.
#pragma once

#include <optional>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// `build` of the model `from` with the rows that the same parts and settings have in `to`, and its variables within
/// their ranges there; nothing where it has them no more. Not evaluated: it need not be compliant there.
std::optional<solver::Build> same_parts_in(const MachineModel& to,
                                           const MachineModel& from,
                                           const solver::Build& build);

}  // namespace millwright::evaluation
