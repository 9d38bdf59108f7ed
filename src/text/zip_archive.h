// SPDX-License-Identifier: Apache-2.0
// Zip files from anybody: what is unpacked is bounded before it is unpacked, and again while it is. (A "zip bomb" of a
// few kilobytes claims, or hides, gigabytes.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::text {

struct ZipEntry {
  std::string name;
  std::uint32_t packed = 0;    ///< bytes, as the directory says
  std::uint32_t unpacked = 0;  ///< bytes, as the directory says; never unpacked beyond it
  std::uint32_t offset = 0;    ///< of its local header
  std::uint16_t method = 0;    ///< 0 stored, 8 deflated
  std::uint16_t flags = 0;
};

/// The directory of a zip file. Where it cannot be read: nothing, and why in `reason`.
std::optional<std::vector<ZipEntry>> zip_directory(std::string_view archive, std::string& reason);

/// The contents of an entry, exactly as many bytes as the directory says. Else nothing, and why in `reason`: damaged,
/// encrypted, packed in another way, of another size.
std::optional<std::string> unzip(std::string_view archive, const ZipEntry& entry, std::string& reason);

}  // namespace millwright::text
