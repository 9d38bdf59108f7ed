// SPDX-License-Identifier: Apache-2.0
#include "evaluation/preferred_parts.h"

#include <algorithm>

namespace millwright::evaluation {
namespace {

double preference_of(const catalogue::Catalogue& catalogue, const PriceBook& prices, const PartUse& use) {
  return use.stated.empty() ? prices.preference(catalogue.table(use.family), use.row) : 1.0;
}

}  // namespace

bool any_preferred(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::span<const SlotTable> tables) {
  for (const SlotTable& table : tables)
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::span<const PartUse> parts = table.candidate(row).parts;
      const auto preferred = [&](const PartUse& use) { return preference_of(catalogue, prices, use) < 1.0; };
      if (std::any_of(parts.begin(), parts.end(), preferred)) return true;
    }
  return false;
}

std::vector<PieceCount> compared_prices(const catalogue::Catalogue& catalogue,
                                        const PriceBook& prices,
                                        std::span<const SlotTable> tables,
                                        std::size_t resource) {
  std::vector<PieceCount> result;
  if (!any_preferred(catalogue, prices, tables)) return result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    PieceCount& compared = result.emplace_back();
    compared.slot = slot;
    compared.state = resource;
    compared.is_resource = true;
    for (std::size_t row = 0; row < tables[slot].rows(); ++row) {
      const Candidate& candidate = tables[slot].candidate(row);
      double price = candidate.price;
      for (const PartUse& use : candidate.parts) price -= (1.0 - preference_of(catalogue, prices, use)) * use.price;
      compared.of_row.push_back(price);
    }
  }
  return result;
}

}  // namespace millwright::evaluation
