// SPDX-License-Identifier: Apache-2.0
// Cells as people read them: a number in its customary unit, a price in its currency, yes or no, a text.
#pragma once

#include <string>

#include "catalogue/table.h"

namespace millwright::catalogue {

/// The unit that the column's numbers are shown in: "N.m", of a price "USD" or "USD/m", "" where there is none.
std::string shown_unit(const Table& table, Column column, int row);

/// "1.26 N.m", "9.62 USD", "yes", "NEMA23"; empty where the cell is not given. Numbers have so many significant digits
/// at most.
std::string cell_text(const Table& table, Column column, int row, int digits = 12);

}  // namespace millwright::catalogue
