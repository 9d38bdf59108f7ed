// SPDX-License-Identifier: Apache-2.0
// What happens beside a search: Ctrl-C ends it early, a terminal sees how it goes.
#pragma once

#include <atomic>
#include <string>

#include "solver/solver.h"

namespace millwright::app {

/// While it lives, Ctrl-C and a request to terminate set `stopped()`; a second Ctrl-C ends the program at once.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  const std::atomic<bool>* stopped() const;
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
