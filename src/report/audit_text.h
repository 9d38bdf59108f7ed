// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/audit.h"
#include "report/text_table.h"

namespace millwright::report {

/// Printed against computed, row by row, and how many rows have each verdict. `derive`: each row is followed by the
/// lines of its calculation.
std::string audit_text(const evaluation::AuditReport& report, bool derive, const Style& style);

}  // namespace millwright::report
