// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "catalogue/table.h"

namespace millwright::evaluation {

/// Reads figures of a row, by column or by name, and adds those that it does not have to a list. Copies add to the same
/// one.
class FigureReader {
 public:
  FigureReader(const catalogue::Table& table, int row, std::vector<catalogue::Column>& missing)
      : table_(table), row_(row), missing_(missing) {}

  double operator()(catalogue::Column figure) const {
    const double value = table_.number(figure, row_);
    if (std::isnan(value)) missing_.push_back(figure);
    return value;
  }
  double operator()(std::string_view name) const { return (*this)(catalogue::column(table_.family(), name)); }

 private:
  const catalogue::Table& table_;
  int row_;
  std::vector<catalogue::Column>& missing_;
};

}  // namespace millwright::evaluation
