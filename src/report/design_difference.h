// SPDX-License-Identifier: Apache-2.0
// In what one build differs from another: parts slot by slot, and what is chosen among values.
#pragma once

#include <string>
#include <vector>

#include "evaluation/ledger.h"

namespace millwright::report {

/// One slot or setting that two builds fill differently.
struct DesignDifference {
  std::string axis, slot;
  std::string before, now;  ///< "StepperOnline 17HS19-2004S1", "24 V"; "–" where a build has nothing there
  /// The same without makers, where the part numbers alone tell them apart.
  std::string short_before, short_now;
};

/// Parts in the order of `now`, then those that only `before` has, then settings (motor current, supply voltage).
/// Dimensions that follow from the parts are not looked at.
std::vector<DesignDifference> differences(const evaluation::Design& before, const evaluation::Design& now);

/// The same parts, but from another shop, or from stock in one of the builds: "17HS19-2004S1 from Shop A".
std::vector<DesignDifference> purchase_differences(const evaluation::Design& before, const evaluation::Design& now);

}  // namespace millwright::report
