// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "machine/problem.h"

namespace millwright::evaluation {

/// Counts what is limited, and notes at each axis whether comparing builds by these objectives reads the cost, and the
/// mass. What does not count tells equals apart where it is first asked for (ties in search_options.cpp); points of a
/// front that are equal in all its objectives are told apart by neither, so where it has no cost and no mass both
/// count.
void note_what_counts(const std::vector<std::string>& objectives, machine::Problem& problem);

}  // namespace millwright::evaluation
