// SPDX-License-Identifier: Apache-2.0
// What happens beside a search: Ctrl-C ends it early, a terminal sees how it goes.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "app/memory_watch.h"
#include "solver/solver.h"

namespace millwright::app {

/// While it lives, Ctrl-C, a request to terminate and too much memory set `stopped()`; a second Ctrl-C ends the program
/// at once. If it was memory it says so in the end, on standard error.
class StopSignal {
 public:
  /// GB; 0: what is_too_much finds too much.
  explicit StopSignal(double memory_limit);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  const std::atomic<bool>* stopped() const;
  /// Takes the stop back, once, if it was for want of memory and at least half of it has been given back since. Whether
  /// it did.
  bool resume();

 private:
  void watch_memory();

  std::uint64_t limit_;                  ///< bytes; 0: none is given
  std::atomic<std::uint64_t> taken_{0};  ///< bytes when it was too much
  bool resumed_ = false;
  std::optional<MemoryWatch> memory_;
};

/// A line on standard error that is written over and over: bound, incumbent, gap, elapsed. Silent unless standard
/// error is a terminal.
class ProgressLine {
 public:
  ProgressLine(bool quiet, std::string unit);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const solver::Progress& progress);
  /// Takes the line away again.
  void clear();
  /// What stands before the figures, "3/7 ".
  void begin_with(std::string words) { before_ = std::move(words); }
  bool active() const { return active_; }

 private:
  bool active_;
  bool shown_ = false;
  std::string unit_, before_;
};

}  // namespace millwright::app
