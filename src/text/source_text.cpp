// SPDX-License-Identifier: Apache-2.0
#include "text/source_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "text/diagnostic.h"
#include "text/large_pages.h"
#include "text/nearest.h"
#include "text/text_check.h"
#include "text/utf8.h"

namespace millwright::text {

namespace {

constexpr std::size_t sniffed_bytes = std::size_t{64} << 10U;

int to_int(std::size_t number) {
  return static_cast<int>(std::min<std::size_t>(number, std::numeric_limits<int>::max()));
}

/// A file descriptor that closes itself.
class File {
 public:
  explicit File(const std::string& path)
      // Without O_NONBLOCK, opening a named pipe would wait for ever for its writer.
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

  /// Appends what is there, up to `room` bytes in all; `at_end` tells whether the file ended. False on a read error.
  bool append_to(SourceText::Buffer& buffer, std::size_t room, bool& at_end) const {
    at_end = false;
    while (buffer.size < room) {
      const ssize_t step = ::read(descriptor_, buffer.bytes.get() + buffer.size, room - buffer.size);
      if (step < 0 && errno == EINTR) continue;
      if (step < 0) return false;
      at_end = step == 0;
      if (at_end) break;
      buffer.size += static_cast<std::size_t>(step);
    }
    return true;
  }

