// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "catalogue/table.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// Reads one file of a family. Reports everything that is wrong at its place: a header without unit, an unknown unit or
/// one of another dimension, a missing required column or value, a number that is none, a negative mass, a price
/// without currency; unknown columns are a warning and are left out, rows with an error are left out. `layer` is kept
/// with each row. `room`: the table has room for so many times its rows, which others will be appended to.
Table read_table(const std::shared_ptr<const text::SourceText>& text,
                 Family family,
                 int layer,
                 text::Diagnostics& diagnostics,
                 double room = 1.0);

/// Reports rows that are the same part as an earlier row, naming both places, and drops them.
void drop_duplicates(Table& table, text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
