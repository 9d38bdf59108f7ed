// SPDX-License-Identifier: Apache-2.0
// Why nothing is compliant, in words: what contradicts itself, by how much each of it must give way, what is missing.
#pragma once

#include <string>
#include <vector>

#include "evaluation/explanation.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// What was left out of what could be eased, as it is not surely looser (times, speeds, forces, loads); empty where
/// nothing was.
std::vector<std::string> withheld_kinds(const evaluation::Explanation& explanation);

/// The same in a sentence.
std::string withheld_text(const evaluation::Explanation& explanation);

/// Of an explanation without a design.
std::string conflicts_text(const MachineResult& result, const evaluation::Explanation& explanation, const Style& style);

}  // namespace millwright::report
