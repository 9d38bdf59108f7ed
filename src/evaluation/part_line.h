// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/counted_parts.h"
#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// A line of the bill of materials: what the catalogue says of a part of a build, and its share of the price.
PartLine part_line(const MachineModel& model,
                   const PartUse& use,
                   const std::string& axis,
                   const std::string& currency,
                   const CountedPartsLedger::Share& share);

}  // namespace millwright::evaluation
