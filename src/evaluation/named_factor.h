// SPDX-License-Identifier: Apache-2.0
//
// Factors by which a printed number is off when its digits are right and its unit is wrong.
#pragma once

#include <optional>
#include <string>

#include "machine/claims.h"

namespace millwright::evaluation {

struct NamedFactor {
  double factor = 1.0;  ///< printed value over true value
  std::string name;     ///< "1000: printed kW, is W"
};

/// The factor that turns `line` (SI, dimension of the unit in which the claim is read) into the printed value:
///  1. the printed number is the value in another usual unit of the same dimension (W for kW, kgf*mm for N*m, r/s for
///     rad/s, mm for m); the nearest one if there are several;
///  2. else a bare factor, up or down: 60 and 3600 (time), 2 pi (turns and radians) where the dimension has a time or
///  is
///     an angle, 9.80665 (weight and force) where it has a mass, 10^3, 10^6, 10^9 or 10^12 (prefixes, mm and m) where
///     it has a dimension at all.
/// A factor counts only if it explains the printed number to half a unit of its last digit, and if the number has at
/// least two significant digits: one digit fits too much. Nothing where no factor does.
std::optional<NamedFactor> named_factor(const machine::PrintedValue& printed, const scalar::Unit& unit, double line);

}  // namespace millwright::evaluation
