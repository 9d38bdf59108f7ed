// SPDX-License-Identifier: Apache-2.0
//
// Why nothing is compliant, where a single check says so: checks that fail whatever is chosen. Proved from bounds over
// all that can be chosen, slot by slot; checks that only fail together are not found here.
#pragma once

#include <string>
#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

struct UnmetCheck {
  std::string axis, element, id, title;
  std::string requirement;  ///< key of its factor or limit, empty if none
  /// No build comes below this; 1 is the limit. Not less than useless_utilisation: no part states what is needed.
  double least_utilisation = 0.0;
};

std::vector<UnmetCheck> unmet_checks(const MachineModel& model);

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

struct SearchOptions;

/// Ways out where all unmet checks ease with a required position error: the least errors that can be had, found to 1 %
/// by solving, with lead errors as made and as mapped by the controller. Within the options' time limit.
std::vector<WayOut> ways_out(const MachineModel& model,
                             const std::vector<UnmetCheck>& unmet,
                             const SearchOptions& options);

}  // namespace millwright::evaluation
