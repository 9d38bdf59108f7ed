// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// The table [currency] of a problem file: for each currency what one unit of it is worth in the problem's own, which
/// is the one, and only one, whose rate is 1. Without the table everything is in USD.
void read_currencies(const text::Node& node, Problem& problem, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
