// SPDX-License-Identifier: Apache-2.0
// Lists of what there is to choose from, for help texts: "cost, mass, cycle_time".
#pragma once

#include <string>

namespace millwright::app {

/// What can be minimised.
std::string all_quantities();

/// The templates of `millwright new`.
std::string all_templates();

}  // namespace millwright::app
