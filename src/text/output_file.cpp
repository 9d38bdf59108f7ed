// SPDX-License-Identifier: Apache-2.0
#include "text/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace millwright::text {

namespace {

std::string directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

/// A file in the directory of the target that vanishes unless it is renamed. Where the file system can, it has no name
/// until it is complete, so that nothing is left of it even if the process is killed.
class TemporaryFile {
 public:
  /// Opened by hand and not with mkstemp, which ignores the permissions that the process gives new files.
  explicit TemporaryFile(const std::string& directory) : directory_(directory) {
    if (open_nameless()) return;
    try_names([this] {
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      return descriptor_ >= 0;
    });
    exists_ = descriptor_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    const int reason = errno;  // what went wrong is reported after this has cleaned up
    if (descriptor_ >= 0) ::close(descriptor_);
    if (exists_) ::unlink(path_.c_str());
    errno = reason;
  }

  bool is_open() const { return descriptor_ >= 0; }
  bool set_mode(mode_t mode) const { return ::fchmod(descriptor_, mode) == 0; }

  bool write(std::string_view contents) const {
    while (!contents.empty()) {
      const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      contents.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// Flushes (a full disk may show only here) and takes the target's place.
  bool replace(const std::string& target) {
    if (::fsync(descriptor_) != 0) return false;
    if (!exists_ && !give_name()) return false;
    if (::rename(path_.c_str(), target.c_str()) != 0) return false;
    exists_ = false;
    return true;
  }

 private:
  /// Of names that are not taken the first with which `make` succeeds.
  template <class Make>
  bool try_names(const Make& make) {
    constexpr int attempts = 1000;
    for (int i = 0; i < attempts; ++i) {
      path_ = fmt::format("{}.millwright-{}-{}.tmp", directory_, ::getpid(), i);
      if (make()) return true;
      if (errno != EEXIST) return false;
    }
    return false;
  }

  /// What stands for the open file where a name of it is wanted.
  [[nodiscard]] std::string handle() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

  bool open_nameless() {
#ifdef O_TMPFILE
    descriptor_ = ::open(directory_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    if (::access(handle().c_str(), F_OK) == 0) return true;  // else it could never be given a name
    ::close(descriptor_);
    descriptor_ = -1;
#endif
    return false;
  }

  bool give_name() {
    exists_ = try_names(
        [this] { return ::linkat(AT_FDCWD, handle().c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0; });
    return exists_;
  }

  std::string directory_;
  std::string path_;
  int descriptor_ = -1;
  bool exists_ = false;
};

/// Makes the rename itself durable. Some file systems cannot; the contents are safe all the same.
void flush_directory(const std::string& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// Why the target cannot be replaced; empty if it can, or is not there yet.
std::string objection(const std::string& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "is a directory and cannot be written";
  if (S_ISLNK(status.st_mode)) return "is a symbolic link; name the file itself";
  if (!S_ISREG(status.st_mode)) return "is not a regular file and cannot be replaced";
  if (::access(path.c_str(), W_OK) != 0) return fmt::format("cannot be written: {}", std::strerror(errno));
  return {};
}

}  // namespace

struct OutputFile::Parts {
  std::string path;
  std::string directory;
  TemporaryFile file;
  Diagnostics& diagnostics;
};

std::unique_ptr<OutputFile> OutputFile::open(const std::string& path, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& reason) {
    diagnostics.error(whole(SourceText::from_string(path, {})), reason);
    return nullptr;
  };
  if (path.empty() || path.back() == '/' || path.find('\0') != std::string::npos) return refuse("is no name of a file");
  struct stat status {};
  const bool exists = ::lstat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) return refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
  if (const std::string reason = exists ? objection(path, status) : std::string(); !reason.empty())
    return refuse(reason);
  const std::string directory = directory_of(path);
  std::unique_ptr<OutputFile> file(
      // NOLINTNEXTLINE(modernize-make-unique): an aggregate, and its file does not move
      new OutputFile(std::unique_ptr<Parts>(new Parts{path, directory, TemporaryFile(directory), diagnostics})));
  if (file->parts_->file.is_open() && (!exists || file->parts_->file.set_mode(status.st_mode & 07777U))) return file;
  return refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
}

OutputFile::OutputFile(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
OutputFile::~OutputFile() = default;

bool OutputFile::refuse() {
  parts_->diagnostics.error(whole(SourceText::from_string(parts_->path, {})),
                            fmt::format("cannot be written: {}", std::strerror(errno)));
  return false;
}

bool OutputFile::append(std::string_view contents) { return parts_->file.write(contents) || refuse(); }

bool OutputFile::commit() {
  if (!parts_->file.replace(parts_->path)) return refuse();
  flush_directory(parts_->directory);
  return true;
}

bool write_file_atomically(const std::string& path, std::string_view contents, Diagnostics& diagnostics) {
  const std::unique_ptr<OutputFile> file = OutputFile::open(path, diagnostics);
  return file && file->append(contents) && file->commit();
}

}  // namespace millwright::text
