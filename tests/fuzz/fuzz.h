// SPDX-License-Identifier: Apache-2.0
// What the fuzz targets share: each is a `LLVMFuzzerTestOneInput` in a file of its own that hands the bytes to one of
// the program's readers and demands of whatever comes back that it is sound. A demand that is not met ends the program,
// as a crash does, and libFuzzer keeps the input.
//
//   require(read.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
//   check(diagnostics);
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/diagnostic.h"
#include "text/source_text.h"
#include "text/utf8.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace millwright::fuzz {

inline void require(bool holds, const char* demand, const std::string& shown = {}) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n%s\n", demand, shown.c_str());
  std::abort();
}

inline std::string_view view(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Characters that a terminal shows as they are: UTF-8 without control characters, except line ends (and the tabs of a
/// source line).
inline bool is_printable(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const text::Character character = text::decode(text, at);
    const bool control = (character.value < 0x20 && character.value != '\n' && character.value != '\t') ||
                         (character.value >= 0x7F && character.value < 0xA0);
    if (!character.valid || control) return false;
    at += static_cast<std::size_t>(character.bytes);
  }
  return true;
}

/// The place is in its text, or one character behind it.
inline void check(const text::SourceSpan& where, const std::string& shown) {
  if (!where.text || where.line == 0) return;
  require(where.line > 0 && where.line <= where.text->line_count() + 1, "the line is one of the text", shown);
  const std::size_t length = text::count_characters(where.text->line(where.line));
  require(where.column > 0 && static_cast<std::size_t>(where.column) <= length + 1, "the column is in the line", shown);
  require(where.length >= 0, "a place has a length", shown);
}

/// Every complaint says something, about a place that is there, and can be printed.
inline void check(const text::Diagnostics& diagnostics) {
  for (const text::Diagnostic& each : diagnostics.all()) {
    const std::string shown = text::format(each);
    require(!each.message.empty(), "a complaint says something", shown);
    require(is_printable(shown), "a complaint can be printed", shown);
    check(each.where, shown);
    if (each.related) check(*each.related, shown);
  }
  const std::string all = text::format(diagnostics);
  require(all.empty() == (diagnostics.count() == 0), "what is counted is shown", all);
  (void)text::folded(all, 60);
}

/// A file in memory for readers that take a name. Its contents can be replaced.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, "there is memory for a file");
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  const std::string& path() const { return path_; }
  void hold(std::string_view contents) const {
    const bool good = ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, contents.data(), contents.size(), 0) ==
                                                              static_cast<ssize_t>(contents.size());
    require(good, "the file in memory takes the input");
  }

 private:
  int descriptor_;
  std::string path_;
};

/// The contents of a file of the project, "problems/sander.toml".
inline std::string project_file(const std::string& name) {
  std::ifstream file(std::string(MILLWRIGHT_SOURCE_DIR "/") + name, std::ios::binary);
  std::ostringstream all;
  all << file.rdbuf();
  require(!all.str().empty(), "a file of the project is there", name);
  return all.str();
}

/// The first line of the input, which is taken off it: what steers a target that has to be told more than one text.
inline std::string_view first_line(std::string_view& input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string_view line = input.substr(0, end);
  input.remove_prefix(std::min(end + 1, input.size()));
  return line;
}

inline std::vector<std::string> lines(std::string_view input) {
  std::vector<std::string> all;
  while (!input.empty()) all.emplace_back(first_line(input));
  return all;
}

}  // namespace millwright::fuzz
