// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/catalogue.h"
#include "machine/problem.h"

namespace millwright::machine {

/// The currents [A] that an axis lists and, between and beyond them, a few that would be set for motors of the
/// catalogue without a list (current_factor times the rated current, from the least to the most); ascending. Whatever
/// can be built with the list can be built with these.
[[nodiscard]] std::vector<double> usual_currents(const Axis& axis, const catalogue::Catalogue& catalogue);

}  // namespace millwright::machine
