// SPDX-License-Identifier: Apache-2.0
// What was asked for on the command line beside the problem file, repeated in the answer: an answer under a budget, or
// without some parts, must not be taken for the answer to the problem.
#pragma once

#include <string>

#include "report/json_value.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// Limits, excluded parts, fixed parts and settings, one a line; empty if there are none.
std::string steering_text(const MachineResult& result, const Style& style);

/// The same as `steering` of a result; nothing is added if there are none.
void add_steering(const MachineResult& result, Json& json);

}  // namespace millwright::report
