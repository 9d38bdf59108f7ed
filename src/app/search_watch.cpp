// SPDX-License-Identifier: Apache-2.0
#include "app/search_watch.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "app/output.h"
#include "text/diagnostic.h"

namespace millwright::app {

namespace {

constexpr double gigabyte = 1e9;

std::atomic<bool> stop_requested{false}, interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void request_stop(int) {
  interrupted.store(true);
  stop_requested.store(true);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  if (handler == request_stop) action.sa_flags |= static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

}  // namespace

StopSignal::StopSignal(double memory_limit)
    : limit_(static_cast<std::uint64_t>(std::ceil(std::min(memory_limit * gigabyte, 1e18)))) {
  interrupted.store(false);
  stop_requested.store(false);
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, request_stop);
  watch_memory();
}

void StopSignal::watch_memory() {
  memory_.emplace(limit_, [this](const MemoryState& state) {
    taken_.store(state.taken);
    stop_requested.store(true);
  });
}

bool StopSignal::resume() {
  if (taken_.load() == 0 || resumed_ || interrupted.load()) return false;
  if (give_memory_back != nullptr) give_memory_back();
  const std::optional<MemoryState> state = memory_state();
  if (!state || 2 * state->taken > taken_.load()) return false;
  resumed_ = true;
  watch_memory();
  stop_requested.store(false);
  if (interrupted.load()) stop_requested.store(true);
  return true;
}

StopSignal::~StopSignal() {
  memory_.reset();
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, SIG_DFL);
  if (taken_.load() == 0) return;
  text::Diagnostics diagnostics;
  diagnostics.warning(
      {},
      fmt::format("the search had taken {:.3g} GB of memory and was told to end: what is said was known by then{}",
                  static_cast<double>(taken_.load()) / gigabyte,
                  resumed_ ? ", or found in a shorter search from there" : ""),
      "let it choose less (--fix, --limit, fewer dimensions), or more memory: --memory-limit");
  print(diagnostics);
}

const std::atomic<bool>* StopSignal::stopped() const { return &stop_requested; }

ProgressLine::ProgressLine(bool quiet, std::string unit)
    : active_(!quiet && isatty(STDERR_FILENO) != 0), unit_(std::move(unit)) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (shown_) fmt::print(stderr, "\r\x1B[K");
  std::fflush(stderr);
  shown_ = false;
}

void ProgressLine::show(const solver::Progress& progress) {
  if (!active_) return;
  shown_ = true;
  const bool found = std::isfinite(progress.incumbent);
  const double gap = found && progress.incumbent != 0.0
                         ? (progress.incumbent - progress.lower_bound) / std::fabs(progress.incumbent)
                         : 1.0;
  const std::string best = found ? fmt::format("best {:.2f} {}, gap {:.2f} %", progress.incumbent, unit_, 100.0 * gap)
                                 : std::string("no build yet");
  std::string line = fmt::format("{}bound {:.2f} {}, {}, {} nodes, {:.1f} s",
                                 before_,
                                 progress.lower_bound,
                                 unit_,
                                 best,
                                 progress.nodes,
                                 progress.elapsed_seconds);
  // In a line of its own it is written over; what runs on into the next stays.
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1U && line.size() >= size.ws_col)
    line.resize(size.ws_col - 1U);
  fmt::print(stderr, "\r\x1B[K{}", line);
  std::fflush(stderr);
}

}  // namespace millwright::app
