// SPDX-License-Identifier: Apache-2.0
//
// What became of random machines.
#pragma once

#include <fmt/format.h>

namespace millwright {

struct RandomMachineCounts {
  int machines = 0, unreadable = 0, too_large = 0, infeasible = 0, on_grid = 0, missed_windows = 0, long_fronts = 0;
  int limited = 0, unfinished = 0, nothing_to_choose = 0, by_both = 0, covered = 0;

  void print() const {
    fmt::print(
        "{} machines: {} infeasible, {} with free dimensions, {} with fronts of several builds, {} limited, {} windows "
        "that only the search found, {} not finished, {} errors by both methods, {} ended fronts; {} too large to "
        "enumerate, {} without any candidate for a slot, {} not readable\n",
        machines,
        infeasible,
        on_grid,
        long_fronts,
        limited,
        missed_windows,
        unfinished,
        by_both,
        covered,
        too_large,
        nothing_to_choose,
        unreadable);
  }
};

}  // namespace millwright
