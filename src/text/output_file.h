// SPDX-License-Identifier: Apache-2.0
// Files that are either written completely or not at all.
#pragma once

#include <string>
#include <string_view>

#include "text/diagnostic.h"

namespace millwright::text {

/// Writes `contents` to a temporary file beside `path`, makes it durable, and renames it over `path`. On any failure
/// (reported, false) the old file is as it was and no temporary file is left. An existing file keeps its permissions.
/// Refused as targets: directories, symbolic links (renaming would replace the link, not the file behind it) and
/// everything else that is no regular file.
bool write_file_atomically(const std::string& path, std::string_view contents, Diagnostics& diagnostics);

}  // namespace millwright::text
