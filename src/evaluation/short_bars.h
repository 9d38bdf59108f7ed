// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// Why a slot of an axis (or member) has no candidate, where that is because all that would fit is sold in bars shorter
/// than the pieces it takes; empty if that is not the reason.
std::string short_bars(const MachineModel& model, const std::string& axis, const std::string& slot);

}  // namespace millwright::evaluation
