// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/import_mapping.h"
#include "report/text_table.h"

namespace millwright::report {

/// How a table would be read: which column is which of ours, in what unit, how sure, and why; what is kept, what is the
/// same for all rows, what is not given.
std::string import_text(const catalogue::ImportMapping& mapping, const Style& style);

/// What became of an import.
struct ImportOutcome {
  std::string file;                                   ///< the table
  const catalogue::ImportMapping* mapping = nullptr;  ///< null where it could not even be proposed
  std::string written;                                ///< the catalogue file; empty if none was written
  std::size_t rows_written = 0, lines_left_out = 0;
};

/// The same for programs, with all findings.
std::string import_json(const ImportOutcome& outcome, const text::Diagnostics& diagnostics);

}  // namespace millwright::report
