// SPDX-License-Identifier: Apache-2.0
// Reads offers.csv (suppliers.h).
#pragma once

#include <string_view>

#include "catalogue/suppliers.h"
#include "text/csv.h"

namespace millwright::catalogue {

inline constexpr std::string_view offers_name = "offers.csv";

/// Adds the lines of the file.
void read_offers(const text::CsvTable& csv,
                 const Catalogue& catalogue,
                 Suppliers& suppliers,
                 text::Diagnostics& diagnostics);
/// Reports what is wrong with the lines, whatever parts they name.
void check_offer_lines(const text::CsvTable& csv, text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
