// SPDX-License-Identifier: Apache-2.0
#include "text/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace millwright::text {

namespace {

/// Reads up to `count` bytes; false on an error, of which errno tells.
bool read_some(const std::string& path, std::size_t count, std::string& bytes, std::string& objection) {
  // Without O_NONBLOCK, opening a named pipe would wait for ever for its writer.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    objection = fmt::format("cannot be opened: {}", std::strerror(errno));
    return false;
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    objection = "is not a file";
  } else {
    const auto size = static_cast<std::size_t>(status.st_size);
    bytes.resize(size < count ? size : count);
    std::size_t filled = 0;
    while (filled < bytes.size()) {
      const ssize_t step = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
      if (step < 0 && errno == EINTR) continue;
      if (step < 0) objection = fmt::format("cannot be read: {}", std::strerror(errno));
      if (step <= 0) break;
      filled += static_cast<std::size_t>(step);
    }
    bytes.resize(filled);
  }
  ::close(descriptor);
  return objection.empty();
}

}  // namespace

std::string first_bytes(const std::string& path, std::size_t count) {
  std::string bytes;
  std::string objection;
  return read_some(path, count, bytes, objection) ? bytes : std::string();
}

std::optional<std::string> read_bytes(const std::string& path, std::uintmax_t size_limit, Diagnostics& diagnostics) {
  std::string bytes;
  std::string objection;
  std::string hint;
  const bool good = read_some(path, static_cast<std::size_t>(size_limit) + 1, bytes, objection);
  if (good && bytes.size() > size_limit) {
    objection = fmt::format("is too large: the limit is {} bytes", size_limit);
    hint = "is this the right file?";
  }
  if (objection.empty()) return bytes;
  diagnostics.error(whole(SourceText::from_string(path, {})), objection, hint);
  return std::nullopt;
}

}  // namespace millwright::text
