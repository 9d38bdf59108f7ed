// SPDX-License-Identifier: Apache-2.0
//
// What an axis moves is a condition too: less mass, inertia or friction is looser. Where a counterbalance holds up a
// part of the weight that is so only until it holds up all of it: what is lighter still is pushed up.
#pragma once

#include <vector>

#include "machine/condition.h"
#include "machine/condition_places.h"

namespace millwright::machine {

/// The loads that are stated of an axis.
std::vector<Condition> load_conditions(const Problem& problem, std::size_t axis, const Places& places);

}  // namespace millwright::machine
