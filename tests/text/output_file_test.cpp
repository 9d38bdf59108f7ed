// SPDX-License-Identifier: Apache-2.0
#include "text/output_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"

namespace output_file_test {

using namespace millwright::text;
namespace fs = std::filesystem;

namespace {

class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "millwright_output_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    root = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  std::string path(const std::string& name) const { return (root / name).string(); }
  std::size_t count() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(root)) ++n;
    return n;
  }
  fs::path root;
};

std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string refusal(const std::string& path) {
  Diagnostics diagnostics;
  CHECK_FALSE(write_file_atomically(path, "new", diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  return diagnostics.all()[0].message;
}

}  // namespace

TEST_CASE("a file is written, replaced, and nothing else is left") {
  const Scratch scratch;
  Diagnostics diagnostics;
  const std::string path = scratch.path("bom.csv");
  CHECK(write_file_atomically(path, "axis,slot\n", diagnostics));
  CHECK(contents(path) == "axis,slot\n");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat status {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777U) == (0666U & ~mask));
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  const std::string binary = std::string("a\0b", 3) + std::string(3000000, 'x');
  CHECK(write_file_atomically(path, binary, diagnostics));
  CHECK(contents(path) == binary);
  REQUIRE(::stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777U) == 0600U);
  CHECK(write_file_atomically(path, "", diagnostics));
  CHECK(contents(path).empty());
  CHECK(write_file_atomically(scratch.path(std::string(250, 'n')), "x", diagnostics));
  CHECK(scratch.count() == 2);
  CHECK(diagnostics.count() == 0);
}

TEST_CASE("what must not be replaced is left alone") {
  const Scratch scratch;
  std::ofstream(scratch.path("real")) << "old";
  fs::create_symlink(scratch.path("real"), scratch.path("link"));
  fs::create_symlink(scratch.path("nowhere"), scratch.path("dangling"));
  fs::create_directory(scratch.path("folder"));
  REQUIRE(::mkfifo(scratch.path("pipe").c_str(), 0600) == 0);
  CHECK(refusal(scratch.path("link")) == "is a symbolic link; name the file itself");
  CHECK(refusal(scratch.path("dangling")) == "is a symbolic link; name the file itself");
  CHECK(refusal(scratch.path("folder")) == "is a directory and cannot be written");
  CHECK(refusal(scratch.path("folder") + "/") == "is no name of a file");
  CHECK(refusal(scratch.path("pipe")) == "is not a regular file and cannot be replaced");
  CHECK(refusal("") == "is no name of a file");
  CHECK(refusal(scratch.path("none") + "/x") == "cannot be written: No such file or directory");
  CHECK(refusal(scratch.path("real") + "/x") == "cannot be written: Not a directory");
  CHECK(refusal(scratch.path(std::string(300, 'n'))) == "cannot be written: File name too long");
  CHECK(contents(scratch.path("real")) == "old");
  CHECK(fs::is_symlink(scratch.path("link")));
  CHECK(scratch.count() == 5);
  if (::geteuid() != 0) {
    fs::permissions(scratch.path("real"), fs::perms::owner_read);
    CHECK(refusal(scratch.path("real")) == "cannot be written: Permission denied");
  }
}

TEST_CASE("when the disk gives no more room, the old file stays whole") {
  const Scratch scratch;
  const std::string path = scratch.path("result.json");
  Diagnostics diagnostics;
  REQUIRE(write_file_atomically(path, "old", diagnostics));
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  rlimit small = before;
  small.rlim_cur = 4096;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const bool written = write_file_atomically(path, std::string(1000000, 'x'), diagnostics);
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, handler);
  CHECK_FALSE(written);
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(diagnostics.all()[0].message == "cannot be written: File too large");
  CHECK(contents(path) == "old");
  CHECK(scratch.count() == 1);
}

namespace {

/// Whether files without a name can be had there.
bool has_nameless_files(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  ::close(descriptor);
  return true;
}

}  // namespace

TEST_CASE("nothing is left of a file whose writer is killed, and the old one is whole") {
  const Scratch scratch;
  if (!has_nameless_files(scratch.root)) return;  // an old file system
  const std::string path = scratch.path("prices.csv");
  Diagnostics diagnostics;
  REQUIRE(write_file_atomically(path, "old", diagnostics));
  for (const bool there : {true, false}) {
    const std::string target = there ? path : scratch.path("new.csv");
    const pid_t writer = ::fork();
    REQUIRE(writer >= 0);
    if (writer == 0) {
      const auto file = OutputFile::open(target, diagnostics);
      if (file && file->append(std::string(100000, 'x'))) ::kill(::getpid(), SIGKILL);
      ::_exit(1);
    }
    int status = 0;
    REQUIRE(::waitpid(writer, &status, 0) == writer);
    CHECK(WIFSIGNALED(status));
    CHECK(contents(path) == "old");
    CHECK(scratch.count() == 1);
  }
}

TEST_CASE("a file that is not committed leaves nothing") {
  const Scratch scratch;
  Diagnostics diagnostics;
  {
    const auto file = OutputFile::open(scratch.path("a.csv"), diagnostics);
    REQUIRE(file);
    CHECK(file->append("half"));
    CHECK_FALSE(fs::exists(scratch.path("a.csv")));
  }
  CHECK(scratch.count() == 0);
  const auto first = OutputFile::open(scratch.path("a.csv"), diagnostics);
  const auto second = OutputFile::open(scratch.path("b.csv"), diagnostics);
  REQUIRE((first && second));
  CHECK(first->append("one"));
  CHECK(second->append("two"));
  CHECK(first->commit());
  CHECK(second->commit());
  CHECK(contents(scratch.path("a.csv")) == "one");
  CHECK(contents(scratch.path("b.csv")) == "two");
  CHECK(scratch.count() == 2);
}

}  // namespace output_file_test
