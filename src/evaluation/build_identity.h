// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// Equal for builds of a model's problem that are the same machine with the same orders: who sells a piece that is
/// owned already, or which of two equal ones is, makes no other build.
std::string build_identity(const MachineModel& model, const solver::Build& build);

}  // namespace millwright::evaluation
