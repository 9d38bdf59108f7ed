// SPDX-License-Identifier: Apache-2.0
//
// The rows of a table in an order of their own: where parts are equally good, which one is named must not hang on where
// it stands in a file, or in which file.
#pragma once

#include <vector>

#include "catalogue/table.h"

namespace millwright::catalogue {

/// All rows by manufacturer and part number (bytes, not numbers: "M10" is before "M4"), and those of the same name by
/// their other cells, column by column; what is not known comes last. Rows that agree in all of that keep their order.
std::vector<int> rows_in_order(const Table& table);

}  // namespace millwright::catalogue
