// SPDX-License-Identifier: Apache-2.0
//
// The same machine with its parts ordered where they cost least. A search that is ended by a limit may have come upon
// good parts in a bad order: two shops' shipping where one sells everything.
#pragma once

#include "evaluation/search_options.h"

namespace millwright::evaluation {

/// Builds with their parts, dimensions and supply voltages as they are, from the suppliers of which the order costs
/// least as builds are compared (MachineModel::compared). A build stays as it is where no other order is cheaper or
/// none is found in the time there is for all, in seconds; all do where suppliers charge for nothing but their parts,
/// or where the model was made for objectives that no cost is in. Of a front those are left out that another one beats
/// then. Of the options objectives, gap and threads count.
void order_cheapest(const MachineModel& model,
                    const SearchOptions& options,
                    std::vector<solver::Build>& builds,
                    double seconds);

}  // namespace millwright::evaluation
