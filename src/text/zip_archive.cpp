// SPDX-License-Identifier: Apache-2.0
#include "text/zip_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

namespace millwright::text {

namespace {

constexpr std::size_t end_record_size = 22;
constexpr std::size_t directory_entry_size = 46;
constexpr std::size_t local_header_size = 30;
constexpr std::uint16_t encrypted = 1;

/// A number of `bytes` bytes, the lowest first; 0 outside the text.
std::uint32_t number_at(std::string_view text, std::size_t offset, unsigned bytes) {
  std::uint32_t value = 0;
  if (offset + bytes > text.size()) return 0;
  for (unsigned i = 0; i < bytes; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[offset + i])) << (8U * i);
  return value;
}

std::uint16_t short_at(std::string_view text, std::size_t offset) {
  return static_cast<std::uint16_t>(number_at(text, offset, 2));
}

std::optional<std::string> inflate_raw(std::string_view packed, std::size_t size, std::string& reason) {
  std::string bytes(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) {
    reason = "cannot be unpacked";
    return std::nullopt;
  }
  // zlib takes a pointer to bytes that it only reads.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  Bytef surplus = 0;
  stream.next_out = size == 0 ? &surplus : reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(size);
  int result = inflate(&stream, Z_FINISH);
  if (result != Z_STREAM_END && stream.avail_out == 0) {
    stream.next_out = &surplus;
    stream.avail_out = 1;
    result = inflate(&stream, Z_FINISH);
  }
  const bool complete = result == Z_STREAM_END && stream.total_out == size;
  const bool larger = stream.total_out > size;
  inflateEnd(&stream);
  if (complete) return bytes;
  reason = larger ? fmt::format("unpacks to more than the {} bytes it claims", size) : "is damaged";
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<ZipEntry>> zip_directory(std::string_view archive, std::string& reason) {
  const auto refuse = [&](const char* why) {
    reason = why;
    return std::nullopt;
  };
  const std::size_t end = archive.rfind("PK\x05\x06");
  if (end == std::string_view::npos || end + end_record_size > archive.size()) return refuse("is no complete zip file");
  const std::size_t count = number_at(archive, end + 10, 2);
  std::size_t at = number_at(archive, end + 16, 4);
  if (number_at(archive, end + 4, 2) != 0 || at == 0xFFFFFFFFU)
    return refuse("is a zip file in parts or of more than 4 GB");
  std::vector<ZipEntry> entries;
  for (std::size_t i = 0; i < count; ++i) {
    if (at + directory_entry_size > archive.size() || archive.substr(at, 4) != "PK\x01\x02")
      return refuse("has a damaged zip directory");
    ZipEntry entry;
    entry.flags = short_at(archive, at + 8);
    entry.method = short_at(archive, at + 10);
    entry.packed = number_at(archive, at + 20, 4);
    entry.unpacked = number_at(archive, at + 24, 4);
    entry.offset = number_at(archive, at + 42, 4);
    const std::size_t name = short_at(archive, at + 28);
    if (at + directory_entry_size + name > archive.size()) return refuse("has a damaged zip directory");
    entry.name = std::string(archive.substr(at + directory_entry_size, name));
    at += directory_entry_size + name + short_at(archive, at + 30) + short_at(archive, at + 32);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::optional<std::string> unzip(std::string_view archive, const ZipEntry& entry, std::string& reason) {
  const auto refuse = [&](const char* why) {
    reason = why;
    return std::nullopt;
  };
  if ((entry.flags & encrypted) != 0) return refuse("is encrypted");
  if (entry.method != 0 && entry.method != 8) return refuse("is packed in a way that is not known");
  const std::size_t at = entry.offset;
  if (at + local_header_size > archive.size() || archive.substr(at, 4) != "PK\x03\x04") return refuse("is damaged");
  const std::size_t begin = at + local_header_size + short_at(archive, at + 26) + short_at(archive, at + 28);
  if (begin > archive.size() || entry.packed > archive.size() - begin) return refuse("is damaged");
  const std::string_view packed = archive.substr(begin, entry.packed);
  if (entry.method == 8) return inflate_raw(packed, entry.unpacked, reason);
  if (entry.packed != entry.unpacked) return refuse("is damaged");
  return std::string(packed);
}

}  // namespace millwright::text
