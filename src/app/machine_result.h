// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "app/machine_input.h"
#include "app/options.h"
#include "evaluation/synthesis.h"
#include "report/result.h"

namespace millwright::app {

/// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Title, file and axes of a result, and what the command line asks for beside the problem.
report::MachineResult result_for(const MachineInput& input);

std::vector<report::MissingSlot> missing_slots(const std::vector<evaluation::EmptySlot>& slots);

/// Threads, limits and objectives as asked for.
evaluation::SearchOptions search_options(const Options& options, const std::vector<std::string>& objectives);

/// Sets the designs, with places as they are printed, and the requirements behind the first.
void set_designs(report::MachineResult& result,
                 const machine::Problem& problem,
                 std::vector<evaluation::Design> designs);

}  // namespace millwright::app
