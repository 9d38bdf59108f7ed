// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "evaluation/explanation.h"
#include "report/json_value.h"
#include "report/result.h"

namespace millwright::report {

/// Adds what is known about tolerances as "tolerances"; nothing where it was not asked for.
void add_tolerances(const MachineResult& result, const evaluation::Design& design, Json& json);
/// The same of `explain`, with what would be chosen at the ends of tolerances.
void add_tolerances(const MachineResult& result, const evaluation::Explanation& explanation, Json& json);

}  // namespace millwright::report
