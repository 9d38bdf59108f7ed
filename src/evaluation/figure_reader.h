// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "catalogue/table.h"

namespace millwright::evaluation {

/// Reads figures of a row [SI; NaN where there is none], by column or by name, and adds those that it does not have to
/// a list. Copies add to the same one. Throws std::logic_error for a column that the family does not have.
class FigureReader {
 public:
  /// `soft`: figures that no hard check of the machine reads, which are not missed.
  FigureReader(const catalogue::Table& table,
               int row,
               std::vector<catalogue::Column>& missing,
               std::span<const catalogue::Column> soft = {})
      : table_(table), row_(row), missing_(missing), soft_(soft) {}

  double operator()(catalogue::Column figure) const {
    const double value = table_.number(figure, row_);
    if (std::isnan(value) && std::find(soft_.begin(), soft_.end(), figure) == soft_.end()) missing_.push_back(figure);
    return value;
  }
  double operator()(std::string_view name) const { return (*this)(catalogue::column(table_.family(), name)); }

 private:
  const catalogue::Table& table_;
  int row_;
  std::vector<catalogue::Column>& missing_;
  std::span<const catalogue::Column> soft_;
};

}  // namespace millwright::evaluation
