// SPDX-License-Identifier: Apache-2.0
#include "evaluation/owned_first.h"

#include <algorithm>
#include <utility>

namespace millwright::evaluation {
namespace {

/// Pieces of the part that a candidate buys from somebody else.
double pieces_elsewhere(const catalogue::Catalogue& catalogue,
                        const PriceBook& prices,
                        const CountedPart& part,
                        const Candidate& candidate) {
  const catalogue::Table& table = catalogue.table(part.family);
  double pieces = 0.0;
  for (const PartUse& use : candidate.parts)
    if (use.stated.empty() && use.family == part.family && table.ownership(use.row) == catalogue::Ownership::none &&
        table.same_part(use.row, table, part.row, catalogue::Identity::point) && !prices.is_counted(table, use.row))
      pieces += use.pieces();
  return pieces;
}

}  // namespace

std::vector<OwnedFirst> find_owned_first(const catalogue::Catalogue& catalogue,
                                         const PriceBook& prices,
                                         std::span<const CountedPart> counted_parts,
                                         const std::vector<std::span<const SlotTable>>& tables,
                                         std::size_t first_state,
                                         std::vector<std::vector<PieceCount>>& counts) {
  std::vector<OwnedFirst> rules;
  for (const CountedPart& part : counted_parts) {
    if (part.only_owned || !(part.owned > 0.0) || part.preference < 1.0) continue;
    OwnedFirst rule{part.owned, 0.0, part.state, first_state + rules.size()};
    for (std::size_t stage = 0; stage < tables.size(); ++stage)
      for (std::size_t slot = 0; slot < tables[stage].size(); ++slot) {
        const SlotTable& table = tables[stage][slot];
        PieceCount count{slot, rule.elsewhere_state, std::vector<double>(table.rows(), 0.0)};
        for (std::size_t row = 0; row < table.rows(); ++row)
          count.of_row[row] = pieces_elsewhere(catalogue, prices, part, table.candidate(row));
        const double most = count.of_row.empty() ? 0.0 : *std::max_element(count.of_row.begin(), count.of_row.end());
        if (most == 0.0) continue;
        rule.line = std::max(rule.line, most);
        counts[stage].push_back(std::move(count));
      }
    if (rule.line > 0.0) rules.push_back(rule);
  }
  return rules;
}

}  // namespace millwright::evaluation
