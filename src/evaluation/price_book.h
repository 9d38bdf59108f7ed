// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"
#include "machine/problem.h"

namespace millwright::evaluation {

/// Turns catalogue prices into the problem's currency. Rows in a currency without a rate are not for sale.
class PriceBook {
 public:
  explicit PriceBook(const machine::Problem& problem);
  /// What one unit of `currency` is worth in the problem's currency; NaN if no rate is given.
  [[nodiscard]] double rate(std::string_view currency) const;
  /// Price of whole pieces plus a length; parts of it that the row does not have count as 0. NaN if nothing is priced.
  [[nodiscard]] double line(const catalogue::Table& table, int row, double pieces, double metres) const;

 private:
  std::map<std::string, double, std::less<>> rates_;
};

}  // namespace millwright::evaluation