 private:
  int descriptor_;
};

std::shared_ptr<char> room_for(std::size_t bytes) {
  const std::shared_ptr<char> room(static_cast<char*>(::operator new(bytes)), [](char* at) { ::operator delete(at); });
  prefer_large_pages(room.get(), bytes);
  return room;
}

std::string_view without_mark(std::string_view bytes) {
  return bytes.substr(0, 3) == "\xEF\xBB\xBF" ? bytes.substr(3) : bytes;
}

std::string kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

}  // namespace

SourceText::SourceText(std::string path, std::string contents)
    : path_(std::move(path)), bytes_(std::move(contents)), contents_(without_mark(bytes_)) {}

SourceText::SourceText(std::string path, Buffer contents)
    : path_(std::move(path)),
      buffer_(std::move(contents)),
      contents_(without_mark({buffer_.bytes.get(), buffer_.size})) {}

std::string_view SourceText::bytes() const {
  if (buffer_.bytes) return {buffer_.bytes.get(), buffer_.size};
  return bytes_;
}

std::shared_ptr<const SourceText> SourceText::from_string(std::string path, std::string contents) {
  return std::make_shared<const SourceText>(std::move(path), std::move(contents));
}

namespace {

/// What is in a folder, sorted; nothing if there is no such folder.
std::vector<std::string> entries_of(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  constexpr std::size_t most = 10000;  // looked at
  std::error_code failure;
  std::vector<std::string> names;
  for (fs::directory_iterator each(folder.empty() ? fs::path(".") : folder, failure), end;
       !failure && each != end && names.size() < most;
       each.increment(failure))
    names.push_back(each->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// "did you mean 'problems/sander.toml'?": what has a similar name in the same folder; or nothing.
std::string similar_name(const std::filesystem::path& wanted) {
  const auto found = nearest(wanted.filename().string(), entries_of(wanted.parent_path()));
  if (!found) return {};
  return "did you mean '" + printable((wanted.parent_path() / *found).string()) + "'?";
}

/// Of a file that is not there: where a link leads, which of its folders is not there either, or what has a similar
/// name; or nothing.
std::string hint_for_missing(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failure;
  if (const fs::path there = fs::read_symlink(path, failure); !failure)
    return "it is a symbolic link to " + in_quotes(there.string(), 200) + ", which leads to nothing";
  fs::path folder;
  const fs::path folders = fs::path(path).parent_path();
  for (const fs::path& part : folders) {
    folder /= part;
    if (fs::exists(folder, failure) || failure) continue;
    const std::string similar = similar_name(folder);
    return "there is no folder " + in_quotes(folder.string(), 200) + (similar.empty() ? "" : "; " + similar);
  }
  return similar_name(path);
}

}  // namespace

std::shared_ptr<const SourceText> SourceText::load(const std::string& path,
                                                   Diagnostics& diagnostics,
                                                   std::uintmax_t size_limit) {
  const auto refuse = [&](const std::string& reason, const std::string& hint = {}) {
    diagnostics.error(whole(from_string(path, {})), reason, hint);
    return nullptr;
  };
  const File file(path.find('\0') == std::string::npos ? path : std::string{});
  if (!file.is_open()) {
    const int failure = errno;
    return refuse(fmt::format("cannot be opened: {}", std::strerror(failure)),
                  failure == ENOENT ? hint_for_missing(path) : std::string());
  }
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) return refuse(std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    return refuse("is " + kind_of(status.st_mode) + ", not a file", S_ISDIR(status.st_mode) ? "name a file in it" : "");

  const auto unreadable = [&] { return refuse(fmt::format("cannot be read: {}", std::strerror(errno))); };
  // The size may be out of date (a file that grows, or one in /proc), so read until the end or the limit.
  const auto size = static_cast<std::uintmax_t>(std::max<off_t>(status.st_size, 0));
  std::size_t room = static_cast<std::size_t>(std::min(size, size_limit)) + sniffed_bytes;
  Buffer buffer{room_for(room), 0};
  bool at_end = false;
  if (!file.append_to(buffer, sniffed_bytes, at_end)) return unreadable();
  if (!looks_like_text(from_string(path, {buffer.bytes.get(), buffer.size}), at_end, diagnostics)) return nullptr;
  const auto too_large = [&](std::uintmax_t found) {
    return refuse(fmt::format("is too large: {} bytes or more, the limit is {}", found, size_limit),
                  "is this the right file?");
  };
  if (size > size_limit) return too_large(size);
  while (!at_end) {
    if (buffer.size == room) {
      room *= 2;
      Buffer larger{room_for(room), buffer.size};
      std::memcpy(larger.bytes.get(), buffer.bytes.get(), buffer.size);
      buffer = std::move(larger);
    }
    if (!file.append_to(buffer, room, at_end)) return unreadable();
    if (buffer.size > size_limit) return too_large(buffer.size);
  }
  return std::make_shared<const SourceText>(path, std::move(buffer));
}

void SourceText::index_lines() const {
  std::call_once(indexed_, [this] {
    const std::string_view text = contents();
    line_begins_.push_back(0);
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
      line_begins_.push_back(at + 1);
    }
  });
}

int SourceText::line_count() const {
  index_lines();
  const bool ends_with_newline = line_begins_.back() == contents().size();
  return to_int(line_begins_.size() - (ends_with_newline ? 1 : 0));
}

std::string_view SourceText::line(int number) const {
  index_lines();
  if (number < 1 || static_cast<std::size_t>(number) > line_begins_.size()) return {};
  const auto index = static_cast<std::size_t>(number) - 1;
  const std::size_t begin = line_begins_[index];
  const std::size_t end = index + 1 < line_begins_.size() ? line_begins_[index + 1] - 1 : contents().size();
  std::string_view line = contents().substr(begin, end - begin);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

Position SourceText::position(std::size_t offset) const {
  const std::string_view text = contents();
  offset = std::min(offset, text.size());
  // Most files are asked for the places of their header, and for nothing else.
  constexpr std::size_t near = 4096;
  if (offset < near) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
    return {to_int(static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1),
            to_int(count_characters(before.substr(begin)) + 1)};
  }
  index_lines();
  const auto after = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
  const std::size_t begin = *(after - 1);
  return {to_int(static_cast<std::size_t>(after - line_begins_.begin())),
          to_int(count_characters(text.substr(begin, offset - begin)) + 1)};
}

SourceSpan whole(std::shared_ptr<const SourceText> text) { return {std::move(text), 0, 0, 0}; }

SourceSpan span_at(const std::shared_ptr<const SourceText>& text, std::size_t offset, std::size_t bytes) {
  const std::string_view contents = text->contents();
  offset = std::min(offset, contents.size());
  std::string_view covered = contents.substr(offset, bytes);
  covered = covered.substr(0, covered.find_first_of("\r\n"));
  const Position place = text->position(offset);
  // The carriage return of a line's end, and what is behind it, has no column of its own.
  const int behind = to_int(count_characters(text->line(place.line))) + 1;
  return {text, place.line, std::min(place.column, behind), to_int(count_characters(covered))};
}

}  // namespace millwright::text
