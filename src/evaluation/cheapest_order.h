// SPDX-License-Identifier: Apache-2.0
//
// The same machine with its parts ordered where they cost least. A search that is ended by a limit may have come upon
// good parts in a bad order: two shops' shipping where one sells everything.
#pragma once

#include "evaluation/search_options.h"

namespace millwright::evaluation {

/// `build` with its parts, its dimensions and its supply voltage as they are, from the suppliers of which the order
/// costs least as builds are compared (MachineModel::compared); `build` itself where no other order is cheaper, or none
/// is found in so many seconds, or where suppliers charge for nothing but their parts, or where the model was made for
/// objectives that no cost is in. Of the options the gap and the threads count.
solver::Build ordered_cheapest(const MachineModel& model,
                               const SearchOptions& options,
                               const solver::Build& build,
                               double seconds);

/// The same for builds of a front, or for the one best build. Of a front those are left out that another one beats
/// then.
void order_cheapest(const MachineModel& model,
                    const SearchOptions& options,
                    std::vector<solver::Build>& builds,
                    double seconds);

}  // namespace millwright::evaluation
