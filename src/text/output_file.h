// SPDX-License-Identifier: Apache-2.0
// Files that are either written completely or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "text/diagnostic.h"

namespace millwright::text {

/// A file that is written piece by piece under another name beside its target, and takes the target's place when it is
/// complete. Until then, and after any failure, the target is as it was; what was not committed vanishes.
class OutputFile {
 public:
  /// Refuses (reported, null) what write_file_atomically() refuses.
  static std::unique_ptr<OutputFile> open(const std::string& path, Diagnostics& diagnostics);
  ~OutputFile();

  /// False, reported, if it could not be written.
  bool append(std::string_view contents);
  /// Makes the contents durable and renames. False, reported, on failure.
  bool commit();

 private:
  struct Parts;
  explicit OutputFile(std::unique_ptr<Parts> parts);
  bool refuse();
  std::unique_ptr<Parts> parts_;
};

/// Writes `contents` to a temporary file beside `path`, makes it durable, and renames it over `path`. On any failure
/// (reported, false) the old file is as it was and no temporary file is left. An existing file keeps its permissions.
/// Refused as targets: directories, symbolic links (renaming would replace the link, not the file behind it) and
/// everything else that is no regular file.
bool write_file_atomically(const std::string& path, std::string_view contents, Diagnostics& diagnostics);

}  // namespace millwright::text
