// SPDX-License-Identifier: Apache-2.0
//
// Parts that are preferred: they are chosen where they cost little more than what would be chosen otherwise. Builds are
// compared by a resource of their own, in which what is paid for preferred parts counts less:
//
//   compared cost = sum over all lines of price * (1 / (1 + premium) of a preferred part, else 1) + orders
//
// Lines are what they cost in the whole order, with breaks, packs, bars, spares and pieces that are owned. Limits and
// minimum orders ask for the cost itself. Of a build that is best by the compared cost, the cost exceeds the least cost
// of any by no more than the difference of its two.
#pragma once

#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/counted_parts.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"

namespace millwright::evaluation {

/// Whether a candidate of a stage has a preferred part.
bool any_preferred(const catalogue::Catalogue& catalogue, const PriceBook& prices, std::span<const SlotTable> tables);

/// What the candidates of a stage add to the compared cost, by slot; nothing where none of them is preferred.
std::vector<PieceCount> compared_prices(const catalogue::Catalogue& catalogue,
                                        const PriceBook& prices,
                                        std::span<const SlotTable> tables,
                                        std::size_t resource);

}  // namespace millwright::evaluation
