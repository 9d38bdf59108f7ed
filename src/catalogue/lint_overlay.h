// SPDX-License-Identifier: Apache-2.0
// Doubts about the files of an overlay that say something of parts elsewhere: stock.csv, suppliers.csv, offers.csv.
// Rules: offer-price (far from what the catalogue's row costs), price-breaks (more pieces at a higher price each),
// shipping-fee (more than one piece of all that is sold there), minimum-order (more than ten of each), stock (so many
// pieces that it is rather a shop's stock).
#pragma once

#include <filesystem>
#include <vector>

#include "catalogue/catalogue.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// The folder that a file is in.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The files of that kind in places that catalogues are loaded from.
std::vector<std::filesystem::path> overlay_files(const std::vector<std::filesystem::path>& places);

/// Reads `files`, reports what is wrong with them, and warns of what is odd. `parts`: whatever they may name, without
/// offers of its own.
void lint_overlay(const std::vector<std::filesystem::path>& files,
                  const Catalogue& parts,
                  text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
