// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "catalogue/import_head.h"
#include "catalogue/import_number.h"
#include "scalar/unit.h"

namespace millwright::catalogue {

/// What the figures of a column of a shop's table look like, seen as one of ours.
struct Figures {
  std::size_t numbers = 0;
  std::size_t with_unit = 0;  ///< of their own, that fits
  std::size_t plausible = 0;  ///< within the column's declared range
  std::size_t judged = 0;
};

/// `bare`: the unit of numbers without one. `usual`: the decimal mark of the table, if it is known; else a number that
/// can be read in two ways is plausible if one of them is.
Figures look_at(const std::vector<TableHead::Sample>& samples,
                Column target,
                const scalar::Unit& bare,
                DecimalMark usual);

}  // namespace millwright::catalogue
