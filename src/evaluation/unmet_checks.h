// SPDX-License-Identifier: Apache-2.0
//
// Why nothing is compliant, where a single check says so: checks that fail whatever is chosen. Proved from bounds over
// all that can be chosen, slot by slot; checks that only fail together are not found here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

struct UnmetCheck {
  std::string axis, element, id, title;
  std::string requirement;  ///< key of its factor or limit, empty if none
  std::string source;       ///< of its formula
  /// No build comes below this; 1 is the limit. Not less than useless_utilisation: no part states what is needed.
  double least_utilisation = 0.0;
  std::string slot, nearest;  ///< the slot that says most, and its part that comes nearest; empty where none alone does
};

/// None when `interrupt`, asked now and then, says so.
std::vector<UnmetCheck> unmet_checks(const MachineModel& model, const std::function<bool()>& interrupt = {});

}  // namespace millwright::evaluation
