// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Square threads as textbooks calculate them, step by step over the tangents of lead and friction angle. power_screw
/// has the same in one piece and for other threads. Everything in SI.
namespace millwright::mechanics::square_thread {

using namespace scalar;

/// Tangent of the lead angle. [khurmi_gupta2005, section 17.4]
template <class T>
T lead_tangent(const T& lead, const T& mean_diameter) {
  return lead / (pi<T>() * mean_diameter);
}

/// Tangent of the sum of lead angle and friction angle. Valid: lead_tangent * friction < 1. [khurmi_gupta2005, section
/// 17.4]
template <class T>
T tangent_of_sum(const T& lead_tangent, const T& friction) {
  watch_validity<T>("square_thread.tangent_of_sum", lead_tangent, friction);
  return (lead_tangent + friction) / (1.0 - lead_tangent * friction);
}

/// Torque that the axial force causes on a diameter (N·m): with the tangent of the sum the raising torque, with that of
/// the lead angle the torque without friction. [khurmi_gupta2005, section 17.4]
template <class T>
T torque(const T& force, const T& diameter, const T& tangent) {
  return force * tangent * diameter / 2.0;
}

/// Force at the circumference that a torque exerts (N). [khurmi_gupta2005, section 17.4]
template <class T>
T tangential_force(const T& torque, const T& diameter) {
  return 2.0 * torque / diameter;
}

/// Square of the core diameter that carries an axial force (m²). [torch_table, eq. 15; khurmi_gupta2005, section 17.10]
template <class T>
T required_core_diameter_squared(const T& force, const T& safety_factor, const T& yield_strength) {
  watch_validity<T>("square_thread.required_core_diameter_squared", force, safety_factor, yield_strength);
  return 4.0 * force * safety_factor / (pi<T>() * yield_strength);
}

}  // namespace millwright::mechanics::square_thread
