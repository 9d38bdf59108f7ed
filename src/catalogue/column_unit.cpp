// SPDX-License-Identifier: Apache-2.0
#include "catalogue/column_unit.h"

#include <array>
#include <vector>

namespace millwright::catalogue {

const scalar::Unit& display_unit(Column column) {
  static const auto units = [] {
    std::array<std::vector<scalar::Unit>, family_count> all;
    for (std::size_t family = 0; family < family_count; ++family) {
      for (std::size_t index = 0; index < column_count(static_cast<Family>(family)); ++index) {
        const Column each{static_cast<Family>(family), static_cast<std::uint8_t>(index)};
        all[family].push_back(scalar::Unit::of(declaration(each).unit));
      }
    }
    return all;
  }();
  return units[static_cast<std::size_t>(column.family)][column.index];
}

}  // namespace millwright::catalogue
