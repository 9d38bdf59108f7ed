// SPDX-License-Identifier: Apache-2.0
// The pieces of a result that describe one design, as JSON.
#pragma once

#include "report/json_value.h"
#include "report/result.h"

namespace millwright::report {

/// "satisfied", "violated", "not evaluated".
const char* verdict_name(evaluation::Verdict verdict);

/// The unit of a quantity's values in JSON.
std::string unit_of(machine::Quantity counted, const std::string& currency);

/// Of each catalogue its place, counts and "sha256": the SHA-256 of the list that `sha256sum` prints of its files with
/// parts, ascending by name; "remarks" are the files that say something of parts, where there are any.
Json catalogues_json(const catalogue::Inventory& inventory);
/// The same of a result; nothing where the files were not looked at.
void add_catalogues(const MachineResult& result, Json& json);

/// Cost, mass and what else the problem counts.
Json totals_of(const evaluation::Design& design);

/// Parts and dimensions.
Json build_of(const evaluation::Design& design);

/// Every check, axis by axis, the most used first.
Json checks_json(const MachineResult& result, const evaluation::Design& design);

/// For each axis the hard check that is used most.
Json governing_of(const MachineResult& result, const evaluation::Design& design);

}  // namespace millwright::report
