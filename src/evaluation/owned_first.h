// SPDX-License-Identifier: Apache-2.0
//
// Of the next best builds none buys a part from somebody while pieces of it that are owned lie about: that is no other
// machine, only a dearer way to the same one, and the best build has no need to. The state counts what is bought
// elsewhere of each part that is owned, and the last stage forbids it as long as what is owned would do for the largest
// line that could be bought there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/counted_parts.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"

namespace millwright::evaluation {

struct OwnedFirst {
  double owned = 0.0;               ///< pieces
  double line = 0.0;                ///< the most pieces that a line bought elsewhere has
  std::size_t taken_state = 0;      ///< where the state counts those of which the owned ones come first
  std::size_t elsewhere_state = 0;  ///< where it counts those bought from others
};

/// The rules for parts of which some are owned and others are sold elsewhere at a price that does not hang on how many
/// are bought: with price breaks it may be cheaper to buy more than is needed. Nor are there rules for preferred parts:
/// where builds are compared, one that is bought may count less than what an order without it is filled up with. Adds
/// what the rows of `tables`, of all stages, count for them to `counts`, of the same stages; the state vector counts it
/// from `first_state` on.
std::vector<OwnedFirst> find_owned_first(const catalogue::Catalogue& catalogue,
                                         const PriceBook& prices,
                                         std::span<const CountedPart> counted_parts,
                                         const std::vector<std::span<const SlotTable>>& tables,
                                         std::size_t first_state,
                                         std::vector<std::vector<PieceCount>>& counts);

}  // namespace millwright::evaluation
