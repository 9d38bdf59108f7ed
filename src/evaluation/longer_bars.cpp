// SPDX-License-Identifier: Apache-2.0
#include "evaluation/longer_bars.h"

namespace millwright::evaluation {

void lengthen_bars(catalogue::Catalogue& parts) {
  constexpr double longer = 1.25;
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    const auto stock = catalogue::find_column(family.family, "stock_length");
    if (!stock) continue;
    const catalogue::Column price = catalogue::column(family.family, "price_per_length");
    for (int row = 0; row < parts.table(family.family).rows(); ++row) {
      const double length = parts.table(family.family).number(*stock, row);
      if (!(length > 0.0)) continue;
      catalogue::Table& table = parts.changeable_table(family.family);
      table.set_number(row, *stock, longer * length);
      table.set_number(row, price, table.number(price, row) / longer);
    }
  }
}

}  // namespace millwright::evaluation
