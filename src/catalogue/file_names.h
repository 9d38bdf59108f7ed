// SPDX-License-Identifier: Apache-2.0
//
// Names of files as people write them: STOCK.CSV is the stock file too.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace millwright::catalogue {

/// Whether a file has this name (in small letters), capitals or not.
bool is_named(const std::filesystem::path& file, std::string_view name);

/// The file of this name in a folder: the one in small letters if there are several. Nothing where there is none, or no
/// folder.
std::optional<std::filesystem::path> named_in(const std::filesystem::path& folder, std::string_view name);

/// Whether a file of that name is read as a table of parts: it ends in .csv, in capitals or not.
bool is_csv_name(const std::filesystem::path& file);

}  // namespace millwright::catalogue
