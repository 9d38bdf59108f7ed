// SPDX-License-Identifier: Apache-2.0
//
// What is decided before a search (`--fix`): parts and settings of a machine, given as lines of a bill of materials.
// Unlike a bill of materials that is judged as it is, the problem keeps its wishes: only builds that it permits anyway
// are left.
#pragma once

#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// Narrows the problem to the supply voltage and the motor currents that are fixed. What is not among the problem's is
/// added to `problems`.
void take_fixed_settings(machine::Problem& problem,
                         const machine::BillOfMaterials& fixed,
                         std::vector<BomProblem>& problems);

/// Fixed values that are not what the problem says, or not within its range.
std::vector<BomProblem> values_out_of_range(const MachineModel& model, const machine::BillOfMaterials& fixed);

}  // namespace millwright::evaluation
