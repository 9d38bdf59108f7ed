// SPDX-License-Identifier: Apache-2.0
// The top of a CSV text: comment lines, separator, column names and units.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "text/csv.h"

namespace millwright::text {

/// What stands before the header, and where the header begins (the size of the text if there is none).
struct CsvPreamble {
  std::vector<CsvComment> comments;
  char separator = ',';
  std::size_t header_begin = 0;
};

CsvPreamble read_preamble(const std::shared_ptr<const SourceText>& text);

/// Splits a header cell `name [unit]` that begins at byte `offset` of the text. Reports a missing name and unpaired
/// brackets. `exact` tells that the content stands in the text as it is (no doubled quotes), so that places inside it
/// are known.
CsvColumn read_header_cell(const std::shared_ptr<const SourceText>& text,
                           std::size_t offset,
                           std::string_view content,
                           bool exact,
                           Diagnostics& diagnostics);

}  // namespace millwright::text
