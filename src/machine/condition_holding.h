// SPDX-License-Identifier: Apache-2.0
//
// That nothing but the motor holds an axis on which gravity acts is a condition too: a brake, or a counterbalance
// instead, may be what a machine lacks.
#pragma once

#include <optional>

#include "machine/condition.h"
#include "machine/condition_places.h"

namespace millwright::machine {

/// The torque of the holding brake of an axis, which may be none, with the counterbalance as what may be had instead;
/// nothing of an axis on which no gravity acts.
std::optional<Condition> brake_condition(const Problem& problem, std::size_t axis, const Places& places);

}  // namespace millwright::machine
