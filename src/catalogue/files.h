// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "catalogue/family.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// A catalogue file, loaded, and the family it belongs to.
struct CatalogueFile {
  std::shared_ptr<const text::SourceText> text;
  Family family;
};

/// The CSV files of a catalogue, in the order of their names. `place` may be a folder of family folders, one family's
/// folder, or a single file; a file directly in the folder is known by its name (ball_screws.csv), or else by its
/// header. A stock file (stock.h) and files of suppliers and offers (suppliers.h) hold no
/// parts and are passed over. What cannot be told or read is reported.
std::vector<CatalogueFile> catalogue_files(const std::filesystem::path& place, text::Diagnostics& diagnostics);

/// Of a place without a CSV file.
void report_no_files(const std::filesystem::path& place, text::Diagnostics& diagnostics);

/// Loads one file; its family is `family`, or else told by its folder, its name, or its header.
std::optional<CatalogueFile> catalogue_file(const std::filesystem::path& file,
                                            std::optional<Family> family,
                                            text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
