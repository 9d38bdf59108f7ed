// SPDX-License-Identifier: Apache-2.0
// Runs the program as a user does, in a folder of its own.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace millwright::app {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
  bool says(const std::string& text) const { return err.find(text) != std::string::npos; }
  bool prints(const std::string& text) const { return out.find(text) != std::string::npos; }
  /// Of anything but shipped parts in euros that a problem without rates leaves out.
  bool complains() const {
    const bool of_rates = says("the problem gives no rate for 'EUR'") && err.ends_with("\n1 warning\n");
    return !err.empty() && !of_rates;
  }
};

/// A temporary folder with the files of one test, removed at the end; programs run in it, so that paths are short.
class Workshop {
 public:
  Workshop() {
    std::string pattern = (std::filesystem::temp_directory_path() / "millwright-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    std::filesystem::create_directory(folder_ / "work");
    setenv("MILLWRIGHT_CATALOGUES", MILLWRIGHT_SOURCE_DIR "/catalogues", 1);
  }
  ~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / "work" / name; }

  void write(const std::string& name, const std::string& contents) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << contents;
  }
  std::string read(const std::string& name) const { return content_of(path(name)); }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Files and folders beside each other in the folder of the test.
  std::size_t entries() const {
    std::filesystem::directory_iterator files(folder_ / "work");
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

  Outcome run(const std::vector<std::string>& arguments) const { return run(arguments, RLIM_INFINITY); }

  /// With so many bytes of address space.
  Outcome run(const std::vector<std::string>& arguments, rlim_t memory) const {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const std::string out = (folder_ / "out").string();
    const std::string err = (folder_ / "err").string();
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, (folder_ / "work").c_str());
    std::vector<std::string> words = {MILLWRIGHT_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    rlimit usual{};
    getrlimit(RLIMIT_AS, &usual);
    const rlimit less{std::min(memory, usual.rlim_cur), usual.rlim_max};
    setrlimit(RLIMIT_AS, &less);  // the child inherits it
    const int failed = posix_spawn(&child, MILLWRIGHT_PROGRAM, &actions, nullptr, argv.data(), environ);
    setrlimit(RLIMIT_AS, &usual);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("the program does not start");
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    outcome.out = content_of(out);
    outcome.err = content_of(err);
    return outcome;
  }

 private:
  static std::string content_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::filesystem::path folder_;
};

/// A small machine that solves in a moment. Line numbers of complaints count in this text.
inline const char* one_slide = R"(title = "One slide"
[objective]
minimise = "cost"
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
direction = "horizontal"
stroke = "200 mm"
structure_mass = "5 kg"
guide_friction = 0.1
acceleration_time = ["0.1 s", "0.3 s"]
mechanism = { kind = "screw", screw = ["lead_screws"], ends = "fixed-free" }
motor = { from = "steppers", frame = ["NEMA17"] }
[[axis.moves]]
distance = "200 mm"
time = "20 s"
force = "20 N"
)";

/// one_slide with the first `from` replaced.
inline std::string one_slide_with(const std::string& from, const std::string& to) {
  std::string text = one_slide;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("one_slide has no " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace millwright::app
