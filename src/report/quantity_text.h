// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "machine/objective.h"

namespace millwright::report {

/// "612.34 USD", "41.200 kg", "12.500 s": a value of a quantity.
std::string quantity_text(machine::Quantity quantity, double value, const std::string& currency);
/// The same of a lower bound: what is said is no more than what was proved.
std::string quantity_bound_text(machine::Quantity quantity, double bound, const std::string& currency);

/// A length that something is cut to, in millimetres: of four digits, and with tenths where there are any.
std::string millimetres_text(double metres);

/// What is left open, as a part, in percent of so many digits; rounded up, so that what is said to be proved is.
std::string percent_rounded_up(double part, int digits = 2);

}  // namespace millwright::report
