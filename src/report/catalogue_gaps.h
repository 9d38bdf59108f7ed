// SPDX-License-Identifier: Apache-2.0
// What is missing in the catalogues, as text and for programs.
#pragma once

#include <string>
#include <vector>

#include "catalogue/gaps.h"
#include "report/text_table.h"

namespace millwright::report {

std::string gaps_text(const std::vector<catalogue::Gap>& gaps, const Style& style);

/// {"schema", "command": "catalogue list", "gaps": [{"family", "missing", "sizes": [...], "reason"}]}
std::string gaps_json(const std::vector<catalogue::Gap>& gaps);

}  // namespace millwright::report
