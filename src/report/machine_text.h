// SPDX-License-Identifier: Apache-2.0
// The answers of solve, pareto and check as text.
#pragma once

#include <string>

#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// Totals, bill of materials, dimensions, checks, requirements, assumptions and certificate of the best build; or why
/// there is none.
std::string solve_text(const MachineResult& result, const Style& style);

/// The builds that no other build beats in all objectives, one a line, then how the ends of the front are built.
std::string front_text(const MachineResult& result, const Style& style);

/// What fails, first; then what was used and every check.
std::string check_text(const MachineResult& result, const Style& style);

/// Title and file, and what was asked for beside the problem.
std::string title_text(const MachineResult& result, const Style& style);

/// Why there is no build: slots without candidates, checks that fail whatever is chosen, ways out.
std::string nothing_text(const MachineResult& result, const Style& style);

/// "612.34 USD", "41.200 kg", "12.500 s": a value of an objective; of a weighted sum only its number.
std::string objective_text(const std::string& objective, double value, const std::string& currency);
/// The same of a lower bound of it, rounded down.
std::string objective_bound_text(const std::string& objective, double bound, const std::string& currency);
/// What is left between a bound and a build, in percent, rounded up: "0.01".
std::string gap_percent(double gap);

/// The unit of an objective's values, empty for a weighted sum.
std::string objective_unit(const std::string& objective, const std::string& currency);

}  // namespace millwright::report
