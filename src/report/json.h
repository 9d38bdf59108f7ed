// SPDX-License-Identifier: Apache-2.0
// The answers for programs: JSON of the schema "millwright.result/1". Names are stable; values are in the unit named
// beside them; what is undefined or infinite is null.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "catalogue/listing.h"
#include "evaluation/audit.h"
#include "report/calculation.h"
#include "report/result.h"
#include "text/diagnostic.h"

namespace millwright::report {

std::string solve_json(const MachineResult& result);
std::string front_json(const MachineResult& result);
std::string check_json(const MachineResult& result);
std::string audit_json(const evaluation::AuditReport& report, const std::string& file);
std::string calculation_json(const Calculation& calculation);
std::string formulas_json(const std::vector<const mechanics::Formula*>& formulas);
std::string families_json(const std::vector<catalogue::FamilySummary>& families, const catalogue::Inventory& inventory);
std::string parts_json(std::string_view family, const std::vector<catalogue::PartLine>& parts);
std::string sheets_json(const std::vector<catalogue::PartSheet>& sheets);
std::string lint_json(const text::Diagnostics& diagnostics, int files, int rows);

}  // namespace millwright::report
