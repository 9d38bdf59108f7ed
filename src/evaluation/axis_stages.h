// SPDX-License-Identifier: Apache-2.0
//
// The elements of one axis as stages, from the tool towards the base.
#pragma once

#include <vector>

#include "evaluation/axis_place.h"
#include "evaluation/machine_model.h"

namespace millwright::evaluation {

/// Its structure, guide and drive, and the joints of screws that hold its carriages and motors, each after what loads
/// it. What has to be known of those loads becomes states of its own, added to `first_state`; `place` is where the axis
/// stands in the chain of the machine without them. Axis, catalogue and prices have to outlive the stages.
std::vector<StageEntry> axis_stages(const machine::Axis& axis,
                                    AxisPlace place,
                                    const std::vector<double>& supply_voltages,
                                    const catalogue::Catalogue& catalogue,
                                    const PriceBook& prices,
                                    std::vector<double>& first_state);

}  // namespace millwright::evaluation
