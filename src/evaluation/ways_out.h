// SPDX-License-Identifier: Apache-2.0
//
// What to give up, where required position errors alone stand in the way: found by solving the machine again and again
// with larger ones.
#pragma once

#include <string>
#include <vector>

#include "evaluation/synthesis.h"
#include "evaluation/unmet_checks.h"

namespace millwright::evaluation {

/// What the problem would have to give up of its required position errors, so that something is compliant.
struct WayOut {
  struct Change {
    std::string axis;
    double from = 0.0, to = 0.0;  ///< m, position_error
    double over = 0.0;            ///< m, the travel it is stated for
  };
  bool mapped = false;          ///< with lead_error = "mapped" on these axes
  bool least = true;            ///< to 1 %; else time was up, and less may do
  std::vector<Change> changes;  ///< where `to` is `from`, mapping is enough
  double cost = 0.0;            ///< of the cheapest build then
  double mass = 0.0;            ///< kg, of that build
  std::string currency;
};

/// Ways out where all unmet checks ease with a required position error: the least errors that can be had, found to 1 %
/// by solving, with lead errors as made and as mapped by the controller. Within the options' time limit.
std::vector<WayOut> ways_out(const MachineModel& model,
                             const std::vector<UnmetCheck>& unmet,
                             const SearchOptions& options);

}  // namespace millwright::evaluation
