// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "machine/objective.h"

namespace millwright::report {

/// "612.34 USD", "41.200 kg", "12.500 s": a value of a quantity.
std::string quantity_text(machine::Quantity quantity, double value, const std::string& currency);
/// The same of a lower bound: what is said is no more than what was proved.
std::string quantity_bound_text(machine::Quantity quantity, double bound, const std::string& currency);

}  // namespace millwright::report
