// SPDX-License-Identifier: Apache-2.0
// The top of somebody's table: titles, the header, perhaps a row of units, and a look at the first parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalogue/import_mapping.h"

namespace millwright::catalogue {

struct TableHead {
  std::vector<std::string> cells;  ///< of the header, as written
  std::vector<text::SourceSpan> spans;
  std::vector<std::string> units;  ///< of the row of units; empty if there is none
  std::vector<std::string> titles;
  text::SourceSpan span;
  std::size_t data_begin = 0;
  struct Sample {
    std::string cell;
    bool is_number = false;  ///< in a workbook
  };
  std::vector<std::vector<Sample>> samples;  ///< of each column, cells that are not empty
};

/// The row that names most of our columns, or those of a mapping file, among the first ones. Reports if there is none.
std::optional<TableHead> find_head(const ImportSheet& sheet,
                                   const ImportChoices& choices,
                                   text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
