// SPDX-License-Identifier: Apache-2.0
// The rows of somebody's table in our format, piece by piece, each piece examined by lint before it counts.
#pragma once

#include <functional>
#include <string_view>

#include "catalogue/import_mapping.h"

namespace millwright::catalogue {

struct ImportSummary {
  std::size_t rows = 0;      ///< written
  std::size_t left_out = 0;  ///< no parts: titles between the rows, the header once more
};

/// Hands the file in our format to `write` (false: it failed and has reported). Reports what cannot be converted, that
/// there are no parts, and what lint finds, at the places of the table that was read; after an error the output is not
/// to be used. Figures keep their digits and their unit, unless a column has several units.
ImportSummary write_import(const ImportSheet& sheet,
                           const ImportMapping& mapping,
                           const std::function<bool(std::string_view)>& write,
                           text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
