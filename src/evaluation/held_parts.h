// SPDX-License-Identifier: Apache-2.0
//
// A bill of materials against a machine's stages: which rows of each slot are still possible and which variables are
// held.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/machine_model.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

struct HeldStage {
  std::vector<std::vector<solver::Row>> allowed;  ///< per slot
  std::vector<bool> named;                        ///< per slot: every part of it is given
  std::vector<std::optional<double>> variables;
};

struct HeldParts {
  std::vector<HeldStage> stages;       ///< as the model's entries
  std::optional<solver::Row> voltage;  ///< of the supply, if given or implied by the supply
  std::vector<BomProblem> problems;
  std::vector<BomProblem> remarks;  ///< what the bill says and nothing reads: more pieces, longer ones
};

/// Slots of the bill of materials that a candidate of this table fills ("screw" and "nut").
std::vector<std::string> slots_of(const SlotTable& table);

/// `only_origin`: hold only lines of that origin (empty = all). `wishes_count`: the model has only what the problem
/// wishes, and complaints say so; a slot that no line fills and that has no candidate is then left to
/// MachineModel::empty_slots().
HeldParts hold_parts(const MachineModel& model,
                     const machine::BillOfMaterials& bom,
                     const std::string& only_origin,
                     bool wishes_count = false);

/// The supply voltage [V] that a bill of materials says, or that its supply gives, and the line that says so.
struct StatedVoltage {
  double volts = 0.0;
  const machine::BomLine* line = nullptr;
};
std::optional<StatedVoltage> stated_voltage(const machine::BillOfMaterials& bom,
                                            const catalogue::Catalogue& catalogue,
                                            const std::string& only_origin);

/// What is held, as the solver takes it; shared choices are left open.
solver::Restriction restriction_of(const MachineModel& model, const HeldParts& held);

}  // namespace millwright::evaluation
