// SPDX-License-Identifier: Apache-2.0
//
// What the whole machine may take at most of what designs are judged by: [limits] of a problem file and `--limit` of
// the command line.
#pragma once

#include <string>
#include <vector>

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// [limits].
void read_limits(const text::Node& node, Problem& problem, text::Diagnostics& diagnostics);

/// A budget as it was given on the command line.
struct LimitOption {
  std::string name;    ///< of a quantity (objective.h)
  double value = 0.0;  ///< SI, of the cost in the problem's currency
};

/// Reads words such as "cost=400", "cost=380 EUR", "mass=12 kg" and sets the problem's limits; where it has one
/// already, the tighter of both. Reported, at the word: unknown names, amounts that are none or not above zero, units
/// that do not fit, currencies without a rate, a limit given twice, what this problem cannot count. What could be read
/// is returned.
std::vector<LimitOption> add_limits(const std::vector<std::string>& words,
                                    Problem& problem,
                                    text::Diagnostics& diagnostics);

}  // namespace millwright::machine
