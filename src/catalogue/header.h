// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "catalogue/companions.h"
#include "catalogue/family.h"
#include "scalar/unit.h"
#include "text/csv.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// What the header of a file says: for each Column.index the field it stands in (-1 = not there) and, for numbers, its
/// unit.
struct Header {
  std::vector<int> field_of_column;
  std::vector<std::optional<scalar::Unit>> units;
  std::vector<Companion> companions;
};

/// Matches the header cells to the family's columns; every problem is reported. Nothing if the file cannot be read with
/// it (a required column is missing).
std::optional<Header> match_header(const text::CsvTable& csv, Family family, text::Diagnostics& diagnostics);

/// How a column is written in a header: "holding_torque [N.m]".
std::string header_cell(Column column);

}  // namespace millwright::catalogue
