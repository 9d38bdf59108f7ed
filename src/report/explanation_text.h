// SPDX-License-Identifier: Apache-2.0
// What 'explain' found out, in words: the conflict and the ways out of it, or what is forced, what is free and what
// each thing that is asked costs.
#pragma once

#include <string>

#include "evaluation/explanation.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// `result`: title, file, axes and what was asked for beside the problem; it needs no design.
std::string explanation_text(const MachineResult& result,
                             const evaluation::Explanation& explanation,
                             const Style& style);

std::string explanation_json(const MachineResult& result, const evaluation::Explanation& explanation);

/// "problems/sander.toml:14:20"; "--set axis.x.stroke=1 m", "--limit cost" where the command line asks; "default" where
/// nobody does.
std::string place_text(const machine::Condition& condition);

}  // namespace millwright::report
