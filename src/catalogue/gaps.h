// SPDX-License-Identifier: Apache-2.0
// What a builder will look for and not find: sizes that standards prefer and no row has, and parts that exist without
// the partner they need (a screw without a nut, a motor without a driver of its current).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"

namespace millwright::catalogue {

/// One thing that is missing.
struct Gap {
  Family family;                   ///< where a row would have to be added
  std::string missing;             ///< "profile rails of size 45 mm", in words
  std::vector<std::string> sizes;  ///< the sizes or parts alone, "45 mm", "Tr28x5"
  std::string reason;              ///< who needs them: a standard's series, or the rows that have no partner
};

/// All gaps, in the order of the families.
std::vector<Gap> find_gaps(const Catalogue& catalogue);

}  // namespace millwright::catalogue
