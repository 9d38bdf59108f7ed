// SPDX-License-Identifier: Apache-2.0
//
// Why an axis has no motor with a driver: which of the two is missing, and for what.
#pragma once

#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "machine/problem.h"

namespace millwright::evaluation {

struct MotorShortage {
  std::string slot;    ///< "motor" or "driver"
  std::string reason;  ///< "no driver runs at the supply's 230 V: those of the catalogues take 8 V to 110 V"
};

/// Of an axis for which no pair of motor and driver was found with any of these supply voltages.
MotorShortage motor_shortage(const catalogue::Catalogue& catalogue,
                             const machine::Axis& axis,
                             const std::vector<double>& voltages);

}  // namespace millwright::evaluation
