// SPDX-License-Identifier: Apache-2.0
//
// What an axis moves is a condition too: less mass, inertia or friction is looser. Where a counterbalance holds up a
// part of the weight that is so only until it holds up all of it: what is lighter still is pushed up. And under less a
// ball nut without preload is softer.
#pragma once

#include <vector>

#include "machine/condition.h"
#include "machine/condition_places.h"

namespace millwright::machine {

/// Whether a drive must be stiff that may have a ball nut without preload: with less force or load it is softer.
bool softens_under_less(const Axis& axis);

/// The loads that are stated of an axis; none where less of them may soften its drive, or one of an axis below it.
std::vector<Condition> load_conditions(const Problem& problem, std::size_t axis, const Places& places);

}  // namespace millwright::machine
