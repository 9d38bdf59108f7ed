// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/import_mapping.h"
#include "report/text_table.h"

namespace millwright::report {

/// How a table would be read: which column is which of ours, in what unit, how sure, and why; what is kept, what is the
/// same for all rows, what is not given.
std::string import_text(const catalogue::ImportMapping& mapping, const Style& style);

}  // namespace millwright::report
