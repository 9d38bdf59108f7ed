// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// Works out from the `carries` of each axis what carries it (Axis::carried_by), and the order of the axes from the
/// tools to the bases (Problem::order). `axes`: the list of axes in the file, one for each of problem.axes. Reported at
/// the entry of `carries`: a name that is no axis, an axis that is carried twice, and each circle once.
void link_axes(const text::Node& axes, Problem& problem, text::Diagnostics& diagnostics);

/// An axis and all that carry it, from it to the base.
[[nodiscard]] std::vector<std::size_t> carriers(const Problem& problem, std::size_t axis);

/// Mass that is stated of an axis and all that it carries [kg].
[[nodiscard]] double stated_mass(const Problem& problem, std::size_t axis);

}  // namespace millwright::machine
