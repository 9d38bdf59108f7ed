// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// Works out from the `carries` of each axis what carries it (Axis::carried_by), and the order of the axes from the
/// tools to the bases (Problem::order). `axes`: the list of axes in the file, one for each of problem.axes. Reported at
/// the entry of `carries`: a name that is no axis, an axis that is carried twice, and each circle once.
void link_axes(const text::Node& axes, Problem& problem, text::Diagnostics& diagnostics);

/// Whether a counterbalance holds up what weighs on this axis, its own or that of one that carries it. Then less weight
/// is not easier: it may be pushed up.
[[nodiscard]] bool is_counterbalanced(const Problem& problem, std::size_t axis);

}  // namespace millwright::machine
