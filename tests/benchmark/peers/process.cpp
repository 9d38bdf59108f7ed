// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "benchmark/measure.h"
#include "benchmark/peers/peer.h"

namespace stack::peers {
namespace {

void say(int to, const std::string& line) {
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t written = write(to, line.data() + done, line.size() - done);
    if (written <= 0) return;
    done += static_cast<std::size_t>(written);
  }
}

void take_line(const std::string& line, double seconds, Outcome& outcome) {
  std::istringstream in(line);
  std::string word;
  in >> word;
  if (word == "claim") outcome.claimed = outcome.design.has_value();
  if (word != "design") return;
  Design design;
  Choice choice;
  while (in >> choice.screw >> choice.motor >> choice.ramp) design.push_back(choice);
  outcome.design = design;
  outcome.claimed = false;
  outcome.found_seconds = seconds;
}

/// The child: quiet, in a process group of its own, so that what it starts can be ended with it.
[[noreturn]] void work(const Peer& peer, const Question& question, int to) {
  setpgid(0, 0);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2}) dup2(nowhere, standard);
  try {
    peer.run(question, Report(to));
  } catch (...) {
    _exit(3);
  }
  _exit(0);
}

}  // namespace

void Report::found(const Design& design) const {
  std::string line = "design";
  for (const Choice& choice : design) line += fmt::format(" {} {} {}", choice.screw, choice.motor, choice.ramp);
  say(to_, line + "\n");
}

void Report::claim() const { say(to_, "claim\n"); }

Outcome run_isolated(const Peer& peer, const Question& question) {
  Outcome outcome;
  int ends[2];
  if (pipe(ends) != 0) return outcome;
  std::fflush(nullptr);
  const auto start = measure::Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    work(peer, question, ends[1]);
  }
  close(ends[1]);
  if (child < 0) return outcome;
  setpgid(child, child);
  const double patience = 1.2 * question.seconds + 1.0;  // a peer's own limit comes first
  std::string text;
  char buffer[4096];
  while (true) {
    const double left = patience - measure::seconds_since(start);
    if (left <= 0.0) {
      outcome.stopped = true;
      break;
    }
    pollfd waiting{ends[0], POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(1e3 * left) + 1) <= 0) continue;
    const ssize_t size = read(ends[0], buffer, sizeof buffer);
    if (size <= 0) break;
    text.append(buffer, static_cast<std::size_t>(size));
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
      take_line(text.substr(0, end), measure::seconds_since(start), outcome);
      text.erase(0, end + 1);
    }
  }
  if (outcome.stopped) kill(-child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  outcome.crashed = !outcome.stopped && !(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  outcome.seconds = measure::seconds_since(start);
  close(ends[0]);
  return outcome;
}

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  std::string folder;
  while (std::getline(folders, folder, ':'))
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

void each_line(const std::string& command, const std::function<void(const std::string&)>& line) {
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return;
  std::string text;
  for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) {
    if (c != '\n') {
      text.push_back(static_cast<char>(c));
      continue;
    }
    line(text);
    text.clear();
  }
  pclose(output);
}

}  // namespace stack::peers
