// SPDX-License-Identifier: Apache-2.0
//
// Bounds of what many motors give at the same few speeds by the winding model (modelled_torque in motor.h): what hangs
// on the speed alone is worked out once for all motors, what hangs on the motor alone once for all speeds.
#pragma once

#include <vector>

#include "machine/motor.h"
#include "scalar/interval.h"

namespace millwright::machine {

class ModelledTorques {
 public:
  /// `speeds` [rad/s]: ascending, none below zero.
  explicit ModelledTorques(const std::vector<double>& speeds);

  /// Bounds of the available torque [N.m] at each speed; `current`: peak amplitude [A].
  void find(const MotorFigures<scalar::Interval>& figures,
            const scalar::Interval& current,
            std::vector<scalar::Interval>& torques) const;

 private:
  std::vector<scalar::Interval> speeds_;
  std::vector<scalar::Interval> losses_;  ///< of a motor of 1 N.m, at each speed
};

}  // namespace millwright::machine
