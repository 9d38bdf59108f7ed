// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// The table [spares] of a problem file: how many pieces more are bought of what is chosen for a slot, of every axis
/// (motor = 1) or of one ("x.motor" = 1). After the axes.
void read_spares(const text::Node& node, Problem& problem, text::Diagnostics& diagnostics);

/// The slots of an axis that are filled from catalogues, as a bill of materials names them.
std::vector<std::string> catalogue_slots(const Axis& axis);

}  // namespace millwright::machine
