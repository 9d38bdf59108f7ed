// SPDX-License-Identifier: Apache-2.0
//
// What an axis moves is a condition too: less mass, inertia or friction is looser. Where a counterbalance holds up a
// part of the weight that is so only until it holds up all of it: what is lighter still is pushed up. And under less a
// ball nut without preload is softer.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "machine/condition.h"
#include "machine/condition_places.h"

namespace millwright::machine {

/// Whether a drive must be stiff that may have a ball nut without preload, or could where the kinds of screws that are
/// permitted are eased too: with less force or load it is softer.
bool softens_under_less(const Axis& axis);

/// Checks that an axis enforces and that slower moves need not keep, though faster ones do: RMS torque, of which rests
/// take their share, and resonances that lie between two speeds.
std::vector<std::string> failed_by_slower(const Axis& axis);

/// Whether another time or speed of a move that these axes make (first of each pair) is looser: not where the time or
/// the energy of the cycle is limited, nor where an axis enforces such a check.
bool slower_is_looser(const Problem& problem, std::span<const std::pair<std::size_t, std::size_t>> moves);

/// Such checks that a lighter load need not keep: frequencies that have to lie apart.
std::vector<std::string> failed_by_lighter(const Axis& axis);

/// The loads that are stated of an axis; none where less of them may be worse for its drive, or one of an axis below
/// it.
std::vector<Condition> load_conditions(const Problem& problem, std::size_t axis, const Places& places);

}  // namespace millwright::machine
