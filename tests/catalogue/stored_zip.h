// SPDX-License-Identifier: Apache-2.0
// Zip files for tests, not packed, and with sizes that may lie.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::catalogue {

struct NamedBytes {
  std::string name;
  std::string bytes;
};

inline void append_number(std::string& text, std::size_t value, unsigned bytes) {
  for (unsigned i = 0; i < bytes; ++i) text.push_back(static_cast<char>((value >> (8U * i)) & 0xFFU));
}

inline std::uint32_t check_sum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<z_size_t>(bytes.size())));
}

inline std::string stored_zip(const std::vector<NamedBytes>& entries) {
  std::string archive;
  std::string directory;
  for (const NamedBytes& entry : entries) {
    std::string described;  // what local header and directory have in common
    append_number(described, 20, 2);
    append_number(described, 0, 2);
    append_number(described, 0, 2);
    append_number(described, 0x00210000U, 4);  // the first day that zip files know
    append_number(described, check_sum(entry.bytes), 4);
    append_number(described, entry.bytes.size(), 4);
    append_number(described, entry.bytes.size(), 4);
    append_number(described, entry.name.size(), 2);
    append_number(described, 0, 2);
    directory += "PK\x01\x02";
    append_number(directory, 20, 2);
    directory += described;
    append_number(directory, 0, 2 + 2 + 2);
    append_number(directory, 0, 4);
    append_number(directory, archive.size(), 4);
    directory += entry.name;
    archive += "PK\x03\x04";
    archive += described;
    archive += entry.name;
    archive += entry.bytes;
  }
  const std::size_t begin = archive.size();
  archive += directory;
  archive += "PK\x05\x06";
  append_number(archive, 0, 4);
  append_number(archive, entries.size(), 2);
  append_number(archive, entries.size(), 2);
  append_number(archive, directory.size(), 4);
  append_number(archive, begin, 4);
  append_number(archive, 0, 2);
  return archive;
}

}  // namespace millwright::catalogue
