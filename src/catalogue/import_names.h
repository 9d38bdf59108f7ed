// SPDX-License-Identifier: Apache-2.0
// Whether the words of somebody's header mean one of our columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/family.h"

namespace millwright::catalogue {

/// A header cell split into a name and what may be its unit, most likely first: "Torque (N.cm)", "Torque, N.cm",
/// "torque_Ncm", "Torque in N.cm". The last one is the whole text without a unit.
struct HeaderReading {
  std::string_view name;
  std::string_view unit;
};
std::vector<HeaderReading> header_readings(std::string_view header);

/// The words of a name, lower case: "HoldingTorque_max" is holding, torque, max.
std::vector<std::string> words_of(std::string_view name);

/// Whether a header holds a number other than 1. A price of such a header may be that of many pieces: "Price/100",
/// "Price per 10", "Price 10+".
bool has_quantity(std::string_view header);

/// How surely these words name the column, 0 to 1: 1 its own name, less a synonym, less again with words too many or
/// too few.
double name_match(const std::vector<std::string>& words, Column column);

}  // namespace millwright::catalogue
