// SPDX-License-Identifier: Apache-2.0
//
// A tool that an axis drives pushes back at what carries that axis: the guides below bear the process forces of all
// axes above them, across their own travel.
#pragma once

#include <cstddef>

#include "machine/problem.h"

namespace millwright::machine {

/// Process forces of carried axes on the guides of the axis that carries them, and where they act.
struct CarriedForces {
  double pressing = 0.0;  ///< N, on the guides or off them
  double sideways = 0.0;  ///< N, across the travel in the plane of the guides
  /// Levers about the middle of the carriages [m], not negative: those of the tool where the problem has one and says
  /// where it stands (at the worst positions of all axes), else those of the moved weight and of the axis's own force.
  double along_arm = 0.0, across_arm = 0.0, height_arm = 0.0;
  /// Those of the axis's own process force [m]: of the tool as far as it is said where it stands, else of the moved
  /// weight and `force_height`.
  double own_across_arm = 0.0, own_height_arm = 0.0;
};

/// The largest process force of each linear axis that `index` carries, directly or not, all at once. One whose
/// direction in the machine is not known is taken as sideways. One along the travel itself is the drive's. The axis
/// must have guides.
CarriedForces carried_forces(const Problem& problem, std::size_t index);

}  // namespace millwright::machine
