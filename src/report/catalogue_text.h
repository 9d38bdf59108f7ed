// SPDX-License-Identifier: Apache-2.0
// What can be bought, as text.
#pragma once

#include <string>
#include <vector>

#include "catalogue/inventory.h"
#include "catalogue/listing.h"
#include "report/text_table.h"

namespace millwright::report {

/// The families with counts, price ranges and how much of them is estimated; below, of places that say something of
/// parts (stock, suppliers, offers), what is there.
std::string families_text(const std::vector<catalogue::FamilySummary>& families,
                          const catalogue::Inventory& inventory,
                          const Style& style);

/// The parts of one family with key figures and price.
std::string parts_list_text(const std::vector<catalogue::PartLine>& parts, const Style& style);

/// All figures of a part, with where each comes from; estimates marked.
std::string sheet_text(const catalogue::PartSheet& sheet, const Style& style);

}  // namespace millwright::report
