// SPDX-License-Identifier: Apache-2.0
// The machines in problems/ that come with a bill of materials.
#pragma once

#include <array>

namespace millwright {

inline constexpr std::array shipped_machines = {"sander",
                                                "mini-mill",
                                                "torch-table",
                                                "fdm-printer",
                                                "lifter",
                                                "belt-printer",
                                                "gantry",
                                                "rotary-table",
                                                "router",
                                                "inserter",
                                                "bar-feeder"};

}  // namespace millwright
